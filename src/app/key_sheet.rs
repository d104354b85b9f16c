//! The sheet of keys, which `?` opens.

use super::keys::BINDINGS;
use super::session::{Command, Session};
use super::{strings, style};
use egui::{Grid, Id, Modal, ScrollArea};

pub fn show(session: &Session, commands: &mut Vec<Command>, ctx: &egui::Context) {
    let frame = style::card_frame(session.look.theme);
    let modal = Modal::new(Id::unique("key sheet"))
        .frame(frame)
        .show(ctx, |ui| {
            let room = ctx.content_rect().size();
            ui.set_max_width((room.x - 80.0).min(700.0));
            ui.horizontal(|ui| {
                ui.label(style::strong(session.localize(strings::KEYS_TITLE), 17.0));
                ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
                    if ui.button(session.localize(strings::CLOSE)).clicked() {
                        commands.push(Command::Keys);
                    }
                });
            });
            ui.separator();
            // The sheet's own idea of its height knows nothing of the window.
            ScrollArea::vertical()
                .min_scrolled_height(room.y - 130.0)
                .max_height(room.y - 130.0)
                .show(ui, |ui| {
                    ui.spacing_mut().interact_size.y = 17.0;
                    Grid::new("keys")
                        .num_columns(4)
                        .spacing([18.0, 5.0])
                        .show(ui, |ui| {
                            let half = BINDINGS.len().div_ceil(2);
                            for row in 0..half {
                                for binding in [BINDINGS.get(row), BINDINGS.get(half + row)]
                                    .into_iter()
                                    .flatten()
                                {
                                    ui.label(style::strong(binding.shown, 13.0));
                                    ui.label(session.localize(binding.strings));
                                }
                                ui.end_row();
                            }
                        });
                });
        });
    if modal.should_close() {
        commands.push(Command::Keys);
    }
}
