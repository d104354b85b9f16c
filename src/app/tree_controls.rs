//! How a figure is zoomed and dragged: by the pointer, and the ray tree by buttons too.

use super::button;
use super::session::{Command, Session};
use super::strings;
use crate::figure::View;
use crate::panels::node_near;
use crate::picture::Rect;
use egui::{Response, Ui};
use glam::Vec2;

/// How much a press of a button zooms.
const PRESS: f32 = 1.5;
/// Points of the wheel that zoom to e times the size.
const WHEEL: f32 = 200.0;

/// Pin or unpin, fit, larger and smaller.
pub fn buttons(session: &Session, commands: &mut Vec<Command>, ui: &mut Ui) {
    ui.spacing_mut().item_spacing.x = 4.0;
    let (sign, name) = match session.pinned() {
        Some(_) => (strings::UNPIN, strings::UNPIN_TREE),
        None => (strings::PIN, strings::PIN_TREE),
    };
    let pin = session.localize(sign);
    button::sign(session, pin, name, Command::Pin, commands, ui);
    let tree = session.tree();
    for (sign, view, name) in [
        (
            session.localize(strings::TREE_FIT),
            tree.fitted(),
            strings::WHOLE_TREE,
        ),
        ("+", tree.zoomed(PRESS, tree.held), strings::LARGER_TREE),
        (
            "−",
            tree.zoomed(1.0 / PRESS, tree.held),
            strings::SMALLER_TREE,
        ),
    ] {
        let command = Command::ViewTree(view);
        button::sign(session, sign, name, command, commands, ui);
    }
}

/// What the pointer does in the ray tree: it holds the node that is nearest.
pub fn pointed(session: &Session, response: &Response, ui: &Ui) -> Option<Command> {
    let tree = session.tree();
    let size = Vec2::new(response.rect.width(), response.rect.height());
    let held = || {
        let at = response.hover_pos()? - response.rect.min;
        node_near(&session.panel_input(), size, Vec2::new(at.x, at.y))
    };
    let factor = factor(ui);
    let drag = response.drag_delta();
    let changed = if response.double_clicked() {
        tree.fitted()
    } else if response.hovered() && factor != 1.0 {
        tree.zoomed(factor, held())
    } else if drag != egui::Vec2::ZERO {
        tree.dragged(Vec2::new(drag.x, drag.y), held()?)
    } else {
        return None;
    };
    (changed != *tree).then_some(Command::ViewTree(changed))
}

/// How much the wheel and a pinch zoom.
fn factor(ui: &Ui) -> f32 {
    let (wheel, pinch) = ui.input(|input| (input.smooth_scroll_delta().y, input.zoom_delta()));
    pinch * (wheel / WHEEL).exp()
}

/// The wheel and a pinch zoom about the pointer, dragging drags. The figure stands in `area` of what is pointed at,
/// with `middle` in its middle. None where nothing changes.
pub fn looked_at(
    view: View,
    middle: impl FnOnce() -> Option<Vec2>,
    area: Rect,
    response: &Response,
    ui: &Ui,
) -> Option<View> {
    let factor = factor(ui);
    let drag = response.drag_delta();
    let extent = Vec2::new(area.width, area.height);
    let changed = if let Some(at) = response.hover_pos().filter(|_| factor != 1.0) {
        let at = at - response.rect.min;
        let from_middle = Vec2::new(at.x, at.y) - area.center();
        view.zoomed_about(factor, middle()?, from_middle, extent)
    } else if drag != egui::Vec2::ZERO {
        view.dragged(Vec2::new(drag.x, drag.y), middle()?, extent)
    } else {
        view
    };
    (changed != view).then_some(changed)
}
