//! The field in which a number is typed.

use super::primary;
use crate::app::session::{Command, Session};
use crate::app::window_state::Window;
use crate::app::{strings, style};
use crate::lesson::{Guess, read_number};
use crate::picture::Ink;
use egui::{Key, RichText, TextEdit, Ui};

/// The field has the keyboard when the question opens, and again for the second try.
pub(super) fn ask(
    session: &Session,
    opens: bool,
    window: &mut Window,
    commands: &mut Vec<Command>,
    ui: &mut Ui,
) {
    let mut pressed = false;
    ui.horizontal_wrapped(|ui| {
        let edit = TextEdit::singleline(&mut window.answer)
            .desired_width(96.0)
            .hint_text("…");
        let response = ui.add(edit);
        if opens {
            response.request_focus();
        }
        if response.changed() {
            window.misread = false;
        }
        let (name, text) = (
            session.localize(strings::YOUR_ANSWER),
            window.answer.clone(),
        );
        response.widget_info(|| egui::WidgetInfo {
            label: Some(name.to_owned()),
            ..egui::WidgetInfo::text_edit(true, "", &text, "")
        });
        let entered = response.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter));
        let check = ui.add(primary(session, session.localize(strings::CHECK)));
        pressed = check.clicked() || entered;
        if pressed {
            window.misread = read_number(&window.answer).is_none();
            if window.misread {
                // What is typed next must correct the answer, not act as keys.
                response.request_focus();
            } else {
                commands.push(Command::Answer(Guess::Number(window.answer.clone())));
            }
        }
    });
    if window.misread {
        let ink = style::color(session.look.theme, Ink::Bad);
        let text = RichText::new(session.localize(strings::NOT_A_NUMBER));
        let label = ui.label(text.color(ink));
        if pressed {
            label.scroll_to_me(None);
        }
    }
}
