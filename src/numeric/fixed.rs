//! 16.16 fixed point, in which early hardware interpolated.

use std::ops::Add;

/// A number in units of 2⁻¹⁶, from −32768 to 32768.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Fixed(pub i32);

impl Fixed {
    const ONE: f64 = 65536.0;

    /// The nearest number of 16.16 bits.
    pub fn nearest(number: f64) -> Self {
        // A cast saturates.
        Fixed((number * Self::ONE).round() as i32)
    }

    pub fn to_f64(self) -> f64 {
        f64::from(self.0) / Self::ONE
    }
}

impl Add for Fixed {
    type Output = Fixed;
    fn add(self, other: Fixed) -> Fixed {
        Fixed(self.0.wrapping_add(other.0))
    }
}
