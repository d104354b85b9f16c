//! What is said about something under the pointer.

use egui::{Rect, RectAlign, Response, Tooltip, Vec2, WidgetText};

/// Half the side of what the pointer itself takes.
const POINTER: f32 = 14.0;
const BESIDE: [RectAlign; 3] = [
    RectAlign::LEFT_START,
    RectAlign::BOTTOM_START,
    RectAlign::TOP_START,
];

/// Says more about what is under the pointer and has those bounds, beside it, so that it is not covered; beside the pointer where there are
/// none.
pub fn said_beside(response: &Response, what: Option<Rect>, text: impl Into<WidgetText>) {
    let at_pointer = || {
        let pointer = response.hover_pos()?;
        Some(Rect::from_center_size(pointer, Vec2::splat(2.0 * POINTER)))
    };
    let Some(what) = what.or_else(at_pointer) else {
        return;
    };
    let mut tooltip = Tooltip::for_enabled(response);
    tooltip.popup = tooltip
        .popup
        .anchor(what)
        .align(RectAlign::RIGHT_START)
        .align_alternatives(&BESIDE);
    tooltip.show(|ui| ui.label(text));
}
