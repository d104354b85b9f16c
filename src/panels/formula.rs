//! The formula of the step: with symbols, with this step's numbers under it, and the result; where a step computes nothing,
//! a sentence. All numbers are values of the run or of the scene, or follow from them.

mod evaluated;
mod known;
mod pieces;
mod set;

use super::message::{NO_STEPS, message};
use super::names;
use super::values::shown;
use super::{PanelInput, Properties};
use crate::algorithms::enclosure::CHANNELS;
use crate::algorithms::prepared_scene::PreparedScene;
use crate::language::{Language, Message};
use crate::picture::{Ink, Picture, Style, wrap};
use crate::record::Value;
use crate::replay::Run;
use crate::vocabulary::expression::{Equation, Expression, Relation, Term, evaluate};
use crate::vocabulary::{Entry, Formula, Kind, When, counted};
pub use evaluated::{Evaluated, evaluated};
use glam::Vec2;
use known::Known;
use pieces::pieces;
use set::{Atom, Voice, flow, set_pieces};

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
    let formulas = formulas(entry, &mut known);
    let says = filled(entry.sentence, &known, prepared, input.language);

    let mut picture = Picture::new(size.x, size.y);
    let layout = |detail: &Detail, count: usize, text: f32| {
        Layout::new(
            &says,
            &formulas[..count],
            &known,
            input.language,
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

/// The least height at which the first formula can be read with its numbers, in a panel of that width.
pub fn least_height(input: &PanelInput, width: f32) -> f32 {
    let walk = input.run.walk();
    let mut known = match walk.is_empty() {
        true => return 0.0,
        false => Known::at(input.run, walk.position()),
    };
    let Some(entry) = entry(walk.declared(walk.position()), &known) else {
        return 0.0;
    };
    let formulas = formulas(entry, &mut known);
    let first = &formulas[..formulas.len().min(1)];
    let heights = DETAILS[..SHORT].iter().map(|detail| {
        let (text, language) = (detail.smallest, input.language);
        Layout::new("", first, &known, language, width, text, detail)
    });
    let fitting = heights.filter(|layout| layout.fits);
    let least = fitting.map(|layout| layout.height).reduce(f32::min);
    least.map_or(0.0, |height| height + 2.0 * MARGIN)
}

const NO_FORMULA: Message = Message("formula-no-formula");

/// The first entry of `kind` that fits.
fn entry(kind: &'static Kind, known: &Known) -> Option<&'static Entry> {
    kind.entries.iter().find(|entry| holds(entry.when, known))
}

fn holds(when: When, known: &Known) -> bool {
    let number = |name| match known.value(name) {
        Some(Value::Number(v)) => v,
        Some(Value::Integer(v)) => v as f64,
        _ => f64::NAN,
    };
    match when {
        When::Always => true,
        When::Recorded(name) => known.value(name).is_some(),
        When::Unrecorded(name) => known.value(name).is_none(),
        When::Is(name, word) => known.value(name) == Some(Value::Word(word)),
        When::True(name) => known.value(name) == Some(Value::Truth(true)),
        When::Negative(name) => number(name) < 0.0,
        When::NotPositive(name) => number(name) <= 0.0,
        When::Finite(name) => number(name).is_finite(),
        When::Equals(name, whole) => known.value(name) == Some(Value::Integer(whole)),
        When::AtLeast(name, bound) => number(name) >= bound,
        When::Same(a, b) => known.value(a) == known.value(b),
        When::Not(when) => !holds(*when, known),
        When::All(all) => all.iter().all(|when| holds(*when, known)),
    }
}

/// The formulas that hold at the step, whose left sides are known; what they define is known from there on.
fn formulas(entry: &'static Entry, known: &mut Known) -> Vec<&'static Formula> {
    let mut found = Vec::new();
    for formula in entry.formulas {
        let equation = formula.equation();
        if let (Some(subject), Some((Relation::Defined, right))) =
            (equation.subject(), &equation.right)
        {
            let value = evaluate(right, &|reference| known.values(reference));
            if let Some(Term::Number(number)) = value {
                known.define(subject.name, Value::Number(number.value));
            }
        }
        let left = equation.left.references();
        if holds(formula.when, known) && left.into_iter().all(|left| known.values(left).is_some()) {
            found.push(formula);
        }
    }
    found
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

/// How much is shown: less where there is less room.
struct Detail {
    largest: f32,
    smallest: f32,
    /// Fractions with a bar, rather than a slash.
    stacked: bool,
    sentences: bool,
    symbols: bool,
    /// Of how many channels the numbers are shown, where they differ.
    channels: usize,
}

const fn detail(
    (largest, smallest): (f32, f32),
    [stacked, sentences, symbols]: [bool; 3],
    channels: usize,
) -> Detail {
    Detail {
        largest,
        smallest,
        stacked,
        sentences,
        symbols,
        channels,
    }
}

/// From here on the details leave out numbers.
const SHORT: usize = 7;

const DETAILS: [Detail; 9] = [
    detail((17.0, 12.0), [true, true, true], 3),
    detail((14.0, 12.0), [true, false, true], 3),
    detail((13.0, 11.0), [false, true, true], 3),
    detail((13.0, 11.0), [false, false, true], 3),
    detail((13.0, 11.0), [true, true, true], 1),
    detail((13.0, 11.0), [true, false, true], 1),
    detail((13.0, 11.0), [false, false, true], 1),
    detail((13.0, 11.0), [true, false, true], 0),
    detail((12.0, 11.0), [false, false, false], 0),
];

/// The lines of the panel at one size of text.
struct Layout {
    lines: Vec<set::Line>,
    height: f32,
    fits: bool,
}

impl Layout {
    fn new(
        says: &str,
        formulas: &[&Formula],
        known: &Known,
        language: Language,
        width: f32,
        text: f32,
        detail: &Detail,
    ) -> Self {
        let width = width - 2.0 * MARGIN;
        let mut layout = Layout {
            lines: Vec::new(),
            height: 0.0,
            fits: true,
        };
        let sentence = |layout: &mut Layout, strings: &str, above: f32| {
            let size = (text - 2.0).clamp(11.0, 13.0);
            for (i, line) in wrap(strings, Style::Label, size, width)
                .into_iter()
                .enumerate()
            {
                let style = Style::Label.size(size).ink(Ink::Muted);
                let gap = if i == 0 { above } else { 1.0 };
                layout.push(vec![Atom::text(line, style)], width, 0.0, gap);
            }
        };
        if detail.sentences || formulas.is_empty() {
            sentence(&mut layout, says, 0.0);
        }
        for formula in formulas {
            let above = 0.5 * text;
            if let Some(note) = formula.note.filter(|_| detail.sentences) {
                sentence(&mut layout, note.text(language), above);
            }
            let equation = formula.equation();
            formula_lines(&mut layout, equation, known, language, width, text, detail);
        }
        layout
    }

    fn push(&mut self, atoms: Vec<Atom>, width: f32, indent: f32, gap: f32) {
        let (lines, fits) = flow(atoms, width, indent);
        for (i, mut line) in lines.into_iter().enumerate() {
            line.gap = if i == 0 && !self.lines.is_empty() {
                gap
            } else {
                2.0
            };
            self.height += line.gap + line.height();
            self.lines.push(line);
        }
        self.fits &= fits;
    }

    fn draw(self, picture: &mut Picture, room: f32) {
        let mut y = MARGIN;
        for line in self.lines {
            y += line.gap;
            if y + line.height() > MARGIN + room {
                break;
            }
            let bottom = y + line.height();
            line.draw(picture, MARGIN, y);
            y = bottom;
        }
    }
}

/// The rows of one formula: symbols, numbers, result.
fn formula_lines(
    layout: &mut Layout,
    equation: &Equation,
    known: &Known,
    language: Language,
    width: f32,
    text: f32,
    detail: &Detail,
) {
    let stacked = detail.stacked;
    let set =
        |side: &Expression, voice| set_pieces(&pieces(side), voice, known, language, text, stacked);
    let sign = |sign: &str| Atom::text(format!("{sign} "), Style::Label.size(text));
    let ending = |value: String| {
        let style = Style::LabelBold.size(text).ink(Ink::This);
        vec![sign("="), Atom::text(value, style)]
    };
    let indent = 1.2 * text;
    let coloured = is_coloured(equation, known);
    let value = result(equation, known);
    let whole = value.map(|value| shown(value, 4, language));

    let mut symbols = set(&equation.left, Voice::Symbols);
    let is_short = whole.is_some() && !detail.symbols;
    let Some((relation, right)) = equation.right.as_ref().filter(|_| !is_short) else {
        // A value alone, or the shortest form: one row with the result.
        symbols.extend(
            whole
                .into_iter()
                .flat_map(|whole| spaced(ending(whole), text)),
        );
        layout.push(symbols, width, indent, 0.5 * text);
        return;
    };
    let mut right_symbols = vec![sign(relation.sign())];
    right_symbols.extend(set(right, Voice::Symbols));
    symbols.extend(spaced(right_symbols, text));
    let has_numbers =
        has_numbers(right, known) || value.is_none() && has_numbers(&equation.left, known);
    let channels = match (has_numbers, coloured) {
        (false, _) => 0,
        (true, true) => detail.channels,
        (true, false) => detail.channels.min(1),
    };
    // Without numbers the result ends the row of the symbols.
    if let (0, Some(whole)) = (channels, &whole) {
        symbols.extend(spaced(ending(whole.clone()), text));
    }
    layout.push(symbols, width, indent, 0.5 * text);

    for (channel, name) in CHANNELS.iter().enumerate().take(channels) {
        let mut row = Vec::new();
        if coloured {
            let name = names::word(name, language);
            let style = Style::Body.size(text.min(12.0)).ink(Ink::Muted);
            row.push(Atom::text(name, style));
        }
        // A comparison has no result: both sides are shown.
        if value.is_none() {
            row.extend(set(&equation.left, Voice::Numbers(channel)));
        }
        let mut numbers = vec![sign(relation.sign())];
        numbers.extend(set(right, Voice::Numbers(channel)));
        let is_first = row.is_empty();
        row.extend(spaced(numbers, if is_first { 0.0 } else { text }));
        if let (true, Some(value)) = (coloured, value) {
            let end = ending(set::number_text(value, channel, language));
            row.extend(spaced(end, text));
        }
        layout.push(row, width, indent, 0.25 * text);
    }
    // Of a colour every channel has its result, unless not all are shown.
    let all_shown = channels == 0 || coloured && channels == CHANNELS.len();
    if let (false, Some(whole)) = (all_shown, whole) {
        layout.push(ending(whole), width, indent, 0.25 * text);
    }
}

/// Atoms that may begin a new line, with a space before.
fn spaced(mut atoms: Vec<Atom>, text: f32) -> Vec<Atom> {
    if let Some(first) = atoms.first_mut() {
        first.breaks = true;
        first.space = 0.4 * text;
    }
    atoms
}

#[cfg(test)]
mod tests;
