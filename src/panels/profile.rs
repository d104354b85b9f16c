//! Intensity along one scan line by several methods: the luminance itself, its slope, and how bright it looks. A jump of the slope is
//! seen as a band that is in no pixel: a Mach band.

use super::comparison::cursor::Cursor;
use super::horizon::after_your_answer;
use super::message::{NOT_COMPARED, message};
use super::values::step_as_sentence;
use super::{PanelInput, Properties, names};
use crate::figure::{Axis, Plot, Scale, legend};
use crate::language::Message;
use crate::methods::Method;
use crate::picture::{Ink, Picture, Rect, Style};
use crate::render::compare::{Compared, SideBySide};
use glam::Vec2;
use std::ops::Range;

const MARGIN: f32 = 8.0;
const TEXT: f32 = 11.0;
const ROW: f32 = 16.0;
/// A strip is at least so high, or there are fewer of them, the first ones: in a lower one no slope can be read.
const STRIP: f32 = 56.0;
/// In a panel lower than this the axis of the pixels has no name.
const LOW: f32 = 300.0;
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

pub const PANEL: Properties = Properties::titled(Message("app-profile")).comparing();

pub fn draw(input: &PanelInput, size: Vec2) -> Picture {
    let compared = &input.finished.compared;
    let Some(first) = compared.pictures().first() else {
        return message(NOT_COMPARED, input.language, size);
    };
    let localize = |strings: Message| strings.text(input.language);
    let cursor = Cursor::of(input);
    let row = cursor.row(&first.frame);
    let hidden = input.hidden_pixels(&first.frame);
    let profiles: Vec<Profile> = compared
        .shaded()
        .map(|(_, compared)| Profile::of(compared, row, hidden.as_deref()))
        .collect();
    let columns = columns(compared, row, first.frame.width);
    let index = |x| first.frame.index(x, row);
    let is_hidden = |x| hidden.as_ref().is_some_and(|hidden| hidden[index(x)]);
    let mut picture = Picture::new(size.x, size.y);
    let whole = picture.bounds().grown(-MARGIN);
    let title = Rect {
        height: ROW,
        ..whole
    };
    let caption = LINE.format(input.language, &[("y", &row.to_string())]);
    let style = Style::Bold.size(TEXT).ink(Ink::This);
    picture.text_in(title, caption.clone(), style);
    let beside = Rect::between(
        (title.x + style.width(&caption) + 14.0, whole.y),
        title.max(),
    );
    let strokes = profiles
        .iter()
        .map(|profile| profile.method.series().stroke);
    let names = profiles
        .iter()
        .map(|profile| names::method(profile.method, input.language));
    let names: Vec<String> = names.collect();
    let legend_entries = strokes.zip(names.iter().map(String::as_str));
    let top = legend(&mut picture, legend_entries, beside, whole.x);

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
    // Under the last strip its numbers and, where there is much room, the name of the axis.
    let is_low = size.y < LOW;
    let below = if is_low { ROW + 2.0 } else { 2.0 * ROW };
    let height = |count: usize| (whole.bottom() - top - below) / count as f32 - ROW;
    let count = (1..=fields.len()).rfind(|&count| height(count) >= STRIP);
    let count = count.unwrap_or(1);
    let height = height(count);
    let fields = &fields[..count];
    let axes = fields.iter().map(|&(name, _, room)| {
        let values = profiles.iter().flat_map(|profile| {
            let values = room(profile);
            let end = (columns.end as usize).min(values.len());
            values[(columns.start as usize).min(end)..end].iter()
        });
        Axis::new(
            Scale::around(values.copied()),
            localize(name),
            input.language,
        )
    });
    let axes: Vec<Axis> = axes.collect();
    // One margin for all, so that the same column stands above itself.
    let widths = axes.iter().map(|axis| axis.width(height));
    let left = whole.x + widths.fold(0.0, f32::max);
    let pixels = Scale::whole(columns.start.into(), columns.end.into());
    let across = if is_low { "" } else { "x" };
    for (strip, (&(_, values, _), up)) in fields.iter().zip(axes).enumerate() {
        let y = top + ROW + (height + ROW) * strip as f32;
        let place = Rect::between((left, y), (whole.right() - 4.0, y + height.max(1.0)));
        let plot = Plot::in_field(Axis::new(pixels, across, input.language), up, place);
        plot.draw_field(&mut picture);
        hidden_columns(&mut picture, &plot, input, &columns, &is_hidden, strip == 0);
        if let Some(x) = cursor.x.filter(|x| columns.contains(x)) {
            let stroke = Ink::This.stroke(1.25);
            plot.upright(&mut picture, f64::from(x) + 0.5, stroke);
        }
        for profile in &profiles {
            profile.curve(&mut picture, &plot, &columns, values(profile));
        }
        if strip + 1 == count {
            plot.draw_below(&mut picture);
        }
    }
    let jumps = profiles.iter().zip(&names).map(|(profile, name)| {
        let jump = input.language.significant(profile.jump, 3);
        LARGEST_JUMP.format(input.language, &[("method", name), ("jump", &jump)])
    });
    picture.alt = format!(
        "{} {caption}. {}.",
        step_as_sentence(input),
        jumps.collect::<Vec<_>>().join("; ")
    );
    picture
}

/// The columns whose pixels are hidden, and words in the widest place of them, where there is one.
fn hidden_columns(
    picture: &mut Picture,
    plot: &Plot,
    input: &PanelInput,
    columns: &Range<u32>,
    is_hidden: &dyn Fn(u32) -> bool,
    in_words: bool,
) {
    let all: Vec<u32> = columns.clone().filter(|&x| is_hidden(x)).collect();
    let runs = all.chunk_by(|a, b| a + 1 == *b);
    let places = runs.map(|run| {
        let [left, right] = [run[0], run[run.len() - 1] + 1].map(|x| plot.point(x.into(), 0.0).x);
        let width = right - left;
        Rect {
            x: left,
            width,
            ..plot.place
        }
    });
    let places: Vec<Rect> = places.collect();
    for &place in &places {
        picture.rect(place, Ink::Faint);
    }
    let widest = places.iter().max_by(|a, b| a.width.total_cmp(&b.width));
    if let Some(&widest) = widest.filter(|_| in_words) {
        after_your_answer(picture, widest, input.language);
    }
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
    /// What is hidden is no number, and neither is what follows from it.
    fn of(compared: &Compared, row: u32, hidden: Option<&[bool]>) -> Profile {
        let frame = &compared.frame;
        let is_hidden = |x| hidden.is_some_and(|hidden| hidden[frame.index(x, row)]);
        let shown = |x, value| if is_hidden(x) { f64::NAN } else { value };
        let intensity: Vec<f64> = (0..frame.width)
            .map(|x| shown(x, frame.pixel(x, row).luminance()))
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
            method: compared.method,
            seen: std::iter::zip(0.., compared.perceived(row))
                .map(|(x, &seen)| shown(x, seen))
                .collect(),
            intensity,
            gentle: gentle(&slope),
            slope,
            jump,
        }
    }

    /// `values` of some columns, broken at an outline.
    fn curve(&self, picture: &mut Picture, plot: &Plot, columns: &Range<u32>, values: &[f64]) {
        // What stands between two pixels is drawn between them.
        let shift = if values.len() < self.intensity.len() {
            1.0
        } else {
            0.5
        };
        let columns = columns.start as usize..(columns.end as usize).min(values.len());
        let stride = (2 * columns.len()).div_ceil(MOST_POINTS).max(1);
        let at = |x: usize| plot.point(x as f64 + shift, values[x]);
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
                _ => self.line(picture, &mut points),
            }
        }
        self.line(picture, &mut points);
    }

    fn line(&self, picture: &mut Picture, points: &mut Vec<Vec2>) {
        if points.len() > 1 {
            picture.polyline(points.iter().copied(), self.method.series().stroke);
        }
        points.clear();
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
