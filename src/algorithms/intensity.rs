//! An intensity of light, with its diffuse part kept apart for a texture to multiply.

use super::scan_line::Varying;
use crate::color::Rgb;
use crate::numeric::Linear;

/// Light sent to the eye, with the part of it that a texture multiplies.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Intensity {
    /// I
    pub whole: Rgb,
    /// The sum of I_d over all lights.
    pub diffuse: Rgb,
}

impl Intensity {
    /// I − I_d, which a texture leaves as it is, and I_d.
    pub fn parts(self) -> [Rgb; 2] {
        [self.whole - self.diffuse, self.diffuse]
    }
}

impl Linear for Intensity {
    #[inline]
    fn plus(self, other: Self) -> Self {
        Intensity {
            whole: self.whole + other.whole,
            diffuse: self.diffuse + other.diffuse,
        }
    }

    #[inline]
    fn minus(self, other: Self) -> Self {
        Intensity {
            whole: self.whole - other.whole,
            diffuse: self.diffuse - other.diffuse,
        }
    }

    #[inline]
    fn times(self, factor: f64) -> Self {
        Intensity {
            whole: self.whole * factor,
            diffuse: self.diffuse * factor,
        }
    }
}

impl Varying for Intensity {
    type Recorded = Rgb;
    fn recorded(self) -> Rgb {
        self.whole
    }
}
