//! Asks before the progress in all lessons is forgotten.

use super::session::{Command, Session, Sheet};
use super::{strings, style};
use egui::{Id, Modal};

pub fn show(session: &Session, commands: &mut Vec<Command>, ctx: &egui::Context) {
    let frame = style::card_frame(session.look.theme);
    let modal = Modal::new(Id::unique("forget"))
        .frame(frame)
        .show(ctx, |ui| {
            ui.set_max_width((ctx.content_rect().width() - 60.0).min(420.0));
            ui.label(style::strong(session.localize(strings::FORGET_IT), 17.0));
            ui.label(session.localize(strings::FORGET_WHAT));
            ui.add_space(6.0);
            ui.horizontal_wrapped(|ui| {
                let keep = ui.button(session.localize(strings::KEEP_IT));
                if ui.memory(|memory| memory.focused().is_none()) {
                    keep.request_focus();
                }
                if keep.clicked() {
                    commands.push(Command::Sheet(Sheet::Forget));
                }
                if ui.button(session.localize(strings::FORGET_IT)).clicked() {
                    commands.push(Command::Forget);
                }
            });
        });
    if modal.should_close() && commands.is_empty() {
        commands.push(Command::Sheet(Sheet::Forget));
    }
}
