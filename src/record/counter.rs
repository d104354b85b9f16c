//! How often an algorithm did what, by its events, of which none is kept.

use super::{Event, Recorder};

/// A recorder that counts events by their kind.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Counter(Vec<(&'static str, u64)>);

impl Counter {
    /// How many events of that kind there were.
    pub fn of(&self, kind: &str) -> u64 {
        let found = self.0.iter().find(|(name, _)| *name == kind);
        found.map_or(0, |(_, count)| *count)
    }

    /// How many events there were.
    pub fn all(&self) -> u64 {
        self.0.iter().map(|(_, count)| count).sum()
    }

    fn count(&mut self, kind: &'static str) {
        match self.0.iter_mut().find(|(name, _)| *name == kind) {
            Some((_, count)) => *count += 1,
            None => self.0.push((kind, 1)),
        }
    }
}

impl<E: Event> Recorder<E> for Counter {
    fn step(&mut self, event: impl FnOnce() -> E) {
        self.count(event().kind());
    }

    fn enter(&mut self, event: impl FnOnce() -> E) {
        self.count(event().kind());
    }

    fn leave(&mut self, event: impl FnOnce() -> E) {
        self.count(event().kind());
    }
}
