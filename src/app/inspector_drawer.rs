//! All values of a step: a search among them, and the list, which scrolls.

use super::panel_on::{PanelResponse, panel_on};
use super::panel_view::PanelView;
use super::session::{Command, Session};
use super::strings;
use crate::panels::{InspectorView, Panel};
use egui::{Rect, TextEdit, Ui, UiBuilder};

/// Height of the search.
const SEARCH: f32 = 28.0;

/// Shows the search and the list in `rect`.
pub fn show(
    session: &Session,
    view: &mut PanelView,
    commands: &mut Vec<Command>,
    rect: Rect,
    ui: &mut Ui,
) -> PanelResponse {
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
