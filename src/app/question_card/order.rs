//! A row for each item, with buttons that move it up and down.

use super::primary;
use crate::app::button::{explain_disabled, for_finger};
use crate::app::prose::prose;
use crate::app::row_end::row_end;
use crate::app::session::{Command, Session};
use crate::app::strings;
use crate::app::window_state::Window;
use crate::language::Message;
use crate::lesson::Guess;
use crate::picture::Ink;
use egui::{Button, Role, Ui, UiBuilder, WidgetInfo};

pub(super) fn ask(
    session: &Session,
    items: &[[String; 2]],
    window: &mut Window,
    commands: &mut Vec<Command>,
    ui: &mut Ui,
) {
    let here = (session.recording(), session.step());
    if window.order.0 != here || window.order.1.len() != items.len() {
        // After a first try the order is the one that was given.
        let order = match session.guesses().last() {
            Some(Guess::Order(order)) if order.len() == items.len() => order.clone(),
            _ => (0..items.len()).collect(),
        };
        window.order = (here, order);
    }
    let mut swapped = None;
    for (place, &item) in window.order.1.iter().enumerate() {
        let text = &items[item][session.look.language as usize];
        // By item, so that the keyboard stays with what it moves.
        let id = ui.scope_id().with(("order", item));
        ui.scope_builder(UiBuilder::new().scope_id(id), |ui| {
            let (up, down) = row(session, place, items.len(), text, ui);
            if up {
                swapped = Some(place - 1);
            }
            if down {
                swapped = Some(place);
            }
        });
    }
    if let Some(upper) = swapped {
        window.order.1.swap(upper, upper + 1);
    }
    let check = primary(session, session.localize(strings::CHECK));
    if ui.add(check).clicked() {
        commands.push(Command::Answer(Guess::Order(window.order.1.clone())));
    }
}

/// An item at its place. Returns whether it is to move up, and down.
fn row(session: &Session, place: usize, count: usize, text: &str, ui: &mut Ui) -> (bool, bool) {
    let width = ui.available_width();
    let mut moves = (false, false);
    ui.horizontal_top(|ui| {
        ui.set_width(width);
        let rest = row_end(ui, |ui, _| {
            let up = step(session, "↑", strings::MOVE_UP, text, place > 0, ui);
            let can = place + 1 < count;
            let down = step(session, "↓", strings::MOVE_DOWN, text, can, ui);
            moves = (up.clicked(), down.clicked());
            // At the end of the list the keyboard goes to the button that leads back.
            if moves.0 && place == 1 {
                down.request_focus();
            }
            if moves.1 && place + 2 == count {
                up.request_focus();
            }
        });
        let text = format!("{}. {text}", place + 1);
        let text = egui::Label::new(prose(session, &text, 13.0, Ink::Text)).wrap();
        ui.scope_builder(UiBuilder::new().max_rect(rest), |ui| ui.add(text));
    });
    moves
}

fn step(
    session: &Session,
    sign: &str,
    name: Message,
    item: &str,
    can: bool,
    ui: &mut Ui,
) -> egui::Response {
    let small = Button::new(sign).small();
    let button = ui.add_enabled(can, for_finger(small, ui));
    let name = name.format(session.look.language, &[("item", item)]);
    button.widget_info(|| WidgetInfo::labeled(Role::Button, can, &name));
    match can {
        true => button,
        false => explain_disabled(button, session.localize(strings::AT_ITS_END)),
    }
}
