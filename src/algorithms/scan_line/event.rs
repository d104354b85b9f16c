//! What scan conversion tells, whatever it carries from the corners to the pixels.

use super::Carried;
use crate::color::Rgb;
use crate::record::Fields;

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

/// The part of scan conversion that an event belongs to. An algorithm's listing has a line for each, in this order; what
/// stands between the last two is its own.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    EdgeTable,
    ScanLine,
    Edge,
    /// The cut of the scan line with an edge, and what is carried there.
    Cut,
    Span,
    Pixel,
    Depth,
    Interpolation,
    Color,
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

impl<A: Carried> Event<A> {
    pub fn kind(&self) -> &'static str {
        match self {
            Event::EdgeTable { .. } => "EdgeTable",
            Event::CornerPlaced { .. } => "CornerPlaced",
            Event::EdgeEntered { .. } => "EdgeEntered",
            Event::EdgeSkipped { .. } => "EdgeSkipped",
            Event::EdgeTableBuilt { .. } => "EdgeTableBuilt",
            Event::ScanLine { .. } => "ScanLine",
            Event::Edge { .. } => "Edge",
            Event::EdgeEnds { .. } => "EdgeEnds",
            Event::EdgeInterpolated { .. } => "EdgeInterpolated",
            Event::EdgeCut => "EdgeCut",
            Event::Span { .. } => "Span",
            Event::SpanEnds { .. } => "SpanEnds",
            Event::Pixel { .. } => "Pixel",
            Event::DepthTested { .. } => "DepthTested",
            Event::SpanInterpolated { .. } => "SpanInterpolated",
            Event::PixelColored { .. } => "PixelColored",
            Event::PixelHidden => "PixelHidden",
            Event::SpanDone => "SpanDone",
            Event::ScanLineDone => "ScanLineDone",
        }
    }

    pub fn part(&self) -> Part {
        match self {
            Event::EdgeTable { .. }
            | Event::CornerPlaced { .. }
            | Event::EdgeEntered { .. }
            | Event::EdgeSkipped { .. }
            | Event::EdgeTableBuilt { .. } => Part::EdgeTable,
            Event::ScanLine { .. } | Event::ScanLineDone => Part::ScanLine,
            Event::Edge { .. } => Part::Edge,
            Event::EdgeEnds { .. } | Event::EdgeInterpolated { .. } | Event::EdgeCut => Part::Cut,
            Event::Span { .. } | Event::SpanEnds { .. } | Event::SpanDone => Part::Span,
            Event::Pixel { .. } => Part::Pixel,
            Event::DepthTested { .. } | Event::PixelHidden => Part::Depth,
            Event::SpanInterpolated { .. } => Part::Interpolation,
            Event::PixelColored { .. } => Part::Color,
        }
    }

    pub fn fields(&self, fields: &mut Fields) {
        match *self {
            Event::EdgeTable { corners } => {
                fields.push("corners", corners);
            }
            Event::CornerPlaced {
                corner,
                x,
                y,
                z,
                value,
            } => {
                fields
                    .push("corner", corner)
                    .push("x", x)
                    .push("y", y)
                    .push("z", z);
                tell(fields, value, |names| names.corner);
            }
            Event::EdgeEntered {
                edge,
                upper,
                lower,
                first,
                end,
                slope,
                step,
            } => {
                fields
                    .push("edge", edge)
                    .push("upper", upper)
                    .push("lower", lower)
                    .push("first", first)
                    .push("end", end);
                fields.push("dx_dy", slope);
                tell(fields, step, |names| names.step);
            }
            Event::EdgeSkipped { from, to } => {
                fields.push("from", from).push("to", to);
            }
            Event::EdgeTableBuilt { edges } => {
                fields.push("edges", edges);
            }
            Event::ScanLine { y, y_4 } => {
                fields.push("y", y).push("y_4", y_4);
            }
            Event::Edge {
                edge,
                upper,
                lower,
                y_1,
                y_2,
                x_4,
            } => {
                fields
                    .push("edge", edge)
                    .push("upper", upper)
                    .push("lower", lower);
                fields.push("y_1", y_1).push("y_2", y_2).push("x_4", x_4);
            }
            Event::EdgeEnds { a_1, a_2 } => {
                tell(fields, a_1, |names| names.one);
                tell(fields, a_2, |names| names.two);
            }
            Event::EdgeInterpolated {
                direct,
                incremental,
            } => {
                tell(fields, direct, |names| names.four);
                tell(fields, incremental, |names| names.four_incremental);
                (incremental - direct).tell("difference", fields);
            }
            Event::Span {
                x_4,
                x_5,
                first,
                end,
            } => {
                fields
                    .push("x_4", x_4)
                    .push("x_5", x_5)
                    .push("first", first)
                    .push("end", end);
            }
            Event::SpanEnds { a_4, a_5 } => {
                tell(fields, a_4, |names| names.four);
                tell(fields, a_5, |names| names.five);
            }
            Event::Pixel { x, y, x_p } => {
                fields.push("x", x).push("y", y).push("x_P", x_p);
            }
            Event::DepthTested { z, nearest, nearer } => {
                fields
                    .push("z", z)
                    .push("nearest", nearest)
                    .push("nearer", nearer);
            }
            Event::SpanInterpolated {
                direct,
                incremental,
            } => {
                tell(fields, direct, |names| names.pixel);
                tell(fields, incremental, |names| names.pixel_incremental);
                (incremental - direct).tell("difference", fields);
            }
            Event::PixelColored { color } => {
                fields.push("color", color);
            }
            Event::EdgeCut | Event::PixelHidden | Event::SpanDone | Event::ScanLineDone => {}
        }
    }
}

/// A carried value under its name.
fn tell<A: Carried>(fields: &mut Fields, value: A, name: fn(&Names) -> &'static str) {
    if let Some(names) = A::NAMES {
        value.tell(name(names), fields);
    }
}
