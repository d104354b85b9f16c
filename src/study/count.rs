//! How often an algorithm did what, in words that a reader knows.

use super::form::Operations;
use crate::record::Counter;

/// The counts of some kinds of events, under their names; what never happened is left out.
pub fn operations(counter: &Counter, kinds: &[(&str, &'static str)]) -> Vec<Operations> {
    let recorded = kinds.iter().map(|&(kind, of)| Operations {
        of,
        count: counter.of(kind),
    });
    recorded.filter(|operations| operations.count > 0).collect()
}
