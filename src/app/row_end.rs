//! What stands at the end of a row, laid out from left to right, so that the focus goes through it as one reads.

use egui::{Align, Layout, Rect, Ui, UiBuilder, pos2};

/// Puts `contents` at the right end of the row that `ui` is; it is given the room that there is. Returns what is left of the row before
/// it. Its width is that of the frame before, which is done again where the two differ.
pub fn row_end(ui: &mut Ui, contents: impl FnOnce(&mut Ui, f32)) -> Rect {
    let id = ui.scope_id().with("row end");
    let row = ui.available_rect_before_wrap();
    let known = ui.data(|data| data.get_temp(id)).unwrap_or(0.0_f32);
    let left = (row.right() - known).max(row.left());
    // As wide as the row, so that nothing becomes narrower by what was known.
    let place = Rect::from_min_size(pos2(left, row.top()), row.size());
    let layout = Layout::left_to_right(ui.layout().vertical_align());
    let mut end = ui.new_child(UiBuilder::new().max_rect(place).layout(layout));
    contents(&mut end, row.width());
    let width = end.min_rect().width();
    if (width - known).abs() > 0.5 {
        ui.data_mut(|data| data.insert_temp(id, width));
        ui.ctx()
            .request_discard("the end of a row has another width");
    }
    ui.advance_cursor_after_rect(end.min_rect());
    let gap = ui.spacing().item_spacing.x;
    Rect::from_min_max(row.min, pos2((left - gap).max(row.left()), row.bottom()))
}

/// Puts `contents` into what is left of a row, from its right.
pub fn before_end(rest: Rect, ui: &mut Ui, contents: impl FnOnce(&mut Ui)) {
    let layout = Layout::right_to_left(Align::Center);
    contents(&mut ui.new_child(UiBuilder::new().max_rect(rest).layout(layout)));
}
