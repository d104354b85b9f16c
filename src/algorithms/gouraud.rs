//! Gouraud shading: intensity at the vertices, interpolated along edges, then along scan lines
//! (Gouraud, "Continuous shading of curved surfaces", IEEE Transactions on Computers 1971, §III).
//!
//! N_v = Σ N_k / |Σ N_k| over the faces that share vertex v; I_v = illumination(N_v);
//! I_4 = (y_4−y_2)/(y_1−y_2)·I_1 + (y_1−y_4)/(y_1−y_2)·I_2 on an edge, and
//! I_P = (x_5−x_P)/(x_5−x_4)·I_4 + (x_P−x_4)/(x_5−x_4)·I_5 on a span. The slide counts y upward, the rows here count down;
//! the formulas are the same. The incremental value, I' = I + ΔI, is the one drawn; the direct one is recorded beside it.

use super::focus::Focus;
use super::frame::Frame;
use super::illumination::{Lighting, SurfacePoint, illuminate};
use super::intensity::Intensity;
use super::prepared_scene::{self, Polygon};
use super::scan_line::{self, EdgeTable, Pixel, Varying};
use super::shading::{self, ShadedScene, Shading, corners, pixel_point};
use super::vertex_cache::VertexCache;
use super::vertex_normal::vertex_normal;
use crate::color::Rgb;
use crate::numeric::interpolate;
use crate::record::{Listing, Recorder};
use glam::DVec3;
use std::iter::zip;

pub static PSEUDOCODE: Listing = Listing {
    name: "Gouraud",
    lines: &[
        ("polygon", "{for-each-polygon}"),
        ("vertex", "  {for-each-vertex-v-not-yet-lit}"),
        ("vertex-normal", "    N_v ← ΣN_k / |ΣN_k|"),
        ("vertex-lit", "    I_v ← illumination(v, N_v)"),
        ("edge-table", "  {build-the-edge-table}"),
        ("scan-line", "  {for-each-scan-line-y}"),
        ("edge", "    {for-each-active-edge}"),
        ("cut", "      I_4 ← {interpolate} I_1, I_2"),
        ("span", "    {for-each-span-from-x-4-to-x-5}"),
        ("pixel", "      {for-each-pixel-x-p}"),
        ("depth", "        {if-nearer-than-the-depth-buffer}"),
        ("interpolation", "          I_P ← {interpolate} I_4, I_5"),
        ("color", "          pixel ← I_P"),
    ],
};

/// Draws what `focus` selects of the scene into `frame`, a band of its picture.
pub fn gouraud<R: Recorder<Event>>(
    scene: &ShadedScene,
    focus: Focus,
    frame: &mut Frame,
    recorder: &mut R,
) {
    let (prepared, lighting) = (scene.prepared, &scene.lighting);
    let (region, eye) = (focus.region(frame), prepared.view.eye);
    let mut cache = VertexCache::default();
    let mut intensities = Vec::new();
    let mut plain = EdgeTable::new(&prepared.view, &region);
    let mut textured = EdgeTable::new(&prepared.view, &region);

    recorder.enter(|| prepared.entered().into());
    for polygon in prepared.polygons(focus, &region) {
        recorder.enter(|| polygon.entered().into());

        // The intensity at each vertex, once for all the polygons that share it
        intensities.clear();
        for corner in 0..polygon.corner_count() {
            let intensity = cache
                .at(&polygon, corner)
                .get_or_insert_with(|| light_vertex(corner, &polygon, eye, lighting, recorder));
            intensities.push(*intensity);
        }

        // Interpolation to the pixels; a texture multiplies the diffuse part, which is then interpolated as well
        match scene.texture(&polygon) {
            None => {
                let intensities = intensities.iter().map(|intensity| intensity.whole);
                plain.build(corners(&polygon, intensities), recorder);
                fill(&mut plain, frame, recorder, |_, _, i_p| i_p);
            }
            Some(texture) => {
                let with_uv = zip(
                    intensities.iter().copied(),
                    texture.corners().iter().copied(),
                );
                textured.build(corners(&polygon, with_uv), recorder);
                fill(
                    &mut textured,
                    frame,
                    recorder,
                    |recorder, pixel, (i_p, uv)| {
                        let position = pixel_point(prepared, &pixel, recorder);
                        texture.applied(i_p.parts(), position, uv, recorder)
                    },
                );
            }
        }
        recorder.leave(|| prepared_scene::Event::PolygonDone.into());
    }
    recorder.leave(|| prepared_scene::Event::FrameDone.into());
}

/// I_v: the illumination model at a vertex, with the mean normal of the faces around it.
fn light_vertex<R: Recorder<Event>>(
    corner: usize,
    polygon: &Polygon,
    eye: DVec3,
    lighting: &Lighting,
    recorder: &mut R,
) -> Intensity {
    let vertex = polygon.mesh.face(polygon.face)[corner];
    let position = polygon.mesh.position(vertex);
    recorder.enter(|| Event::Vertex { vertex, position });
    let normal = vertex_normal(polygon.corner(corner), polygon.vertex_normals, recorder);
    let point = SurfacePoint::seen_from(eye, position, normal, polygon.material);
    let intensity = illuminate(&point, lighting, recorder, |_, _| true);
    recorder.leave(|| Event::VertexLit {
        vertex,
        intensity: intensity.whole,
    });
    intensity
}

/// Interpolates the intensities of a polygon along its edges and spans. `color` is the colour of a pixel of intensity I_P.
fn fill<I: Varying<Recorded = Rgb>, R: Recorder<Event>>(
    edge_table: &mut EdgeTable<I>,
    frame: &mut Frame,
    recorder: &mut R,
    color: impl Fn(&mut R, Pixel, I) -> Rgb,
) {
    while let Some(line) = edge_table.next_scan_line() {
        recorder.enter(|| line.entered().into());

        // I_4 where the scan line cuts each active edge, between I_1 at its upper and I_2 at its lower end
        for edge in edge_table.active_edges() {
            recorder.enter(|| edge.entered().into());
            recorder.step(|| edge.ends().into());
            if let Some(textured) = edge.textured() {
                recorder.step(|| textured.into());
            }
            recorder.leave(|| {
                let (i_1, y_1) = (edge.upper.value, edge.upper.y);
                let (i_2, y_2) = (edge.lower.value, edge.lower.y);
                let direct = interpolate(i_1, y_1, i_2, y_2, line.y_4);
                scan_line::Event::on_edge(direct, edge.value.value).into()
            });
        }

        // I_P at each pixel of each span, between I_4 at its left and I_5 at its right end
        for span in edge_table.spans(line) {
            recorder.enter(|| span.entered().into());
            recorder.step(|| span.ends().into());
            if let Some(textured) = span.textured() {
                recorder.step(|| textured.into());
            }
            let (i_4, x_4) = (span.left, span.x_4);
            let (i_5, x_5) = (span.right, span.x_5);
            let mut i_p = span.ramp(i_4, i_5);
            for pixel in span.pixels() {
                if pixel.passes_depth_test(frame, recorder) {
                    recorder.step(|| {
                        let direct = interpolate(i_4, x_4, i_5, x_5, pixel.x_p());
                        scan_line::Event::on_span(direct, i_p.value).into()
                    });
                    let color = color(recorder, pixel, i_p.value);
                    pixel.draw(color, frame, recorder);
                }
                i_p.advance();
            }
            recorder.leave(|| scan_line::Event::SpanDone.into());
        }
        recorder.leave(|| scan_line::Event::ScanLineDone.into());
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Gouraud {}

impl Shading for Gouraud {
    const NAME: &'static str = "gouraud";
    const LISTING: &'static Listing = &PSEUDOCODE;
    /// An intensity is interpolated.
    type Recorded = Rgb;
}

pub type Event = shading::Event<Gouraud>;

const _: () = assert!(size_of::<Event>() <= 64);
