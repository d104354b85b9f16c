//! Textures on converted polygons: a texture multiplies k_d, and so the diffuse part of the light alone, pixel by pixel.
//!
//! (u, v) come from the object's own chart at P, the point of the polygon that the pixel shows: the same that a ray through the
//! pixel finds. The naive way interpolates the corners' (u, v) linearly on the screen, as intensities and normals are. Wherever
//! the depth changes along a polygon that is visibly wrong (Heckbert & Moreton, "Interpolation for polygon texture mapping and
//! shading", 1991): it is recorded beside the right one, and drawn with [`Mapping::Linear`].

use super::prepared_scene::Polygon;
use crate::color::Rgb;
use crate::record::{Listing, Recorder};
use crate::scene::primitives::FaceChart;
use crate::scene::{Object, Texture};
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

named! {
    /// Where (u, v) come from on a converted polygon.
    #[derive(Default)]
    pub enum Mapping {
        /// From the point that the pixel shows.
        #[default]
        Perspective = "perspective",
        /// From the corners, linearly on the screen: a mistake worth looking at.
        Linear = "linear",
    }
}

/// How the polygons of a scene are textured.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Texturing {
    /// What polygons take that have no texture of their own.
    pub plain: Option<Texture>,
    pub mapping: Mapping,
}

/// The texture of a polygon. The polygon interpolates the (u, v) of its corners.
pub struct PolygonTexture<'a> {
    texture: Texture,
    chart: FaceChart<'a>,
    mapping: Mapping,
}

impl<'a> PolygonTexture<'a> {
    /// None where the polygon, which is one of `objects`, has no texture.
    pub fn of(objects: &'a [Object], polygon: &Polygon<'a>, texturing: Texturing) -> Option<Self> {
        let texture = polygon.material.texture.or(texturing.plain)?;
        let shape = &objects[polygon.object].shape;
        Some(PolygonTexture {
            texture,
            chart: FaceChart::new(shape, polygon.mesh, polygon.face),
            mapping: texturing.mapping,
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

    /// I where the texture multiplies k_d, given I_d and the rest of the intensity without it: I − I_d + T·I_d.
    pub fn applied<E: From<Event>>(
        &self,
        [rest, diffuse]: [Rgb; 2],
        position: DVec3,
        linear: DVec2,
        recorder: &mut impl Recorder<E>,
    ) -> Rgb {
        let textured = rest + self.color_at(position, linear, recorder) * diffuse;
        recorder.step(|| Event::TextureApplied { diffuse, textured }.into());
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
