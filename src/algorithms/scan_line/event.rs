//! The events of scan conversion, whatever is interpolated from the corners to the pixels.

use super::varying::{Named, Varying};
use crate::color::Rgb;
use glam::{DVec2, DVec3};

/// Indices: `edge` and `corner` count within the polygon as it is after clipping at the near plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Event<A> {
    /// Opens the construction of the edge table.
    EdgeTable {
        corners: u32,
    },
    /// In the camera frame.
    CornerTransformed {
        corner: u32,
        position: DVec3,
    },
    /// On the screen, in pixels; z is the depth.
    CornerPlaced {
        corner: u32,
        x: f64,
        y: f64,
        z: f64,
        value: A,
    },
    /// The (u, v) of a texture at a corner.
    CornerTextured {
        corner: u32,
        uv: DVec2,
    },
    /// Rows `first..end`; `slope` is dx/dy, `step` the increment of the value from one scan line to the next.
    EdgeEntered {
        edge: u32,
        upper: u32,
        lower: u32,
        first: u32,
        end: u32,
        slope: f64,
        step: A,
    },
    /// The edge passes the centre of no row.
    EdgeSkipped {
        from: u32,
        to: u32,
    },
    /// Closes `EdgeTable`.
    EdgeTableBuilt {
        edges: u32,
    },
    /// Opens a scan line; `y_4` is the height of its pixels' centres.
    ScanLine {
        y: u32,
        y_4: f64,
    },
    /// Opens an active edge on the current scan line.
    Edge {
        edge: u32,
        upper: u32,
        lower: u32,
        y_1: f64,
        y_2: f64,
        x_4: f64,
        /// Depth at the cut, as are `z_4` and `z_5` of a span at its ends.
        z_4: f64,
    },
    EdgeEnds {
        upper: A,
        lower: A,
    },
    /// The (u, v) of a texture at the ends of an edge, and where the scan line cuts it.
    EdgeTextured {
        upper: DVec2,
        lower: DVec2,
        cut: DVec2,
    },
    /// Closes `Edge`.
    EdgeInterpolated {
        direct: A,
        incremental: A,
    },
    /// Closes `Edge` where nothing is interpolated.
    EdgeCut,
    /// Opens a span; its pixels are `first..end`, those whose centres lie in [x_4, x_5).
    Span {
        x_4: f64,
        x_5: f64,
        z_4: f64,
        z_5: f64,
        first: u32,
        end: u32,
    },
    SpanEnds {
        left: A,
        right: A,
    },
    /// The (u, v) of a texture at the ends of a span.
    SpanTextured {
        left: DVec2,
        right: DVec2,
    },
    /// Opens a pixel.
    Pixel {
        x: u32,
        y: u32,
        x_p: f64,
    },
    /// Depths; `nearest` is infinite where nothing was drawn yet.
    DepthTested {
        z: f64,
        nearest: f64,
        nearer: bool,
    },
    SpanInterpolated {
        direct: A,
        incremental: A,
    },
    /// Closes `Pixel`.
    PixelColored {
        color: Rgb,
    },
    /// Closes `Pixel`: something nearer was drawn there before.
    PixelHidden,
    /// Closes `Span`.
    SpanDone,
    /// Closes `ScanLine`.
    ScanLineDone,
}

impl<A: Named> Event<A> {
    /// The value on an edge, in both ways.
    pub fn on_edge<V: Varying<Recorded = A>>(direct: V, incremental: V) -> Self {
        Event::EdgeInterpolated {
            direct: direct.recorded(),
            incremental: incremental.recorded(),
        }
    }

    /// The value at a pixel, in both ways.
    pub fn on_span<V: Varying<Recorded = A>>(direct: V, incremental: V) -> Self {
        Event::SpanInterpolated {
            direct: direct.recorded(),
            incremental: incremental.recorded(),
        }
    }
}
