//! Notes on standard error, one line each. In JSON they stand under `notes`.

use super::failure::note;
use crate::scene::Note;

/// So many are written out; a list of all of them is in the JSON of the commands that have one.
const MOST_LINES: usize = 100;

/// Writes notes on the file `name`, after which the work goes on.
pub fn print(name: &dyn std::fmt::Display, notes: &[Note]) {
    for found in notes.iter().take(MOST_LINES) {
        note(format_args!("{name}: note: {found}"));
    }
    if let Some(more) = notes.len().checked_sub(MOST_LINES).filter(|&more| more > 0) {
        note(format_args!("{name}: and {more} more notes"));
    }
}
