//! Sets the pieces of a formula in boxes beside each other, and lets them flow into lines.

use super::super::names;
use super::super::values::shown;
use super::known::Known;
use super::pieces::Piece;
use crate::language::Language;
use crate::picture::{Ink, Picture, Style, Tag, Text, ascent, descent};
use crate::record::Value;
use crate::vocabulary::expression::Reference;
use glam::Vec2;

/// Whether a formula is written with its symbols or with the numbers of a colour channel (0 for what has no colour).
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Voice {
    Symbols,
    Numbers(usize),
}

/// What stays together on a line: texts and fraction bars around a common baseline.
#[derive(Clone, Default)]
pub struct Atom {
    texts: Vec<(Vec2, String, Text, Option<Tag>)>,
    /// Left end and length.
    bars: Vec<(Vec2, f32)>,
    width: f32,
    up: f32,
    down: f32,
    /// Whether a line may end before it, and the space that else stands there.
    pub breaks: bool,
    pub space: f32,
}

impl Atom {
    pub fn text(text: String, style: Text) -> Self {
        Atom {
            width: style.width(&text),
            up: ascent(style.style, style.size),
            down: descent(style.style, style.size),
            texts: vec![(Vec2::ZERO, text, style, None)],
            ..Atom::default()
        }
    }

    /// Its texts one after the other.
    pub fn written(&self) -> String {
        self.texts
            .iter()
            .map(|(_, text, ..)| text.as_str())
            .collect()
    }

    /// The same, showing what the tag says.
    pub fn tagged(mut self, tag: Tag) -> Self {
        for text in &mut self.texts {
            text.3 = Some(tag);
        }
        self
    }

    /// Puts `other` to the right, its baseline `drop` lower.
    pub fn append(&mut self, other: Atom, drop: f32) {
        let at = Vec2::new(self.width, drop);
        let moved = |(place, text, style, tag)| (place + at, text, style, tag);
        self.texts.extend(other.texts.into_iter().map(moved));
        self.bars.extend(
            other
                .bars
                .into_iter()
                .map(|(place, length)| (place + at, length)),
        );
        self.width += other.width;
        self.up = self.up.max(other.up - drop);
        self.down = self.down.max(other.down + drop);
    }

    /// One above the other with a bar between, at the height of a minus sign.
    fn fraction(above: Atom, below: Atom, size: f32) -> Self {
        const PADDING: f32 = 2.0;
        let width = above.width.max(below.width) + 2.0 * PADDING;
        let axis = -0.31 * size;
        let mut fraction = Atom {
            bars: vec![(Vec2::new(1.0, axis), width - 2.0)],
            ..Atom::default()
        };
        for (part, drop) in [
            (&above, axis - 1.5 - above.down),
            (&below, axis + 2.5 + below.up),
        ] {
            fraction.width = 0.5 * (width - part.width);
            fraction.append(part.clone(), drop);
        }
        fraction.width = width;
        fraction
    }
}

/// The atoms of a formula's side; a line may break before an operator, inside of parentheses only where fractions are not stacked.
pub fn set_pieces(
    pieces: &[Piece],
    voice: Voice,
    known: &Known,
    language: Language,
    size: f32,
    stacked: bool,
) -> Vec<Atom> {
    let style = match voice {
        Voice::Symbols => Style::Formula.size(size),
        Voice::Numbers(_) => Style::Label.size(size),
    };
    let mut atoms = vec![Atom::default()];
    let mut depth = 0;
    // What stands before a number: after an operator, a negative one needs parentheses.
    let mut before = ' ';
    for (i, piece) in pieces.iter().enumerate() {
        let last = atoms.len() - 1;
        match piece {
            Piece::Text(text) => {
                let mut start = 0;
                for (at, c) in text.char_indices() {
                    depth += i32::from(c == '(') - i32::from(c == ')');
                    let next = text[at..].chars().nth(1);
                    let is_open = depth == 0 || !stacked;
                    if c == ' ' && is_open && next.is_some_and(|next| "+−·×<≥".contains(next))
                    {
                        append_text(&mut atoms, &text[start..at], style);
                        atoms.push(Atom {
                            breaks: true,
                            space: 0.3 * size,
                            ..Atom::default()
                        });
                        start = at + 1;
                    }
                    if c != ' ' {
                        before = c;
                    }
                }
                append_text(&mut atoms, &text[start..], style);
            }
            Piece::Value(reference) | Piece::Sum(reference) => {
                let is_base = matches!(pieces.get(i + 1), Some(Piece::Raised(_)));
                let bracketed = is_base || "+−·×/".contains(before);
                let number = match voice {
                    Voice::Symbols => None,
                    Voice::Numbers(channel) => {
                        numbers(reference, known, channel, bracketed, language)
                    }
                };
                let is_symbol = number.is_none();
                let sign = if matches!(piece, Piece::Sum(_)) {
                    "Σ"
                } else {
                    ""
                };
                let symbol = || format!("{sign}{}", names::symbol(reference, language));
                let style = match is_symbol {
                    true => style,
                    false => style.ink(Ink::Linked),
                };
                let mut atom = Atom::text(number.unwrap_or_else(symbol), style);
                if let Some(recorded) = known.get(reference.name) {
                    atom.texts[0].3 = Some(Tag::Field(recorded.field.name));
                }
                atoms[last].append(atom, 0.0);
                before = ' ';
            }
            Piece::Raised(exponent) => {
                for atom in set_pieces(exponent, voice, known, language, size, false) {
                    for (_, text, style, tag) in atom.texts {
                        let mut raised = Atom::text(format!("^{{{text}}}"), style);
                        raised.texts[0].3 = tag;
                        atoms[last].append(raised, 0.0);
                    }
                }
                before = ' ';
            }
            Piece::Fraction(above, below) => {
                let part =
                    |pieces: &[Piece]| set_pieces(pieces, voice, known, language, size, stacked);
                if stacked {
                    let [above, below] = [above, below].map(|pieces| joined(part(pieces)));
                    atoms[last].append(Atom::fraction(above, below, size), 0.0);
                } else {
                    let [above, below] = [above, below].map(|pieces| match stands_alone(pieces) {
                        true => part(pieces),
                        false => bracketed(part(pieces), style),
                    });
                    run_on(&mut atoms, above);
                    atoms.push(Atom {
                        breaks: true,
                        ..Atom::default()
                    });
                    append_text(&mut atoms, "/", style);
                    run_on(&mut atoms, below);
                }
                before = ' ';
            }
        }
    }
    atoms
}

fn append_text(atoms: &mut [Atom], text: &str, style: Text) {
    if let (false, Some(last)) = (text.is_empty(), atoms.last_mut()) {
        last.append(Atom::text(text.to_string(), style), 0.0);
    }
}

/// Appends atoms to the last one, which those after the first may still begin a new line after.
fn run_on(atoms: &mut Vec<Atom>, more: Vec<Atom>) {
    let mut more = more.into_iter();
    if let (Some(last), Some(first)) = (atoms.last_mut(), more.next()) {
        last.append(first, 0.0);
    }
    atoms.extend(more);
}

/// Whether a part of a fraction needs no parentheses beside a slash: one value, or one length.
fn stands_alone(pieces: &[Piece]) -> bool {
    match pieces {
        [Piece::Text(text)] => !text.contains(' '),
        [_] => true,
        [Piece::Text(first), between @ .., Piece::Text(last)] => {
            let is_bar = |piece: &Piece| matches!(piece, Piece::Text(text) if text.contains('|'));
            first == "|" && last == "|" && !between.iter().any(is_bar)
        }
        _ => false,
    }
}

fn bracketed(atoms: Vec<Atom>, style: Text) -> Vec<Atom> {
    let mut whole = vec![Atom::text("(".to_string(), style)];
    run_on(&mut whole, atoms);
    append_text(&mut whole, ")", style);
    whole
}

fn joined(atoms: Vec<Atom>) -> Atom {
    let mut whole = Atom::default();
    for atom in atoms {
        whole.width += atom.space;
        whole.append(atom, 0.0);
    }
    whole
}

/// The most terms of a sum that are written out.
const MOST_TERMS: usize = 5;

/// The values of a reference, several joined by plus signs; none where they are not known.
fn numbers(
    reference: &Reference,
    known: &Known,
    channel: usize,
    bracketed: bool,
    language: Language,
) -> Option<String> {
    let values = known.values(reference)?;
    let terms: Vec<String> = values
        .iter()
        .enumerate()
        .map(|(i, &value)| {
            let text = number_text(value, channel, language);
            if text.starts_with('−') && (bracketed || i > 0) {
                format!("({text})")
            } else {
                text
            }
        })
        .collect();
    Some(if terms.len() > MOST_TERMS {
        let (first, last) = (&terms[..MOST_TERMS - 2], &terms[terms.len() - 1]);
        format!("{} + … + {last}", first.join(" + "))
    } else {
        terms.join(" + ")
    })
}

/// A value as it stands in a formula: of a colour the one channel.
pub fn number_text(value: Value, channel: usize, language: Language) -> String {
    match value {
        Value::Rgb(color) => shown(Value::Number(color.channels()[channel]), 4, language),
        value => shown(value, 4, language),
    }
}

/// A line of atoms, and the space above it.
pub struct Line {
    atom: Atom,
    pub gap: f32,
}

impl Line {
    pub fn height(&self) -> f32 {
        self.atom.up + self.atom.down
    }

    /// With its upper left corner at (x, y).
    pub fn draw(self, picture: &mut Picture, x: f32, y: f32) {
        let at = Vec2::new(x, y + self.atom.up);
        for (place, text, style, tag) in self.atom.texts {
            let item = |picture: &mut Picture| {
                picture.text(at + place, text, style);
            };
            match tag {
                Some(tag) => {
                    picture.tagged(tag, item);
                }
                None => item(picture),
            }
        }
        for (place, length) in self.atom.bars {
            let from = at + place;
            picture.line(from, from + Vec2::X * length, Ink::Text.stroke(1.0));
        }
    }
}

/// Breaks atoms into lines of at most `width`, those after the first set in by `indent`; and whether none is wider.
pub fn flow(atoms: Vec<Atom>, width: f32, indent: f32) -> (Vec<Line>, bool) {
    let mut lines: Vec<Atom> = Vec::new();
    let mut units: Vec<Atom> = Vec::new();
    for atom in atoms {
        match units.last_mut() {
            Some(unit) if !atom.breaks => unit.append(atom, 0.0),
            _ => units.push(atom),
        }
    }
    for unit in units {
        match lines.last_mut() {
            Some(line) if line.width + unit.space + unit.width <= width => {
                line.width += unit.space;
                line.append(unit, 0.0);
            }
            _ => {
                let mut line = Atom {
                    width: if lines.is_empty() { 0.0 } else { indent },
                    ..Atom::default()
                };
                line.append(unit, 0.0);
                lines.push(line);
            }
        }
    }
    let fits = lines.iter().all(|line| line.width <= width);
    let lines = lines
        .into_iter()
        .map(|atom| Line { atom, gap: 0.0 })
        .collect();
    (lines, fits)
}
