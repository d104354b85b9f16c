//! Samples in batches, each of which brings their number to four times what it was: the standard error is halved from one to the next.

use std::iter::successors;
use std::ops::Range;

/// Samples of the first batch.
pub const FIRST: u32 = 16;

/// 0..16, 16..64, 64..256, …, up to `count`.
pub fn batches(count: u32) -> impl Iterator<Item = Range<u32>> {
    let ends = successors(Some(FIRST), |end| Some(end.saturating_mul(4)));
    let mut start = 0;
    ends.map_while(move |end| {
        let batch = start..end.min(count);
        start = batch.end;
        (!batch.is_empty()).then_some(batch)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn batches_follow_each_other_and_leave_nothing_out() {
        let of = |count| {
            batches(count)
                .map(|batch| (batch.start, batch.end))
                .collect::<Vec<_>>()
        };
        assert_eq!(of(100), [(0, 16), (16, 64), (64, 100)]);
        assert_eq!(of(16), [(0, 16)]);
        assert_eq!(of(5), [(0, 5)]);
        assert!(of(0).is_empty());
        assert_eq!(of(u32::MAX).last().map(|&(_, end)| end), Some(u32::MAX));
    }
}
