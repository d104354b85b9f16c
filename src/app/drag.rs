//! How a light or the eye is moved by the pointer, and how the arrow is turned that a question asks for.

use super::session::{Command, Session};
use super::strings;
use crate::lesson::Change;
use crate::panels::{Grip, Held, Panel, PlaneGrip, degrees_toward, grip, vector_grip};
use egui::{CursorIcon, Pos2, Response, Ui};
use glam::Vec2;

/// What the pointer holds, and in which panel.
#[derive(Clone, Copy)]
enum Hold {
    Space(Grip),
    Vectors(PlaneGrip),
}

impl Hold {
    fn at(session: &Session, panel: Panel, size: Vec2, at: Vec2) -> Option<Self> {
        let show = session.panel_input();
        match panel {
            Panel::Space => grip(&show, size, at).map(Hold::Space),
            Panel::Vectors => vector_grip(&show, size, at).map(Hold::Vectors),
            _ => None,
        }
    }

    /// Once the pointer is at `at`.
    fn change(&self, at: Vec2) -> Change {
        let (held, position) = match self {
            Hold::Space(grip) => (Held::Light(grip.light), grip.position(at)),
            Hold::Vectors(grip) => (grip.held, grip.position(at)),
        };
        match held {
            Held::Light(light) => Change::Light { light, position },
            Held::Eye => Change::Eye { position },
        }
    }
}

/// Turns the arrow that is asked for toward the pointer, while it is pressed in the vectors panel.
pub fn turned(session: &Session, response: &Response) -> Option<Command> {
    let pressed = response.is_pointer_button_down_on() || response.clicked();
    let at = response.interact_pointer_pos().filter(|_| pressed)? - response.rect.min;
    let size = Vec2::new(response.rect.width(), response.rect.height());
    let degrees = degrees_toward(&session.panel_input(), size, Vec2::new(at.x, at.y))?;
    (session.arrow_asked() != Some(degrees)).then_some(Command::Turn(degrees))
}

/// Moves what the pointer holds in a panel, once a frame; over something that it could hold, says so. Returns whether it holds
/// something.
pub fn dragged(
    session: &Session,
    panel: Panel,
    response: &Response,
    command: &mut Option<Command>,
    ui: &Ui,
) -> bool {
    let id = response.id.with("grip");
    let size = Vec2::new(response.rect.width(), response.rect.height());
    let place = |at: Pos2| {
        let at = at - response.rect.min;
        Vec2::new(at.x, at.y)
    };
    let movable = |at: Pos2| {
        let hold = Hold::at(session, panel, size, place(at))?;
        let moved = Command::Change(hold.change(place(at)));
        session.allows(&moved).is_ok().then_some(hold)
    };
    if response.drag_started() {
        let origin = ui.input(|input| input.pointer.press_origin());
        let held = origin.and_then(movable);
        ui.data_mut(|data| data.insert_temp(id, held));
    }
    let held = ui.data(|data| data.get_temp::<Option<Hold>>(id)).flatten();
    if response.drag_stopped() {
        ui.data_mut(|data| data.remove::<Option<Hold>>(id));
    }
    if let (Some(hold), Some(at)) = (held, response.interact_pointer_pos()) {
        ui.ctx().set_cursor_icon(CursorIcon::Grabbing);
        if response.drag_delta() != egui::Vec2::ZERO {
            *command = Some(Command::Change(hold.change(place(at))));
        }
        return true;
    }
    if let Some((at, hold)) = response.hover_pos().and_then(|at| Some((at, movable(at)?))) {
        ui.ctx().set_cursor_icon(CursorIcon::Grab);
        let strings = match hold.change(place(at)) {
            Change::Eye { .. } => strings::DRAG_THE_EYE,
            _ => strings::DRAG_THE_LIGHT,
        };
        response.show_tooltip_text(session.localize(strings));
    }
    false
}
