//! Textures on converted polygons: a texture multiplies k_d, and so the diffuse part of the light alone, pixel by pixel.
//!
//! (u, v) come from the object's own chart at P, the point of the polygon that the pixel shows: the same that a ray through the
//! pixel finds. The naive way interpolates the corners' (u, v) linearly on the screen, as intensities and normals are. Wherever
//! the depth changes along a polygon that is visibly wrong (Heckbert & Moreton, "Interpolation for polygon texture mapping and
//! shading", 1991): it is recorded beside the right one, and drawn with [`Mapping::Linear`].

use super::intensity::Intensity;
use super::mapping::Mapping;
use super::prepared_scene::{Polygon, PreparedScene};
use crate::color::Rgb;
use crate::record::{Listing, Recorder};
use crate::scene::Texture;
use crate::scene::primitives::FaceChart;
use glam::{DVec2, DVec3};

pub static PSEUDOCODE: Listing = Listing {
    name: "texture",
    lines: &[
        ("", "texture(x_P, y_P)"),
        (
            "point",
            "  P ← {the-point-of-the-polygon-that-the-pixel-shows}",
        ),
        ("chart", "  (u, v) ← {the-chart-of-the-object-at-p}"),
        ("texture", "  T ← {colour-of-the-texture-at-u-v}"),
        (
            "applied",
            "  k_d ← T · k_d,   {and-so}   I ← I − I_d + T · I_d",
        ),
    ],
};

/// The texture of a polygon. The polygon interpolates the (u, v) of its corners.
pub struct PolygonTexture<'a> {
    texture: Texture,
    chart: FaceChart<'a>,
    mapping: Mapping,
}

impl<'a> PolygonTexture<'a> {
    /// None where the polygon has no texture.
    pub fn of(prepared: &'a PreparedScene, polygon: &Polygon<'a>) -> Option<Self> {
        let texture = polygon.texture?;
        let shape = &prepared.scene.objects[polygon.object].shape;
        Some(PolygonTexture {
            texture,
            chart: FaceChart::new(shape, polygon.mesh, polygon.face),
            mapping: prepared.mapping,
        })
    }

    /// (u, v) at the polygon's corners.
    pub fn corners(&self) -> &[DVec2] {
        self.chart.corners()
    }

    /// T, at the point `position` of the surface, to which the (u, v) of the corners were interpolated as `linear`.
    pub fn color_at<E: From<Event>>(
        &self,
        position: DVec3,
        linear: DVec2,
        recorder: &mut impl Recorder<E>,
    ) -> Rgb {
        let uv = self.chart.uv(position);
        let color = self.texture.color_at(uv);
        recorder.step(|| Event::Textured { uv, color }.into());
        let plain = self.texture.color_at(linear);
        recorder.step(|| {
            Event::TexturedLinearly {
                uv: linear,
                color: plain,
            }
            .into()
        });
        let color = match self.mapping {
            Mapping::Perspective => color,
            Mapping::Linear => plain,
        };
        let linear = self.mapping == Mapping::Linear;
        recorder.step(|| Event::TextureTaken { color, linear }.into());
        color
    }

    /// Applies the texture to an intensity computed without it.
    pub fn applied<E: From<Event>>(
        &self,
        intensity: Intensity,
        position: DVec3,
        linear: DVec2,
        recorder: &mut impl Recorder<E>,
    ) -> Rgb {
        let textured = intensity.textured(self.color_at(position, linear, recorder));
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

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Event {
    /// The texture at the point that the pixel shows.
    Textured { uv: DVec2, color: Rgb },
    /// The texture at the (u, v) interpolated from the corners.
    TexturedLinearly { uv: DVec2, color: Rgb },
    /// Which of the two is T: the interpolated one where `linear`.
    TextureTaken { color: Rgb, linear: bool },
    /// `diffuse` is I_d, the part of the intensity that the texture multiplies.
    TextureApplied { diffuse: Rgb, textured: Rgb },
}
