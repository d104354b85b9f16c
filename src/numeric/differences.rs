//! Forward differences of second order (Bishop & Weimer 1986; Foley, van Dam, Feiner, Hughes 1990, §11.2.9).

use num_traits::Float;

/// A polynomial of second order, evaluated step by step with two additions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Differences<F> {
    pub value: F,
    /// Δ: what the next step adds to the value.
    pub first: F,
    /// Δ²: what each step adds to Δ.
    pub second: F,
}

impl<F: Float> Differences<F> {
    /// One step further. A rounding error of Δ is added again at every step that follows.
    #[inline]
    pub fn advance(&mut self) {
        self.value = self.value + self.first;
        self.first = self.first + self.second;
    }
}
