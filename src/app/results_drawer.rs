//! What a search has found, as a list: the step, what it does, and the scopes that it lies in.

use super::prose::prose;
use super::session::{Command, Session};
use super::style;
use crate::picture::Ink;
use egui::{Label, Rect, RichText, ScrollArea, Sense, Ui, UiBuilder};

/// Shows the list in `rect`; a click goes to the step.
pub fn show(session: &Session, commands: &mut Vec<Command>, rect: Rect, ui: &mut Ui) {
    let Some(results) = session.results() else {
        return;
    };
    let theme = session.look.theme;
    let mut ui = ui.new_child(UiBuilder::new().max_rect(rect.shrink2(egui::vec2(8.0, 2.0))));
    ScrollArea::vertical()
        .auto_shrink(false)
        .show(&mut ui, |ui| {
            ui.spacing_mut().item_spacing.y = 2.0;
            for row in &results.rows {
                let current = row.step == session.step();
                let ink = if current { Ink::This } else { Ink::Linked };
                let head = format!("{}  {}", row.step, row.title);
                let head = style::strong(head, 13.0).color(style::color(theme, ink));
                if ui.add(Label::new(head).sense(Sense::click())).clicked() {
                    commands.push(Command::Seek(row.step));
                }
                ui.label(prose(session, &row.sentence, 13.0, Ink::Text));
                if !row.scopes.is_empty() {
                    let muted = style::color(theme, Ink::Muted);
                    ui.label(RichText::new(&row.scopes).size(12.0).color(muted));
                }
                ui.add_space(8.0);
            }
            if let Some(end) = session.results_end() {
                ui.label(prose(session, &end, 13.0, Ink::Muted));
            }
        });
}
