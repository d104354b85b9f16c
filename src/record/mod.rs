//! How the steps of an algorithm are recorded: it is written once, generic over [`Recorder`], and run at two speeds.
//!
//! With [`Unrecorded`] the calls compile away; with [`Recording`] the same body keeps every step.
//! This floor knows no algorithm: an algorithm brings its own event type, which names itself by [`Event`].

mod counter;
mod event;
mod outline;
mod recording;
mod spare;

pub use counter::Counter;
pub use event::{Event, Field, Fields, Line, Listing, Value};
pub use outline::Outline;
pub use recording::{Mark, Recording, RecordingLimit};

/// Receives the steps of a run. Events come as closures, so that a run that is not recorded never builds them.
pub trait Recorder<E> {
    /// A fact, in the past tense.
    fn step(&mut self, event: impl FnOnce() -> E);
    /// Opens a scope, named by a noun (`ScanLine`, `Ray`, `Iteration`).
    fn enter(&mut self, event: impl FnOnce() -> E);
    /// Closes the scope opened last, with its result.
    fn leave(&mut self, event: impl FnOnce() -> E);
}

/// The recorder that keeps nothing and costs nothing.
pub struct Unrecorded;

impl<E> Recorder<E> for Unrecorded {
    #[inline(always)]
    fn step(&mut self, _: impl FnOnce() -> E) {}
    #[inline(always)]
    fn enter(&mut self, _: impl FnOnce() -> E) {}
    #[inline(always)]
    fn leave(&mut self, _: impl FnOnce() -> E) {}
}
