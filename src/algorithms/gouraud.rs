//! Gouraud shading: intensity at the vertices, interpolated along edges, then along scan lines
//! (Gouraud, "Continuous shading of curved surfaces", IEEE Transactions on Computers 1971, §III).
//!
//! N_v = Σ N_k / |Σ N_k| over the faces that share vertex v; I_v = illumination(N_v);
//! I_4 = (y_4−y_2)/(y_1−y_2)·I_1 + (y_1−y_4)/(y_1−y_2)·I_2 on an edge, and
//! I_P = (x_5−x_P)/(x_5−x_4)·I_4 + (x_P−x_4)/(x_5−x_4)·I_5 on a span. The slide counts y upward, the rows here count down;
//! the formulas are the same. What is drawn is the incremental value, I' = I + ΔI; the direct one is told beside it.

use super::fill::Fill;
use super::focus::Focus;
use super::frame::Frame;
use super::illumination::{SurfacePoint, illuminate};
use super::intensity::Intensity;
use super::prepared_scene::{self, PreparedScene};
use super::scan_line::{Carried, Names};
use super::shading::{self, OnceAVertex, Shading, pixel_point};
use super::vertex_normal::vertex_normal;
use crate::color::Rgb;
use crate::record::{Listing, Recorder, Value};

pub static PSEUDOCODE: Listing = Listing {
    name: "Gouraud",
    lines: &[
        ("polygon", "for each polygon"),
        ("vertex", "  for each vertex v not yet lit"),
        ("vertex-normal", "    N_v ← ΣN_k / |ΣN_k|"),
        ("vertex-lit", "    I_v ← illumination(v, N_v)"),
        ("edge-table", "  build the edge table"),
        ("scan-line", "  for each scan line y"),
        ("edge", "    for each active edge"),
        ("cut", "      I_4 ← interpolate I_1, I_2"),
        ("span", "    for each span from x_4 to x_5"),
        ("pixel", "      for each pixel x_P"),
        ("depth", "        if nearer than the depth buffer"),
        ("interpolation", "          I_P ← interpolate I_4, I_5"),
        ("color", "          pixel ← I_P"),
    ],
};

/// Draws the part of the stage that `focus` takes into `frame`, a band of the picture of the stage's view.
pub fn gouraud<R: Recorder<Event>>(
    prepared: &PreparedScene,
    focus: Focus,
    frame: &mut Frame,
    recorder: &mut R,
) {
    let region = focus.region(frame);
    let lighting = prepared.lighting();
    let mut fill: Fill<Rgb, Intensity> = Fill::new(prepared, &region);
    let mut intensities = Vec::new();
    let mut lit = OnceAVertex::default();

    recorder.enter(|| prepared.entered().into());
    for polygon in prepared.polygons(focus, &region) {
        recorder.enter(|| polygon.entered().into());
        // Intensity at each vertex, once for all the polygons that share it
        intensities.clear();
        for (vertex, _) in polygon.corners() {
            let intensity = lit.at(&polygon, vertex, || {
                let position = polygon.mesh.position(vertex);
                recorder.enter(|| Event::Vertex { vertex, position });
                let normal = vertex_normal(polygon.mesh, vertex, recorder);
                let point = SurfacePoint {
                    position,
                    normal,
                    to_eye: (prepared.view.eye - position).normalize_or_zero(),
                    material: polygon.material,
                    diffuse: polygon.material.diffuse,
                };
                let intensity = illuminate(&point, &lighting, recorder, |_, _| true);
                recorder.leave(|| Event::VertexLit {
                    vertex,
                    intensity: intensity.whole,
                });
                intensity
            });
            intensities.push(intensity);
        }

        // Interpolation along edges and spans
        fill.polygon(
            &polygon,
            &intensities,
            frame,
            recorder,
            |_, fragment| fragment.value,
            |recorder, fragment, texture| {
                let position = pixel_point(prepared, &fragment, recorder);
                texture.applied(fragment.value, position, recorder)
            },
        );
        recorder.leave(|| prepared_scene::Event::PolygonDone.into());
    }
    recorder.leave(|| prepared_scene::Event::FrameDone.into());
}

/// Gouraud carries an intensity.
impl Carried for Rgb {
    const NAMES: Option<&'static Names> = Some(&Names {
        corner: "I",
        one: "I_1",
        two: "I_2",
        four: "I_4",
        four_incremental: "I_4_incremental",
        five: "I_5",
        pixel: "I_P",
        pixel_incremental: "I_P_incremental",
        step: "dI_dy",
    });

    fn value(self) -> Option<Value> {
        Some(self.into())
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Gouraud {}

impl Shading for Gouraud {
    type Recorded = Rgb;
    const LISTING: &'static Listing = &PSEUDOCODE;
}

pub type Event = shading::Event<Gouraud>;

const _: () = assert!(size_of::<Event>() <= 64);
