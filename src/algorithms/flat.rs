//! Flat shading: one intensity per polygon, at the mean of its vertices with its face normal (Bouknight 1970).
//!
//! Exact where the object really is a polyhedron, the light is far (N·L constant) and the viewer is far (V·R constant).

use super::focus::Focus;
use super::frame::Frame;
use super::illumination::{SurfacePoint, illuminate};
use super::prepared_scene;
use super::scan_line::EdgeTable;
use super::shading::{self, ShadedScene, Shading, corners, pixel_point};
use crate::record::{Listing, Recorder};
use glam::DVec3;

pub static PSEUDOCODE: Listing = Listing {
    name: "flat",
    lines: &[
        ("polygon", "{for-each-polygon}"),
        ("middle", "  P ← {mean-of-the-vertices}"),
        ("", "  I ← illumination(P, N)"),
        ("edge-table", "  {build-the-edge-table}"),
        ("scan-line", "  {for-each-scan-line-y}"),
        ("edge", "    {for-each-active-edge}"),
        ("cut", "      x_4 ← {where-y-cuts-the-edge}"),
        ("span", "    {for-each-span-from-x-4-to-x-5}"),
        ("pixel", "      {for-each-pixel-x-p}"),
        ("depth", "        {if-nearer-than-the-depth-buffer}"),
        ("color", "          pixel ← I"),
    ],
};

/// Draws what `focus` selects of the scene into `frame`, a band of its picture.
pub fn flat<R: Recorder<Event>>(
    scene: &ShadedScene,
    focus: Focus,
    frame: &mut Frame,
    recorder: &mut R,
) {
    let (prepared, lighting) = (scene.prepared, &scene.lighting);
    let region = focus.region(frame);
    let mut plain = EdgeTable::new(&prepared.view, &region);
    let mut textured = EdgeTable::new(&prepared.view, &region);

    recorder.enter(|| prepared.entered().into());
    for polygon in prepared.polygons(focus, &region) {
        recorder.enter(|| polygon.entered().into());

        // One intensity for the whole polygon
        let vertices = polygon.mesh.face(polygon.face);
        let position = vertices
            .iter()
            .map(|&vertex| polygon.mesh.position(vertex))
            .sum::<DVec3>()
            / vertices.len() as f64;
        recorder.step(|| Event::Middle { position });
        let normal = polygon.mesh.normal(polygon.face);
        let point = SurfacePoint::seen_from(prepared.view.eye, position, normal, polygon.material);
        let intensity = illuminate(&point, lighting, recorder, |_, _| true);

        // Every pixel takes it; a texture multiplies its diffuse part
        match scene.texture(&polygon) {
            None => {
                let corners = corners(&polygon, vertices.iter().map(|_| ()));
                plain.fill(corners, frame, recorder, |_, _, ()| intensity.whole);
            }
            Some(texture) => {
                let corners = corners(&polygon, texture.corners().iter().copied());
                textured.fill(corners, frame, recorder, |recorder, pixel, uv| {
                    let position = pixel_point(prepared, &pixel, recorder);
                    texture.applied(intensity.parts(), position, uv, recorder)
                });
            }
        }
        recorder.leave(|| prepared_scene::Event::PolygonDone.into());
    }
    recorder.leave(|| prepared_scene::Event::FrameDone.into());
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Flat {}

impl Shading for Flat {
    const NAME: &'static str = "flat";
    const LISTING: &'static Listing = &PSEUDOCODE;
    /// Nothing is interpolated.
    type Recorded = ();
}

pub type Event = shading::Event<Flat>;

const _: () = assert!(size_of::<Event>() <= 64);
