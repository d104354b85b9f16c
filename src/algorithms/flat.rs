//! Flat shading: one intensity a polygon, at the mean of its vertices with its face normal (Bouknight 1970).
//!
//! Exact where the object really is a polyhedron, the light is far (N·L constant) and the viewer is far (V·R constant).

use super::fill::Fill;
use super::focus::Focus;
use super::frame::Frame;
use super::illumination::{SurfacePoint, illuminate};
use super::prepared_scene::{self, PreparedScene};
use super::scan_line::{Carried, Names};
use super::shading::{self, Shading, pixel_point};
use crate::numeric::Linear;
use crate::record::{Listing, Recorder, Value};
use glam::DVec3;
use std::ops::{Add, Mul, Sub};

pub static PSEUDOCODE: Listing = Listing {
    name: "flat",
    lines: &[
        ("polygon", "for each polygon"),
        ("middle", "  P ← mean of the vertices"),
        ("", "  I ← illumination(P, N)"),
        ("edge-table", "  build the edge table"),
        ("scan-line", "  for each scan line y"),
        ("edge", "    for each active edge"),
        ("cut", "      x_4 ← where y cuts the edge"),
        ("span", "    for each span from x_4 to x_5"),
        ("pixel", "      for each pixel x_P"),
        ("depth", "        if nearer than the depth buffer"),
        ("color", "          pixel ← I"),
    ],
};

/// Draws the part of the stage that `focus` takes into `frame`, a band of the picture of the stage's view.
pub fn flat<R: Recorder<Event>>(
    prepared: &PreparedScene,
    focus: Focus,
    frame: &mut Frame,
    recorder: &mut R,
) {
    let region = focus.region(frame);
    let lighting = prepared.lighting();
    let mut fill: Fill<Nothing, Nothing> = Fill::new(prepared, &region);

    recorder.enter(|| prepared.entered().into());
    for polygon in prepared.polygons(focus, &region) {
        recorder.enter(|| polygon.entered().into());
        let vertices = polygon.mesh.face(polygon.face);
        let position = vertices
            .iter()
            .map(|&vertex| polygon.mesh.position(vertex))
            .sum::<DVec3>()
            / vertices.len() as f64;
        recorder.step(|| Event::Middle { position });
        let normal = polygon.mesh.normal(polygon.face);
        let point = SurfacePoint {
            position,
            normal,
            to_eye: (prepared.view.eye - position).normalize_or_zero(),
            material: polygon.material,
            diffuse: polygon.material.diffuse,
        };
        let intensity = illuminate(&point, &lighting, recorder, |_, _| true);

        fill.polygon(
            &polygon,
            &vec![Nothing; vertices.len()],
            frame,
            recorder,
            |_, _| intensity.whole,
            |recorder, fragment, texture| {
                let position = pixel_point(prepared, &fragment, recorder);
                texture.applied(intensity, position, recorder)
            },
        );
        recorder.leave(|| prepared_scene::Event::PolygonDone.into());
    }
    recorder.leave(|| prepared_scene::Event::FrameDone.into());
}

/// Flat shading carries nothing from the corners to the pixels.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Nothing;

impl Carried for Nothing {
    const NAMES: Option<&'static Names> = None;
    fn value(self) -> Option<Value> {
        None
    }
}

impl Linear for Nothing {}

impl Add for Nothing {
    type Output = Nothing;
    fn add(self, _: Nothing) -> Nothing {
        Nothing
    }
}

impl Sub for Nothing {
    type Output = Nothing;
    fn sub(self, _: Nothing) -> Nothing {
        Nothing
    }
}

impl Mul<f64> for Nothing {
    type Output = Nothing;
    fn mul(self, _: f64) -> Nothing {
        Nothing
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Flat {}

impl Shading for Flat {
    type Recorded = Nothing;
    const LISTING: &'static Listing = &PSEUDOCODE;
}

pub type Event = shading::Event<Flat>;

const _: () = assert!(size_of::<Event>() <= 64);
