//! A button for each thing, for those who do not click it in the picture; those already tried are disabled.

use crate::app::button::{explain_disabled, for_finger};
use crate::app::prose::prose;
use crate::app::session::{Command, Session};
use crate::app::strings;
use crate::lesson::{Guess, Thing};
use crate::picture::Ink;
use egui::{Button, RichText, Role, Ui, WidgetInfo};

pub(super) fn ask(
    session: &Session,
    thing: Thing,
    names: &[[String; 2]],
    commands: &mut Vec<Command>,
    ui: &mut Ui,
) {
    let click = match thing {
        Thing::Object => strings::CLICK_AN_OBJECT,
        Thing::Patch => strings::CLICK_A_PATCH,
    };
    ui.label(RichText::new(session.localize(click)).strong());
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing = egui::vec2(4.0, 4.0);
        for (number, name) in names.iter().enumerate() {
            let guess = Guess::Pick(number);
            let is_new = !session.guesses().contains(&guess);
            let name = &name[session.look.language as usize];
            // Of patches there are many: they are called by their number.
            let shown = match thing {
                Thing::Object => name.clone(),
                Thing::Patch => number.to_string(),
            };
            let button = ui.add_enabled(is_new, for_finger(Button::new(shown), ui));
            button.widget_info(|| WidgetInfo::labeled(Role::Button, is_new, name));
            if !is_new {
                explain_disabled(button, session.localize(strings::ALREADY_TRIED));
                continue;
            }
            let text = prose(session, name, 13.0, Ink::Text);
            if button.on_hover_text(text).clicked() {
                commands.push(Command::Answer(guess));
            }
        }
    });
}
