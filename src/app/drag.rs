//! How things of the scene are moved by the pointer, and how the arrow is turned that a question asks for.

use super::parameter_drawer::place_name;
use super::session::{Command, Session};
use super::{strings, style};
use crate::lesson::Change;
use crate::panels::{Grip, Handle, Panel, PlaneGrip, degrees_toward, handles, vector_grip};
use crate::picture::Ink;
use crate::scene::Movable;
use egui::{CursorIcon, Pos2, Response, Stroke, Ui};
use glam::Vec2;

/// How near the pointer must be to a handle for it to be shown, in points.
const NEAR: f32 = 120.0;
/// Radius of a handle: around the disc of a vertex, whose number stays to be read.
const HANDLE: f32 = 11.5;

/// What the pointer holds, and in which kind of panel.
#[derive(Clone, Copy)]
enum Hold {
    Thing(Grip),
    Vector(PlaneGrip),
}

impl Hold {
    fn at(session: &Session, panel: Panel, shown: &[Handle], size: Vec2, at: Vec2) -> Option<Self> {
        match panel {
            Panel::Vectors => {
                let grip = vector_grip(&session.panel_input(), size, at)?;
                session.may_move(grip.held).then_some(Hold::Vector(grip))
            }
            _ => Grip::nearest(shown, at).map(Hold::Thing),
        }
    }

    fn of(&self) -> Movable {
        match self {
            Hold::Thing(grip) => grip.of(),
            Hold::Vector(grip) => grip.held,
        }
    }

    /// Once the pointer is at `at`.
    fn change(&self, at: Vec2) -> Change {
        Change::Place {
            of: self.of(),
            position: match self {
                Hold::Thing(grip) => grip.position(at),
                Hold::Vector(grip) => grip.position(at),
            },
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

/// Moves what the pointer holds in a panel, once a frame; shows what it could hold near it. Returns whether it
/// holds something.
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
    let held = ui.data(|data| data.get_temp::<Option<Hold>>(id)).flatten();
    let hovered = response.hover_pos().map(place);
    let shown = match hovered.is_some() || held.is_some() || response.drag_started() {
        true => handles(panel, &session.panel_input(), size, session.movable()),
        false => Vec::new(),
    };
    if response.drag_started() {
        let origin = ui.input(|input| input.pointer.press_origin()).map(place);
        let held = origin.and_then(|at| Hold::at(session, panel, &shown, size, at));
        ui.data_mut(|data| data.insert_temp(id, held));
    }
    let held = ui.data(|data| data.get_temp::<Option<Hold>>(id)).flatten();
    if response.drag_stopped() {
        ui.data_mut(|data| data.remove::<Option<Hold>>(id));
    }
    let hovers = hovered.and_then(|at| Hold::at(session, panel, &shown, size, at));
    let near = held.or(hovers).map(|hold| hold.of());
    show(session, &shown, hovered, near, response, ui);
    if let (Some(hold), Some(at)) = (held, response.interact_pointer_pos()) {
        ui.ctx().set_cursor_icon(CursorIcon::Grabbing);
        if response.drag_delta() != egui::Vec2::ZERO {
            *command = Some(Command::Change(hold.change(place(at))));
        }
        return true;
    }
    if let Some(hold) = hovers {
        ui.ctx().set_cursor_icon(CursorIcon::Grab);
        response.show_tooltip_text(can_be_dragged(session, hold.of()));
    }
    false
}

/// The handles near the pointer, as rings: a bold one around what can be taken or is held.
fn show(
    session: &Session,
    handles: &[Handle],
    pointer: Option<Vec2>,
    near: Option<Movable>,
    response: &Response,
    ui: &Ui,
) {
    let painter = ui.painter().with_clip_rect(response.rect);
    let color = |ink| style::color(session.look.theme, ink);
    for handle in handles {
        let is_near = near == Some(handle.of);
        let is_close = pointer.is_some_and(|at| at.distance(handle.at) < NEAR);
        if !is_near && !is_close {
            continue;
        }
        let at = response.rect.min + egui::vec2(handle.at.x, handle.at.y);
        let width = if is_near { 4.0 } else { 1.5 };
        // Dark in light, so that it is seen on whatever the picture shows.
        let around = Stroke::new(width + 2.0, color(Ink::Surface));
        painter.circle_stroke(at, HANDLE, around);
        painter.circle_stroke(at, HANDLE, Stroke::new(width, color(Ink::Linked)));
    }
}

fn can_be_dragged(session: &Session, of: Movable) -> String {
    let thing = place_name(session, of);
    strings::DRAG.format(session.look.language, &[("thing", &thing)])
}
