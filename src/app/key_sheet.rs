//! The sheet of keys, which `?` opens.

use super::keys::BINDINGS;
use super::session::{Command, Session};
use super::{strings, style};
use crate::language::Message;
use egui::{Grid, Id, Modal, ScrollArea};

/// A narrower window has one column of keys.
const TWO_COLUMNS: f32 = 700.0;
/// Width of the keys of most meanings, and what stands between columns.
const KEYS: f32 = 80.0;
const SPACE: f32 = 18.0;

/// The keys of each meaning, and the meaning.
fn rows() -> Vec<(String, Message)> {
    let mut rows: Vec<(Vec<&str>, Message)> = Vec::new();
    for binding in BINDINGS {
        match rows.iter_mut().find(|row| row.1 == binding.strings) {
            Some((keys, _)) => keys.push(binding.shown),
            None => rows.push((vec![binding.shown], binding.strings)),
        }
    }
    let written = |keys: Vec<&str>| match keys[..] {
        [first, _, .., last] if keys.len() > 2 => format!("{first} – {last}"),
        _ => keys.join(", "),
    };
    let rows = rows.into_iter();
    rows.map(|(keys, meaning)| (written(keys), meaning))
        .collect()
}

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
                    let columns = if room.x < TWO_COLUMNS { 1 } else { 2 };
                    let width = ui.available_width() / columns as f32 - SPACE;
                    Grid::new("keys")
                        .num_columns(2 * columns)
                        .max_col_width(width - KEYS - SPACE)
                        .spacing([SPACE, 5.0])
                        .show(ui, |ui| {
                            let rows = rows();
                            let height = rows.len().div_ceil(columns);
                            for row in 0..height {
                                for (keys, meaning) in rows.iter().skip(row).step_by(height) {
                                    ui.label(style::strong(keys, 13.0));
                                    ui.label(session.localize(*meaning));
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
