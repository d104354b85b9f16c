//! How often an algorithm did what: heard from its events, of which none is kept.

use super::form::Operations;
use crate::record::{Event, Recorder};

/// A recorder that counts events by their kind.
#[derive(Clone, Debug, Default)]
pub struct Counter(Vec<(&'static str, u64)>);

impl Counter {
    /// How many events of that kind there were.
    pub fn of(&self, kind: &str) -> u64 {
        let found = self.0.iter().find(|(name, _)| *name == kind);
        found.map_or(0, |(_, count)| *count)
    }

    /// The counts of some kinds, under names that a reader knows; what never happened is left out.
    pub fn operations(&self, kinds: &[(&str, &'static str)]) -> Vec<Operations> {
        let told = kinds.iter().map(|&(kind, of)| Operations {
            of,
            count: self.of(kind),
        });
        told.filter(|operations| operations.count > 0).collect()
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

    /// The end of what was counted when it began.
    fn leave(&mut self, _: impl FnOnce() -> E) {}
}
