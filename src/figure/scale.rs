//! From the values along an axis to points, and the ticks that stand there.

use crate::language::{Language, power_of_ten};
use std::ops::RangeInclusive;

/// Powers of ten on an axis with fewer have 2 and 5 times each between them.
const FEW_POWERS: usize = 3;
/// Of a logarithmic scale around values, at both ends.
const MARGIN: f64 = 0.06;

/// A linear or logarithmic scale between two places on the screen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scale {
    kind: Kind,
    /// At its ends; on a logarithmic scale their logarithms to the base 10.
    low: f64,
    high: f64,
    /// Points at its ends.
    start: f32,
    end: f32,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Kind {
    Linear,
    /// Linear, and counts: nothing lies between two whole numbers.
    Whole,
    /// Zero, which has no logarithm, stands where `zero` has.
    Logarithmic {
        zero: Option<f64>,
    },
}

/// What the numbers at an axis count.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unit {
    None,
    Seconds,
}

/// A value with what is written at it.
pub type Tick = (f64, String);

impl Scale {
    fn new(kind: Kind, low: f64, high: f64) -> Self {
        Scale {
            kind,
            low,
            high,
            start: 0.0,
            end: 1.0,
        }
    }

    /// Around all finite values and 0, up to round numbers.
    pub fn around(values: impl IntoIterator<Item = f64>) -> Self {
        let finite = values.into_iter().filter(|value| value.is_finite());
        let (low, high) = finite.fold((0.0_f64, 0.0_f64), |(low, high), value| {
            (low.min(value), high.max(value))
        });
        let high = if high > low { high } else { low + 1.0 };
        let step = round_step((high - low) / 4.0);
        let [low, high] = [(low / step).floor(), (high / step).ceil()].map(|ends| ends * step);
        Scale::new(Kind::Linear, low, high)
    }

    /// Whole numbers between two that differ.
    pub fn whole(low: f64, high: f64) -> Self {
        Scale::new(Kind::Whole, low, high)
    }

    /// Whole powers of ten around all positive finite values, and at least one decade.
    pub fn decades(values: impl IntoIterator<Item = f64>) -> Self {
        let [low, high] = exponents(values).map_or([-1.0, 0.0], |[low, high]| {
            [low.floor(), high.ceil().max(low.floor() + 1.0)]
        });
        Scale::new(Kind::Logarithmic { zero: None }, low, high)
    }

    /// Around all positive values with a margin, zero below them where it occurs; none of no values.
    pub fn logarithmic(values: impl IntoIterator<Item = f64> + Clone) -> Option<Self> {
        let has_zero = values.clone().into_iter().any(|value| value == 0.0);
        let [low, high] = exponents(values).or(has_zero.then_some([0.0; 2]))?;
        let (low, high) = match high - low {
            span if span < 0.5 => (low - 0.25, high + 0.25),
            _ => (low, high),
        };
        let zero = has_zero.then_some(low - 0.12 * (high - low) - 0.5);
        let first = zero.unwrap_or(low);
        let margin = MARGIN * (high - first);
        Some(Scale::new(
            Kind::Logarithmic { zero },
            first - margin,
            high + margin,
        ))
    }

    /// The scale from `start` to `end`.
    pub fn along(self, [start, end]: [f32; 2]) -> Self {
        Scale { start, end, ..self }
    }

    /// The part of it between two shares of its length.
    pub fn part(self, [from, to]: [f64; 2]) -> Self {
        let at = |share: f64| self.low + share * (self.high - self.low);
        Scale {
            low: at(from),
            high: at(to),
            ..self
        }
    }

    /// How far along the scale a value is; beyond its ends, less than 0 or more than 1.
    pub fn share(&self, value: f64) -> f64 {
        let at = match self.kind {
            Kind::Logarithmic { zero } if value <= 0.0 => zero.unwrap_or(self.low),
            Kind::Logarithmic { .. } => value.log10(),
            Kind::Linear | Kind::Whole => value,
        };
        (at - self.low) / (self.high - self.low)
    }

    pub fn at(&self, value: f64) -> f32 {
        self.start + self.share(value) as f32 * (self.end - self.start)
    }

    /// The place of a value; what lies beyond an end stands there.
    pub fn clamped(&self, value: f64) -> f32 {
        let share = self.share(value).clamp(0.0, 1.0) as f32;
        self.start + share * (self.end - self.start)
    }

    /// Whether the value lies on the scale, be it at an end.
    pub fn holds(&self, value: f64) -> bool {
        (-1e-9..=1.0 + 1e-9).contains(&self.share(value))
    }

    /// Values with what is written at them, the least first, at least `apart` points from each other.
    pub fn ticks(&self, apart: f32, unit: Unit, language: Language) -> Vec<Tick> {
        let length = f64::from((self.end - self.start).abs());
        let room = (length / f64::from(apart)).max(1e-6);
        match self.kind {
            Kind::Logarithmic { zero } => self.logarithmic_ticks(room, zero, (unit, language)),
            Kind::Linear | Kind::Whole => {
                let step = round_step((self.high - self.low) / room);
                let step = if self.kind == Kind::Whole {
                    step.max(1.0)
                } else {
                    step
                };
                let first = (self.low / step - 1e-9).ceil() as i64;
                let last = (self.high / step + 1e-9).floor() as i64;
                let mut ticks: Vec<f64> = (first..=last).map(|n| n as f64 * step).collect();
                if ticks.len() < 2 && room >= 1.0 {
                    ticks = vec![self.low, self.high];
                }
                let ticks = ticks.into_iter();
                ticks.map(|value| (value, language.number(value))).collect()
            }
        }
    }

    /// Powers of ten, where they are few and there is room also 2 and 5 times each; and zero.
    fn logarithmic_ticks(
        &self,
        room: f64,
        zero: Option<f64>,
        (unit, language): (Unit, Language),
    ) -> Vec<Tick> {
        let powers = self.low.floor() as i32..=self.high.ceil() as i32;
        let whole = self.low.ceil() as i32..=self.high.floor() as i32;
        let decade = room / (self.high - self.low);
        let every = (1.0 / decade - 1e-6).ceil().max(1.0) as i32;
        let times: &[f64] = match whole.clone().count() < FEW_POWERS {
            true if 2_f64.log10() * decade >= 1.0 => &[1.0, 2.0, 5.0],
            true if 0.5 * decade >= 1.0 => &[1.0, 3.0],
            _ => &[1.0],
        };
        let mut ticks: Vec<Tick> = Vec::new();
        if zero.is_some() && self.holds(0.0) {
            ticks.push((0.0, "0".into()));
        }
        for power in powers.filter(|power| power.rem_euclid(every) == 0) {
            for &times in times {
                let value = times * 10_f64.powi(power);
                let beside_zero = zero.is_some_and(|zero| (value.log10() - zero) * decade < 1.0);
                if self.holds(value) && !beside_zero {
                    ticks.push((value, written((times, power), &whole, unit, language)));
                }
            }
        }
        if ticks.is_empty() {
            let power = self.low.ceil() as i32;
            ticks.push((
                10_f64.powi(power),
                written((1.0, power), &whole, unit, language),
            ));
        }
        ticks
    }
}

/// A tick of a logarithmic scale: a plain number where all powers of ten are short ones.
fn written(
    (times, power): (f64, i32),
    powers: &RangeInclusive<i32>,
    unit: Unit,
    language: Language,
) -> String {
    let short = *powers.start() >= -3 && *powers.end() <= 4;
    match unit {
        Unit::Seconds => seconds(times, power, language),
        Unit::None if short => language.number(times * 10_f64.powi(power)),
        Unit::None if times == 1.0 => power_of_ten(power),
        Unit::None => format!("{times}·{}", power_of_ten(power)),
    }
}

/// `times`·10^`power` seconds: `200 µs`.
fn seconds(times: f64, power: i32, language: Language) -> String {
    let (unit, name) = match power {
        0.. => (0, "s"),
        -3..0 => (-3, "ms"),
        -6..-3 => (-6, "µs"),
        _ => (-9, "ns"),
    };
    let value = times * 10_f64.powi(power - unit);
    format!("{} {name}", language.number(value))
}

/// The logarithms of the least and the largest positive finite value.
fn exponents(values: impl IntoIterator<Item = f64>) -> Option<[f64; 2]> {
    let positive = values
        .into_iter()
        .filter(|value| *value > 0.0 && value.is_finite());
    let logarithms = positive.map(|value| [value.log10(); 2]);
    logarithms.reduce(|[low, high], [value, _]| [low.min(value), high.max(value)])
}

/// The least of …, 0.1, 0.2, 0.5, 1, 2, 5, 10, … that is not less than `least`.
fn round_step(least: f64) -> f64 {
    let power = 10_f64.powf(least.log10().floor());
    let times = [1.0, 2.0, 5.0, 10.0].into_iter();
    let fitting = times
        .map(|times| times * power)
        .find(|&step| step >= least * (1.0 - 1e-9));
    fitting.unwrap_or(least)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn texts(scale: Scale, apart: f32) -> Vec<String> {
        let ticks = scale.ticks(apart, Unit::None, Language::English);
        ticks.into_iter().map(|(_, text)| text).collect()
    }

    #[test]
    fn a_scale_spans_whole_powers_of_ten_or_round_numbers() {
        let decades = Scale::decades([0.02, 3.0, 0.0, f64::NAN]).along([300.0, 0.0]);
        assert_eq!(texts(decades, 22.0), ["0.01", "0.1", "1", "10"]);
        assert_eq!((decades.at(0.01), decades.at(10.0)), (300.0, 0.0));
        assert_eq!((decades.clamped(0.0), decades.clamped(1e9)), (300.0, 0.0));
        assert_eq!(Scale::decades([]).share(0.1), 0.0);
        let linear = Scale::around([0.83, -0.1]).along([0.0, 100.0]);
        assert_eq!(texts(linear, 15.0), ["−0.5", "0", "0.5", "1"]);
        let counted = Scale::whole(0.0, 3.0).along([0.0, 900.0]);
        assert_eq!(texts(counted, 56.0), ["0", "1", "2", "3"]);
    }

    #[test]
    fn ticks_stand_as_far_apart_as_they_must() {
        let scale = Scale::decades([1e-12, 1.0]).along([0.0, 100.0]);
        for apart in [5.0, 22.0, 34.0, 80.0, 1e4] {
            let ticks = scale.ticks(apart, Unit::None, Language::English);
            let places: Vec<f32> = ticks.iter().map(|(value, _)| scale.at(*value)).collect();
            assert!(
                places
                    .windows(2)
                    .all(|pair| pair[1] - pair[0] >= apart - 0.01)
            );
            assert!(!ticks.is_empty());
        }
        assert_eq!(texts(scale, 40.0), ["10⁻¹⁰", "10⁻⁵", "1"]);
    }

    #[test]
    fn decades_are_equally_long_and_zero_stands_below_all() {
        let scale = Scale::logarithmic([1e-6, 0.0, 1e-2])
            .unwrap()
            .along([0.0, 500.0]);
        let decade = scale.at(1e-2) - scale.at(1e-3);
        assert!((scale.at(1e-5) - scale.at(1e-6) - decade).abs() < 1e-3);
        assert!(scale.at(0.0) > 0.0 && scale.at(0.0) < scale.at(1e-6) - 5.0);
        assert_eq!(texts(scale, 22.0)[0], "0");
        assert!(Scale::logarithmic([]).is_none());
        let half = scale.part([0.5, 1.0]);
        assert!((half.at(1e-2) - 500.0 - 2.0 * (scale.at(1e-2) - 500.0)).abs() < 1e-3);
    }

    #[test]
    fn times_have_units() {
        for (times, power, name) in [(1.0, 0, "1 s"), (2.0, -4, "200 µs"), (5.0, -1, "500 ms")] {
            assert_eq!(seconds(times, power, Language::English), name);
        }
    }
}
