//! What scan conversion tells, whatever it carries from the corners to the pixels.

use crate::color::Rgb;

/// How the carried values are called: for Gouraud `I_1` … `I_P`, as the slide names them.
#[derive(Debug)]
pub struct Names {
    pub corner: &'static str,
    pub one: &'static str,
    pub two: &'static str,
    pub four: &'static str,
    pub four_incremental: &'static str,
    pub five: &'static str,
    pub pixel: &'static str,
    pub pixel_incremental: &'static str,
    /// What one scan line down adds.
    pub step: &'static str,
}

/// Indices: `edge` and `corner` count within the polygon as it is after clipping at the near plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Event<A> {
    /// Opens the building of the edge table.
    EdgeTable {
        corners: u32,
    },
    /// On the screen, in pixels; z is the depth.
    CornerPlaced {
        corner: u32,
        x: f64,
        y: f64,
        z: f64,
        value: A,
    },
    /// Rows `first..end`; `slope` is dx/dy, `step` what one scan line adds to the carried value.
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
    },
    EdgeEnds {
        a_1: A,
        a_2: A,
    },
    /// Closes `Edge`.
    EdgeInterpolated {
        direct: A,
        incremental: A,
    },
    /// Closes `Edge` where nothing is carried.
    EdgeCut,
    /// Opens a span; its pixels are `first..end`, those whose centres lie in [x_4, x_5).
    Span {
        x_4: f64,
        x_5: f64,
        first: u32,
        end: u32,
    },
    SpanEnds {
        a_4: A,
        a_5: A,
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
