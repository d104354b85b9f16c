//! The same spans, eight pixels at a time, in f32: how fast each scan-line method can be, beside the textbook body that is stepped.
//!
//! Coverage is decided as in [`scan_line`](crate::algorithms::scan_line), in f64 and by the same formulas, so that the same pixels are
//! drawn. What a span carries is one linear function of the screen over the triangle; each lane takes its value directly, by a
//! product and an addition, so that no value waits for the one before. Plain arrays of [`LANES`] numbers, which the compiler
//! turns into vector instructions. Scenes of triangles, diffuse surfaces and directional lights: what the methods are compared on.

mod frame;
mod shades;
mod triangle;

use super::Method;
use crate::algorithms::focus::{Focus, Region};
use crate::algorithms::prepared_scene::PreparedScene;
use crate::algorithms::scan_line::{Corner, clip_near};
use crate::color::Rgb;
use crate::scene::{Light, View};
use shades::{FastPhong, Flat, Gouraud, Phong, Surface};
use triangle::{Setup, Triangle};

pub use frame::LaneFrame;

#[cfg(test)]
mod tests;

/// Pixels that are drawn at once.
pub const LANES: usize = 8;

type Lanes = [f32; LANES];

/// What a method does in a span.
trait Shade {
    /// Takes a triangle in hand.
    fn triangle(&mut self, triangle: &Triangle, setup: &Setup);
    /// Takes a span in hand, whose first pixel has its centre at (x, y).
    fn span(&mut self, x: f64, y: f64);
    /// Finds the colours, by channel, of eight pixels that lie `offset` to the right of it.
    fn colors(&self, offset: &Lanes, color: &mut [Lanes; 3]);
}

/// A scene made ready: triangles on the screen, with their vertices lit or the normals there. Drawing it is the work of a frame alone.
pub struct LanePainter {
    background: Rgb,
    view: View,
    triangles: Vec<Triangle>,
    /// The numbers of the triangles of each band of rows.
    bins: Vec<Vec<u32>>,
    surfaces: Vec<Surface>,
    method: Shading,
}

enum Shading {
    Flat,
    Gouraud,
    Phong,
    FastPhong,
}

impl LanePainter {
    /// None where the method fills no spans, or the scene has more than triangles, diffuse surfaces and directional lights.
    pub fn new(prepared: &PreparedScene, method: Method) -> Option<Self> {
        if !is_simple(prepared) {
            return None;
        }
        let (method, values) = match method {
            Method::Flat => (Shading::Flat, shades::middles(prepared)),
            Method::Gouraud => (Shading::Gouraud, shades::lit_vertices(prepared)),
            Method::Phong => (Shading::Phong, shades::normals(prepared)),
            Method::FastPhong => (Shading::FastPhong, shades::normals(prepared)),
            _ => return None,
        };
        let View { width, height, .. } = prepared.view;
        let triangles = triangles(prepared, &values);
        Some(LanePainter {
            background: prepared.scene.background,
            view: prepared.view,
            bins: bins(&triangles, height, frame::band_rows(width)),
            triangles,
            surfaces: shades::surfaces(prepared),
            method,
        })
    }

    /// Draws the whole picture into `frame`, which has the size of the stage's view.
    pub fn draw(&self, frame: &mut LaneFrame) {
        match &self.method {
            Shading::Flat => draw(self, &mut Flat::default(), frame),
            Shading::Gouraud => draw(self, &mut Gouraud::default(), frame),
            Shading::Phong => draw(self, &mut Phong::new(&self.view, &self.surfaces), frame),
            Shading::FastPhong => {
                draw(self, &mut FastPhong::new(&self.view, &self.surfaces), frame);
            }
        }
    }
}

fn is_simple(prepared: &PreparedScene) -> bool {
    let is_far = |light: &Light| matches!(light, Light::Directional { .. });
    let (scene, mut meshes) = (&prepared.scene, prepared.tessellation.meshes.iter());
    let materials = &scene.materials;
    scene.lights.iter().all(is_far)
        && materials
            .iter()
            .all(|material| material.specular == Rgb::BLACK)
        && materials.iter().all(|material| material.texture.is_none())
        && meshes.all(|mesh| (0..mesh.face_count()).all(|face| mesh.face(face).len() == 3))
}

/// What lies before the eye, in its order, with `values` at the corners.
fn triangles(prepared: &PreparedScene, values: &shades::Values) -> Vec<Triangle> {
    let view = &prepared.view;
    let region = Region {
        columns: 0..view.width,
        rows: 0..view.height,
    };
    let (mut pieces, mut triangles) = (Vec::new(), Vec::new());
    for polygon in prepared.polygons(Focus::Frame, &region) {
        let corners = polygon.corners().map(|(vertex, place)| Corner {
            position: place.camera,
            value: values.at(&polygon, vertex),
        });
        let corners: Vec<_> = corners.collect();
        clip_near(&corners, view.near, &mut pieces);
        for last in 2..pieces.len() {
            let piece = [pieces[0], pieces[last - 1], pieces[last]];
            triangles.push(Triangle {
                corners: piece.map(|corner| view.to_screen(corner.position)),
                inverse_depths: piece.map(|corner| 1.0 / corner.position.z),
                values: piece.map(|corner| corner.value),
                object: polygon.object,
                face_normal: polygon.mesh.normal(polygon.face),
            });
        }
    }
    triangles
}

/// The triangles that reach into each band of `rows` rows, in their order.
fn bins(triangles: &[Triangle], height: u32, rows: u32) -> Vec<Vec<u32>> {
    let mut bins = vec![Vec::new(); height.div_ceil(rows) as usize];
    for (number, triangle) in triangles.iter().enumerate() {
        let reached = triangle.rows(height);
        if !reached.is_empty() {
            for bin in reached.start / rows..=(reached.end - 1) / rows {
                bins[bin as usize].push(number as u32);
            }
        }
    }
    bins
}

fn draw(painter: &LanePainter, shade: &mut impl Shade, frame: &mut LaneFrame) {
    for (band, bin) in painter.bins.iter().enumerate() {
        let rows = frame.band(band as u32);
        frame.clear(&rows, painter.background);
        for &number in bin {
            let triangle = &painter.triangles[number as usize];
            let setup = triangle.setup();
            shade.triangle(triangle, &setup);
            let inverse_depth = setup.plane(triangle.inverse_depths);
            triangle.spans(frame.width(), &rows, |y, columns| {
                frame.fill_span(y, columns, &inverse_depth, shade);
            });
        }
    }
}
