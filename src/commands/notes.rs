//! Notes on standard error, one line each. In JSON they stand under `notes`.

use super::failure::note;
use crate::methods::Method;
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

/// Notes on options that were given although `method` has no use for them; `has_use` says which methods have.
pub fn without_effect(
    given: impl IntoIterator<Item = &'static str>,
    method: Method,
    has_use: impl Fn(Method) -> bool,
) -> Vec<Note> {
    if has_use(method) {
        return Vec::new();
    }
    let others = Method::ALL.into_iter().filter(|&method| has_use(method));
    let others = others.map(Method::name).collect::<Vec<_>>().join(", ");
    let what = format!("given with {}", method.name());
    let note = |option| Note::new(option, &what, format!("it counts only for {others}"));
    given.into_iter().map(note).collect()
}
