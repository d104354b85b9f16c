//! The formula of the step: with symbols, with this step's numbers under it, and the result; where a step computes nothing,
//! a sentence. All numbers are values of the run or of the scene, or follow from them.

mod evaluated;
mod known;
mod layout;
mod pieces;
mod set;
mod written;

use super::message::{NO_STEPS, message};
use super::names;
use super::values::shown;
use super::{PanelInput, Properties};
use crate::algorithms::prepared_scene::PreparedScene;
use crate::language::{Language, Message};
use crate::picture::Picture;
use crate::record::Value;
use crate::replay::Run;
use crate::vocabulary::expression::{Equation, Expression, Relation, evaluate};
use crate::vocabulary::{Entry, Formula, Kind, When, counted};
pub use evaluated::{Evaluated, Slip, evaluated, slipped};
use glam::Vec2;
use known::Known;
use layout::{DETAILS, Detail, Layout, SHORT, Values};
pub use written::written;

const MARGIN: f32 = 10.0;

pub const PANEL: Properties = Properties::titled(Message("app-formula"));

pub fn draw(input: &PanelInput, size: Vec2) -> Picture {
    let walk = input.run.walk();
    if walk.is_empty() {
        return message(NO_STEPS, input.language, size);
    }
    let prepared = input.run.prepared();
    let mut known = Known::at(input.run, walk.position());
    let Some(entry) = entry(walk.declared(walk.position()), &known) else {
        return message(NO_FORMULA, input.language, size);
    };
    let mut formulas = formulas(entry, &mut known);
    if let Some(presented) = input.presented {
        formulas.sort_by_key(|formula| !is_about(formula, presented));
    }
    let says = filled(entry.sentence, &known, prepared, input.language);
    let values = Values {
        known: &known,
        worked: worked_channel(input, &formulas, &known),
        language: input.language,
    };

    let mut picture = Picture::new(size.x, size.y);
    // From which formula on only their number is said.
    let counted_from = |count: usize| match input.presented {
        Some(_) => formulas.len(),
        None => count,
    };
    let layout = |detail: &Detail, count: usize, text: f32| {
        Layout::new(
            &says,
            [&formulas[..count], &formulas[counted_from(count)..]],
            values,
            size.x,
            text,
            detail,
        )
    };
    let room = size.y - 2.0 * MARGIN;
    // Before the numbers of the first formula go, the formulas after it do.
    let (with_numbers, short) = DETAILS.split_at(SHORT);
    let whole = with_numbers.iter().map(|detail| (detail, formulas.len()));
    let fewer = (1..formulas.len()).rev();
    let fewer = fewer.flat_map(|count| with_numbers.iter().map(move |detail| (detail, count)));
    let counts = (1..=formulas.len()).rev();
    let short = short.iter();
    let short = short.flat_map(|detail| counts.clone().map(move |count| (detail, count)));
    let fitting = whole.chain(fewer).chain(short).find_map(|(detail, count)| {
        let steps = (detail.largest - detail.smallest) as usize;
        (0..=steps)
            .map(|i| layout(detail, count, detail.largest - i as f32))
            .find(|layout| layout.fits && layout.height <= room)
    });
    let least = || layout(&DETAILS[DETAILS.len() - 1], formulas.len(), 11.0);
    let layout = fitting.unwrap_or_else(least);
    layout.draw(&mut picture, room);
    picture.alt = in_words(&says, &formulas, &known, input.language);
    picture
}

/// What a step does, in a sentence with its values; empty where the kind has none.
pub fn said(run: &Run, step: usize, language: Language) -> String {
    let known = Known::at(run, step);
    let entry = entry(run.walk().declared(step), &known);
    entry.map_or_else(String::new, |entry| {
        filled(entry.sentence, &known, run.prepared(), language)
    })
}

/// The same as the text of a lesson has it, with the names of its values in braces; what no lesson could fill in stands there as it is.
pub fn said_with_names(run: &Run, step: usize, language: Language) -> String {
    // Braces of the sentence itself would be taken for names.
    const OPEN: char = '\u{e000}';
    const CLOSE: char = '\u{e001}';
    let known = Known::at(run, step);
    let prepared = run.prepared();
    let Some(entry) = entry(run.walk().declared(step), &known) else {
        return String::new();
    };
    let fields = run.walk().fields(step);
    let text = entry.sentence.format_with(language, |name| {
        let value = fields
            .get(name)
            .filter(|&value| counted(name, value) == value);
        let thing = |value| names::of_field(prepared, name, value, language);
        match value {
            Some(value @ Value::Integer(_)) if thing(value).is_some() && name != "light" => {
                Some(format!("{OPEN}{name}{CLOSE} ({OPEN}{name}:name{CLOSE})"))
            }
            Some(Value::Number(_) | Value::Rgb(_) | Value::Vector(_)) => {
                Some(format!("{OPEN}{name}:3{CLOSE}"))
            }
            Some(Value::Integer(_) | Value::Word(_)) => Some(format!("{OPEN}{name}{CLOSE}")),
            _ => in_sentence(name, &known, prepared, language),
        }
    });
    let text = text.replace(['{', '}'], "");
    text.replace(OPEN, "{").replace(CLOSE, "}")
}

/// The least height at which the first formula can be read with its numbers, in a panel of that width.
pub fn least_height(input: &PanelInput, width: f32) -> f32 {
    height_of(input, width, 1)
}

/// The same for all formulas.
pub fn whole_height(input: &PanelInput, width: f32) -> f32 {
    height_of(input, width, usize::MAX)
}

fn height_of(input: &PanelInput, width: f32, count: usize) -> f32 {
    let walk = input.run.walk();
    let mut known = match walk.is_empty() {
        true => return 0.0,
        false => Known::at(input.run, walk.position()),
    };
    let Some(entry) = entry(walk.declared(walk.position()), &known) else {
        return 0.0;
    };
    let formulas = formulas(entry, &mut known);
    let shown = &formulas[..formulas.len().min(count)];
    let values = Values {
        known: &known,
        worked: worked_channel(input, &formulas, &known),
        language: input.language,
    };
    let heights = DETAILS[..SHORT].iter().map(|detail| {
        let text = detail.smallest;
        Layout::new("", [shown, &[]], values, width, text, detail)
    });
    let fitting = heights.filter(|layout| layout.fits);
    let least = fitting.map(|layout| layout.height).reduce(f32::min);
    least.map_or(0.0, |height| height + 2.0 * MARGIN)
}

/// The channel that is worked out: the one that was chosen, else that in which the first coloured result is largest.
fn worked_channel(input: &PanelInput, formulas: &[&Formula], known: &Known) -> usize {
    let mut results = formulas
        .iter()
        .filter_map(|formula| result(formula.equation(), known));
    let color = results.find_map(|value| match value {
        Value::Rgb(color) if !color.is_grey() => Some(color),
        _ => None,
    });
    input.channel.unwrap_or_else(|| {
        let channels = color.map_or([0.0; 3], |color| color.channels());
        // The first of equals.
        let larger = |best: usize, next: usize| {
            if channels[next] > channels[best] {
                next
            } else {
                best
            }
        };
        (0..channels.len()).fold(0, larger)
    })
}

const NO_FORMULA: Message = Message("formula-no-formula");

/// The first entry of `kind` that fits.
fn entry(kind: &'static Kind, known: &Known) -> Option<&'static Entry> {
    kind.entries.iter().find(|entry| holds(entry.when, known))
}

fn holds(when: When, known: &Known) -> bool {
    let number = |name| match known.last(name) {
        Some(Value::Number(v)) => v,
        Some(Value::Integer(v)) => v as f64,
        _ => f64::NAN,
    };
    match when {
        When::Always => true,
        When::Recorded(name) => known.value(name).is_some(),
        When::Unrecorded(name) => known.value(name).is_none(),
        When::Is(name, word) => known.value(name) == Some(Value::Word(word)),
        When::True(name) => known.last(name) == Some(Value::Truth(true)),
        When::Negative(name) => number(name) < 0.0,
        When::Zero(name) => match known.last(name) {
            Some(Value::Vector(vector)) => vector.length() == 0.0,
            _ => number(name) == 0.0,
        },
        When::NotPositive(name) => number(name) <= 0.0,
        When::Finite(name) => number(name).is_finite(),
        When::Equals(name, whole) => known.value(name) == Some(Value::Integer(whole)),
        When::AtLeast(name, bound) => number(name) >= bound,
        When::Same(a, b) => {
            let [a, b] = [a, b].map(|text| known.referred(text));
            a.is_some() && a == b
        }
        When::Known(text) => known.referred(text).is_some(),
        When::Not(when) => !holds(*when, known),
        When::All(all) => all.iter().all(|when| holds(*when, known)),
    }
}

/// The formulas that hold at the step, whose left sides are known; what they define is known from there on.
fn formulas(entry: &'static Entry, known: &mut Known) -> Vec<&'static Formula> {
    let mut found = Vec::new();
    for formula in entry.formulas {
        let equation = formula.equation();
        if !holds(formula.when, known) {
            continue;
        }
        if let (Some(subject), Some((Relation::Defined, right))) =
            (equation.subject(), &equation.right)
            && let Some(term) = evaluate(right, &|reference| known.terms(reference))
        {
            known.define(subject.name, term);
        }
        let left = equation.left.references();
        if left.into_iter().all(|left| known.values(left).is_some()) {
            found.push(formula);
        }
    }
    found
}

/// Whether one of these values stands on the formula's left side.
fn is_about(formula: &Formula, names: &[String]) -> bool {
    let subject = formula.equation().subject();
    subject.is_some_and(|subject| names.iter().any(|name| name == subject.name))
}

/// The value that the formula is about, where it is no comparison.
fn result(equation: &Equation, known: &Known) -> Option<Value> {
    let compares = matches!(
        equation.right,
        Some((Relation::Less | Relation::AtLeast, _))
    );
    let subject = equation.subject().filter(|_| !compares)?;
    known.values(subject)?.first().copied()
}

/// Whether a colour with unequal channels takes part: then each channel has a row of its own.
fn is_coloured(equation: &Equation, known: &Known) -> bool {
    let references = equation.references().into_iter();
    references
        .filter_map(|reference| known.values(reference))
        .flatten()
        .any(|value| matches!(value, Value::Rgb(color) if !color.is_grey()))
}

/// Whether the expression says something else with numbers than with symbols.
fn has_numbers(expression: &Expression, known: &Known) -> bool {
    let references = expression.references().into_iter();
    references
        .map(|reference| known.values(reference))
        .any(|values| values.is_some())
}

/// The sentence of a step with its values; things of the scene by their names.
fn filled(
    sentence: Message,
    known: &Known,
    prepared: &PreparedScene,
    language: Language,
) -> String {
    sentence.format_with(language, |name| {
        in_sentence(name, known, prepared, language)
    })
}

/// A value as it stands in a sentence.
fn in_sentence(
    name: &str,
    known: &Known,
    prepared: &PreparedScene,
    language: Language,
) -> Option<String> {
    let value = known.get(name)?.field.value;
    if let Value::Word(word) = value {
        return Some(names::word(word, language));
    }
    let number = shown(counted(name, value), 4, language);
    // Lights have no names, only kinds.
    let thing = names::of_field(prepared, name, value, language).filter(|_| name != "light");
    Some(match thing {
        Some(thing) => format!("{number} ({thing})"),
        None => number,
    })
}

fn in_words(says: &str, formulas: &[&Formula], known: &Known, language: Language) -> String {
    let mut text = says.to_string();
    for equation in formulas.iter().map(|formula| formula.equation()) {
        if let (Some(value), Some(subject)) = (result(equation, known), equation.subject()) {
            let value = shown(value, 4, language);
            let symbol = names::symbol(subject, language);
            text.push_str(&format!(" {symbol} = {value}."));
        }
    }
    text.replace(['{', '}'], "")
}

#[cfg(test)]
mod tests;
