//! Intensity along one scan line by several methods: the luminance itself, its slope, and how bright it looks. A jump of the slope is
//! seen as a band that is in no pixel: a Mach band.

use super::PanelInput;
use super::comparison::cursor::Cursor;
use super::message::{NOT_COMPARED, message};
use super::values::told_in_words;
use crate::language::{Language, Message};
use crate::methods::Method;
use crate::picture::{Ink, Picture, Rect, Stroke, Style, elide};
use crate::render::compare::{Compared, SideBySide};
use glam::Vec2;
use std::ops::Range;

const MARGIN: f32 = 8.0;
const TEXT: f32 = 11.0;
const ROW: f32 = 16.0;
/// Pixels to the left and right of what is drawn.
const AROUND: u32 = 4;
/// With more points the least and the most of several stand for all.
const MOST_POINTS: usize = 220;
/// A slope so many times as steep as those on both sides of it is a jump of the value.
const JUMP: f64 = 2.0;

const INTENSITY: Message = Message("profile-intensity");
const SLOPE: Message = Message("profile-slope");
const SEEN: Message = Message("profile-seen");
const LINE: Message = Message("profile-line");
const LARGEST_JUMP: Message = Message("profile-largest-jump");

pub fn draw(input: &PanelInput, size: Vec2) -> Picture {
    let compared = &input.finished.compared;
    let Some(first) = compared.pictures().first() else {
        return message(NOT_COMPARED, input.language, size);
    };
    let localize = |strings: Message| strings.text(input.language);
    let cursor = Cursor::of(input);
    let row = cursor.row(&first.frame);
    let profiles: Vec<Profile> = compared
        .shaded()
        .map(|(number, compared)| Profile::of(number, compared, row))
        .collect();
    let columns = columns(compared, row, first.frame.width);
    let mut picture = Picture::new(size.x, size.y);
    let whole = picture.bounds().grown(-MARGIN);
    let title = Rect {
        height: ROW,
        ..whole
    };
    let caption = format!("{} y = {row}", localize(LINE));
    let style = Style::Bold.size(TEXT).ink(Ink::This);
    picture.text_in(title, caption.clone(), style);
    let beside = title.x + style.width(&caption) + 14.0;
    let below = legend(
        &mut picture,
        &profiles,
        Rect {
            x: beside,
            width: whole.right() - beside,
            ..title
        },
        whole.x,
    );
    let whole = Rect {
        y: below - ROW,
        height: whole.bottom() - below + ROW,
        ..whole
    };

    // What is drawn, and what the strip has room for
    let fields: [(Message, Values, Values); 3] = [
        (
            INTENSITY,
            |profile| &profile.intensity,
            |profile| &profile.intensity,
        ),
        (SLOPE, |profile| &profile.slope, |profile| &profile.gentle),
        (SEEN, |profile| &profile.seen, |profile| &profile.seen),
    ];
    let height = (whole.height - 2.0 * ROW) / fields.len() as f32;
    let ranges = fields.map(|(_, _, room)| range(profiles.iter().map(room), &columns));
    // One margin for all, so that the same column stands above itself.
    let numbers = ranges.iter().flat_map(|&(low, high)| [low, high]);
    let style = Style::Body.size(TEXT);
    let widths = numbers.map(|end| style.width(&input.language.significant(end, 3)));
    let left = widths.fold(0.0, f32::max) + 8.0;
    for (strip, ((strings, values, _), (low, high))) in fields.into_iter().zip(ranges).enumerate() {
        let field = Field {
            place: Rect::new(
                whole.x + left,
                whole.y + 2.0 * ROW + height * strip as f32,
                (whole.width - left - 4.0).max(1.0),
                (height - ROW - 4.0).max(1.0),
            ),
            columns: columns.clone(),
            low,
            high,
        };
        field.frame(&mut picture, localize(strings), cursor.x, input.language);
        for profile in &profiles {
            field.curve(&mut picture, profile, values(profile));
        }
        if strip + 1 == 3 {
            field.pixels(&mut picture);
        }
    }
    let jumps = profiles.iter().map(|profile| {
        let name = profile.method.name();
        format!(
            "{name}: {} {}",
            localize(LARGEST_JUMP),
            input.language.significant(profile.jump, 3)
        )
    });
    picture.alt = format!(
        "{} {} {row}. {}.",
        told_in_words(input),
        localize(LINE),
        jumps.collect::<Vec<_>>().join("; ")
    );
    picture
}

/// Whether two neighbours, by their inverse depths, are both drawn, and so near behind one another as one surface is.
fn one_surface(a: f64, b: f64) -> bool {
    const NEAR: f64 = 0.02;
    a > 0.0 && b > 0.0 && (a - b).abs() < NEAR * a.max(b)
}

/// What is shown of a profile.
type Values = fn(&Profile) -> &[f64];

/// The row's columns that any method has drawn, and a few around them.
fn columns(compared: &SideBySide, row: u32, width: u32) -> Range<u32> {
    let drawn = |x: &u32| {
        compared.shaded().any(|(_, compared)| {
            let frame = &compared.frame;
            frame.inverse_depth[frame.index(*x, row)] > 0.0
        })
    };
    let first = (0..width).find(drawn);
    let last = (0..width).rev().find(drawn);
    match (first, last) {
        (Some(first), Some(last)) => first.saturating_sub(AROUND)..(last + 1 + AROUND).min(width),
        _ => 0..width,
    }
}

/// One method along the scan line, a value a column.
struct Profile {
    /// Among all methods compared.
    number: usize,
    method: Method,
    intensity: Vec<f64>,
    /// Between a pixel and the next on one surface; not a number across an outline.
    slope: Vec<f64>,
    /// The slope, with 0 in place of jumps of the value.
    gentle: Vec<f64>,
    seen: Vec<f64>,
    /// The largest jump of the slope between neighbours on one surface.
    jump: f64,
}

impl Profile {
    fn of(number: usize, compared: &Compared, row: u32) -> Profile {
        let frame = &compared.frame;
        let intensity: Vec<f64> = (0..frame.width)
            .map(|x| frame.pixel(x, row).luminance())
            .collect();
        let depth = |x: usize| frame.inverse_depth[frame.index(x as u32, row)];
        let pairs = intensity.windows(2).enumerate();
        let slope: Vec<f64> = pairs
            .map(|(x, pair)| match one_surface(depth(x), depth(x + 1)) {
                true => pair[1] - pair[0],
                false => f64::NAN,
            })
            .collect();
        // The largest number leaves out what is none.
        let jumps = slope.windows(2).map(|pair| (pair[1] - pair[0]).abs());
        let jump = jumps.fold(0.0, f64::max);
        Profile {
            number,
            method: compared.method,
            seen: compared.perceived(row).to_vec(),
            intensity,
            gentle: gentle(&slope),
            slope,
            jump,
        }
    }

    fn stroke(&self) -> Stroke {
        let stroke = Ink::Series(self.number as u8).stroke(1.5);
        match self.number % 3 {
            0 => stroke,
            1 => stroke.dashed(),
            _ => stroke.dotted(),
        }
    }
}

fn gentle(slope: &[f64]) -> Vec<f64> {
    let steepness = |at: usize| slope.get(at).map_or(0.0, |slope| slope.abs());
    let beside = |at: usize| steepness(at + 1).max(at.checked_sub(1).map_or(0.0, steepness));
    let of = |at: usize| match steepness(at) > JUMP * beside(at) {
        true => 0.0,
        false => slope[at],
    };
    (0..slope.len()).map(of).collect()
}

/// The methods with their lines, from `row` on; what does not fit stands in rows below it that begin at `left`. Returns where they
/// end.
fn legend(picture: &mut Picture, profiles: &[Profile], row: Rect, left: f32) -> f32 {
    let style = Style::Body.size(TEXT);
    let (mut x, mut y) = (row.x, row.y);
    for profile in profiles {
        let name = profile.method.name();
        let width = 22.0 + style.width(name);
        if x + width > row.right() && x > left {
            (x, y) = (left, y + ROW);
        }
        let place = Rect { x, y, ..row };
        let middle = place.center().y;
        picture.line((x, middle), (x + 18.0, middle), profile.stroke());
        picture.text_in(
            Rect {
                x: x + 22.0,
                ..place
            },
            name,
            style,
        );
        x += width + 12.0;
    }
    y + ROW
}

/// The least and the most of all values in some columns, and 0.
fn range<'a>(curves: impl Iterator<Item = &'a [f64]>, columns: &Range<u32>) -> (f64, f64) {
    let part = |values: &'a [f64]| {
        let end = (columns.end as usize).min(values.len());
        &values[(columns.start as usize).min(end)..end]
    };
    let values = curves.flat_map(part).filter(|value| value.is_finite());
    let (low, high) = values.fold((0.0_f64, 0.0_f64), |(low, high), &value| {
        (low.min(value), high.max(value))
    });
    (low, if high > low { high } else { low + 1.0 })
}

/// A strip of its own scale.
struct Field {
    place: Rect,
    columns: Range<u32>,
    low: f64,
    high: f64,
}

impl Field {
    fn x(&self, column: f64) -> f32 {
        let share = (column - f64::from(self.columns.start)) / self.columns.len().max(1) as f64;
        self.place.x + self.place.width * share as f32
    }

    fn y(&self, value: f64) -> f32 {
        let share = (value - self.low) / (self.high - self.low);
        self.place.bottom() - self.place.height * share.clamp(0.0, 1.0) as f32
    }

    fn frame(&self, picture: &mut Picture, title: &str, cursor: Option<u32>, language: Language) {
        let style = Style::Body.size(TEXT).ink(Ink::Muted);
        let row = Rect::new(self.place.x, self.place.y - ROW, self.place.width, ROW);
        picture.text_in(
            row,
            elide(title, Style::Body, TEXT, row.width),
            style.ink(Ink::Text),
        );
        picture.rect(self.place, Ink::Rule.stroke(1.0));
        let mut ends = vec![self.high];
        if self.low < 0.0 {
            ends.push(self.low);
        }
        let apart = |value: f64| (self.y(value) - self.y(0.0)).abs() > 15.0;
        ends.retain(|&value| apart(value));
        ends.push(0.0);
        for value in ends {
            let at = self.y(value);
            picture.line(
                (self.place.x - 3.0, at),
                (self.place.x, at),
                Ink::Muted.stroke(1.0),
            );
            let baseline = at + style.baseline_below_middle();
            picture.text(
                (self.place.x - 5.0, baseline),
                language.significant(value, 3),
                style.end(),
            );
        }
        if self.low < 0.0 {
            let at = self.y(0.0);
            let stroke = Ink::Rule.stroke(1.0);
            picture.line((self.place.x, at), (self.place.right(), at), stroke);
        }
        if let Some(x) = cursor.filter(|x| self.columns.contains(x)) {
            let at = self.x(f64::from(x) + 0.5);
            let stroke = Ink::This.stroke(1.25);
            picture.line((at, self.place.y), (at, self.place.bottom()), stroke);
        }
    }

    fn curve(&self, picture: &mut Picture, profile: &Profile, values: &[f64]) {
        // What stands between two pixels is drawn between them.
        let shift = if values.len() < profile.intensity.len() {
            1.0
        } else {
            0.5
        };
        let columns = self.columns.start as usize..(self.columns.end as usize).min(values.len());
        let stride = (2 * columns.len()).div_ceil(MOST_POINTS).max(1);
        let at = |x: usize| Vec2::new(self.x(x as f64 + shift), self.y(values[x]));
        let mut points = Vec::new();
        for first in columns.clone().step_by(stride) {
            let part = first..(first + stride).min(columns.end);
            let recorded = || part.clone().filter(|&x| !values[x].is_nan());
            let by_value = |a: &usize, b: &usize| values[*a].total_cmp(&values[*b]);
            match (recorded().min_by(by_value), recorded().max_by(by_value)) {
                (Some(least), Some(most)) if recorded().count() == part.len() => {
                    points.push(at(least.min(most)));
                    if least != most {
                        points.push(at(least.max(most)));
                    }
                }
                // The line is broken at an outline.
                _ => self.line(picture, profile, &mut points),
            }
        }
        self.line(picture, profile, &mut points);
    }

    fn line(&self, picture: &mut Picture, profile: &Profile, points: &mut Vec<Vec2>) {
        if points.len() > 1 {
            picture.polyline(points.iter().copied(), profile.stroke());
        }
        points.clear();
    }

    /// Numbers of pixels under the last strip.
    fn pixels(&self, picture: &mut Picture) {
        let style = Style::Body.size(TEXT).ink(Ink::Muted);
        let row = Rect::new(
            self.place.x,
            self.place.bottom() + 1.0,
            self.place.width,
            ROW,
        );
        let last = self.columns.end.saturating_sub(1);
        picture.text_in(row, format!("x = {}", self.columns.start), style);
        picture.text_in(row, format!("x = {last}"), style.end());
    }
}

#[cfg(test)]
mod tests {
    use super::gentle;

    #[test]
    fn a_jump_of_the_value_is_no_slope() {
        let stairs = [0.0, 0.0, 0.3, 0.0, 0.0, -0.2, 0.0];
        assert_eq!(gentle(&stairs), [0.0; 7]);
        let roof = [0.1, 0.1, 0.1, -0.2, -0.2];
        assert_eq!(gentle(&roof), roof);
        assert!(gentle(&[]).is_empty());
    }
}
