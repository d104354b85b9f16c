//! Textures on converted polygons: a texture multiplies k_d, and so the diffuse part of the light alone, pixel by pixel.
//!
//! (u, v) are asked of the object's own chart at P, the point of the polygon that the pixel shows: they are those that a ray through the
//! pixel finds. The plain way carries the corners' (u, v) to the pixels as intensities and normals are, linearly on the screen.
//! Wherever the depth changes along a polygon that is wrong, and seen to be (Heckbert & Moreton, "Interpolation for polygon texture
//! mapping and shading", 1991): it is told beside the right one, and drawn where the stage asks for it.

use super::intensity::Intensity;
use super::prepared_scene::{Polygon, PreparedScene};
use super::scan_line::Cargo;
use crate::color::Rgb;
use crate::numeric::Linear;
use crate::record::{Listing, Recorder};
use crate::scene::primitives::FaceChart;
use crate::scene::{Part, Texture};
use glam::{DVec2, DVec3};
use std::ops::{Add, Mul, Sub};

pub static PSEUDOCODE: Listing = Listing {
    name: "texture",
    lines: &[
        ("", "texture(x_P, y_P)"),
        (
            "point",
            "  P ← the point of the polygon that the pixel shows",
        ),
        ("chart", "  (u, v) ← the object's chart at P"),
        ("texture", "  T ← colour of the texture at (u, v)"),
        (
            "applied",
            "  k_d ← T · k_d,   and so   I ← I − I_d + T · I_d",
        ),
    ],
};

/// Where (u, v) come from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Mapping {
    /// From the point that the pixel shows.
    #[default]
    Perspective,
    /// From the corners, linearly on the screen: a mistake, to be looked at.
    Linear,
}

impl Mapping {
    pub const ALL: [Mapping; 2] = [Mapping::Perspective, Mapping::Linear];

    /// As in lesson files.
    pub fn name(self) -> &'static str {
        match self {
            Mapping::Perspective => "perspective",
            Mapping::Linear => "linear",
        }
    }

    pub fn from_name(name: &str) -> Option<Self> {
        Mapping::ALL
            .into_iter()
            .find(|mapping| mapping.name() == name)
    }
}

/// The texture of a polygon.
pub struct OnPolygon<'a> {
    texture: Texture,
    chart: FaceChart<'a>,
    mapping: Mapping,
}

impl<'a> OnPolygon<'a> {
    /// None where the polygon's material has no texture, and none is looked up all the same.
    pub fn of(prepared: &'a PreparedScene, polygon: &Polygon<'a>) -> Option<Self> {
        let white = prepared.forced().has(Part::TextureCoordinates);
        let texture = polygon.material.texture;
        let texture = texture.or(white.then_some(Texture::WHITE))?;
        let shape = &prepared.scene.objects[polygon.object].shape;
        Some(OnPolygon {
            texture,
            chart: FaceChart::new(shape, polygon.mesh, polygon.face),
            mapping: prepared.mapping,
        })
    }

    /// (u, v) at the polygon's corners.
    pub fn corners(&self) -> &[DVec2] {
        self.chart.corners()
    }
}

/// The texture at a pixel of a polygon.
#[derive(Clone, Copy)]
pub struct AtPixel<'a> {
    pub on: &'a OnPolygon<'a>,
    /// (u, v) as the corners' were carried here.
    pub linear: DVec2,
}

impl AtPixel<'_> {
    /// T, at the point `position` of the surface.
    pub fn color_at<E: From<Event>>(self, position: DVec3, recorder: &mut impl Recorder<E>) -> Rgb {
        let OnPolygon {
            texture,
            chart,
            mapping,
        } = self.on;
        let uv = chart.uv(position);
        let color = texture.color_at(uv);
        recorder.step(|| Event::Textured { uv, color }.into());
        let plain = texture.color_at(self.linear);
        recorder.step(|| {
            Event::TexturedLinearly {
                uv: self.linear,
                color: plain,
            }
            .into()
        });
        let color = match mapping {
            Mapping::Perspective => color,
            Mapping::Linear => plain,
        };
        let linear = *mapping == Mapping::Linear;
        recorder.step(|| Event::TextureTaken { color, linear }.into());
        color
    }

    /// An intensity found without the texture, with it.
    pub fn applied<E: From<Event>>(
        self,
        intensity: Intensity,
        position: DVec3,
        recorder: &mut impl Recorder<E>,
    ) -> Rgb {
        let textured = intensity.textured(self.color_at(position, recorder));
        recorder.step(|| {
            Event::TextureApplied {
                diffuse: intensity.diffuse,
                textured,
            }
            .into()
        });
        textured
    }
}

/// What a textured polygon carries: (u, v) go along, untold.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WithUv<T> {
    pub value: T,
    pub uv: DVec2,
}

impl<T> WithUv<T> {
    /// Another value with the same (u, v).
    pub fn with<U>(&self, value: U) -> WithUv<U> {
        WithUv { value, uv: self.uv }
    }
}

impl<T: Cargo> Cargo for WithUv<T> {
    type Recorded = T::Recorded;
    fn recorded(self) -> T::Recorded {
        self.value.recorded()
    }
}

impl<T: Linear> Linear for WithUv<T> {}

impl<T: Linear> Add for WithUv<T> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        WithUv {
            value: self.value + other.value,
            uv: self.uv + other.uv,
        }
    }
}

impl<T: Linear> Sub for WithUv<T> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        WithUv {
            value: self.value - other.value,
            uv: self.uv - other.uv,
        }
    }
}

impl<T: Linear> Mul<f64> for WithUv<T> {
    type Output = Self;
    fn mul(self, factor: f64) -> Self {
        WithUv {
            value: self.value * factor,
            uv: self.uv * factor,
        }
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Event {
    /// The texture at the point that the pixel shows.
    Textured { uv: DVec2, color: Rgb },
    /// The texture at the (u, v) that the plain way finds.
    TexturedLinearly { uv: DVec2, color: Rgb },
    /// Which of the two is T: the plain one where `linear`.
    TextureTaken { color: Rgb, linear: bool },
    /// `diffuse` is I_d, the part of the intensity that the texture multiplies.
    TextureApplied { diffuse: Rgb, textured: Rgb },
}
