//! What the scan-line methods that light surfaces have in common: each lights points of its polygons (their middles, vertices or
//! pixels), carries something from the corners to the pixels, and tells of it in the same words. A method says what it carries
//! and where its listing has the lines.

use super::illumination;
use super::prepared_scene::{self, Polygon, PreparedScene};
use super::scan_line::{self, Carried, Fragment};
use super::texture;
use super::vertex_normal;
use crate::color::Rgb;
use crate::record::{Listing, Recorder};
use glam::DVec3;
use std::fmt::Debug;

/// A scan-line method that lights surfaces.
pub trait Shading: Copy + PartialEq + Debug + Send + Sync + 'static {
    /// What is told of what goes from the corners to the pixels.
    type Recorded: Carried;
    const LISTING: &'static Listing;
}

/// What is found once for each vertex of an object, for all the polygons that share it.
pub struct OnceAVertex<V> {
    object: Option<usize>,
    found: Vec<Option<V>>,
}

impl<V> Default for OnceAVertex<V> {
    fn default() -> Self {
        OnceAVertex {
            object: None,
            found: Vec::new(),
        }
    }
}

impl<V: Copy> OnceAVertex<V> {
    /// What was found at a vertex of the polygon's object, or what `find` finds now. Objects come one after another.
    pub fn at(&mut self, polygon: &Polygon, vertex: u32, find: impl FnOnce() -> V) -> V {
        if self.object != Some(polygon.object) {
            self.object = Some(polygon.object);
            self.found.clear();
            self.found.resize(polygon.mesh.vertex_count(), None);
        }
        *self.found[vertex as usize].get_or_insert_with(find)
    }
}

/// P, the point of its polygon that a pixel shows.
pub fn pixel_point<M: Shading, A, R: Recorder<Event<M>>>(
    prepared: &PreparedScene,
    fragment: &Fragment<A>,
    recorder: &mut R,
) -> DVec3 {
    let position = fragment.position(&prepared.view);
    recorder.step(|| Event::PixelPoint { position });
    position
}

/// What a method of the family tells.
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
    /// The interpolated normal at a pixel vanishes: the normal of the face stands for it.
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

impl<M: Shading> From<prepared_scene::Event> for Event<M> {
    fn from(event: prepared_scene::Event) -> Self {
        Event::PreparedScene(event)
    }
}

impl<M: Shading> From<vertex_normal::Event> for Event<M> {
    fn from(event: vertex_normal::Event) -> Self {
        Event::Normal(event)
    }
}

impl<M: Shading> From<illumination::Event> for Event<M> {
    fn from(event: illumination::Event) -> Self {
        Event::Illumination(event)
    }
}

impl<M: Shading> From<scan_line::Event<M::Recorded>> for Event<M> {
    fn from(event: scan_line::Event<M::Recorded>) -> Self {
        Event::ScanLine(event)
    }
}

impl<M: Shading> From<texture::Event> for Event<M> {
    fn from(event: texture::Event) -> Self {
        Event::Texture(event)
    }
}
