//! The window of a phone: one column, and everything as large as a finger needs it.

use super::button::for_finger;
use super::cards::{numbered, show_drawer};
use super::layout::{MARGIN, Narrow};
use super::panel_on::panel_on;
use super::session::{Command, Session};
use super::window_state::Window;
use super::{narration, notice, strings, style, transport};
use crate::panels::Panel;
use crate::picture::Tag;
use egui::{Button, Rect, Role, ScrollArea, Ui, UiBuilder, Vec2, WidgetInfo};

/// Shows everything below the bar of the window `whole`; returns what lies under the pointer.
pub fn show(
    session: &mut Session,
    window: &mut Window,
    whole: Rect,
    commands: &mut Vec<Command>,
    ui: &mut Ui,
) -> Option<Tag> {
    let placed = Narrow::new(whole.size()).shifted(whole.min.to_vec2());
    transport::show_narrow(session, window, commands, placed.walk, ui);
    notice::show(
        session,
        window,
        placed.walk.right_top() - Vec2::splat(MARGIN),
        ui,
    );
    if let Some(drawer) = session.look.drawer {
        let rect = placed.above_walk();
        let under = show_drawer(session, &mut window.views, drawer, rect, commands, ui);
        window.write_lesson(session, rect, ui);
        return under;
    }
    names(session, placed.names, commands, ui);
    let under = narration::show(session, window, placed.column, commands, ui);
    let Some(key) = session.key_panel() else {
        return under;
    };
    style::card(session.look.theme, placed.key, ui);
    let view = window.views.entry(key).or_default();
    let shown = panel_on(session, key, view, placed.key.shrink(MARGIN), ui);
    if shown.filled {
        commands.push(Command::Fill);
    }
    commands.extend(shown.command);
    shown.under.or(under)
}

/// The names of the panels in one row, which a finger moves; the one that is shown is chosen.
fn names(session: &Session, place: Rect, commands: &mut Vec<Command>, ui: &mut Ui) {
    let key = session.key_panel();
    let id = ui.scope_id().with("chosen");
    let shown_before: Option<Panel> = ui.data_mut(|data| data.get_temp(id)).flatten();
    ui.data_mut(|data| data.insert_temp(id, key));
    let mut ui = ui.new_child(UiBuilder::new().max_rect(place));
    ScrollArea::horizontal()
        .id_salt("names")
        .show(&mut ui, |ui| {
            ui.horizontal(|ui| {
                ui.spacing_mut().item_spacing.x = 4.0;
                for panel in session.panels() {
                    let chosen = key == Some(panel);
                    let title = session.localize(panel.title());
                    let name = strings::ENLARGE.format(session.look.language, &[("panel", title)]);
                    let shown = Button::new(numbered(session, panel)).selected(chosen);
                    let response = ui.add(for_finger(shown, ui));
                    response
                        .widget_info(|| WidgetInfo::selected(Role::Button, true, chosen, &name));
                    if response.clicked() && !chosen {
                        commands.push(Command::Key(panel));
                    }
                    // Once: then the row stays where the finger moves it.
                    if chosen && shown_before != key {
                        response.scroll_to_me(None);
                    }
                }
            });
        });
}
