//! Scan conversion of one polygon: edge table, active edge list, spans, depth buffer
//! (Wylie, Romney, Evans, Erdahl 1967; Catmull 1974; Foley, van Dam, Feiner, Hughes 1990, §3.6 and §15.4).
//!
//! Convex and concave polygons, even–odd. A pixel belongs to a polygon when its centre is inside, half-open: on an edge
//! shared by two polygons it belongs to exactly one of them. A quantity given at the corners (an intensity, a normal) is
//! interpolated along edges and then along spans, linearly on the screen, by increments; each method does that itself, and
//! records the direct value beside the incremental one. Where a scan line cuts an edge is always computed directly, so that
//! no rounding error moves a pixel across it.
//!
//! Screen frame: pixels, x to the right, y down; pixel (x, y) has its centre at (x + 0.5, y + 0.5). Depth is the distance
//! along the viewing direction; its inverse is linear on the screen.

mod clip;
mod edge;
mod edge_table;
mod event;
mod fill;
mod span;

use crate::numeric::Linear;
use glam::{DVec2, DVec3};

pub use clip::clip_near;
pub use edge_table::EdgeTable;
pub use event::{Event, Named, Names};
pub use span::Pixel;

#[cfg(test)]
mod tests;

/// A quantity that varies over a polygon: given at its corners, interpolated to its pixels.
pub trait Varying: Linear {
    /// The part of it that is recorded.
    type Recorded: Named;
    fn recorded(self) -> Self::Recorded;
}

impl<V: Named> Varying for V {
    type Recorded = V;
    fn recorded(self) -> V {
        self
    }
}

/// The (u, v) of a texture are interpolated without being recorded.
impl Varying for DVec2 {
    type Recorded = ();
    fn recorded(self) {}
}

/// A value and the (u, v) of a texture.
impl<V: Varying> Varying for (V, DVec2) {
    type Recorded = V::Recorded;
    fn recorded(self) -> V::Recorded {
        self.0.recorded()
    }
}

/// A corner in the camera frame, with the value there.
#[derive(Clone, Copy, Debug)]
pub struct Corner<V> {
    pub position: DVec3,
    pub value: V,
}

impl<V> Corner<V> {
    /// The same corner with another value.
    pub fn map<W>(self, change: impl FnOnce(V) -> W) -> Corner<W> {
        Corner {
            position: self.position,
            value: change(self.value),
        }
    }
}

/// The first row or column, within 0..=size, whose centre is not before `edge`.
#[inline]
fn first_centre(edge: f64, size: u32) -> u32 {
    // A cast from float saturates, and takes NaN to 0.
    ((edge - 0.5).ceil() as u32).min(size)
}
