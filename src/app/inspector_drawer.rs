//! All values of a step: a search among them, and the list, which scrolls.

use super::cards::{Shown, panel_on};
use super::panel_view::PanelView;
use super::session::{Command, Session};
use super::strings;
use crate::panels::{InspectorView, Panel, inspector_scrolled};
use egui::{Key, Rect, Response, TextEdit, Ui, UiBuilder};
use glam::Vec2;

/// Height of the search.
const SEARCH: f32 = 28.0;
/// Points of the wheel that scroll by a line.
const LINE: f32 = 20.0;

/// Shows the search and the list in `rect`.
pub fn show(
    session: &Session,
    view: &mut PanelView,
    commands: &mut Vec<Command>,
    rect: Rect,
    ui: &mut Ui,
) -> Shown {
    let (mut search, mut list) = (rect, rect);
    search.max.y = rect.min.y + SEARCH.max(ui.spacing().interact_size.y);
    list.min.y = search.max.y;
    let mut row = ui.new_child(UiBuilder::new().max_rect(search.shrink2(egui::vec2(8.0, 2.0))));
    let mut text = session.inspector().search.clone();
    let name = session.localize(strings::SEARCH_VALUES);
    let edit = TextEdit::singleline(&mut text)
        .desired_width(f32::INFINITY)
        .align(egui::Align2::LEFT_CENTER)
        .hint_text(name);
    let response = row.add(edit);
    response.widget_info(|| egui::WidgetInfo {
        label: Some(name.to_owned()),
        ..egui::WidgetInfo::text_edit(true, "", &text, "")
    });
    if text != session.inspector().search {
        commands.push(Command::ViewInspector(InspectorView {
            search: text,
            first: 0,
        }));
    }
    panel_on(session, Panel::Inspector, view, list, ui)
}

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
