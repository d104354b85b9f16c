//! A logarithmic axis.

use super::{SMALL, TEXT};
use crate::language::{Language, power_of_ten};
use crate::picture::{Ink, Picture, Rect, Style};
use glam::Vec2;

/// What an axis must show: positive values, and zero where it occurs.
#[derive(Clone, Copy, Debug)]
pub struct Span {
    least: f64,
    most: f64,
    zero: bool,
}

impl Span {
    /// None of no values. Where all are zero, the axis has nothing else.
    pub fn of(values: impl Iterator<Item = f64>) -> Option<Span> {
        let values: Vec<f64> = values.collect();
        let positive = || values.iter().copied().filter(|&value| value > 0.0);
        let zero = values.contains(&0.0);
        match (positive().reduce(f64::min), positive().reduce(f64::max)) {
            (Some(least), Some(most)) => Some(Span { least, most, zero }),
            _ => zero.then_some(Span {
                least: 1.0,
                most: 1.0,
                zero,
            }),
        }
    }
}

/// From logarithms to points.
#[derive(Clone, Copy, Debug)]
pub struct Axis {
    /// log10 at its ends.
    low: f64,
    high: f64,
    /// Points at its ends.
    start: f32,
    end: f32,
    /// Whether zero stands at its lower end.
    zero: bool,
    named: Named,
}

/// How ticks are written.
#[derive(Clone, Copy, Debug)]
pub enum Named {
    Number,
    /// With a unit of time.
    Seconds,
}

/// Of the axis's length, at both ends.
const MARGIN: f64 = 0.06;

impl Axis {
    pub fn new(span: Span, named: Named, [start, end]: [f32; 2]) -> Axis {
        let (mut low, mut high) = (span.least.log10(), span.most.log10());
        if high - low < 0.5 {
            (low, high) = (low - 0.25, high + 0.25);
        }
        if span.zero {
            low -= 0.12 * (high - low) + 0.5;
        }
        let margin = MARGIN * (high - low);
        Axis {
            low: if span.zero { low } else { low - margin },
            high: high + margin,
            start,
            end,
            zero: span.zero,
            named,
        }
    }

    /// Whether the value lies on the axis.
    pub fn holds(&self, value: f64) -> bool {
        value > 0.0 && (self.low..=self.high).contains(&value.log10())
    }

    pub fn at(&self, value: f64) -> f32 {
        let inset = if self.zero {
            14.0_f32.copysign(self.end - self.start)
        } else {
            0.0
        };
        if value <= 0.0 {
            return self.start + inset;
        }
        let share = (value.log10() - self.low) / (self.high - self.low);
        self.start + share as f32 * (self.end - self.start)
    }

    /// Places and names, least first: powers of ten, and 2 and 5 times them where there are few.
    fn ticks(&self) -> Vec<(f32, String)> {
        let powers = self.low.ceil() as i32..=self.high.floor() as i32;
        let mut ticks = Vec::new();
        if self.zero {
            ticks.push((self.at(0.0), "0".to_string()));
        }
        let few = powers.clone().count() < 3;
        // So that names lie apart
        let every = (powers.clone().count() as i32 / 12 + 1).max(1);
        for power in self.low.floor() as i32..=self.high.floor() as i32 {
            for times in [1.0, 2.0, 5.0] {
                let value = times * 10_f64.powi(power);
                // A name beside that of zero would cover it.
                let beside_zero = self.zero && (self.at(value) - self.at(0.0)).abs() < 16.0;
                if !self.holds(value) || beside_zero || times > 1.0 && !few || power % every != 0 {
                    continue;
                }
                let name = match self.named {
                    Named::Seconds => whole_seconds(times, power),
                    Named::Number if (-3..4).contains(&power) => Language::English.number(value),
                    Named::Number if times > 1.0 => format!("{times}·{}", power_of_ten(power)),
                    Named::Number => power_of_ten(power),
                };
                ticks.push((self.at(value), name));
            }
        }
        ticks
    }

    /// Below `place`.
    pub fn draw_across(&self, picture: &mut Picture, place: Rect, name: &str) {
        for (x, tick) in self.ticks() {
            picture.line((x, place.y), (x, place.bottom()), Ink::Faint.stroke(1.0));
            let set = Style::Body.size(SMALL).ink(Ink::Muted).middle();
            picture.text((x, place.bottom() + 16.0), tick, set);
        }
        let (left, right) = (place.x, place.right());
        let y = place.bottom();
        picture.line((left, y), (right, y), Ink::Muted.stroke(1.0));
        let at = Vec2::new(place.center().x, y + 40.0);
        picture.text(at, name, Style::Label.size(TEXT).middle());
    }

    /// Left of `place`; its name stands above it, where it can be read without turning the head.
    pub fn draw_up(&self, picture: &mut Picture, place: Rect, name: &str) {
        for (y, tick) in self.ticks() {
            picture.line((place.x, y), (place.right(), y), Ink::Faint.stroke(1.0));
            let row = Rect::new(0.0, y - 8.0, place.x - 8.0, 16.0);
            picture.text_in(row, tick, Style::Body.size(SMALL).ink(Ink::Muted).end());
        }
        let x = place.x;
        picture.line((x, place.y), (x, place.bottom()), Ink::Muted.stroke(1.0));
        picture.text((20.0, place.y - 8.0), name, Style::Label.size(TEXT));
    }
}

/// `times`·10^`power` seconds: `200 µs`.
pub fn whole_seconds(times: f64, power: i32) -> String {
    let (unit, name) = match power {
        0.. => (0, "s"),
        -3..0 => (-3, "ms"),
        -6..-3 => (-6, "µs"),
        _ => (-9, "ns"),
    };
    format!(
        "{} {name}",
        Language::English.number(times * 10_f64.powi(power - unit))
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_have_units() {
        for (times, power, name) in [(1.0, 0, "1 s"), (2.0, -4, "200 µs"), (5.0, -1, "500 ms")] {
            assert_eq!(whole_seconds(times, power), name);
        }
    }

    #[test]
    fn decades_are_equally_long_and_zero_stands_below_all() {
        let span = Span::of([1e-6, 0.0, 1e-2].into_iter()).unwrap();
        let axis = Axis::new(span, Named::Number, [0.0, 500.0]);
        let decade = axis.at(1e-2) - axis.at(1e-3);
        assert!((axis.at(1e-5) - axis.at(1e-6) - decade).abs() < 1e-3);
        assert!(axis.at(0.0) < axis.at(1e-6) - 5.0);
        assert!(Span::of(std::iter::empty()).is_none());
    }
}
