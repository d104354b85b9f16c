//! Keeps progress and settings where the user finds them again: written whole after each change, so that a killed process loses
//! nothing. Several windows may write them: what one has not changed itself stays as it is kept.

#[cfg(not(target_arch = "wasm32"))]
mod folder;
#[cfg(target_arch = "wasm32")]
mod page;

#[cfg(not(target_arch = "wasm32"))]
pub use folder::Store;
#[cfg(target_arch = "wasm32")]
pub use page::Store;

use super::borders::Borders;
use super::session::Kept;
use super::strings;
use crate::language::Language;
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};
use std::io;
use std::time::Duration;

/// Until another window has written.
pub const BUSY: Duration = Duration::from_millis(20);

/// What is kept.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize)]
#[serde(default)]
pub struct State {
    pub session: Kept,
    pub layout: Borders,
}

/// Why something was not kept, or could not be read.
#[derive(Debug)]
pub enum Trouble {
    /// What was kept made no sense; now it stands here.
    SetAside(String),
    Failed(io::Error),
}

impl Trouble {
    pub fn in_language(&self, language: Language) -> String {
        match self {
            Trouble::SetAside(path) => strings::KEPT_SET_ASIDE.format(language, &[("path", path)]),
            Trouble::Failed(error) => {
                strings::NOT_KEPT.format(language, &[("why", &error.to_string())])
            }
        }
    }
}

impl From<io::Error> for Trouble {
    fn from(error: io::Error) -> Self {
        Trouble::Failed(error)
    }
}

/// A store, and what this window has read from it or written to it.
pub struct Keeper {
    store: Store,
    /// As this window knows it to be kept: what differs from that, the window has changed.
    known: Value,
    /// What could not be written: it is tried again with the next change.
    refused: Option<Value>,
    /// Whether the user knows that nothing can be written.
    complained: bool,
}

impl Keeper {
    /// Reads what is kept; where there is nothing, nothing was kept so far. Errors: it made no sense or could not be read; the keeper
    /// works all the same.
    pub fn open(store: Store) -> (Keeper, Result<State, Trouble>) {
        let found = read(&store).map(|found| found.map(|(state, _)| state).unwrap_or_default());
        let known = serde_json::to_value(found.as_ref().ok()).unwrap_or_default();
        let keeper = Keeper {
            store,
            known,
            refused: None,
            complained: matches!(found, Err(Trouble::Failed(_))),
        };
        (keeper, found)
    }

    /// Writes what differs from what is kept. Errors: why it cannot, once.
    pub fn save(&mut self, state: &State) -> Result<Saved, Trouble> {
        let ours = serde_json::to_value(state).map_err(io::Error::other)?;
        if ours == self.known || self.refused.as_ref() == Some(&ours) {
            return Ok(Saved::Unchanged);
        }
        let written = self.write(&ours);
        match written {
            Ok(Saved::Busy) => {}
            Ok(_) | Err(Trouble::SetAside(_)) => (self.known, self.refused) = (ours, None),
            Err(Trouble::Failed(_)) => {
                self.refused = Some(ours);
                if std::mem::replace(&mut self.complained, true) {
                    return Ok(Saved::Unchanged);
                }
            }
        }
        written
    }

    /// Puts what this window has changed into what is kept.
    fn write(&self, ours: &Value) -> Result<Saved, Trouble> {
        let Some(_lock) = self.store.lock()? else {
            return Ok(Saved::Busy);
        };
        let (theirs, set_aside) = match read(&self.store) {
            Ok(found) => (found.map(|(_, value)| value), None),
            Err(Trouble::SetAside(path)) => (None, Some(path)),
            Err(failed) => return Err(failed),
        };
        // Where nothing is kept any more, all of ours is written.
        let merged = match &theirs {
            Some(theirs) => merged(Some(&self.known), Some(ours), Some(theirs)),
            None => Some(ours.clone()),
        };
        let mut text = serde_json::to_vec_pretty(&merged).map_err(io::Error::other)?;
        text.push(b'\n');
        self.store.write(&text)?;
        match set_aside {
            Some(path) => Err(Trouble::SetAside(path)),
            None => Ok(Saved::Written),
        }
    }

    /// Lets the next change also remove what only other windows have written.
    pub fn forget(&mut self) {
        if let Ok(Some((state, _))) = read(&self.store) {
            self.known = serde_json::to_value(state).unwrap_or_default();
        }
    }
}

/// What came of writing.
#[derive(Debug, PartialEq)]
pub enum Saved {
    Unchanged,
    Written,
    /// Another window is writing; to be tried again soon.
    Busy,
}

/// What is kept, also as it was written, with parts that a newer program may have added; none where nothing is. What makes no sense
/// is set aside.
fn read(store: &Store) -> Result<Option<(State, Value)>, Trouble> {
    let Some(text) = store.read()? else {
        return Ok(None);
    };
    // A list would be taken for the values of a `State` in their order.
    let object: Result<Map<String, Value>, _> = serde_json::from_slice(&text);
    let value = object.map(Value::Object);
    match value.and_then(|value| Ok((State::deserialize(&value)?, value))) {
        Ok(found) => Ok(Some(found)),
        Err(_) => Err(Trouble::SetAside(store.set_aside()?)),
    }
}

/// Three-way merge, key by key: what differs between `known` and `ours` goes over `theirs`.
fn merged(known: Option<&Value>, ours: Option<&Value>, theirs: Option<&Value>) -> Option<Value> {
    if known == ours {
        return theirs.cloned();
    }
    let (Some(Value::Object(our)), Some(Value::Object(their))) = (ours, theirs) else {
        return ours.cloned();
    };
    let knew = known.and_then(Value::as_object);
    let keys = our
        .keys()
        .chain(their.keys().filter(|key| !our.contains_key(*key)));
    let entries = keys.filter_map(|key| {
        let known = knew.and_then(|knew| knew.get(key));
        Some((key.clone(), merged(known, our.get(key), their.get(key))?))
    });
    Some(Value::Object(entries.collect::<Map<_, _>>()))
}

#[cfg(test)]
mod tests;
