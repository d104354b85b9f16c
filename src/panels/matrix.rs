//! The form factors of the system, row by row: the matrix as a map of its magnitudes, and the sum of each row.

mod draw;
mod grid;
mod sides;
mod system;

use super::horizon::UNKNOWN;
use super::message::{NO_PATCHES, NO_STEPS, message};
use super::{PanelInput, Properties};
use crate::algorithms::enclosure::Enclosure;
use crate::algorithms::prepared_scene::PreparedScene;
use crate::algorithms::radiosity::SolverEvent;
use crate::language::{Language, Message};
use crate::picture::Picture;
use crate::replay::Run;
use crate::replay::radiosity::{State, used_form_factors};
use glam::Vec2;
use std::borrow::Cow;
use std::iter::zip;

const NO_MATRIX: Message = Message("matrix-no-matrix");
const NO_ROOM: Message = Message("matrix-no-room");
const GATHERS: Message = Message("matrix-gathers");
const SHOOTS: Message = Message("matrix-shoots");
const ENTRIES: Message = Message("matrix-entries");
const SMALLER: Message = Message("matrix-smaller");
const MATRIX: Message = Message("common-matrix-of-form-factors");

/// So many of a row are said one by one.
const MOST_ENTRIES: usize = 12;

/// All that is drawn.
struct Layout<'a> {
    prepared: &'a PreparedScene,
    room: &'a Enclosure,
    /// Row by row; no number where it is hidden, and so are the sums.
    matrix: Cow<'a, [f64]>,
    row_sums: Cow<'a, [f64]>,
    n: usize,
    hand: Option<Hand>,
    language: Language,
}

/// The current patch, and its exchange.
#[derive(Clone, Copy)]
struct Hand {
    i: usize,
    recorded: SolverEvent,
    /// Row and column of the current form factor, and its value.
    entry: Option<(usize, usize, f64)>,
}

impl Hand {
    fn of(state: &State) -> Option<Hand> {
        let focused = state.focused?;
        let i = focused.i as usize;
        let entry = match focused.exchange {
            Some((j, SolverEvent::Exchanged { f_ij, .. })) => Some((i, j as usize, f_ij)),
            Some((j, SolverEvent::Received { f_ji, .. })) => Some((j as usize, i, f_ji)),
            _ => None,
        };
        Some(Hand {
            i,
            recorded: focused.recorded,
            entry,
        })
    }

    fn shoots(&self) -> bool {
        matches!(self.recorded, SolverEvent::Shooting { .. })
    }
}

pub const PANEL: Properties = Properties::titled(Message("app-matrix"));

pub fn draw(input: &PanelInput, size: Vec2) -> Picture {
    let (setup, replay) = match input.run {
        Run::Radiosity(setup, replay) => (setup, replay),
        Run::FormFactor(..) | Run::Hierarchical(..) => {
            return message(NO_MATRIX, input.language, size);
        }
        _ => return message(NO_PATCHES, input.language, size),
    };
    let state = replay.state();
    let (Some(room), Some(solved)) = (input.run.enclosure(), &state.solved) else {
        return message(NO_ROOM, input.language, size);
    };
    let Some(matrix) = room.matrix().filter(|_| !room.patches.is_empty()) else {
        return message(NO_ROOM, input.language, size);
    };
    if input.run.walk().is_empty() {
        return message(NO_STEPS, input.language, size);
    }
    let n = room.patches.len();
    let (mut matrix, mut row_sums) = (Cow::from(matrix), Cow::from(&solved.row_sums));
    if input.is_pending() {
        hide_unused(&mut matrix, &mut row_sums, &used_form_factors(replay, n));
    }
    let layout = Layout {
        prepared: &setup.prepared,
        room,
        matrix,
        n,
        row_sums,
        hand: Hand::of(state),
        language: input.language,
    };
    let mut picture = Picture::new(size.x, size.y);
    draw::draw(&mut picture, &layout);
    let step = super::values::step_in_words(input);
    picture.alt = super::message::labelled(&step, &layout.in_words(), input.language);
    picture
}

/// While a question waits, only what the solver has used is known, and the sums of rows that it has used whole.
fn hide_unused(matrix: &mut Cow<[f64]>, row_sums: &mut Cow<[f64]>, used: &[bool]) {
    for (value, _) in zip(matrix.to_mut(), used).filter(|(_, used)| !**used) {
        *value = f64::NAN;
    }
    let n = row_sums.len().max(1);
    for (sum, used) in zip(row_sums.to_mut(), used.chunks(n)) {
        if used.contains(&false) {
            *sum = f64::NAN;
        }
    }
}

impl Layout<'_> {
    fn name(&self, patch: usize) -> String {
        super::names::patch(self.prepared, self.room, patch, self.language)
    }

    /// A value as `write` writes it, a question mark where it is hidden.
    fn known(&self, value: f64, write: impl Fn(Language, f64) -> String) -> String {
        match value.is_nan() {
            true => UNKNOWN.to_string(),
            false => write(self.language, value),
        }
    }

    fn row(&self, i: usize) -> &[f64] {
        &self.matrix[i * self.n..(i + 1) * self.n]
    }

    /// The form factors of the row or column in question that are known and not 0, the largest first.
    fn entries(&self, hand: Hand) -> String {
        let entry = |j: usize| match hand.shoots() {
            true => self.matrix[j * self.n + hand.i],
            false => self.matrix[hand.i * self.n + j],
        };
        let mut entries: Vec<(usize, f64)> = (0..self.n).map(|j| (j, entry(j))).collect();
        entries.retain(|&(_, f)| f > 0.0);
        entries.sort_by(|a, b| b.1.total_cmp(&a.1));
        let smaller = entries.len().saturating_sub(MOST_ENTRIES);
        entries.truncate(MOST_ENTRIES);
        let written = entries
            .iter()
            .map(|&(j, f)| format!("{} {}", self.name(j), self.language.number(f)));
        let mut written: Vec<String> = written.collect();
        if smaller > 0 {
            written.push(SMALLER.format(self.language, &[("count", &smaller.to_string())]));
        }
        ENTRIES.format(self.language, &[("entries", &written.join("; "))])
    }

    fn in_words(&self) -> String {
        let mut text = MATRIX.format(self.language, &[("n", &self.n.to_string())]);
        if let Some(hand) = self.hand {
            let (i, name) = (hand.i.to_string(), self.name(hand.i));
            let does = if hand.shoots() {
                SHOOTS.format(self.language, &[("patch", &name), ("column", &i)])
            } else {
                let sum = self.known(self.row_sums[hand.i], Language::number);
                let arguments = [("patch", &*name), ("row", &i), ("sum", &sum)];
                GATHERS.format(self.language, &arguments)
            };
            text = format!("{text} {does}; {}", self.entries(hand));
            if let Some((row, column, f)) = hand.entry {
                text.push_str(&format!(
                    "; F({row}, {column}) = {}",
                    self.language.number(f)
                ));
            }
            text.push('.');
        }
        text
    }
}

#[cfg(test)]
mod tests;
