//! Linear interpolation, direct and incremental (Gouraud 1971; Foley, van Dam, Feiner, Hughes 1990, §3.6).

use crate::color::Rgb;
use glam::{DVec2, DVec3};

/// A quantity that can be interpolated linearly: a number, a colour, a vector, several of these together, or nothing at all.
pub trait Linear: Copy {
    fn plus(self, other: Self) -> Self;
    fn minus(self, other: Self) -> Self;
    fn times(self, factor: f64) -> Self;
}

macro_rules! linear {
    ($($type:ty),*) => {$(
        impl Linear for $type {
            #[inline]
            fn plus(self, other: Self) -> Self {
                self + other
            }

            #[inline]
            fn minus(self, other: Self) -> Self {
                self - other
            }

            #[inline]
            fn times(self, factor: f64) -> Self {
                self * factor
            }
        }
    )*};
}
linear!(f64, Rgb, DVec2, DVec3);

impl Linear for () {
    fn plus(self, (): ()) {}
    fn minus(self, (): ()) {}
    fn times(self, _: f64) {}
}

impl<A: Linear, B: Linear> Linear for (A, B) {
    #[inline]
    fn plus(self, other: Self) -> Self {
        (self.0.plus(other.0), self.1.plus(other.1))
    }

    #[inline]
    fn minus(self, other: Self) -> Self {
        (self.0.minus(other.0), self.1.minus(other.1))
    }

    #[inline]
    fn times(self, factor: f64) -> Self {
        (self.0.times(factor), self.1.times(factor))
    }
}

/// The direct form, weights as on the lecture's slide:
/// `(s − s_2)/(s_1 − s_2)·a_1 + (s_1 − s)/(s_1 − s_2)·a_2`. `s_1` and `s_2` must differ.
#[inline]
pub fn interpolate<A: Linear>(a_1: A, s_1: f64, a_2: A, s_2: f64, s: f64) -> A {
    let (weight_1, weight_2) = ((s - s_2) / (s_1 - s_2), (s_1 - s) / (s_1 - s_2));
    a_1.times(weight_1).plus(a_2.times(weight_2))
}

/// The incremental form: one addition a step. After n steps its rounding error is at most n units in the last place
/// of the largest value passed.
#[derive(Clone, Copy, Debug)]
pub struct Ramp<A> {
    pub value: A,
    /// What one unit of `s` adds.
    pub step: A,
}

impl<A: Linear> Ramp<A> {
    /// Starts at `s`, by the direct form, on the line through `(s_1, a_1)` and `(s_2, a_2)`.
    #[inline]
    pub fn start(a_1: A, s_1: f64, a_2: A, s_2: f64, s: f64) -> Self {
        Ramp {
            value: interpolate(a_1, s_1, a_2, s_2, s),
            step: a_2.minus(a_1).times(1.0 / (s_2 - s_1)),
        }
    }

    /// One unit further.
    #[inline]
    pub fn advance(&mut self) {
        self.value = self.value.plus(self.step);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_forms_meet_the_ends_and_each_other() {
        assert_eq!(interpolate(0.25, 3.0, 0.75, 7.0, 3.0), 0.25);
        assert_eq!(interpolate(0.25, 3.0, 0.75, 7.0, 7.0), 0.75);
        let mut ramp = Ramp::start(0.0, 0.0, 1.0, 1e4, 0.0);
        for _ in 0..10_000 {
            ramp.advance();
        }
        // 10⁴ additions of values up to 1, each rounded by at most half an ulp (1.1e-16).
        assert!(
            (ramp.value - 1.0).abs() <= 1e4 * 1.2e-16,
            "drift {:e}",
            ramp.value - 1.0
        );
    }
}
