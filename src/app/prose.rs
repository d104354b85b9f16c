//! Text with symbols.

use super::session::Session;
use super::style;
use crate::picture::{self, Ink, Script};
use egui::text::{LayoutJob, TextFormat};
use egui::{Align, FontFamily, FontId};

/// A text whose symbols (`I_4`, `x_P`) are set as the panels set them, and its code in type of equal width.
pub fn prose(session: &Session, text: &str, size: f32, ink: Ink) -> LayoutJob {
    set(session, text, FontId::proportional(size), ink)
}

/// As [`prose`], in any font.
pub fn set(session: &Session, text: &str, font: FontId, ink: Ink) -> LayoutJob {
    let mut job = LayoutJob::default();
    for run in picture::prose(text) {
        // A line height of its own would put an index into the middle of the line, so that it could be neither low nor high.
        let (scale, line_height, valign) = match run.script {
            Script::Base => (1.0, Some(1.45 * font.size), Align::Center),
            Script::Sub => (0.72, None, Align::BOTTOM),
            Script::Super => (0.72, None, Align::TOP),
        };
        let family = match run.code {
            true => FontFamily::Monospace,
            false => font.family.clone(),
        };
        let format = TextFormat {
            font_id: FontId::new(scale * font.size, family),
            color: style::color(session.look.theme, ink),
            line_height,
            valign,
            ..TextFormat::default()
        };
        job.append(&run.text, 0.0, format);
    }
    job
}
