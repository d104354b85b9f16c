//! Why the last command did nothing, or what it did: over the lower border of the panels, until the next command. Also how far the files
//! are that are being made, each of which can be cancelled.

use super::announced::announced;
use super::session::Session;
use super::window_state::Window;
use super::{strings, style};
use crate::picture::Ink;
use egui::{Align2, Area, Frame, Id, Label, Margin, ProgressBar, RichText, Stroke, Ui};

/// Shows the notice with its lower right corner at `corner`.
pub fn show(session: &Session, window: &Window, corner: egui::Pos2, ui: &Ui) {
    let truncated = session.walk().truncated();
    let truncated = truncated.then(|| session.localize(strings::TRUNCATED));
    let text = window.notice.as_deref().or(truncated);
    if text.is_none() && window.taking.is_empty() {
        return;
    }
    let ink = |ink| style::color(session.look.theme, ink);
    let area = Area::new(Id::unique("notice"))
        .pivot(Align2::RIGHT_BOTTOM)
        .fixed_pos(corner)
        .interactable(!window.taking.is_empty());
    area.show(ui.ctx(), |ui| {
        let frame = Frame::new()
            .fill(ink(Ink::WarnTint))
            .stroke(Stroke::new(1.0, ink(Ink::Warn)))
            .corner_radius(4)
            .inner_margin(Margin::symmetric(10, 6));
        frame.show(ui, |ui| {
            let room = ui.ctx().content_rect().width() - 48.0;
            ui.set_max_width(room.min(420.0));
            let set = |text: &str| RichText::new(text).size(13.0).color(ink(Ink::Text));
            if let Some(text) = text {
                announced(ui.add(Label::new(set(text)).wrap()));
            }
            for taking in &window.taking {
                let percent = taking.work.percent().unwrap_or(100);
                ui.label(set(&taking.name));
                ui.horizontal(|ui| {
                    let bar = ProgressBar::new(percent as f32 / 100.0).desired_width(220.0);
                    ui.add(bar.text(format!("{percent} %")));
                    if ui.button(session.localize(strings::CALL_OFF)).clicked() {
                        taking.work.cancel();
                    }
                });
            }
        });
    });
}
