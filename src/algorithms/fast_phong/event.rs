//! The events of Fast Phong shading.

use super::listing::FastPhong;
use crate::algorithms::shading::{self, ShadingEvent};
use crate::algorithms::{illumination, prepared_scene, scan_line, texture, vertex_normal};
use crate::color::Rgb;
use crate::numeric::{Differences, Quadratic};
use glam::{DVec2, DVec3};

/// A cosine of the illumination model.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cosine {
    /// N·L, of the diffuse term.
    NDotL,
    /// N·H, of the specular term (Blinn 1977).
    NDotH,
    /// R·V, of the specular term (Phong 1975).
    RDotV,
    /// N·V, of which R·V is made.
    NDotV,
}

impl Cosine {
    pub fn name(self) -> &'static str {
        match self {
            Cosine::NDotL => "N_dot_L",
            Cosine::NDotH => "N_dot_H",
            Cosine::RDotV => "R_dot_V",
            Cosine::NDotV => "N_dot_V",
        }
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Event {
    /// An event that every method has; of the illumination model, the directions at the point of expansion.
    Shading(shading::Event<FastPhong>),
    /// Opens a triangle between three corners of the polygon, or what the near plane leaves of it; `triangle` counts within the
    /// polygon.
    Triangle {
        triangle: u32,
        corners: [u32; 3],
    },
    /// A corner of the triangle, `number` 0 to 2, on the screen and with its depth, and its unit normal.
    TriangleCorner {
        number: u32,
        place: DVec2,
        depth: f64,
        normal: DVec3,
    },
    /// The point of expansion on the screen, its depth, and N there, on the side of the eye; where the vertex normals cancel out
    /// it is the normal of the face. Pieces of one triangle that was `cut` have one point of expansion.
    NormalAtMiddle {
        middle: DVec2,
        depth: f64,
        n_0: DVec3,
        vanished: bool,
        turned: bool,
        cut: bool,
    },
    /// What one pixel to the right and one row down add to N.
    NormalSlopes {
        n_x: DVec3,
        n_y: DVec3,
    },
    /// N·N/|N_0|² over the triangle: see [`LinearNormal::squared`](crate::numeric::LinearNormal::squared).
    NormalSquared {
        squared: [f64; 5],
    },
    /// The dot product of N/|N_0| with a direction: see [`LinearNormal::along`](crate::numeric::LinearNormal::along).
    DotProduct {
        cosine: Cosine,
        along: [f64; 3],
    },
    Series {
        cosine: Cosine,
        series: Quadratic,
    },
    /// Closes a light.
    LightExpanded,
    /// Closes the point of expansion.
    Expanded,
    /// The differences at the first pixel of a span.
    DifferencesStarted {
        light: u16,
        cosine: Cosine,
        running: Differences<f64>,
    },
    /// A cosine at a pixel: by differences, by the polynomial itself, and exactly, with N brought to unit length.
    CosineEvaluated {
        light: u16,
        cosine: Cosine,
        running: Differences<f64>,
        direct: f64,
        exact: f64,
    },
    /// A light that reaches the pixel; `power` is that of the highlight, from the table.
    LightSummed {
        power: f64,
        i_d: Rgb,
        i_s: Rgb,
    },
    /// Closes `Triangle`.
    TriangleDone,
}

impl ShadingEvent for Event {
    type Shading = FastPhong;

    /// All but the series.
    fn shading(&self) -> Option<&shading::Event<FastPhong>> {
        match self {
            Event::Shading(event) => Some(event),
            _ => None,
        }
    }
}

const _: () = assert!(size_of::<Event>() <= 64);

contains_events! {
    [] Event {
        shading::Event<FastPhong> => Event::Shading,
        prepared_scene::Event => |event| Event::Shading(event.into()),
        vertex_normal::Event => |event| Event::Shading(event.into()),
        illumination::Event => |event| Event::Shading(event.into()),
        scan_line::Event<()> => |event| Event::Shading(event.into()),
        texture::Event => |event| Event::Shading(event.into()),
    }
}
