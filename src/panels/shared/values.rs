//! How panels write and colour the values of events.

use super::names;
use crate::color::Rgb;
use crate::language::{Language, Message};
use crate::panels::PanelInput;
use crate::picture::Ink;
use crate::record::Value;
use crate::vocabulary::counted;

/// A value with at most `digits` decimals: one number for a grey colour, three for another.
pub fn short(value: Value, digits: usize, language: Language) -> String {
    let decimal = |v: f64| language.short(v, digits);
    match value {
        Value::Number(number) => decimal(number),
        Value::Integer(integer) => decimal(integer as f64),
        Value::Rgb(color) if color.is_grey() => decimal(color.r),
        Value::Rgb(color) => color.channels().map(decimal).join(" "),
        Value::Vector(vector) => vector.to_array().map(decimal).join(" "),
        Value::Truth(truth) => yes_or_no(truth).text(language).to_string(),
        Value::Word(word) => names::word(word, language),
    }
}

/// A difference of nearly equal values, to two digits: `2.2·10⁻¹⁶`, `0`; of vectors, its length.
pub fn difference(value: Value, language: Language) -> String {
    let small = |v: f64| language.significant(v, 2);
    match value {
        Value::Number(number) => small(number),
        Value::Rgb(color) if color.is_grey() => small(color.r),
        Value::Rgb(color) => color.channels().map(small).join(" "),
        Value::Vector(vector) => small(vector.length()),
        value => short(value, 6, language),
    }
}

/// The colour that a value is, where it is one.
pub fn swatch(value: Option<Value>) -> Ink {
    match value {
        Some(Value::Rgb(color)) => Ink::Rgb(color),
        _ => Ink::Surface,
    }
}

/// Black or white, whichever is read more easily on a value's colour.
pub fn on_swatch(value: Option<Value>) -> Ink {
    match value {
        // The luminance whose contrast against black and against white is the same (WCAG 2.1).
        Some(Value::Rgb(color)) if color.luminance() < 0.179 => Ink::Rgb(Rgb::WHITE),
        Some(Value::Rgb(_)) => Ink::Rgb(Rgb::BLACK),
        _ => Ink::Text,
    }
}

/// How the sentence begins that says a step in words: its number and kind, and at the end of an iteration, which one that is.
pub fn step_in_words(input: &PanelInput) -> String {
    let walk = input.run.walk();
    if walk.is_empty() {
        return Message("panels-no-step").text(input.language).to_string();
    }
    let position = walk.position();
    let kind = names::kind(walk.kind(position), input.language);
    let step = position.to_string();
    match names::iteration_ended(walk, position, input.language) {
        Some(scope) => Message("panels-step-and-scope").format(
            input.language,
            &[("step", &step), ("kind", &kind), ("scope", &scope)],
        ),
        None => Message("panels-step").format(input.language, &[("step", &step), ("kind", &kind)]),
    }
}

fn yes_or_no(truth: bool) -> Message {
    Message(if truth { "panels-yes" } else { "panels-no" })
}

/// A value in one line: numbers to six digits, a grey as one number, vectors and colours with `decimals` each.
pub fn shown(value: Value, decimals: usize, language: Language) -> String {
    match value {
        Value::Number(v) => language.number(v),
        Value::Integer(v) => language.number(v as f64),
        Value::Rgb(color) if color.is_grey() => language.number(color.r),
        Value::Rgb(color) => color
            .channels()
            .map(|channel| component(channel, decimals, language))
            .join("  "),
        Value::Vector(v) => {
            let components = v.to_array().map(|v| language.fixed(v, decimals));
            format!("({})", language.list(components))
        }
        Value::Truth(truth) => yes_or_no(truth).text(language).to_string(),
        Value::Word(word) => names::word(word, language),
    }
}

/// With `decimals`, but what would round to zero with two digits: a difference of 10⁻¹⁷ is none of 0.
fn component(v: f64, decimals: usize, language: Language) -> String {
    let rounds_to_zero = v.abs() < 0.5 * 10_f64.powi(-(decimals as i32));
    if v == 0.0 {
        "0".to_string()
    } else if rounds_to_zero {
        language.significant(v, 2)
    } else {
        language.fixed(v, decimals)
    }
}

/// The whole step as a sentence: its number, its kind, and its values.
pub fn step_as_sentence(input: &PanelInput) -> String {
    let walk = input.run.walk();
    if walk.is_empty() {
        return step_in_words(input);
    }
    let values: Vec<String> = walk
        .own_fields(walk.position())
        .iter()
        .map(|field| {
            let name = names::field(field.name, input.language);
            let value = counted(field.name, field.value);
            format!("{name} = {}", short(value, 6, input.language))
        })
        .collect();
    sentence(&step_in_words(input), &values, input.language)
}

/// What a step is called, with its values, as a sentence.
pub fn sentence(step: &str, values: &[String], language: Language) -> String {
    if values.is_empty() {
        return format!("{step}.");
    }
    let values = values.join(", ");
    Message("panels-step-and-values").format(language, &[("step", step), ("values", &values)])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algorithms::focus::Focus;
    use crate::algorithms::radiosity::Solver;
    use crate::panels::fixture::Fixture;
    use glam::DVec3;

    #[test]
    fn the_end_of_an_iteration_has_its_number() {
        let mut fixture = Fixture::room(Solver::GaussSeidel, Focus::Frame);
        for k in [0, 2] {
            fixture.go_to("IterationDone", k);
            let said = step_in_words(&fixture.input());
            assert!(
                said.ends_with(&format!("Iteration done (iteration {k})")),
                "{said}"
            );
        }
    }

    #[test]
    fn grey_is_one_number_and_differences_are_magnitudes() {
        assert_eq!(
            short(Rgb::splat(0.514).into(), 3, Language::English),
            "0.514"
        );
        assert_eq!(
            short(Rgb::new(0.5, 0.25, -0.1).into(), 2, Language::English),
            "0.5 0.25 −0.1"
        );
        assert_eq!(short(Value::Number(6.0), 2, Language::English), "6");
        assert_eq!(
            difference(Value::Number(-f64::EPSILON), Language::English),
            "−2.2·10⁻¹⁶"
        );
        assert_eq!(difference(Rgb::BLACK.into(), Language::English), "0");
        assert_eq!(on_swatch(Some(Rgb::BLACK.into())), Ink::Rgb(Rgb::WHITE));
    }

    #[test]
    fn every_type_of_value_has_its_form() {
        let en = |value| shown(value, 3, Language::English);
        assert_eq!(en(Value::Number(1.0 / 3.0)), "0.333333");
        assert_eq!(en(Value::Integer(-12)), "−12");
        assert_eq!(en(Rgb::splat(0.25).into()), "0.25");
        assert_eq!(
            en(Rgb::new(0.5, -1.25e-17, 0.0).into()),
            "0.500  −1.2·10⁻¹⁷  0"
        );
        assert_eq!(
            en(DVec3::new(0.0, -0.6, 0.8).into()),
            "(0.000, −0.600, 0.800)"
        );
        assert_eq!(shown(true.into(), 3, Language::Indonesian), "ya");
    }
}
