//! The lines of the panel at one size of text: sentences, and each formula with symbols, with numbers, and its result.

use super::super::channels::DRAWN;
use super::super::values::shown;
use super::known::Known;
use super::pieces::pieces;
use super::set::{Atom, Line, Voice, flow, number_text, set_pieces};
use super::{MARGIN, has_numbers, is_coloured, result};
use crate::algorithms::enclosure::CHANNELS;
use crate::language::{Language, Message};
use crate::picture::{Ink, Picture, Style, Tag, wrap};
use crate::vocabulary::Formula;
use crate::vocabulary::expression::{Equation, Expression};
use std::ops::Range;

/// How much is shown: less where there is less room.
pub struct Detail {
    pub largest: f32,
    pub smallest: f32,
    /// Fractions with a bar, rather than a slash.
    stacked: bool,
    sentences: bool,
    symbols: bool,
    /// Of how many channels the numbers are shown, where they differ; of one, it is the one that is worked out.
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

/// What does not fit in a small panel.
const MORE: Message = Message("formula-more");

/// From here on the details leave out numbers.
pub const SHORT: usize = 7;

pub const DETAILS: [Detail; 9] = [
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

/// The values that formulas are set with, and how.
#[derive(Clone, Copy)]
pub struct Values<'a> {
    pub known: &'a Known<'a>,
    /// The channel that is worked out where there is room for one.
    pub worked: usize,
    pub language: Language,
}

/// The lines of the panel at one size of text.
pub struct Layout {
    lines: Vec<Line>,
    pub height: f32,
    pub fits: bool,
}

impl Layout {
    pub fn new(
        says: &str,
        [formulas, left_out]: [&[&Formula]; 2],
        values: Values,
        width: f32,
        text: f32,
        detail: &Detail,
    ) -> Self {
        let language = values.language;
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
            formula_lines(&mut layout, equation, values, width, text, detail);
        }
        if !left_out.is_empty() {
            let count = left_out.len().to_string();
            sentence(
                &mut layout,
                &MORE.format(language, &[("count", &count)]),
                0.5 * text,
            );
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

    pub fn draw(self, picture: &mut Picture, room: f32) {
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
    values: Values,
    width: f32,
    text: f32,
    detail: &Detail,
) {
    let Values {
        known,
        worked,
        language,
    } = values;
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

    let first = if coloured && channels == 1 { worked } else { 0 };
    for channel in first..first + channels {
        let mut row = Vec::new();
        if coloured {
            // Where one is worked out, a click on another's letter chooses that.
            let shown = if channels == 1 {
                0..CHANNELS.len()
            } else {
                channel..channel + 1
            };
            row.push(letters(shown, channel, text.min(12.0)));
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
            let end = ending(number_text(value, channel, language));
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

/// The letters of channels, that of the row bold.
fn letters(channels: Range<usize>, of_row: usize, size: f32) -> Atom {
    let letter = |channel: usize| {
        let style = match channel == of_row {
            true => Style::LabelBold.size(size),
            false => Style::Label.size(size).ink(Ink::Muted),
        };
        Atom::text(DRAWN[channel].letter.to_string(), style).tagged(Tag::Channel(channel))
    };
    let mut letters = Atom::default();
    for channel in channels {
        letters.append(letter(channel), 0.0);
    }
    letters
}

/// Atoms that may begin a new line, with a space before.
fn spaced(mut atoms: Vec<Atom>, text: f32) -> Vec<Atom> {
    if let Some(first) = atoms.first_mut() {
        first.breaks = true;
        first.space = 0.4 * text;
    }
    atoms
}
