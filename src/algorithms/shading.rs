//! What the scan-line methods that light surfaces have in common: their events, and how they meet polygons and pixels. A method
//! says what it interpolates, and on which lines of its pseudocode.

use super::illumination;
use super::prepared_scene::{self, Polygon, PreparedScene};
use super::scan_line::{self, Corner, Named, Pixel};
use super::texture;
use super::vertex_normal;
use crate::color::Rgb;
use crate::record::{Listing, Recorder};
use glam::DVec3;
use std::fmt::Debug;
use std::iter::zip;

/// A scan-line method that lights surfaces.
pub trait Shading: Copy + PartialEq + Debug + Send + Sync + 'static {
    /// What is interpolated from the corners to the pixels and recorded.
    type Recorded: Named;
    const LISTING: &'static Listing;
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

contains_events! {
    [M: Shading] Event<M> {
        prepared_scene::Event => Event::PreparedScene,
        vertex_normal::Event => Event::Normal,
        illumination::Event => Event::Illumination,
        scan_line::Event<M::Recorded> => Event::ScanLine,
        texture::Event => Event::Texture,
    }
}
