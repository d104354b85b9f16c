//! The exact picture that flat, Gouraud and Phong shading are compared with: the same scan conversion, but each pixel is lit at the
//! point of the true surface that the ray through its centre meets, with the surface's own normal there.
//!
//! Spheres, cylinders and Bézier patches have a true surface behind their polygons. Polygons and meshes are what they are divided
//! into: a polygon's normal is that of its face, and a mesh, which has no true surface, keeps Phong's interpolated normal.

use super::focus::Focus;
use super::frame::Frame;
use super::phong::{PixelLighting, light_pixels, unit_normal};
use super::prepared_scene::{Polygon, PreparedScene};
use super::shading::{self, ShadedScene, Shading};
use crate::record::{Listing, Recorder};
use crate::scene::primitives::true_point;
use glam::DVec3;

pub static PSEUDOCODE: Listing = Listing {
    name: "exact",
    lines: &[
        ("polygon", "{for-each-polygon}"),
        ("vertex", "  {for-each-vertex-v-without-a-normal}"),
        ("vertex-normal", "    N_v ← ΣN_k / |ΣN_k|"),
        ("edge-table", "  {build-the-edge-table}"),
        ("scan-line", "  {for-each-scan-line-y}"),
        ("edge", "    {for-each-active-edge}"),
        ("cut", "      N_4 ← {interpolate} N_1, N_2"),
        ("span", "    {for-each-span-from-x-4-to-x-5}"),
        ("pixel", "      {for-each-pixel-x-p}"),
        ("depth", "        {if-nearer-than-the-depth-buffer}"),
        ("interpolation", "          N_P ← {interpolate} N_4, N_5"),
        (
            "point",
            "          P ← {the-point-of-the-polygon-that-the-pixel-shows}",
        ),
        (
            "normal",
            "          P, N ← {the-true-surface-behind-p};  {without-one} N ← N_P / |N_P|",
        ),
        ("", "          I ← illumination(P, N)"),
        ("color", "          pixel ← I"),
    ],
};

/// Draws what `focus` selects of the scene into `frame`, a band of its picture.
pub fn exact<R: Recorder<Event>>(
    scene: &ShadedScene,
    focus: Focus,
    frame: &mut Frame,
    recorder: &mut R,
) {
    light_pixels::<Exact, R>(scene, focus, frame, recorder);
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Exact {}

impl Shading for Exact {
    const NAME: &'static str = "exact";
    const LISTING: &'static Listing = &PSEUDOCODE;
    type Recorded = DVec3;
}

impl PixelLighting for Exact {
    fn surface<R: Recorder<Event>>(
        prepared: &PreparedScene,
        polygon: &Polygon,
        position: DVec3,
        n_p: DVec3,
        recorder: &mut R,
    ) -> (DVec3, DVec3) {
        let shape = &prepared.scene.objects[polygon.object].shape;
        let (mesh, face, eye) = (polygon.mesh, polygon.face, prepared.view.eye);
        match true_point(shape, mesh, face, eye, position) {
            Some(point) => {
                let (position, normal) = (point.position, point.normal);
                recorder.step(|| Event::TruePoint { position, normal });
                (position, normal)
            }
            None => (position, unit_normal(n_p, polygon, recorder)),
        }
    }
}

pub type Event = shading::Event<Exact>;

const _: () = assert!(size_of::<Event>() <= 64);
