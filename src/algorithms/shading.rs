//! What the scan-line methods that light surfaces have in common: what they draw, their events, and how they meet polygons and
//! pixels. A method says what it is called and interpolates, and on which lines of its pseudocode.

use super::illumination::{self, Lighting};
use super::prepared_scene::{self, Polygon, PreparedScene};
use super::scan_line::{self, Corner, Named, Pixel};
use super::texture::{self, PolygonTexture, Texturing};
use super::vertex_normal;
use crate::color::Rgb;
use crate::record::{self, Listing, Recorder};
use crate::scene::{Part, has_highlights};
use glam::DVec3;
use std::fmt::Debug;
use std::iter::zip;

/// A scan-line method that lights surfaces.
pub trait Shading: Copy + PartialEq + Debug + Send + Sync + 'static {
    /// As on the command line and in lesson files.
    const NAME: &'static str;
    const LISTING: &'static Listing;
    /// What of its work a scene may not need.
    const PARTS: &'static [Part] = &[Part::TextureCoordinates, Part::Highlights];
    /// What is interpolated from the corners to the pixels and recorded.
    type Recorded: Named;
}

/// What such a method draws.
#[derive(Clone, Copy, Debug)]
pub struct ShadedScene<'a> {
    pub prepared: &'a PreparedScene,
    /// Without shadows.
    pub lighting: Lighting<'a>,
    pub texturing: Texturing,
}

impl<'a> ShadedScene<'a> {
    /// With what the scene needs, and no more.
    pub fn of(prepared: &'a PreparedScene) -> Self {
        let scene = &prepared.scene;
        ShadedScene {
            prepared,
            lighting: Lighting::of(scene, has_highlights(scene)),
            texturing: Texturing::default(),
        }
    }

    /// The texture of a polygon, where it takes one.
    pub fn texture(&self, polygon: &Polygon<'a>) -> Option<PolygonTexture<'a>> {
        PolygonTexture::of(&self.prepared.scene.objects, polygon, self.texturing)
    }
}

/// An event of such a method: one that all of them have, or one of its own.
pub trait ShadingEvent: record::Event {
    type Shading: Shading;

    fn shading(&self) -> Option<&Event<Self::Shading>>;
}

/// The corners of a polygon, with a value for each.
pub fn corners<'a, V>(
    polygon: &Polygon<'a>,
    values: impl IntoIterator<Item = V>,
) -> impl Iterator<Item = Corner<V>> {
    zip(polygon.corners(), values).map(|((_, place), value)| Corner {
        position: place.camera,
        value,
    })
}

/// P, the point of its polygon that a pixel shows.
pub fn pixel_point<M: Shading, R: Recorder<Event<M>>>(
    prepared: &PreparedScene,
    pixel: &Pixel,
    recorder: &mut R,
) -> DVec3 {
    let position = pixel.position(&prepared.view);
    recorder.step(|| Event::PixelPoint { position });
    position
}

/// The events of the scan-line methods.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Event<M: Shading> {
    PreparedScene(prepared_scene::Event),
    /// The mean of the polygon's vertices, in the world.
    Middle {
        position: DVec3,
    },
    /// Opens a vertex of the object's mesh, at `position` in the world.
    Vertex {
        vertex: u32,
        position: DVec3,
    },
    Normal(vertex_normal::Event),
    Illumination(illumination::Event),
    /// Closes `Vertex`: its intensity is known.
    VertexLit {
        vertex: u32,
        intensity: Rgb,
    },
    /// Closes `Vertex`: its normal is known.
    VertexReady {
        vertex: u32,
    },
    ScanLine(scan_line::Event<M::Recorded>),
    /// The point of the polygon that a pixel shows, in the world.
    PixelPoint {
        position: DVec3,
    },
    Texture(texture::Event),
    /// The interpolated normal at a pixel, of length `length`, brought to unit length.
    PixelNormal {
        length: f64,
        normal: DVec3,
    },
    /// The interpolated normal at a pixel vanishes: the normal of the face takes its place.
    PixelNormalLost {
        length: f64,
        normal: DVec3,
    },
    /// The point of the true surface that the ray through a pixel meets.
    TruePoint {
        position: DVec3,
        normal: DVec3,
    },
}

impl<M: Shading> ShadingEvent for Event<M> {
    type Shading = M;

    fn shading(&self) -> Option<&Self> {
        Some(self)
    }
}

contains_events! {
    [M: Shading] Event<M> {
        prepared_scene::Event => Event::PreparedScene,
        vertex_normal::Event => Event::Normal,
        illumination::Event => Event::Illumination,
        scan_line::Event<M::Recorded> => Event::ScanLine,
        texture::Event => Event::Texture,
    }
}
