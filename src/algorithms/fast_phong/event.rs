//! What Fast Phong tells.

use super::PSEUDOCODE;
use crate::algorithms::flat::Nothing;
use crate::algorithms::shading::{self, Lines, Shading};
use crate::algorithms::{illumination, prepared_scene, scan_line, texture, vertex_normal};
use crate::color::Rgb;
use crate::numeric::{Differences, Quadratic};
use crate::record::{self, Fields, Line};
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
}

impl Cosine {
    pub fn name(self) -> &'static str {
        match self {
            Cosine::NDotL => "N_dot_L",
            Cosine::NDotH => "N_dot_H",
            Cosine::RDotV => "R_dot_V",
        }
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FastPhong {}

impl Shading for FastPhong {
    type Recorded = Nothing;
    const LINES: Lines = Lines {
        listing: &PSEUDOCODE,
        vertex_normal: 2,
        vertex_done: 2,
        edge_table: 10,
        pixel_point: texture::POINT,
        pixel_normal: 18,
    };
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Event {
    /// What every method tells; of the illumination model, its directions at the point of expansion.
    Shading(shading::Event<FastPhong>),
    /// Opens a triangle between three corners of the polygon, or what the near plane leaves of it.
    Triangle {
        corners: [u32; 3],
    },
    /// The point of expansion on the screen, and N there, on the side of the eye; where the vertex normals cancel out it is
    /// the normal of the face.
    NormalAtMiddle {
        middle: DVec2,
        n_0: DVec3,
        vanished: bool,
    },
    /// What one pixel to the right and one row down add to N.
    NormalSlopes {
        n_x: DVec3,
        n_y: DVec3,
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
    /// A cosine at a pixel: by differences, by the polynomial itself, and with N made a unit vector.
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

const _: () = assert!(size_of::<Event>() <= 64);

impl From<prepared_scene::Event> for Event {
    fn from(event: prepared_scene::Event) -> Self {
        Event::Shading(event.into())
    }
}

impl From<vertex_normal::Event> for Event {
    fn from(event: vertex_normal::Event) -> Self {
        Event::Shading(event.into())
    }
}

impl From<illumination::Event> for Event {
    fn from(event: illumination::Event) -> Self {
        Event::Shading(event.into())
    }
}

impl From<scan_line::Event<Nothing>> for Event {
    fn from(event: scan_line::Event<Nothing>) -> Self {
        Event::Shading(event.into())
    }
}

impl From<texture::Event> for Event {
    fn from(event: texture::Event) -> Self {
        Event::Shading(event.into())
    }
}

impl From<shading::Event<FastPhong>> for Event {
    fn from(event: shading::Event<FastPhong>) -> Self {
        Event::Shading(event)
    }
}

impl record::Event for Event {
    fn kind(&self) -> &'static str {
        match self {
            Event::Shading(event) => event.kind(),
            Event::Triangle { .. } => "Triangle",
            Event::NormalAtMiddle { .. } => "NormalAtMiddle",
            Event::NormalSlopes { .. } => "NormalSlopes",
            Event::Series { .. } => "Series",
            Event::LightExpanded => "LightExpanded",
            Event::Expanded => "Expanded",
            Event::DifferencesStarted { .. } => "DifferencesStarted",
            Event::CosineEvaluated { .. } => "CosineEvaluated",
            Event::LightSummed { .. } => "LightSummed",
            Event::TriangleDone => "TriangleDone",
        }
    }

    fn line(&self) -> Line {
        let number = match self {
            // The directions have lines of their own here, for they are found once a triangle.
            Event::Shading(shading::Event::Illumination(event)) => match event {
                illumination::Event::Light { .. } => 6,
                illumination::Event::ToLight { .. } => 7,
                illumination::Event::Mirrored { .. } | illumination::Event::Halfway { .. } => 8,
                _ => 5,
            },
            Event::Shading(event) => return event.line(),
            Event::Triangle { .. } | Event::Expanded | Event::TriangleDone => 3,
            Event::NormalAtMiddle { .. } | Event::NormalSlopes { .. } => 4,
            Event::LightExpanded => 6,
            Event::Series { .. } => 9,
            Event::DifferencesStarted { .. } => 17,
            Event::CosineEvaluated { .. } => 18,
            Event::LightSummed { .. } => 19,
        };
        Line {
            listing: &PSEUDOCODE,
            number,
        }
    }

    fn fields(&self, fields: &mut Fields) {
        match *self {
            Event::Shading(event) => event.fields(fields),
            Event::Triangle { corners: [a, b, c] } => {
                fields.push("a", a).push("b", b).push("c", c);
            }
            Event::NormalAtMiddle {
                middle,
                n_0,
                vanished,
            } => {
                fields.push("x_0", middle.x).push("y_0", middle.y);
                fields.push("N_0", n_0).push("vanished", vanished);
            }
            Event::NormalSlopes { n_x, n_y } => {
                fields.push("N_x", n_x).push("N_y", n_y);
            }
            Event::Series { cosine, series } => {
                fields.push("cosine", cosine.name());
                let names = ["T_0", "T_1", "T_2", "T_3", "T_4", "T_5"];
                for (name, term) in names.into_iter().zip(series.0) {
                    fields.push(name, term);
                }
            }
            Event::DifferencesStarted {
                light,
                cosine,
                running,
            } => {
                fields.push("light", light).push("cosine", cosine.name());
                tell(fields, running);
            }
            Event::CosineEvaluated {
                light,
                cosine,
                running,
                direct,
                exact,
            } => {
                fields.push("light", light).push("cosine", cosine.name());
                tell(fields, running);
                fields.push("c_direct", direct).push("c_exact", exact);
                fields.push("difference", running.value - direct);
                fields.push("error", running.value - exact);
            }
            Event::LightSummed { power, i_d, i_s } => {
                fields.push("power", power);
                fields.push("I_d", i_d).push("I_s", i_s);
            }
            Event::LightExpanded | Event::Expanded | Event::TriangleDone => {}
        }
    }
}

fn tell(fields: &mut Fields, running: Differences<f64>) {
    fields
        .push("c", running.value)
        .push("dc", running.first)
        .push("d2c", running.second);
}
