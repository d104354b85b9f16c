//! The form factors of the system, row by row: the matrix as a map of its magnitudes, and the sum of each row.

mod draw;
mod grid;
mod viridis;

use super::Show;
use super::message::{NO_PATCHES, NO_STEPS, message};
use super::words::{Language, Words};
use crate::algorithms::radiosity::Told;
use crate::algorithms::room::Room;
use crate::algorithms::stage::Stage;
use crate::picture::{Picture, number};
use crate::replay::Run;
use crate::replay::radiosity::State;
use glam::Vec2;

const NO_MATRIX: Words = Words::new(
    "This run finds one form factor, not all of them. Open a lesson on a radiosity solver.",
    "Proses ini mencari satu faktor bentuk, bukan semuanya. Buka pelajaran tentang penyelesaian radiositas.",
);
const NO_ROOM: Words = Words::new(
    "This scene has no patches: radiosity needs surfaces of finite size.",
    "Adegan ini tidak memiliki patch: radiositas memerlukan permukaan yang terbatas.",
);
const GATHERS: Words = Words::new("gathers row", "mengumpulkan baris");
const SHOOTS: Words = Words::new("shoots column", "menembakkan kolom");
const MATRIX: Words = Words::new("Matrix of form factors", "Matriks faktor bentuk");
const SUM: Words = Words::new("sum of the row", "jumlah baris");

/// All that is drawn.
struct Sheet<'a> {
    stage: &'a Stage,
    room: &'a Room,
    matrix: &'a [f64],
    n: usize,
    hand: Option<Hand>,
    language: Language,
}

/// The patch in hand, and its exchange.
#[derive(Clone, Copy)]
struct Hand {
    i: usize,
    told: Told,
    /// The row and column of the form factor in hand, and what was told of it.
    entry: Option<(usize, usize, f64)>,
}

impl Hand {
    fn of(state: &State) -> Option<Hand> {
        let focused = state.focused?;
        let i = focused.i as usize;
        let entry = match focused.exchange {
            Some((j, Told::Exchanged { f_ij, .. })) => Some((i, j as usize, f_ij)),
            Some((j, Told::Received { f_ji, .. })) => Some((j as usize, i, f_ji)),
            _ => None,
        };
        Some(Hand {
            i,
            told: focused.told,
            entry,
        })
    }

    fn shoots(&self) -> bool {
        matches!(self.told, Told::Shooting { .. })
    }
}

pub fn draw(show: &Show, size: Vec2) -> Picture {
    let (stage, replay) = match show.run {
        Run::Radiosity(stage, replay) => (stage, replay),
        Run::FormFactor(..) => return message(NO_MATRIX, show.language, size),
        _ => return message(NO_PATCHES, show.language, size),
    };
    let Some((room, matrix)) = stage
        .room()
        .ok()
        .and_then(|room| Some((room, room.matrix()?)))
    else {
        return message(NO_ROOM, show.language, size);
    };
    if room.patches.is_empty() {
        return message(NO_ROOM, show.language, size);
    }
    if show.run.walk().is_empty() {
        return message(NO_STEPS, show.language, size);
    }
    let sheet = Sheet {
        stage,
        room,
        matrix,
        n: room.patches.len(),
        hand: Hand::of(replay.state()),
        language: show.language,
    };
    let mut picture = Picture::new(size.x, size.y);
    draw::draw(&mut picture, &sheet);
    picture.alt = format!(
        "{}: {}",
        super::values::step_in_words(show),
        sheet.in_words()
    );
    picture
}

impl Sheet<'_> {
    fn name(&self, patch: usize) -> String {
        super::names::patch(self.stage, self.room, patch)
    }

    fn row(&self, i: usize) -> &[f64] {
        &self.matrix[i * self.n..(i + 1) * self.n]
    }

    fn sum(&self, i: usize) -> f64 {
        self.row(i).iter().sum()
    }

    fn in_words(&self) -> String {
        let say = |words: Words| words.in_language(self.language);
        let mut text = format!("{} {} × {}.", say(MATRIX), self.n, self.n);
        if let Some(hand) = self.hand {
            let does = if hand.shoots() { SHOOTS } else { GATHERS };
            let (i, name) = (hand.i, self.name(hand.i));
            text.push_str(&format!(" {name} {} {i}", say(does)));
            if !hand.shoots() {
                text.push_str(&format!(", {} {}", say(SUM), number(self.sum(i))));
            }
            if let Some((row, column, f)) = hand.entry {
                text.push_str(&format!("; F({row}, {column}) = {}", number(f)));
            }
            text.push('.');
        }
        text
    }
}

#[cfg(test)]
mod tests;
