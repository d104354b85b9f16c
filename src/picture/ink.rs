//! What shapes are painted with: colours by their meaning, strokes and fills.

use crate::color::Rgb;

/// A colour by its meaning; a [`Theme`](super::Theme) says which it is.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Ink {
    /// The window behind the panels.
    Background,
    /// The panel itself: every picture begins with it.
    Surface,
    /// What is to be read.
    Text,
    /// What may be read: units, captions, axes.
    Muted,
    /// Quiet fills: bars and cells that nothing happens in.
    Faint,
    /// Rules, frames and grid lines.
    Rule,
    /// The accent: this step, and nothing else.
    This,
    /// A fill under what belongs to this step.
    ThisTint,
    /// Linked to what is looked at, or: go there.
    Linked,
    /// A fill under what is linked or current.
    LinkedTint,
    /// Holds, clear, done.
    Good,
    /// Fails, blocked.
    Bad,
    /// To be looked at: questions and warnings.
    Warn,
    /// A fill under a question or a warning.
    WarnTint,
    /// The n-th of several alike (Okabe–Ito; it repeats). Never distinguished by colour alone: add a dash or a letter.
    Series(u8),
    /// A colour of the scene, linear; clamped and encoded as the image is.
    Rgb(Rgb),
}

impl Ink {
    /// A line of this ink, `width` points wide.
    pub fn stroke(self, width: f32) -> Stroke {
        Stroke {
            ink: self,
            width,
            dash: Dash::Solid,
            opacity: 1.0,
        }
    }

    /// An area of this ink.
    pub fn fill(self) -> Paint {
        Paint {
            fill: Some(Fill {
                ink: self,
                opacity: 1.0,
            }),
            stroke: None,
        }
    }
}

/// How a line is broken.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Dash {
    Solid,
    /// 5 points drawn, 4 left out.
    Dashed,
    /// 2 points drawn, 3 left out.
    Dotted,
}

impl Dash {
    /// Lengths drawn and left out, alternating, in points.
    pub(super) fn lengths(self) -> Option<[f32; 2]> {
        match self {
            Dash::Solid => None,
            Dash::Dashed => Some([5.0, 4.0]),
            Dash::Dotted => Some([2.0, 3.0]),
        }
    }
}

/// How a line is drawn; the width is in points, the opacity in [0, 1].
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Stroke {
    pub ink: Ink,
    pub width: f32,
    pub dash: Dash,
    pub opacity: f32,
}

impl Stroke {
    pub fn dashed(self) -> Self {
        Stroke {
            dash: Dash::Dashed,
            ..self
        }
    }

    pub fn dotted(self) -> Self {
        Stroke {
            dash: Dash::Dotted,
            ..self
        }
    }

    pub fn opacity(self, opacity: f32) -> Self {
        Stroke { opacity, ..self }
    }
}

/// How an area is filled; the opacity is in [0, 1].
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Fill {
    pub ink: Ink,
    pub opacity: f32,
}

/// How a closed shape is painted: its area, then its outline.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct Paint {
    pub fill: Option<Fill>,
    pub stroke: Option<Stroke>,
}

impl Paint {
    /// The fill's opacity; an outline has its own.
    pub fn opacity(mut self, opacity: f32) -> Self {
        if let Some(fill) = &mut self.fill {
            fill.opacity = opacity;
        }
        self
    }

    pub fn outlined(self, stroke: Stroke) -> Self {
        Paint {
            stroke: Some(stroke),
            ..self
        }
    }
}

impl From<Ink> for Paint {
    fn from(ink: Ink) -> Self {
        ink.fill()
    }
}

/// The outline alone.
impl From<Stroke> for Paint {
    fn from(stroke: Stroke) -> Self {
        Paint::default().outlined(stroke)
    }
}
