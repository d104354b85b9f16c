//! How a figure is zoomed and dragged: by the pointer, and the ray tree by buttons too.

use super::button;
use super::session::{Command, Session};
use super::strings;
use crate::figure::View;
use crate::panels::{tree_area, tree_middle};
use crate::picture::Rect;
use egui::{Response, Ui};
use glam::Vec2;

/// How much a press of a button zooms.
const PRESS: f32 = 1.5;
/// Points of the wheel that zoom to e times the size.
const WHEEL: f32 = 200.0;

/// Fit, larger and smaller.
pub fn buttons(session: &Session, commands: &mut Vec<Command>, ui: &mut Ui) {
    ui.spacing_mut().item_spacing.x = 4.0;
    let shown = session.tree().shown;
    for (sign, view, name) in [
        (
            session.localize(strings::TREE_FIT),
            View::WHOLE,
            strings::WHOLE_TREE,
        ),
        ("+", shown.zoomed(PRESS), strings::LARGER_TREE),
        ("−", shown.zoomed(1.0 / PRESS), strings::SMALLER_TREE),
    ] {
        let command = Command::ViewTree(session.tree().showing(view));
        button::sign(session, sign, name, command, commands, ui);
    }
}

/// What the pointer does in the ray tree.
pub fn pointed(session: &Session, response: &Response, ui: &Ui) -> Option<Command> {
    let tree = session.tree();
    let size = Vec2::new(response.rect.width(), response.rect.height());
    let middle = || tree_middle(&session.panel_input(), size);
    let view = match response.double_clicked() {
        true => View::WHOLE,
        false => looked_at(tree.shown, middle, tree_area(size), response, ui)?,
    };
    Some(Command::ViewTree(tree.showing(view)))
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
    let (wheel, pinch) = ui.input(|input| (input.smooth_scroll_delta().y, input.zoom_delta()));
    let factor = pinch * (wheel / WHEEL).exp();
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
