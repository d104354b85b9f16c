//! Linear RGB, and the only place where a colour is clamped or sRGB-encoded.
//!
//! Everything upstream works in linear light, unclamped, in `f64`. Encoding follows IEC 61966-2-1.

mod animation;
mod encode;
mod files;
mod read;

use std::iter::Sum;
use std::ops::{Add, AddAssign, Div, Mul, Sub};

pub use animation::{Animation, AnimationFormat};
pub use files::{pfm, png_rgb8, png_rgba8};
pub use read::{StoredImage, read_image, surplus};

/// A linear RGB triple: intensity, coefficient or radiant exitance, one number a channel.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct Rgb {
    pub r: f64,
    pub g: f64,
    pub b: f64,
}

impl Rgb {
    pub const BLACK: Rgb = Rgb::splat(0.0);
    pub const WHITE: Rgb = Rgb::splat(1.0);

    pub const fn new(r: f64, g: f64, b: f64) -> Self {
        Rgb { r, g, b }
    }

    /// The grey `(value, value, value)`.
    pub const fn splat(value: f64) -> Self {
        Rgb::new(value, value, value)
    }

    pub const fn channels(self) -> [f64; 3] {
        [self.r, self.g, self.b]
    }

    /// Whether the three channels are equal, so that one number says it all.
    pub fn is_grey(self) -> bool {
        self.r == self.g && self.g == self.b
    }

    /// The largest channel.
    pub fn max_channel(self) -> f64 {
        self.r.max(self.g).max(self.b)
    }

    /// Channels that overflowed to infinity become the largest number, so that no later product with 0 is NaN.
    pub fn finite(self) -> Self {
        Rgb::from(self.channels().map(|channel| channel.min(f64::MAX)))
    }

    /// 8-bit sRGB: each channel clamped to [0, 1], encoded, rounded to nearest.
    pub fn to_srgb8(self) -> [u8; 3] {
        encode::srgb8(self.channels())
    }

    /// The linear colour of 8-bit sRGB codes.
    pub fn from_srgb8(codes: [u8; 3]) -> Self {
        Rgb::from(encode::linear(codes))
    }

    /// Relative luminance by ITU-R BT.709 primaries.
    pub fn luminance(self) -> f64 {
        0.2126 * self.r + 0.7152 * self.g + 0.0722 * self.b
    }
}

/// The sRGB transfer function of a linear value, which is clamped to [0, 1] first. NaN stays NaN, and 0 in 8 bits.
pub fn srgb_encode(linear: f64) -> f64 {
    let linear = linear.clamp(0.0, 1.0);
    if linear <= 0.003_130_8 {
        12.92 * linear
    } else {
        1.055 * linear.powf(1.0 / 2.4) - 0.055
    }
}

/// The inverse of [`srgb_encode`] on [0, 1].
fn srgb_decode(encoded: f64) -> f64 {
    if encoded <= 0.040_45 {
        encoded / 12.92
    } else {
        ((encoded + 0.055) / 1.055).powf(2.4)
    }
}

impl From<[f64; 3]> for Rgb {
    fn from([r, g, b]: [f64; 3]) -> Self {
        Rgb { r, g, b }
    }
}

impl Add for Rgb {
    type Output = Rgb;
    fn add(self, other: Rgb) -> Rgb {
        Rgb::new(self.r + other.r, self.g + other.g, self.b + other.b)
    }
}

impl AddAssign for Rgb {
    fn add_assign(&mut self, other: Rgb) {
        *self = *self + other;
    }
}

impl Sub for Rgb {
    type Output = Rgb;
    fn sub(self, other: Rgb) -> Rgb {
        Rgb::new(self.r - other.r, self.g - other.g, self.b - other.b)
    }
}

/// Channel by channel: a coefficient applied to a light.
impl Mul for Rgb {
    type Output = Rgb;
    fn mul(self, other: Rgb) -> Rgb {
        Rgb::new(self.r * other.r, self.g * other.g, self.b * other.b)
    }
}

impl Mul<f64> for Rgb {
    type Output = Rgb;
    fn mul(self, factor: f64) -> Rgb {
        Rgb::new(self.r * factor, self.g * factor, self.b * factor)
    }
}

impl Div<f64> for Rgb {
    type Output = Rgb;
    fn div(self, divisor: f64) -> Rgb {
        Rgb::new(self.r / divisor, self.g / divisor, self.b / divisor)
    }
}

impl Sum for Rgb {
    fn sum<I: Iterator<Item = Rgb>>(iter: I) -> Rgb {
        iter.fold(Rgb::BLACK, Add::add)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn srgb_has_the_values_of_the_standard() {
        // IEC 61966-2-1: linear 0.5 encodes to 0.735357; the two branches meet at 0.0031308.
        assert!((srgb_encode(0.5) - 0.735_356_983_052_449_2).abs() < 1e-12);
        assert!((srgb_encode(0.003_130_8) - srgb_encode(0.003_130_800_1)).abs() < 1e-7);
        assert_eq!(
            Rgb::new(-1.0, 0.214_041_140_482_232_55, 7.0).to_srgb8(),
            [0, 128, 255]
        );
        assert_eq!(Rgb::splat(f64::NAN).to_srgb8(), [0, 0, 0]);
    }
}
