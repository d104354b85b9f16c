//! Sums that carry their rounding error along (Kahan, "Further remarks on reducing truncation errors", CACM 1965).

use num_traits::Float;

/// A sum, and the part of what was added to it that it was too coarse to hold.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CompensatedSum<F> {
    pub sum: F,
    /// By how much `sum` is too large.
    excess: F,
}

impl<F: Float> CompensatedSum<F> {
    pub fn new(start: F) -> Self {
        CompensatedSum {
            sum: start,
            excess: F::zero(),
        }
    }

    /// The error stays that of one rounding, however many terms are added, as long as these do not grow.
    #[inline]
    pub fn add(&mut self, term: F) {
        let corrected = term - self.excess;
        let sum = self.sum + corrected;
        // What the addition took in, less what it should have
        self.excess = (sum - self.sum) - corrected;
        self.sum = sum;
    }
}
