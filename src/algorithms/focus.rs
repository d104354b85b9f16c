//! Which part of a frame a run carries out. A recorded run takes the part that is looked at, and nothing else.

use std::ops::Range;

/// The part of a frame that is looked at.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Focus {
    Frame,
    /// Counted from 0 over all objects in their order.
    Polygon(usize),
    ScanLine(u32),
    Pixel {
        x: u32,
        y: u32,
    },
}

/// A rectangle of pixels, half-open.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Region {
    pub columns: Range<u32>,
    pub rows: Range<u32>,
}

impl Focus {
    /// The pixels that can be looked at in a picture of `width`×`height`.
    pub fn region(self, width: u32, height: u32) -> Region {
        match self {
            Focus::Frame | Focus::Polygon(_) => Region {
                columns: 0..width,
                rows: 0..height,
            },
            Focus::ScanLine(y) => Region {
                columns: 0..width,
                rows: y.min(height)..(y + 1).min(height),
            },
            Focus::Pixel { x, y } => Region {
                columns: x.min(width)..(x + 1).min(width),
                rows: y.min(height)..(y + 1).min(height),
            },
        }
    }

    /// Whether the polygon of this index can be looked at.
    pub fn takes_polygon(self, polygon: usize) -> bool {
        match self {
            Focus::Polygon(only) => only == polygon,
            _ => true,
        }
    }
}
