//! The part of its work that a run records: of a frame, or of the exchange of light in an enclosure. A recorded run does that part
//! and nothing else.

use super::frame::Frame;
use std::ops::Range;

/// The part of the work that is recorded.
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
    /// Of a solver of radiosity: from `start` up to, but without, `end`.
    Iterations {
        start: u32,
        end: u32,
    },
    /// The exchange of one patch of an enclosure, counted from 0 over all objects.
    Patch(u32),
    /// The form factor from patch `i` to patch `j`.
    FormFactor {
        i: u32,
        j: u32,
    },
}

/// A rectangle of pixels, half-open.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Region {
    pub columns: Range<u32>,
    pub rows: Range<u32>,
}

impl Focus {
    /// The pixels of `frame` that are drawn.
    pub fn region(self, frame: &Frame) -> Region {
        let (columns, rows) = match self {
            Focus::Frame
            | Focus::Polygon(_)
            | Focus::Iterations { .. }
            | Focus::Patch(_)
            | Focus::FormFactor { .. } => (0..u32::MAX, 0..u32::MAX),
            Focus::ScanLine(y) => (0..u32::MAX, y..y.saturating_add(1)),
            Focus::Pixel { x, y } => (x..x.saturating_add(1), y..y.saturating_add(1)),
        };
        let within = |part: Range<u32>, whole: Range<u32>| {
            let start = part.start.clamp(whole.start, whole.end);
            start..part.end.clamp(start, whole.end)
        };
        Region {
            columns: within(columns, 0..frame.width),
            rows: within(rows, frame.rows.clone()),
        }
    }
}
