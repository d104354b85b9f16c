//! The formula of the step: with symbols, with this step's numbers under it, and the result; where a step computes nothing,
//! a sentence. All numbers are told values.

mod set;
mod template;

use super::PanelInput;
use super::message::{NO_STEPS, message};
use super::names;
use super::values::shown;
use crate::algorithms::prepared_scene::PreparedScene;
use crate::language::{Language, Message};
use crate::picture::{Ink, Picture, Style, symbol, wrap};
use crate::record::Value;
use crate::vocabulary::{Entry, Formula, Kind, When};
use glam::Vec2;
use set::{Atom, Voice, flow, set_pieces};
use template::{Known, Piece, parse, places};

const MARGIN: f32 = 10.0;
const CHANNELS: [&str; 3] = ["red", "green", "blue"];

pub fn draw(input: &PanelInput, size: Vec2) -> Picture {
    let walk = input.run.walk();
    if walk.is_empty() {
        return message(NO_STEPS, input.language, size);
    }
    let known = Known::at(walk, walk.position());
    let Some(entry) = entry(walk.declared(walk.position()), &known) else {
        return message(NO_FORMULA, input.language, size);
    };
    let formulas = formulas(entry, &known);
    let says = filled(entry.sentence, &known, input.run.prepared(), input.language);

    let mut picture = Picture::new(size.x, size.y);
    let layout = |detail: &Detail, text: f32| {
        Layout::new(
            &says,
            &formulas,
            &known,
            input.language,
            size.x,
            text,
            detail,
        )
    };
    let room = size.y - 2.0 * MARGIN;
    let fitting = DETAILS.iter().find_map(|detail| {
        let steps = (detail.largest - detail.smallest) as usize;
        (0..=steps)
            .map(|i| layout(detail, detail.largest - i as f32))
            .find(|layout| layout.fits && layout.height <= room)
    });
    let layout = fitting.unwrap_or_else(|| layout(&DETAILS[DETAILS.len() - 1], 11.0));
    layout.draw(&mut picture, room);
    picture.alt = in_words(&says, &formulas, &known, input.language);
    picture
}

const NO_FORMULA: Message = Message("formula-no-formula");

/// The first entry of `kind` that fits.
fn entry(kind: &'static Kind, known: &Known) -> Option<&'static Entry> {
    kind.entries.iter().find(|entry| holds(entry.when, known))
}

fn holds(when: When, known: &Known) -> bool {
    let value = |name| known.get(name).map(|recorded| recorded.field.value);
    let number = |name| match value(name) {
        Some(Value::Number(v)) => v,
        Some(Value::Integer(v)) => v as f64,
        _ => f64::NAN,
    };
    match when {
        When::Always => true,
        When::Recorded(name) => value(name).is_some(),
        When::Unrecorded(name) => value(name).is_none(),
        When::Is(name, word) => value(name) == Some(Value::Word(word)),
        When::True(name) => value(name) == Some(Value::Truth(true)),
        When::Negative(name) => number(name) < 0.0,
        When::NotPositive(name) => number(name) <= 0.0,
        When::Finite(name) => number(name).is_finite(),
    }
}

/// A formula of the step, split at its equals sign.
struct Parsed {
    left: Vec<Piece>,
    right: Vec<Piece>,
    note: Option<Message>,
}

fn formulas(entry: &Entry, known: &Known) -> Vec<Parsed> {
    let applies = |formula: &&Formula| {
        holds(formula.when, known)
            && places(&parse(formula.template))
                .into_iter()
                .all(|place| known.values(place).is_some())
    };
    let parsed = |formula: &Formula| {
        let (left, right) = formula
            .template
            .split_once(" = ")
            .unwrap_or((formula.template, ""));
        Parsed {
            left: parse(left),
            right: parse(right),
            note: formula.note,
        }
    };
    entry.formulas.iter().filter(applies).map(parsed).collect()
}

impl Parsed {
    /// The value that the formula defines, where it is no mere relation.
    fn result(&self, known: &Known) -> Option<Value> {
        match self.left.as_slice() {
            [Piece::Place(place)] => known.values(place)?.first().copied(),
            _ => None,
        }
    }

    /// Whether a colour with unequal channels takes part: then each channel has a row of its own.
    fn is_coloured(&self, known: &Known) -> bool {
        let all = [places(&self.left), places(&self.right)].concat();
        all.into_iter()
            .filter_map(|place| known.values(place))
            .flatten()
            .any(|value| matches!(value, Value::Rgb(color) if !color.is_grey()))
    }
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
        let number = shown(value, 4, language);
        // Lights have no names, only kinds.
        let thing = names::of_field(prepared, name, value, language).filter(|_| name != "light");
        Some(match thing {
            Some(thing) => format!("{number} ({thing})"),
            None => number,
        })
    })
}

fn in_words(says: &str, formulas: &[Parsed], known: &Known, language: Language) -> String {
    let mut text = says.replace(['{', '}'], "");
    for formula in formulas {
        if let (Some(value), [Piece::Place(place)]) = (formula.result(known), &formula.left[..]) {
            let value = shown(value, 4, language);
            text.push_str(&format!(" {} = {value}.", symbol(&place.name)));
        }
    }
    text
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
        formulas: &[Parsed],
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
            formula_lines(&mut layout, formula, known, language, width, text, detail);
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
    formula: &Parsed,
    known: &Known,
    language: Language,
    width: f32,
    text: f32,
    detail: &Detail,
) {
    let stacked = detail.stacked;
    let set = |pieces: &[Piece], voice| set_pieces(pieces, voice, known, language, text, stacked);
    let equals = || Atom::text("= ".to_string(), Style::Label.size(text));
    let result = |value: String| {
        let style = Style::LabelBold.size(text).ink(Ink::This);
        vec![equals(), Atom::text(value, style)]
    };
    let indent = 1.2 * text;
    let coloured = formula.is_coloured(known);
    let value = formula.result(known);
    let whole = value.map(|value| shown(value, 4, language));

    let mut symbols = set(&formula.left, Voice::Symbols);
    let has_numbers = !places(&formula.right).is_empty();
    // A value alone, a formula without numbers of its own, or the shortest form: one row with the result.
    if formula.right.is_empty() || !detail.symbols {
        match whole {
            Some(whole) => symbols.extend(spaced(result(whole), text)),
            None => {
                layout.push(symbols, width, indent, 0.5 * text);
                symbols = set(&formula.left, Voice::Numbers(0));
            }
        }
        layout.push(symbols, width, indent, 0.5 * text);
        return;
    }
    let mut right = vec![equals()];
    right.extend(set(&formula.right, Voice::Symbols));
    symbols.extend(spaced(right, text));
    let channels = match (has_numbers, coloured) {
        (false, _) => 0,
        (true, true) => detail.channels,
        (true, false) => detail.channels.min(1),
    };
    // Without numbers the result ends the row of the symbols.
    if let (0, Some(whole)) = (channels, &whole) {
        symbols.extend(spaced(result(whole.clone()), text));
    }
    layout.push(symbols, width, indent, 0.5 * text);

    for (channel, name) in CHANNELS.iter().enumerate().take(channels) {
        let mut row = Vec::new();
        if coloured {
            let name = names::word(name, language);
            let style = Style::Body.size(text.min(12.0)).ink(Ink::Muted);
            row.push(Atom::text(name, style));
        }
        let mut numbers = vec![equals()];
        numbers.extend(set(&formula.right, Voice::Numbers(channel)));
        row.extend(spaced(numbers, if coloured { text } else { 0.0 }));
        if let (true, Some(value)) = (coloured, value) {
            let end = result(set::number_text(value, channel, language));
            row.extend(spaced(end, text));
        }
        layout.push(row, width, indent, 0.25 * text);
    }
    // Of a colour every channel has its result, unless not all are shown.
    let all_told = channels == 0 || coloured && channels == CHANNELS.len();
    if let (false, Some(whole)) = (all_told, whole) {
        layout.push(result(whole), width, indent, 0.25 * text);
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
