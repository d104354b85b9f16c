//! A number, give or take a tolerance.

use crate::language::{Language, Message};

const TOO_SMALL: Message = Message("hint-too-small");
const TOO_LARGE: Message = Message("hint-too-large");

/// A number as an answer is typed: with a decimal point, or a comma as Indonesian writes it.
pub fn read_number(text: &str) -> Option<f64> {
    let number: f64 = text
        .trim()
        .replace(',', ".")
        .replace('−', "-")
        .parse()
        .ok()?;
    number.is_finite().then_some(number)
}

/// To the decimal place that still counts under `tolerance`, as it would be answered.
pub fn rounded(value: f64, tolerance: f64) -> f64 {
    if tolerance <= 0.0 {
        return value;
    }
    let places = 10f64.powf(-tolerance.log10().floor());
    (value * places).round() / places
}

/// On which side of the value a guess lies.
pub(super) fn hint(value: f64, guess: &str, language: Language) -> String {
    let is_small = read_number(guess).is_some_and(|guess| guess < value);
    let side = if is_small { TOO_SMALL } else { TOO_LARGE };
    side.text(language).to_owned()
}
