//! Notes: input that has no effect, or another one than its author may think. A note refuses nothing.

use super::document::OneLine;
use serde::Serialize;
use std::fmt;

/// Input without effect, or with another one than its author may think.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Note {
    /// The path in the document, such as `objects[2].mesh.file`.
    pub place: String,
    /// What stands there.
    pub what: String,
    /// Why it has no effect, or what is done with it.
    pub why: String,
}

impl Note {
    pub fn new(place: impl fmt::Display, what: impl Into<String>, why: impl Into<String>) -> Self {
        Note {
            place: place.to_string(),
            what: what.into(),
            why: why.into(),
        }
    }
}

/// On one line, whatever it quotes from a file.
impl fmt::Display for Note {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let Note { place, what, why } = self;
        write!(f, "{}", OneLine(&format!("{place}: {what}: {why}")))
    }
}
