//! The menu of what can be taken away: a row for each, with a button for each kind of file.

use super::button::button;
use super::session::{Command, Session};
use super::{strings, style};
use crate::export::TakeAway;
use egui::{Align, Button, Grid, Label, Layout, RichText, ScrollArea, Ui};

/// Of the hint under the rows.
const WIDTH: f32 = 330.0;

pub fn show(session: &Session, commands: &mut Vec<Command>, ui: &mut Ui) {
    ui.menu_button(session.localize(strings::TAKE_AWAY), |ui| {
        // As the buttons of the rest of the window look.
        ui.set_style(ui.ctx().global_style());
        let room = ui.ctx().content_rect();
        ui.set_max_width(WIDTH.min(room.width() - 24.0));
        style::beside_scroll_bar(ui);
        ScrollArea::vertical()
            .max_height(room.height() - 80.0)
            .show(ui, |ui| {
                let layout = Layout::top_down(Align::Min);
                ui.with_layout(layout, |ui| entries(session, commands, ui));
            });
    });
}

fn entries(session: &Session, commands: &mut Vec<Command>, ui: &mut Ui) {
    let copy = session.localize(strings::COPY_PICTURE);
    let command = Command::CopyPicture;
    button(session, Button::new(copy), copy, command, commands, ui);
    ui.separator();
    Grid::new("take_away").num_columns(2).show(ui, |ui| {
        for what in TakeAway::ALL {
            let title = session.localize(what.title());
            ui.add(Label::new(title));
            ui.horizontal(|ui| {
                for ending in what.endings() {
                    let kind = ending.to_uppercase();
                    let name = format!("{title} ({kind})");
                    let take = Command::TakeAway(what, ending);
                    button(session, Button::new(kind), &name, take, commands, ui);
                }
            });
            ui.end_row();
        }
    });
    ui.separator();
    let hint = RichText::new(session.localize(strings::TAKE_PINNED)).size(12.0);
    ui.add(Label::new(hint).wrap());
}
