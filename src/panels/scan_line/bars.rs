//! An interpolation as bars: how much weight each end has, the ramp from end to end, and the direct and the incremental value.
//! The ramp of a colour is its shades, that of a normal a fan of arrows: how it turns, and how it grows shorter on the way.

use super::super::values::{difference, short};
use crate::figure::{Cell, gradient, mono_or_narrow};
use crate::language::{Language, Message};
use crate::picture::{Ink, Picture, Rect, Stroke, Style, Tag};
use crate::record::Value;
use crate::replay::shading::{Interpolated, State};
use glam::{DVec3, Vec2};

const WEIGHTS: Message = Message("scan-line-weights");
const RAMP: Message = Message("scan-line-ramp");
const DIRECT: Message = Message("scan-line-direct");
const INCREMENTAL: Message = Message("scan-line-incremental");
const DIFFERENCE: Message = Message("scan-line-difference");

/// Height of a bar with the gap under it, and of a line of text.
const BAR: f32 = 24.0;
const LINE: f32 = 16.0;
/// The width from which on the values stand side by side.
const WIDE: f32 = 420.0;

/// By how much the fan of a normal is higher than the shades of a colour.
const FAN: f32 = 20.0;
/// Between two arrows of a fan.
const ARROWS: f32 = 26.0;

/// The height that the bars of such a value take of a panel of that size: none where the panel is too low.
pub(super) fn height(of: Value, size: Vec2) -> f32 {
    let lines = if size.x >= WIDE { 2.0 } else { 3.0 };
    let ramp = BAR + extra(of);
    match size.y {
        y if y >= 300.0 => BAR + ramp + lines * LINE + 6.0,
        y if y >= 230.0 => BAR + ramp + 4.0,
        y if y >= 170.0 => BAR + 4.0,
        _ => 0.0,
    }
}

/// What the ramp of such a value needs beyond the height of a bar.
fn extra(of: Value) -> f32 {
    match of {
        Value::Vector(_) => FAN,
        _ => 0.0,
    }
}

/// An interpolation between two ends.
pub(super) struct Interpolation {
    ends: [(&'static str, Value); 2],
    /// Of the ends; they sum up to 1.
    weights: [f64; 2],
    /// Names of the direct and the incremental value.
    names: [&'static str; 2],
    values: Option<Interpolated>,
}

impl Interpolation {
    /// At the current pixel on its span, or of the current edge on the scan line.
    pub fn current(state: &State) -> Option<Self> {
        let names = state.names?;
        if let (Some(pixel), Some(span)) = (&state.pixel, &state.span) {
            let [four, five] = span.ends?;
            return Some(Interpolation {
                ends: [(names.left, four), (names.right, five)],
                weights: weights(span.x_4, span.x_5, pixel.x_p),
                names: [names.pixel, names.pixel_incremental],
                values: pixel.values,
            });
        }
        let edge = state.edges.get(state.edge?)?;
        let upper = state.corners.get(edge.upper as usize)?;
        let lower = state.corners.get(edge.lower as usize)?;
        Some(Interpolation {
            ends: [(names.upper, upper.value?), (names.lower, lower.value?)],
            weights: weights(upper.y, lower.y, state.scan_line?.y_4),
            names: [names.left, names.left_incremental],
            values: edge.cut.and_then(|cut| cut.values),
        })
    }

    pub fn draw(&self, picture: &mut Picture, area: Rect, language: Language) {
        let title = Style::Body.size(12.0).ink(Ink::Muted);
        let titles = [WEIGHTS, RAMP].map(|strings| strings.text(language));
        // Titles only where the bars stay long.
        let left = if area.width >= 380.0 { 72.0 } else { 4.0 };
        let ramp = BAR + extra(self.ends[0].1);
        let bar = |top: f32, height: f32| {
            let width = area.width - left - 4.0;
            Rect::new(area.x + left, area.y + top + 2.0, width, height - 6.0)
        };
        let bars = [bar(0.0, BAR), bar(BAR, ramp)];
        let rows = if area.height >= BAR + ramp - 4.0 {
            2
        } else {
            1
        };
        if left > 4.0 {
            for (bar, strings) in bars.into_iter().zip(titles).take(rows) {
                let place = Rect::new(area.x + 4.0, bar.y, left, bar.height);
                picture.text_in(place, strings, title);
            }
        }
        self.draw_weights(picture, bars[0], language);
        if rows == 2 {
            self.draw_ramp(picture, bars[1]);
        }
        let rest = area.height - BAR - ramp;
        if rest >= LINE {
            let rest = Rect::new(area.x + 4.0, area.y + BAR + ramp, area.width - 8.0, rest);
            self.draw_values(picture, rest, language);
        }
    }

    /// A bar in two parts, as long as the weights of the ends.
    fn draw_weights(&self, picture: &mut Picture, bar: Rect, language: Language) {
        let cut = bar.x + self.weights[0].clamp(0.0, 1.0) as f32 * bar.width;
        let parts = [
            Rect::between(bar.min(), (cut, bar.bottom())),
            Rect::between((cut, bar.y), bar.max()),
        ];
        let set = Style::Label.size(12.0).middle();
        for (i, (part, fill)) in parts
            .into_iter()
            .zip([Ink::LinkedTint, Ink::Faint])
            .enumerate()
        {
            let (name, _) = self.ends[i];
            let weight = language.short(self.weights[i], 3);
            picture.tagged(Tag::Field(name), |picture| {
                picture.rect(part, fill);
                let texts = [format!("{weight} → {name}"), name.to_string()];
                let fits = |text: &&String| set.width(text) <= part.width - 4.0;
                if let Some(text) = texts.iter().find(fits) {
                    picture.text_in(part, text.clone(), set);
                }
            });
        }
        picture.rect(bar, Ink::Rule.stroke(1.0));
    }

    /// The colours from one end to the other, with a mark where the step is.
    fn draw_ramp(&self, picture: &mut Picture, bar: Rect) {
        let [(first, one), (second, two)] = self.ends;
        let set = Style::Label.size(12.0);
        let room = set.width(first).max(set.width(second)) + 8.0;
        let strip = Rect::new(bar.x + room, bar.y, bar.width - 2.0 * room, bar.height);
        let ends = [(first, bar.x, set), (second, bar.right(), set.end())];
        for (name, x, set) in ends {
            let y = bar.center().y + set.baseline_below_middle();
            picture.tagged(Tag::Field(name), |picture| {
                picture.text((x, y), name, set);
            });
        }
        let at = self.weights[1].clamp(0.0, 1.0);
        let x = strip.x + at as f32 * strip.width;
        match (one, two) {
            (Value::Vector(one), Value::Vector(two)) => {
                picture.rect(strip, Ink::Rule.stroke(1.0));
                fan(picture, strip, [one, two], at);
            }
            _ => {
                if let (Value::Rgb(one), Value::Rgb(two)) = (one, two) {
                    picture.image(strip, gradient(|share| one * (1.0 - share) + two * share));
                }
                picture.rect(strip, Ink::Rule.stroke(1.0));
                let mark = Rect::new(x - 3.0, strip.y - 2.0, 6.0, strip.height + 4.0);
                picture.rect(mark.grown(1.0), Ink::Surface.stroke(1.0));
                picture.rect(mark, Ink::This.stroke(2.0));
            }
        }
    }

    /// Direct value, incremental value, and what lies between them: side by side where there is room.
    fn draw_values(&self, picture: &mut Picture, area: Rect, language: Language) {
        let Some(Interpolated {
            direct,
            incremental,
            difference: rounding,
        }) = self.values
        else {
            return;
        };
        let digits = |value| match value {
            Value::Rgb(color) if !color.is_grey() => 3,
            Value::Vector(_) => 3,
            _ => 6,
        };
        let columns = [
            (
                DIRECT,
                self.names[0],
                exact(direct, digits(direct), language),
            ),
            (
                INCREMENTAL,
                self.names[1],
                exact(incremental, digits(incremental), language),
            ),
            (DIFFERENCE, "difference", difference(rounding, language)),
        ];
        let title = Style::Body.size(12.0).ink(Ink::Muted);
        let side_by_side = area.width + 12.0 >= WIDE;
        for (i, (strings, name, value)) in columns.into_iter().enumerate() {
            let i = i as f32;
            let (words_at, value_at, room) = if side_by_side {
                let width = area.width / 3.0;
                let x = area.x + i * width;
                ((x, area.y), (x, area.y + LINE), width - 8.0)
            } else {
                let y = area.y + i * LINE;
                ((area.x, y), (area.x + 88.0, y), area.width - 88.0)
            };
            let below = 0.5 * LINE + title.baseline_below_middle();
            picture.text(
                (words_at.0, words_at.1 + below),
                strings.text(language),
                title,
            );
            picture.tagged(Tag::Field(name), |picture| {
                let place = Rect::new(value_at.0, value_at.1, room, LINE);
                Cell::forms(mono_or_narrow(value, 12.0, Ink::Text)).draw(picture, place);
            });
        }
    }
}

/// With all its decimals, so that values stand under each other.
fn exact(value: Value, digits: usize, language: Language) -> String {
    let one = |v: f64| language.fixed(v, digits);
    match value {
        Value::Rgb(color) if color.is_grey() => one(color.r),
        Value::Rgb(color) => color.channels().map(one).join(" "),
        Value::Vector(vector) => vector.to_array().map(one).join(" "),
        value => short(value, digits, language),
    }
}

/// The weights of two values at `one` and `two`, at a place between them.
fn weights(one: f64, two: f64, at: f64) -> [f64; 2] {
    [(at - two) / (one - two), (one - at) / (one - two)]
}

/// The normals from one end to the other, in the plane of both with their mean direction upward; the one at `at` stands out.
/// A dotted line shows how high a unit vector reaches.
fn fan(picture: &mut Picture, strip: Rect, [one, two]: [DVec3; 2], at: f64) {
    let up = (one + two).try_normalize();
    let up = up.unwrap_or_else(|| one.any_orthonormal_vector());
    let across = (two - one).reject_from_normalized(up).normalize_or_zero();
    let unit = strip.height - 6.0;
    let foot = strip.bottom() - 3.0;
    let top = foot - unit;
    let reach = Ink::Rule.stroke(1.0).dotted();
    picture.line((strip.x, top), (strip.right(), top), reach);
    let aside = (0.5 * unit).min(0.25 * strip.width);
    let feet = Rect::new(strip.x + aside, strip.y, strip.width - 2.0 * aside, unit);
    let mut arrow = |at: f64, stroke: Stroke| {
        let normal = one.lerp(two, at);
        let along = Vec2::new(normal.dot(across) as f32, -normal.dot(up) as f32);
        let from = Vec2::new(feet.x + at as f32 * feet.width, foot);
        picture.clipped(strip, |picture| {
            picture.arrow(from, from + unit * along, stroke);
        });
    };
    let count = (feet.width / ARROWS).floor().max(1.0);
    for i in 0..=count as u32 {
        arrow(f64::from(i) / f64::from(count), Ink::Muted.stroke(1.0));
    }
    arrow(at, Ink::This.stroke(2.5));
}
