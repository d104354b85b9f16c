//! What a node says, line by line.

use super::arrange::{Detail, LINE};
use super::node::{Describer, STRIP, ink, mark, nothing_passes, own_light, sum, too_deep};
use super::strings::*;
use crate::figure::Cell;
use crate::panels::message::labelled;
use crate::picture::{Ink, Picture, Rect, Style, Text};
use crate::replay::rays::RayState;

/// Between a node's border and its text.
const INSET: f32 = 5.0;

/// Lines that a node has more than others of its detail.
pub(super) fn further_lines(ray: &RayState, detail: Detail) -> usize {
    let remarks = usize::from(nothing_passes(ray)) + usize::from(!too_deep(ray).is_empty());
    match detail {
        Detail::Dot => 0,
        Detail::Short | Detail::Stacked | Detail::Brief => remarks,
        Detail::Full => remarks + ray.shadows.len(),
    }
}

/// Writes what a node says, line by line.
pub(super) fn write(
    picture: &mut Picture,
    describer: &Describer,
    rect: Rect,
    ray: Option<&RayState>,
    detail: Detail,
    scale: f32,
) {
    let (line, size) = match detail {
        Detail::Short | Detail::Stacked => (14.0, 11.0),
        _ => (LINE, 12.0),
    };
    let mut writer = Writer {
        left: rect.x + INSET + STRIP + 1.0,
        right: rect.right() - INSET,
        y: rect.y + 3.0 * scale,
        scale,
        line: line * scale,
        picture,
    };
    let bold = Style::Bold.size(size * scale);
    let body = Style::Body.size(11.0 * scale);
    let label = Style::Label.size(11.0 * scale);
    let muted = body.ink(Ink::Muted);
    let Some(ray) = ray else {
        writer.line(
            &[describer.localize(NOT_TRACED), describer.localize(ASKED)],
            muted,
        );
        return;
    };
    let name = describer.name(ray);
    let place = describer.place(ray);
    let marks: Vec<bool> = ray.shadows.iter().map(|verdict| !verdict.blocked).collect();
    let own = own_light(describer, ray);
    let sum = sum(describer, ray);
    match detail {
        Detail::Dot => return,
        Detail::Short => {
            writer.line_and_end(&name, bold, (&place, muted));
            writer.line_and_end(&own, label, (&sum[0], label));
        }
        Detail::Stacked => {
            writer.line_and_end(&name, bold, (&place, muted));
            writer.line(&own, label);
            writer.line(&sum, label);
        }
        Detail::Brief => {
            writer.line_and_marks(&name, bold, &marks);
            writer.line(&[place], body);
            writer.line(&own, label);
            writer.line(&sum, label);
        }
        Detail::Full => {
            writer.line(&name, bold);
            let facing = ray.surface.and_then(|surface| surface.facing);
            let cosine =
                facing.map(|(_, cosine, _)| format!("   cos θ_i {}", describer.number(cosine)));
            let at = place + &cosine.unwrap_or_default();
            writer.line(&[at], label);
            if let Some((normal, ..)) = facing {
                let normal = normal.to_array().map(|v| describer.number(v));
                writer.line(&[format!("N ({})", describer.language.list(normal))], muted);
            }
            for verdict in &ray.shadows {
                let light = describer.light(verdict.light);
                let by = verdict.by.map_or_else(String::new, |hit| {
                    format!(
                        "{}, t {}",
                        describer.object(hit.object),
                        describer.number(hit.t)
                    )
                });
                let mark = mark(!verdict.blocked);
                writer.line(
                    &[format!("{light} {mark} {by}")],
                    body.ink(ink(!verdict.blocked)),
                );
            }
            writer.line(&own, label);
            writer.line(&sum, label);
        }
    }
    writer.remarks(describer, ray);
}

/// Lines of text from the top of a node down.
struct Writer<'a> {
    picture: &'a mut Picture,
    left: f32,
    right: f32,
    y: f32,
    line: f32,
    scale: f32,
}

impl Writer<'_> {
    /// The first of several wordings that fits, else the last, shortened.
    fn line(&mut self, wordings: &[String], set: Text) {
        self.line_up_to(self.right, wordings, set);
    }

    fn line_up_to(&mut self, right: f32, wordings: &[String], set: Text) {
        let place = Rect::new(self.left, self.y, right - self.left, self.line);
        let forms = wordings.iter().map(|text| (text.clone(), set));
        Cell::forms(forms).draw(self.picture, place);
        self.y += self.line;
    }

    /// A line that is so much shorter as the text at its right end needs.
    fn line_and_end(&mut self, wordings: &[String], set: Text, (end, end_set): (&str, Text)) {
        let place = Rect::new(self.left, self.y, self.right - self.left, self.line);
        self.picture.text_in(place, end, end_set.end());
        self.line_up_to(self.right - end_set.width(end) - 5.0, wordings, set);
    }

    /// A line with verdicts at its right end.
    fn line_and_marks(&mut self, wordings: &[String], set: Text, marks: &[bool]) {
        const MOST: usize = 4;
        let bold = Style::Bold.size(12.0 * self.scale);
        let mut right = self.right;
        let counted: Vec<(String, bool)> = if marks.len() <= MOST {
            marks
                .iter()
                .map(|&clear| (mark(clear).to_owned(), clear))
                .collect()
        } else {
            let count = |clear| marks.iter().filter(|&&mark| mark == clear).count();
            [true, false]
                .map(|clear| (format!("{}{}", mark(clear), count(clear)), clear))
                .into()
        };
        for (text, clear) in counted.into_iter().rev() {
            let place = Rect::new(self.left, self.y, right - self.left, self.line);
            right -= bold.width(&text) + 2.0;
            self.picture
                .text_in(place, text, bold.ink(ink(clear)).end());
        }
        self.line_up_to(right - 3.0, wordings, set);
    }

    fn remarks(&mut self, describer: &Describer, ray: &RayState) {
        let set = Style::Body.size(11.0 * self.scale).ink(Ink::Muted);
        if nothing_passes(ray) {
            self.line(&[describer.localize(NO_TRANSMITTED)], set.ink(Ink::Warn));
        }
        let missing = too_deep(ray);
        if !missing.is_empty() {
            let depth = describer.localize(DEPTH_REACHED);
            let missing = labelled(&missing.join(", "), &depth, describer.language);
            self.line(&[missing, depth], set);
        }
    }
}
