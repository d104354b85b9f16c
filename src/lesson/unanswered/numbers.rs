//! The numbers that stand in texts, and those in values.

use crate::language::Language;
use crate::record::Value;

/// A number in a text, and half of its last place.
#[derive(Clone, Copy, Debug)]
pub(super) struct Written {
    pub value: f64,
    pub half: f64,
}

impl Written {
    /// Whether it is `value`, rounded.
    pub fn rounds(&self, value: f64) -> bool {
        (self.value - value).abs() <= self.half * (1.0 + 1e-9)
    }
}

/// The numbers in a text, by the decimal sign of the language. What follows a letter or `_` is an index.
pub(super) fn numbers(text: &str, language: Language) -> Vec<Written> {
    let separator = if language == Language::Indonesian {
        ','
    } else {
        '.'
    };
    let characters: Vec<char> = text.chars().collect();
    let mut numbers = Vec::new();
    let mut at = 0;
    while at < characters.len() {
        let start = at;
        let is_digit = |at: usize| characters.get(at).is_some_and(char::is_ascii_digit);
        if !is_digit(at) {
            at += 1;
            continue;
        }
        while is_digit(at) {
            at += 1;
        }
        let mut decimals = 0;
        if characters.get(at) == Some(&separator) && is_digit(at + 1) {
            at += 1;
            let first = at;
            while is_digit(at) {
                at += 1;
            }
            decimals = at - first;
        }
        let before = start.checked_sub(1).map(|before| characters[before]);
        if before.is_some_and(|c| c.is_alphabetic() || c == '_') {
            continue;
        }
        let digits: String = characters[start..at].iter().collect();
        let mut value: f64 = digits.replace(separator, ".").parse().unwrap();
        let mut half = 0.5 * 10_f64.powi(-(decimals as i32));
        let rest: String = characters[at..].iter().collect();
        if let Some(power) = rest.strip_prefix("·10") {
            let sign = |c: &char| "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().position(|digit| digit == *c);
            let negative = power.starts_with('⁻');
            let digits = power.trim_start_matches('⁻').chars();
            let exponent = digits
                .map_while(|c| sign(&c))
                .fold(0, |all, one| 10 * all + one as i32);
            let scale = 10_f64.powi(if negative { -exponent } else { exponent });
            value *= scale;
            half *= scale;
        }
        if before == Some('−') {
            value = -value;
        }
        numbers.push(Written { value, half });
    }
    numbers
}

/// The numbers in a value.
pub(super) fn parts(value: Value) -> Vec<f64> {
    match value {
        Value::Number(number) => vec![number],
        Value::Integer(whole) => vec![whole as f64],
        Value::Rgb(color) => color.channels().to_vec(),
        Value::Vector(vector) => vector.to_array().to_vec(),
        Value::Truth(_) | Value::Word(_) => Vec::new(),
    }
}
