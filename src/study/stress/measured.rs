//! What came out of a case, and how far it is from what was expected.

use num_traits::Float;

/// What came out.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ran {
    pub in_f64: Measured,
    pub in_f32: Option<Measured>,
    /// By how much a relative change of what is given changes the answer.
    pub condition: Option<f64>,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measured {
    pub found: f64,
    pub expected: f64,
    /// Of which [`Unit`] it is; not a number where nothing can be said for it.
    pub error: f64,
    pub unit: Unit,
}

/// The unit of an error.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unit {
    Relative,
    Absolute,
    /// In units in the last place of the precision that is looked at.
    Ulps,
    /// How many of all answers are wrong.
    Share,
}

impl Unit {
    pub fn name(self) -> &'static str {
        match self {
            Unit::Relative => "relative",
            Unit::Absolute => "absolute",
            Unit::Ulps => "ulps",
            Unit::Share => "share",
        }
    }
}

impl Measured {
    /// `expected` must not be 0.
    pub fn relative(found: f64, expected: f64) -> Self {
        Measured {
            found,
            expected,
            error: (found / expected - 1.0).abs(),
            unit: Unit::Relative,
        }
    }

    pub fn absolute(found: f64, expected: f64) -> Self {
        Measured {
            found,
            expected,
            error: (found - expected).abs(),
            unit: Unit::Absolute,
        }
    }

    /// In units in the last place of `found`'s precision at `expected`, which must not be 0.
    pub fn ulps<F: Float + Into<f64>>(found: F, expected: f64) -> Self {
        let found: f64 = found.into();
        let digits: f64 = F::epsilon().into();
        const EXPONENT: u64 = 0x7ff << 52;
        let ulp = f64::from_bits(expected.to_bits() & EXPONENT) * digits;
        Measured {
            found,
            expected,
            error: (found - expected).abs() / ulp,
            unit: Unit::Ulps,
        }
    }

    /// `wrong` of `all` answers; none ought to be.
    pub fn share(wrong: usize, all: usize) -> Self {
        let share = wrong as f64 / all as f64;
        Measured {
            found: share,
            expected: 0.0,
            error: share,
            unit: Unit::Share,
        }
    }
}

impl From<Measured> for Ran {
    fn from(in_f64: Measured) -> Self {
        Ran {
            in_f64,
            in_f32: None,
            condition: None,
        }
    }
}

impl Ran {
    pub fn and_f32(self, measured: Measured) -> Self {
        let in_f32 = Some(measured);
        Ran { in_f32, ..self }
    }

    pub fn conditioned(self, condition: f64) -> Self {
        let condition = Some(condition);
        Ran { condition, ..self }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ulps_are_those_of_the_precision_at_the_expected_value() {
        assert_eq!(Measured::ulps(1.0 + f64::EPSILON, 1.0).error, 1.0);
        assert_eq!(Measured::ulps(1.0 + 2.0 * f32::EPSILON, 1.0).error, 2.0);
        assert_eq!(Measured::ulps(3.0_f64.next_up(), 3.0).error, 1.0);
        assert_eq!(Measured::ulps(-0.25_f64, -0.25).error, 0.0);
    }
}
