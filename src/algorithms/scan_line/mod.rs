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
mod corner;
mod edge;
mod edge_table;
mod event;
mod fill;
mod span;
mod varying;

pub use clip::{Kept, clip_near, clip_to_picture, kept};
pub use corner::Corner;
pub use edge_table::EdgeTable;
pub use event::Event;
pub use span::Pixel;
pub use varying::{Named, Names, Varying};

#[cfg(test)]
mod tests;
