//! Why the last command did nothing, or what it did: over the lower border of the panels, until the next command.

use super::announced::announced;
use super::session::Session;
use super::window_state::Window;
use super::{strings, style};
use crate::picture::Ink;
use egui::{Align2, Area, Frame, Id, Label, Margin, RichText, Stroke, Ui};

/// Shows the notice with its lower right corner at `corner`.
pub fn show(session: &Session, window: &Window, corner: egui::Pos2, ui: &Ui) {
    let truncated = session.walk().truncated();
    let truncated = truncated.then(|| session.localize(strings::TRUNCATED));
    let Some(text) = window.notice.as_deref().or(truncated) else {
        return;
    };
    let ink = |ink| style::color(session.look.theme, ink);
    let area = Area::new(Id::unique("notice"))
        .pivot(Align2::RIGHT_BOTTOM)
        .fixed_pos(corner)
        .interactable(false);
    area.show(ui.ctx(), |ui| {
        let frame = Frame::new()
            .fill(ink(Ink::WarnTint))
            .stroke(Stroke::new(1.0, ink(Ink::Warn)))
            .corner_radius(4)
            .inner_margin(Margin::symmetric(10, 6));
        frame.show(ui, |ui| {
            let room = ui.ctx().content_rect().width() - 48.0;
            ui.set_max_width(room.min(420.0));
            let text = RichText::new(text).size(13.0).color(ink(Ink::Text));
            announced(ui.add(Label::new(text).wrap()));
        });
    });
}
