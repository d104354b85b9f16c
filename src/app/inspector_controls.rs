//! The list of values scrolls.

use super::session::{Command, Session};
use crate::panels::{InspectorView, inspector_scrolled};
use egui::{Key, Response, Ui};
use glam::Vec2;

/// Points of the wheel that scroll by a line.
const LINE: f32 = 20.0;

/// What the wheel and a finger do in the list, and Alt with the arrows.
pub fn pointed(session: &Session, response: &Response, ui: &Ui) -> Option<Command> {
    let view = session.inspector();
    let wheel = match response.hovered() {
        true => ui.input(|input| input.smooth_scroll_delta().y),
        false => 0.0,
    };
    let wheel = -(wheel + response.drag_delta().y) / LINE;
    let has_focus = response.has_focus();
    let pressed = ui.input(|input| match has_focus && input.modifiers.alt {
        true => input.num_presses(Key::ArrowDown) as f32 - input.num_presses(Key::ArrowUp) as f32,
        false => 0.0,
    });
    // Parts of a line add up.
    let id = response.id.with("scrolled");
    let part: f32 = ui.data(|data| data.get_temp(id).unwrap_or_default());
    let by = part + wheel + pressed;
    let lines = by.trunc();
    ui.data_mut(|data| data.insert_temp(id, by - lines));
    if lines == 0.0 {
        return None;
    }
    let size = Vec2::new(response.rect.width(), response.rect.height());
    let wanted = (view.first as f32 + lines).max(0.0) as usize;
    let first = inspector_scrolled(&session.panel_input(), size, wanted);
    (first != view.first).then(|| {
        Command::ViewInspector(InspectorView {
            first,
            ..view.clone()
        })
    })
}
