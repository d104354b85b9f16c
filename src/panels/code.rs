//! The pseudocode, with the line that this step carries out; a listing that was called stands below its caller.

use super::message::{NO_STEPS, message};
use super::{PanelInput, Properties};
use crate::language::{Language, Message};
use crate::picture::{Ink, Picture, Rect, Script, Style, Tag, braced, math, measure};
use crate::record::{Line, Listing};
use crate::replay::Walk;
use glam::Vec2;

const MARGIN: f32 = 8.0;
/// Room for the mark in front of the current line, in sizes of the text.
const GUTTER: f32 = 1.3;
const LINE_HEIGHT: f32 = 1.6;
/// A continued line is set in by so many characters more than the line that it continues.
const HANGING: usize = 4;
const LARGEST: f32 = 16.0;
const SMALLEST: f32 = 11.0;
/// The largest text whose lines are continued on the next rather than made smaller still.
const CONTINUED: f32 = 13.0;

pub const PANEL: Properties = Properties::titled(Message("app-code"));

pub fn draw(input: &PanelInput, size: Vec2) -> Picture {
    let walk = input.run.walk();
    if walk.is_empty() {
        return message(NO_STEPS, input.language, size);
    }
    let blocks = blocks(walk, walk.position());
    let (text_size, rows) = lay_out(&blocks, input.language, size);
    let height = LINE_HEIGHT * text_size;
    let visible = (((size.y - 2.0 * MARGIN) / height) as usize).max(1);
    let current = rows.iter().position(|row| row.mark == Mark::Current);
    let first = current
        .unwrap_or(0)
        .saturating_sub(visible / 2)
        .min(rows.len().saturating_sub(visible));

    let mut picture = Picture::new(size.x, size.y);
    for (i, row) in rows.iter().skip(first).take(visible).enumerate() {
        let y = MARGIN + i as f32 * height;
        let band = Rect::new(2.0, y, size.x - 4.0, height);
        match row.number {
            Some(number) if row.listing == rows[rows.len() - 1].listing => {
                picture.tagged(Tag::Line(number), |picture| {
                    row.draw(picture, band, text_size)
                });
            }
            _ => row.draw(&mut picture, band, text_size),
        }
    }
    let Line { listing, number } = walk.line(walk.position());
    let line = listing.text(number, input.language);
    picture.alt = Message("code-at-line").format(input.language, &[("line", line.trim())]);
    picture
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Mark {
    None,
    /// Where the listing below was called.
    Calling,
    Current,
}

/// The line carried out, and before it the lines that called its listing, outermost first; each listing once.
fn blocks(walk: &dyn Walk, step: usize) -> Vec<Line> {
    let mut blocks = vec![walk.line(step)];
    for scope in walk.outline().scopes(step) {
        let callee = blocks[blocks.len() - 1].listing;
        let line = walk.line(scope);
        if blocks.iter().all(|block| block.listing != line.listing) {
            blocks.push(calling(line, callee));
        }
    }
    blocks.reverse();
    blocks
}

/// The line at or below `scope` that calls `callee` by its name.
fn calling(scope: Line, callee: &Listing) -> Line {
    let call = format!("{}(", callee.name);
    let lines = scope.listing.lines;
    let number = (scope.number..lines.len())
        .find(|&number| lines[number].1.contains(&call))
        .unwrap_or(scope.number);
    Line { number, ..scope }
}

/// A row of the panel: a line of a listing or a part of one; the gap between two listings has no number.
struct Row {
    listing: &'static str,
    number: Option<usize>,
    mark: Mark,
    /// Whether it begins its line.
    begins: bool,
    /// In characters.
    indent: usize,
    text: String,
}

impl Row {
    fn draw(&self, picture: &mut Picture, band: Rect, size: f32) {
        let x = MARGIN + GUTTER * size + self.indent as f32 * measure(" ", Style::Mono, size);
        let (style, ink) = match self.mark {
            Mark::Current => (Style::MonoBold, Ink::Text),
            Mark::Calling => (Style::Mono, Ink::Text),
            Mark::None => (Style::Mono, Ink::Muted),
        };
        match self.mark {
            Mark::Current => picture.rounded_rect(band, 3.0, Ink::ThisTint),
            Mark::Calling => picture.rounded_rect(band, 3.0, Ink::Faint),
            Mark::None => picture,
        };
        if self.number.is_none() {
            let y = band.center().y;
            picture.line(
                (MARGIN, y),
                (band.right() - MARGIN, y),
                Ink::Rule.stroke(1.0),
            );
        }
        if self.mark == Mark::Current && self.begins {
            let mark = Style::Mono.size(size.max(SMALLEST)).ink(Ink::This);
            picture.text_in(
                Rect {
                    x: MARGIN - 2.0,
                    ..band
                },
                "▶",
                mark,
            );
        }
        let base = style.size(size).ink(ink);
        let baseline = band.center().y + base.baseline_below_middle();
        set(&self.text, style, size, |run, at, size| {
            picture.text((x + at.x, baseline + at.y), run, style.size(size).ink(ink));
        });
    }
}

/// The largest text at which all lines fit. Where that is too small, of the calling listings only the lines that call;
/// where that does not do, long lines are continued on the next; where even then not all fit, the smallest text.
fn lay_out(blocks: &[Line], language: Language, size: Vec2) -> (f32, Vec<Row>) {
    let fits = |text_size: f32, rows: &[Row]| {
        rows.len() as f32 * LINE_HEIGHT * text_size <= size.y - 2.0 * MARGIN
    };
    let sizes = |largest: f32| {
        let steps = (largest - SMALLEST) as usize;
        (0..=steps).map(move |i| largest - i as f32)
    };
    let width = |text_size: f32| size.x - 2.0 * MARGIN - GUTTER * text_size;
    let unbroken = |callers: Callers, smallest: f32| {
        let rows = rows(blocks, callers, language, LARGEST, f32::INFINITY);
        let is_narrow = |text_size: f32| {
            rows.iter().all(|row| {
                let indent = row.indent as f32 * measure(" ", Style::Mono, text_size);
                indent + set_width(&row.text, text_size) <= width(text_size)
            })
        };
        let text_size = sizes(LARGEST)
            .take_while(|&text_size| text_size >= smallest)
            .find(|&text_size| fits(text_size, &rows) && is_narrow(text_size))?;
        Some((text_size, rows))
    };
    let continued = |callers: Callers| {
        sizes(CONTINUED)
            .map(|text_size| {
                (
                    text_size,
                    rows(blocks, callers, language, text_size, width(text_size)),
                )
            })
            .find(|(text_size, rows)| fits(*text_size, rows))
    };
    unbroken(Callers::Whole, 12.0)
        .or_else(|| continued(Callers::Whole))
        .or_else(|| unbroken(Callers::CallingLine, 12.0))
        .or_else(|| continued(Callers::CallingLine))
        .unwrap_or_else(|| {
            let rows = rows(
                blocks,
                Callers::CallingLine,
                language,
                SMALLEST,
                width(SMALLEST),
            );
            (SMALLEST, rows)
        })
}

/// How much of a calling listing is shown.
#[derive(Clone, Copy, PartialEq, Debug)]
enum Callers {
    Whole,
    CallingLine,
}

/// The rows of all blocks, lines wider than `width` continued.
fn rows(blocks: &[Line], callers: Callers, language: Language, size: f32, width: f32) -> Vec<Row> {
    let space = measure(" ", Style::Mono, size);
    let mut rows = Vec::new();
    for (i, block) in blocks.iter().enumerate() {
        let current = i + 1 == blocks.len();
        if i > 0 {
            rows.push(Row {
                listing: block.listing.name,
                number: None,
                mark: Mark::None,
                begins: true,
                indent: 0,
                text: String::new(),
            });
        }
        for number in 0..block.listing.lines.len() {
            if !current && callers == Callers::CallingLine && number != block.number {
                continue;
            }
            let line = block.listing.text(number, language);
            let text = line.trim_start();
            let indent = line.len() - text.len();
            let mark = match (number == block.number, current) {
                (true, true) => Mark::Current,
                (true, false) => Mark::Calling,
                (false, _) => Mark::None,
            };
            let first = width - indent as f32 * space;
            let rest = first - HANGING as f32 * space;
            for (part, text) in continued(text, size, first, rest).into_iter().enumerate() {
                rows.push(Row {
                    listing: block.listing.name,
                    number: Some(number),
                    mark,
                    begins: part == 0,
                    indent: indent + if part == 0 { 0 } else { HANGING },
                    text,
                });
            }
        }
    }
    rows
}

/// `text` in parts, the first at most `first` wide, the others `rest`; broken at spaces.
fn continued(text: &str, size: f32, first: f32, rest: f32) -> Vec<String> {
    if set_width(text, size) <= first {
        return vec![text.to_string()];
    }
    let mut parts: Vec<String> = vec![String::new()];
    for word in text.split_whitespace() {
        let width = if parts.len() == 1 { first } else { rest };
        let last = parts.len() - 1;
        let gap = if parts[last].is_empty() { "" } else { " " };
        let longer = format!("{}{gap}{word}", parts[last]);
        if parts[last].is_empty() || set_width(&longer, size) <= width {
            parts[last] = longer;
        } else {
            parts.push(word.to_string());
        }
    }
    parts
}

/// The width of a line as it is set, in bold, which is never narrower.
fn set_width(text: &str, size: f32) -> f32 {
    set(text, Style::MonoBold, size, |_, _, _| ())
}

/// Hands each run of a line to `put` with its place right of and below the line's start, and its size; returns the width.
/// `N_v` and `f_att` get subscripts, `^n` a superscript. No run is smaller than text may be.
fn set(text: &str, style: Style, size: f32, mut put: impl FnMut(String, Vec2, f32)) -> f32 {
    let mut x = 0.0;
    let mut pending = String::new();
    let mut flush = |pending: &mut String, x: &mut f32, drop: f32, size: f32| {
        if !pending.is_empty() {
            let width = measure(pending, style, size);
            put(std::mem::take(pending), Vec2::new(*x, drop), size);
            *x += width;
        }
    };
    for run in math(&braced(text)) {
        let script = (0.75 * size).max(SMALLEST.min(size));
        match run.script {
            Script::Base => pending.push_str(&run.text),
            Script::Sub | Script::Super => {
                flush(&mut pending, &mut x, 0.0, size);
                let drop = if run.script == Script::Sub {
                    0.15
                } else {
                    -0.25
                };
                pending.push_str(&run.text);
                flush(&mut pending, &mut x, drop * size, script);
            }
        }
    }
    flush(&mut pending, &mut x, 0.0, size);
    x
}

#[cfg(test)]
mod tests {
    use super::super::fixtures::{self, SIZES, assert_legible};
    use super::*;
    use crate::picture::Shape;
    use crate::render::Method;

    /// The text on the tint, in all its runs, without spaces.
    fn highlighted(picture: &Picture) -> String {
        let tints: Vec<Rect> = picture
            .items
            .iter()
            .filter_map(|item| match item.shape {
                Shape::Rect { rect, paint, .. } => (paint == Ink::ThisTint.into()).then_some(rect),
                _ => None,
            })
            .collect();
        picture
            .items
            .iter()
            .filter_map(|item| match &item.shape {
                Shape::Text { text, .. } if text != "▶" => tints
                    .iter()
                    .any(|tint| tint.contains(item.shape.bounds().center()))
                    .then_some(text.as_str()),
                _ => None,
            })
            .flat_map(|text| text.split_whitespace())
            .collect()
    }

    #[test]
    fn the_line_that_lights_up_is_the_steps_at_every_step_and_size() {
        for method in Method::ALL {
            let mut fixture = fixtures::fixtures(method);
            for step in fixture.some_steps(997) {
                fixture.seek(step);
                let line = fixture.walk().line(step);
                let expected: String = line
                    .listing
                    .text(line.number, Language::English)
                    .chars()
                    .filter(|c| !matches!(c, ' ' | '_' | '^'))
                    .collect();
                for size in SIZES {
                    let picture = draw(&fixture.show_in(Language::English), size);
                    let what = format!("{} {step} at {size}", fixture.walk().kind(step));
                    assert_eq!(highlighted(&picture), expected, "{what}");
                    assert_legible(&picture, &what);
                }
            }
        }
    }

    #[test]
    fn a_called_listing_stands_below_the_line_that_calls_it() {
        let mut fixture = fixtures::fixtures(Method::Gouraud);
        let step = fixture.first("Diffuse");
        let blocks = blocks(fixture.seek(step).walk(), step);
        let lines: Vec<String> = blocks
            .iter()
            .map(|block| block.listing.text(block.number, Language::English))
            .collect();
        assert_eq!(
            lines,
            [
                "    I_v ← illumination(v, N_v)",
                "    I_d = k_d · I_light · f_att · max(0, N·L)"
            ]
        );
    }

    #[test]
    fn nothing_recorded_is_said() {
        let fixture = fixtures::nothing();
        for language in Language::ALL {
            assert_legible(&draw(&fixture.show_in(language), SIZES[0]), "empty");
        }
    }
}
