//! Phong shading: the normal at the vertices, interpolated along edges, then along scan lines, and the illumination model at every
//! pixel (Phong, "Illumination for computer generated pictures", Communications of the ACM 18.6, 1975).
//!
//! N_4 and N_P are interpolated exactly as Gouraud's intensities are, directly and by increments; the incremental value is the one
//! used, brought to unit length at the pixel. Where it vanishes (opposite vertex normals, half-way between) the normal of the face
//! takes its place. P is the point of the polygon that the pixel shows: L and V start there.

use super::focus::Focus;
use super::frame::Frame;
use super::illumination::{SurfacePoint, illuminate};
use super::prepared_scene::{self, Polygon, PreparedScene};
use super::scan_line::{self, EdgeTable, Pixel, Varying};
use super::shading::{self, ShadedScene, Shading, corners, pixel_point};
use super::vertex_cache::VertexCache;
use super::vertex_normal::{self, VANISHED, vertex_normal};
use crate::color::Rgb;
use crate::numeric::interpolate;
use crate::record::{Listing, Recorder};
use glam::DVec3;
use std::iter::zip;

pub static PSEUDOCODE: Listing = Listing {
    name: "Phong",
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
        ("normal", "          N ← N_P / |N_P|"),
        ("", "          I ← illumination(P, N)"),
        ("color", "          pixel ← I"),
    ],
};

/// Draws what `focus` selects of the scene into `frame`, a band of its picture.
pub fn phong<R: Recorder<Event>>(
    scene: &ShadedScene,
    focus: Focus,
    frame: &mut Frame,
    recorder: &mut R,
) {
    light_pixels::<Phong, R>(scene, focus, frame, recorder);
}

/// A method that interpolates the vertex normals and lights every pixel.
pub(super) trait PixelLighting: Shading<Recorded = DVec3> {
    /// The point to be lit and its unit normal, where a pixel shows `position` of the polygon and the normal interpolated
    /// there is `n_p`.
    fn surface<R: Recorder<shading::Event<Self>>>(
        prepared: &PreparedScene,
        polygon: &Polygon,
        position: DVec3,
        n_p: DVec3,
        recorder: &mut R,
    ) -> (DVec3, DVec3);
}

pub(super) fn light_pixels<M: PixelLighting, R: Recorder<shading::Event<M>>>(
    scene: &ShadedScene,
    focus: Focus,
    frame: &mut Frame,
    recorder: &mut R,
) {
    let (prepared, lighting) = (scene.prepared, &scene.lighting);
    let region = focus.region(frame);
    let mut cache = VertexCache::default();
    let mut normals = Vec::new();
    let mut plain = EdgeTable::new(&prepared.view, &region);
    let mut textured = EdgeTable::new(&prepared.view, &region);

    recorder.enter(|| prepared.entered().into());
    for polygon in prepared.polygons(focus, &region) {
        recorder.enter(|| polygon.entered().into());

        // The normal at each vertex, once for all the polygons that share it
        normals.clear();
        for corner in 0..polygon.corner_count() {
            let normal = cache
                .at(&polygon, corner)
                .get_or_insert_with(|| find_normal::<M, _>(corner, &polygon, recorder));
            normals.push(*normal);
        }

        // Interpolation to the pixels, and the illumination model at each pixel
        let point = |n_p: DVec3, pixel: Pixel, recorder: &mut R| {
            let position = pixel_point(prepared, &pixel, recorder);
            let (position, normal) = M::surface(prepared, &polygon, position, n_p, recorder);
            SurfacePoint::seen_from(prepared.view.eye, position, normal, polygon.material)
        };
        match scene.texture(&polygon) {
            None => {
                plain.build(corners(&polygon, normals.iter().copied()), recorder);
                fill(&mut plain, frame, recorder, |recorder, pixel, n_p| {
                    let point = point(n_p, pixel, recorder);
                    illuminate(&point, lighting, recorder, |_, _| true).whole
                });
            }
            Some(texture) => {
                let uvs = texture.corners().iter().copied();
                let with_uv = zip(normals.iter().copied(), uvs);
                textured.build(corners(&polygon, with_uv), recorder);
                fill(
                    &mut textured,
                    frame,
                    recorder,
                    |recorder, pixel, (n_p, uv)| {
                        let mut point = point(n_p, pixel, recorder);
                        let color = texture.color_at(point.position, uv, recorder);
                        point.diffuse = color * point.diffuse;
                        illuminate(&point, lighting, recorder, |_, _| true).whole
                    },
                );
            }
        }
        recorder.leave(|| prepared_scene::Event::PolygonDone.into());
    }
    recorder.leave(|| prepared_scene::Event::FrameDone.into());
}

/// N_v: the mean normal of the faces around a vertex.
pub(super) fn find_normal<M: Shading, E>(
    corner: usize,
    polygon: &Polygon,
    recorder: &mut impl Recorder<E>,
) -> DVec3
where
    E: From<shading::Event<M>> + From<vertex_normal::Event>,
{
    let vertex = polygon.mesh.face(polygon.face)[corner];
    let position = polygon.mesh.position(vertex);
    recorder.enter(|| shading::Event::Vertex { vertex, position }.into());
    let normal = vertex_normal(polygon.corner(corner), polygon.vertex_normals, recorder);
    recorder.leave(|| shading::Event::VertexReady { vertex }.into());
    normal
}

/// Interpolates the normals of a polygon along its edges and spans. `color` is the colour of a pixel.
fn fill<M: PixelLighting, V: Varying<Recorded = DVec3>, R: Recorder<shading::Event<M>>>(
    edge_table: &mut EdgeTable<V>,
    frame: &mut Frame,
    recorder: &mut R,
    color: impl Fn(&mut R, Pixel, V) -> Rgb,
) {
    while let Some(line) = edge_table.next_scan_line() {
        recorder.enter(|| line.entered().into());

        // N_4 where the scan line cuts each active edge, between N_1 at its upper and N_2 at its lower end
        for edge in edge_table.active_edges() {
            recorder.enter(|| edge.entered().into());
            recorder.step(|| edge.ends().into());
            if let Some(textured) = edge.textured() {
                recorder.step(|| textured.into());
            }
            recorder.leave(|| {
                let (n_1, y_1) = (edge.upper.value, edge.upper.y);
                let (n_2, y_2) = (edge.lower.value, edge.lower.y);
                let direct = interpolate(n_1, y_1, n_2, y_2, line.y_4);
                scan_line::Event::on_edge(direct, edge.value.value).into()
            });
        }

        // N_P at each pixel of each span, between N_4 at its left and N_5 at its right end
        for span in edge_table.spans(line) {
            recorder.enter(|| span.entered().into());
            recorder.step(|| span.ends().into());
            if let Some(textured) = span.textured() {
                recorder.step(|| textured.into());
            }
            let (n_4, x_4) = (span.left, span.x_4);
            let (n_5, x_5) = (span.right, span.x_5);
            let mut n_p = span.ramp(n_4, n_5);
            for pixel in span.pixels() {
                if pixel.passes_depth_test(frame, recorder) {
                    recorder.step(|| {
                        let direct = interpolate(n_4, x_4, n_5, x_5, pixel.x_p());
                        scan_line::Event::on_span(direct, n_p.value).into()
                    });
                    let color = color(recorder, pixel, n_p.value);
                    pixel.draw(color, frame, recorder);
                }
                n_p.advance();
            }
            recorder.leave(|| scan_line::Event::SpanDone.into());
        }
        recorder.leave(|| scan_line::Event::ScanLineDone.into());
    }
}

/// An interpolated normal brought to unit length; where it vanishes, the normal of the face.
pub(super) fn unit_normal<M: Shading, R: Recorder<shading::Event<M>>>(
    interpolated: DVec3,
    polygon: &Polygon,
    recorder: &mut R,
) -> DVec3 {
    let length = interpolated.length();
    if length > VANISHED {
        let normal = interpolated / length;
        recorder.step(|| shading::Event::PixelNormal { length, normal });
        normal
    } else {
        let normal = polygon.mesh.normal(polygon.face);
        recorder.step(|| shading::Event::PixelNormalLost { length, normal });
        normal
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Phong {}

impl Shading for Phong {
    const NAME: &'static str = "phong";
    const LISTING: &'static Listing = &PSEUDOCODE;
    /// A normal is interpolated.
    type Recorded = DVec3;
}

impl PixelLighting for Phong {
    fn surface<R: Recorder<Event>>(
        _: &PreparedScene,
        polygon: &Polygon,
        position: DVec3,
        n_p: DVec3,
        recorder: &mut R,
    ) -> (DVec3, DVec3) {
        (position, unit_normal(n_p, polygon, recorder))
    }
}

pub type Event = shading::Event<Phong>;

const _: () = assert!(size_of::<Event>() <= 64);
