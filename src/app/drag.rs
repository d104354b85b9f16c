//! How a light is moved by the pointer.

use super::session::{Command, Session};
use super::words;
use crate::lesson::Change;
use crate::panels::{Grip, grip};
use egui::{CursorIcon, Pos2, Response, Ui};
use glam::Vec2;

/// Moves the light that the pointer holds, once a frame; over one that it could hold, says so.
pub fn dragged(session: &Session, response: &Response, ui: &Ui) -> Option<Command> {
    let id = response.id.with("grip");
    let size = Vec2::new(response.rect.width(), response.rect.height());
    let place = |at: Pos2| {
        let at = at - response.rect.min;
        Vec2::new(at.x, at.y)
    };
    let movable = |at: Pos2| {
        let grip = grip(&session.show(), size, place(at))?;
        let moved = Command::Change(Change::Light {
            light: grip.light,
            position: grip.position(place(at)),
        });
        session.allows(&moved).is_ok().then_some(grip)
    };
    if response.drag_started() {
        let origin = ui.input(|input| input.pointer.press_origin());
        let held = origin.and_then(movable);
        ui.data_mut(|data| data.insert_temp(id, held));
    }
    let held = ui.data(|data| data.get_temp::<Option<Grip>>(id)).flatten();
    if response.drag_stopped() {
        ui.data_mut(|data| data.remove::<Option<Grip>>(id));
    }
    if let (Some(grip), Some(at)) = (held, response.interact_pointer_pos()) {
        ui.ctx().set_cursor_icon(CursorIcon::Grabbing);
        return (response.drag_delta() != egui::Vec2::ZERO).then(|| {
            Command::Change(Change::Light {
                light: grip.light,
                position: grip.position(place(at)),
            })
        });
    }
    if response.hover_pos().and_then(movable).is_some() {
        ui.ctx().set_cursor_icon(CursorIcon::Grab);
        response.show_tooltip_text(session.say(words::DRAG_THE_LIGHT));
    }
    None
}
