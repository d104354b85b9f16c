//! What scan conversion interpolates, and the names under which it is recorded.

use crate::color::Rgb;
use crate::numeric::Linear;
use crate::record::Value;
use glam::{DVec2, DVec3};
use std::fmt::Debug;

/// A quantity that varies over a polygon: given at its corners, interpolated to its pixels.
pub trait Varying: Linear {
    /// The part of it that is recorded.
    type Recorded: Named;
    fn recorded(self) -> Self::Recorded;

    /// The (u, v) of a texture in it, which are recorded beside the rest.
    #[inline]
    fn texture(self) -> Option<DVec2> {
        None
    }
}

impl<V: Named> Varying for V {
    type Recorded = V;
    fn recorded(self) -> V {
        self
    }
}

/// The (u, v) of a texture alone.
impl Varying for DVec2 {
    type Recorded = ();
    fn recorded(self) {}

    #[inline]
    fn texture(self) -> Option<DVec2> {
        Some(self)
    }
}

/// A value and the (u, v) of a texture.
impl<V: Varying> Varying for (V, DVec2) {
    type Recorded = V::Recorded;
    fn recorded(self) -> V::Recorded {
        self.0.recorded()
    }

    #[inline]
    fn texture(self) -> Option<DVec2> {
        Some(self.1)
    }
}

/// An interpolated quantity that is recorded under the names of its values. Flat shading interpolates none, which is `()`.
pub trait Named: Linear + PartialEq + Debug + Send + Sync + 'static {
    const NAMES: Option<&'static Names>;
    fn value(self) -> Option<Value>;
}

/// The names of the interpolated values, such as `I_1` … `I_P` of Gouraud shading, as on the slide.
#[derive(Debug)]
pub struct Names {
    pub corner: &'static str,
    pub upper: &'static str,
    pub lower: &'static str,
    pub left: &'static str,
    pub left_incremental: &'static str,
    pub right: &'static str,
    pub pixel: &'static str,
    pub pixel_incremental: &'static str,
    /// The increment from one scan line to the next.
    pub step: &'static str,
    /// Zero: a colour or a vector, like all the values.
    pub zero: Value,
}

impl Named for () {
    const NAMES: Option<&'static Names> = None;
    fn value(self) -> Option<Value> {
        None
    }
}

/// An intensity.
impl Named for Rgb {
    const NAMES: Option<&'static Names> = Some(&Names {
        corner: "I",
        upper: "I_1",
        lower: "I_2",
        left: "I_4",
        left_incremental: "I_4_incremental",
        right: "I_5",
        pixel: "I_P",
        pixel_incremental: "I_P_incremental",
        step: "dI_dy",
        zero: Value::Rgb(Rgb::BLACK),
    });
    fn value(self) -> Option<Value> {
        Some(self.into())
    }
}

/// A normal.
impl Named for DVec3 {
    const NAMES: Option<&'static Names> = Some(&Names {
        corner: "N",
        upper: "N_1",
        lower: "N_2",
        left: "N_4",
        left_incremental: "N_4_incremental",
        right: "N_5",
        pixel: "N_P",
        pixel_incremental: "N_P_incremental",
        step: "dN_dy",
        zero: Value::Vector(DVec3::ZERO),
    });
    fn value(self) -> Option<Value> {
        Some(self.into())
    }
}
