//! How panels write and colour the values that events tell.

use super::Show;
use super::words::Words;
use crate::algorithms::scan_line::Carried;
use crate::color::Rgb;
use crate::picture::{Ink, fixed};
use crate::record::{Fields, Value};

const STEP: Words = Words::new("Step", "Langkah");

/// What the corners carry, as a value; none where nothing is carried.
pub(super) fn value_of<A: Carried>(carried: A) -> Option<Value> {
    let names = A::NAMES?;
    let mut fields = Fields::default();
    carried.tell(names.corner, &mut fields);
    fields.get(names.corner)
}

/// A value with at most `digits` decimals: one number for a grey colour, three for another.
pub(super) fn short(value: Value, digits: usize) -> String {
    let decimal = |v: f64| trimmed(&fixed(v, digits));
    match value {
        Value::Number(number) => decimal(number),
        Value::Integer(integer) => fixed(integer as f64, 0),
        Value::Rgb(color) if color.is_grey() => decimal(color.r),
        Value::Rgb(color) => color.channels().map(decimal).join(" "),
        Value::Vector(vector) => vector.to_array().map(decimal).join(" "),
        Value::Truth(truth) => truth.to_string(),
        Value::Word(word) => word.to_string(),
    }
}

/// A difference of nearly equal values, by its order of magnitude: `2.2e−16`, `0`.
pub(super) fn difference(value: Value) -> String {
    let small = |v: f64| match v {
        0.0 => "0".to_string(),
        v => format!("{v:.1e}").replace('-', "−"),
    };
    match value {
        Value::Number(number) => small(number),
        Value::Rgb(color) if color.is_grey() => small(color.r),
        Value::Rgb(color) => color.channels().map(small).join(" "),
        value => short(value, 6),
    }
}

/// The colour that a value is, where it is one.
pub(super) fn swatch(value: Option<Value>) -> Ink {
    match value {
        Some(Value::Rgb(color)) => Ink::Rgb(color),
        _ => Ink::Surface,
    }
}

/// Black or white, whichever is read more easily on a value's colour.
pub(super) fn on_swatch(value: Option<Value>) -> Ink {
    match value {
        // The luminance whose contrast against black and against white is the same (WCAG 2.1).
        Some(Value::Rgb(color)) if color.luminance() < 0.179 => Ink::Rgb(Rgb::WHITE),
        Some(Value::Rgb(_)) => Ink::Rgb(Rgb::BLACK),
        _ => Ink::Text,
    }
}

/// How the sentence begins that says a step in words: its number and kind.
pub(super) fn step_in_words(show: &Show) -> String {
    let walk = show.run.walk();
    let step = STEP.in_language(show.language);
    if walk.is_empty() {
        return format!("{step} –");
    }
    let position = walk.position();
    format!("{step} {position}, {}", walk.kind(position))
}

fn trimmed(decimal: &str) -> String {
    if decimal.contains('.') {
        decimal
            .trim_end_matches('0')
            .trim_end_matches('.')
            .to_string()
    } else {
        decimal.to_string()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn grey_is_one_number_and_differences_are_magnitudes() {
        assert_eq!(short(Rgb::splat(0.514).into(), 3), "0.514");
        assert_eq!(short(Rgb::new(0.5, 0.25, -0.1).into(), 2), "0.5 0.25 −0.1");
        assert_eq!(short(Value::Number(6.0), 2), "6");
        assert_eq!(difference(Value::Number(-f64::EPSILON)), "−2.2e−16");
        assert_eq!(difference(Rgb::BLACK.into()), "0");
        assert_eq!(value_of(crate::algorithms::flat::Nothing), None);
        assert_eq!(on_swatch(Some(Rgb::BLACK.into())), Ink::Rgb(Rgb::WHITE));
    }
}
