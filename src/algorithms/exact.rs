//! The exact picture that flat, Gouraud and Phong shading are compared with: the same scan conversion, but each pixel is lit at the
//! point of the true surface that the ray through its centre meets, with the surface's own normal there.
//!
//! Spheres, cylinders and Bézier patches have a true surface behind their polygons. Polygons and meshes are what they are divided
//! into: a polygon's normal is that of its face, and a mesh, of which nothing better is known, takes Phong's interpolated one.

use super::focus::Focus;
use super::frame::Frame;
use super::phong::{shade_pixels, unit_normal};
use super::prepared_scene::PreparedScene;
use super::shading::{self, Lines, Shading};
use crate::record::{Line, Listing, Recorder};
use crate::scene::primitives::true_point;
use glam::DVec3;

pub static PSEUDOCODE: Listing = Listing {
    name: "exact",
    lines: &[
        "for each polygon",
        "  for each vertex v without a normal",
        "    N_v ← ΣN_k / |ΣN_k|",
        "  build the edge table",
        "  for each scan line y",
        "    for each active edge",
        "      N_4 ← interpolate N_1, N_2",
        "    for each span from x_4 to x_5",
        "      for each pixel x_P",
        "        if nearer than the depth buffer",
        "          N_P ← interpolate N_4, N_5",
        "          P ← the point of the polygon that the pixel shows",
        "          P, N ← the true surface behind P;  without one N ← N_P / |N_P|",
        "          I ← illumination(P, N)",
        "          pixel ← I",
    ],
};

/// Draws the part of the stage that `focus` takes into `frame`, a band of the picture of the stage's view.
pub fn exact<R: Recorder<Event>>(
    prepared: &PreparedScene,
    focus: Focus,
    frame: &mut Frame,
    recorder: &mut R,
) {
    shade_pixels(
        prepared,
        focus,
        frame,
        recorder,
        |polygon, seen, recorder| {
            let shape = &prepared.scene.objects[polygon.object].shape;
            let (mesh, face, eye) = (polygon.mesh, polygon.face, prepared.view.eye);
            match true_point(shape, mesh, face, eye, seen.position) {
                Some(point) => {
                    let (position, normal) = (point.position, point.normal);
                    recorder.step(|| Event::TruePoint { position, normal });
                    (position, normal)
                }
                None => (seen.position, unit_normal(seen.normal, polygon, recorder)),
            }
        },
    );
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Exact {}

impl Shading for Exact {
    type Recorded = DVec3;
    const LINES: Lines = Lines {
        listing: &PSEUDOCODE,
        vertex_normal: 2,
        vertex_done: 2,
        edge_table: 3,
        pixel_point: Line {
            listing: &PSEUDOCODE,
            number: 11,
        },
        pixel_normal: 12,
    };
}

pub type Event = shading::Event<Exact>;

const _: () = assert!(size_of::<Event>() <= 64);
