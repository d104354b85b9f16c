//! A slider for the arrow, for those who do not drag it in the picture.

use super::primary;
use crate::app::prose::prose;
use crate::app::session::{Command, Session};
use crate::app::{arrow_focus, strings};
use crate::lesson::Guess;
use crate::picture::Ink;
use egui::{Key, Label, Slider, SliderClamping, Ui, WidgetInfo};

/// What an arrow key turns it by, in degrees.
const STEP: f64 = 1.0;

/// The slider has the keyboard when the question opens, and again for the second try.
pub(super) fn ask(
    session: &Session,
    name: &str,
    opens: bool,
    commands: &mut Vec<Command>,
    ui: &mut Ui,
) {
    let Some(degrees) = session.arrow_asked() else {
        return;
    };
    let language = session.look.language;
    let how = session.localize(strings::TURN_THE_ARROW);
    ui.add(Label::new(prose(session, how, 13.0, Ink::Text)).wrap());
    ui.horizontal(|ui| {
        let number = language.fixed(degrees, 0);
        ui.spacing_mut().slider_width = (ui.available_width() - 150.0).max(60.0);
        let mut turned = degrees;
        let slider = Slider::new(&mut turned, -180.0..=180.0)
            .step_by(STEP)
            .clamping(SliderClamping::Edits)
            .show_value(false);
        let response = ui.add(slider);
        let angle = strings::ARROW_ANGLE.format(language, &[("name", name)]);
        response.widget_info(|| WidgetInfo::slider(true, degrees, &angle));
        if opens {
            response.request_focus();
        }
        if turned != degrees {
            commands.push(Command::Turn(turned));
        }
        let mut entered = false;
        if response.has_focus() {
            arrow_focus::claim(ui.ctx());
            entered = ui.input(|input| input.key_pressed(Key::Enter));
        }
        ui.add_sized([44.0, 20.0], Label::new(format!("{number}°")));
        let check = ui.add(primary(session, session.localize(strings::CHECK)));
        if check.clicked() || entered {
            commands.push(Command::Answer(Guess::Arrow(degrees)));
        }
    });
}
