//! How the ray tree is zoomed and dragged.

use super::button::button;
use super::session::{Command, Session};
use super::strings;
use crate::panels::{tree_area, tree_middle};
use egui::{Button, Response, RichText, Ui};
use glam::Vec2;

/// How much a press of a button zooms.
const PRESS: f32 = 1.5;
/// Points of the wheel that zoom to e times the size.
const WHEEL: f32 = 200.0;

/// Fit, larger and smaller, from the right.
pub fn buttons(session: &Session, commands: &mut Vec<Command>, ui: &mut Ui) {
    ui.spacing_mut().item_spacing.x = 4.0;
    let tree = session.tree();
    for (sign, view, name) in [
        ("−", tree.zoomed(1.0 / PRESS), strings::SMALLER_TREE),
        ("+", tree.zoomed(PRESS), strings::LARGER_TREE),
        (
            session.localize(strings::TREE_FIT),
            tree.fit(),
            strings::WHOLE_TREE,
        ),
    ] {
        let sign = RichText::new(sign).size(13.0);
        let small = Button::new(sign).min_size(egui::vec2(24.0, 22.0));
        let command = Command::ViewTree(view);
        button(
            session,
            small,
            session.localize(name),
            command,
            commands,
            ui,
        );
    }
}

/// What the pointer does in the panel: the wheel and a pinch zoom about it, dragging drags, a double click fits.
pub fn pointed(session: &Session, response: &Response, ui: &Ui) -> Option<Command> {
    let tree = session.tree();
    if response.double_clicked() {
        return Some(Command::ViewTree(tree.fit()));
    }
    let (wheel, pinch) = ui.input(|input| (input.smooth_scroll_delta().y, input.zoom_delta()));
    let factor = pinch * (wheel / WHEEL).exp();
    let drag = response.drag_delta();
    let pointer = response.hover_pos().filter(|_| factor != 1.0);
    if pointer.is_none() && drag == egui::Vec2::ZERO {
        return None;
    }
    let size = Vec2::new(response.rect.width(), response.rect.height());
    let area = tree_area(size);
    let extent = Vec2::new(area.width, area.height);
    let middle = tree_middle(&session.panel_input(), size)?;
    let view = match pointer {
        Some(at) => {
            let at = at - response.rect.min;
            let from_middle = Vec2::new(at.x, at.y) - area.center();
            tree.zoomed_about(factor, middle, from_middle, extent)
        }
        None => tree.dragged(Vec2::new(drag.x, drag.y), middle, extent),
    };
    (view != *tree).then_some(Command::ViewTree(view))
}
