//! What of a run is recorded: some iterations, and in them the exchanges of some patch.

use std::ops::Range;

/// The part of a run that is looked at. By default all of it.
///
/// Outside the iterations watched nothing is recorded but the beginning and the end; on entering them, the values of every patch.
/// With a patch, only exchanges that concern it are recorded: what it gathers, what its own shots bring to all, what other shots bring to it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct RecordFilter {
    /// Counted from 0; of the shooting methods, shots.
    pub iterations: Option<Range<u32>>,
    pub patch: Option<u32>,
}

impl RecordFilter {
    /// Whether iteration `k` is recorded.
    pub fn takes(&self, k: u32) -> bool {
        self.iterations
            .as_ref()
            .is_none_or(|iterations| iterations.contains(&k))
    }
}

/// The patches whose exchanges are recorded.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Followed(pub Option<u32>);

impl Followed {
    pub fn takes(self, patch: usize) -> bool {
        self.0.is_none_or(|followed| followed as usize == patch)
    }
}
