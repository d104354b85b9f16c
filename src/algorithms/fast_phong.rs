//! Fast Phong shading: the cosines of Phong's model as a Taylor series of second order over a triangle
//! (Bishop & Weimer, "Fast Phong Shading", SIGGRAPH 1986).
//!
//! Phong interpolates N and makes it a unit vector at every pixel: N·L/|N|, a division and a square root. With N(x, y) linear
//! on the screen over a triangle, that cosine is a function of x and y, expanded here about the triangle's middle:
//! T_5·x² + T_4·xy + T_3·y² + T_2·x + T_1·y + T_0. Along a span, forward differences evaluate it with two additions a pixel; the
//! highlight's cosine takes two more, and its power comes from a table.
//!
//! As in the paper, L, V and the attenuation are those of the point of expansion, for the whole triangle, however near the light or
//! the eye is. N is turned toward the eye once a triangle, at that point: were it turned vertex by vertex, N would pass through
//! zero inside a triangle on the outline, and the series with it. A polygon is divided into triangles first. A texture multiplies the
//! diffuse part, as elsewhere.

mod event;
mod expansion;

use super::flat::Nothing;
use super::focus::Focus;
use super::frame::Frame;
use super::prepared_scene::{self, PreparedScene};
use super::scan_line::{Corner, ScanLine, clip_near};
use super::shading::{self, OnceAVertex};
use super::texture::{AtPixel, OnPolygon, WithUv};
use super::vertex_normal::vertex_normal;
use crate::numeric::PowerTable;
use crate::record::{Listing, Recorder};
use expansion::Expansion;

pub use event::{Cosine, Event, FastPhong};

#[cfg(test)]
mod tests;

pub static PSEUDOCODE: Listing = Listing {
    name: "Fast Phong",
    lines: &[
        ("polygon", "for each polygon"),
        ("vertex", "  for each vertex v not yet met"),
        ("vertex-normal", "    N_v ← ΣN_k / |ΣN_k|"),
        ("triangle", "  for each triangle of it, about its middle"),
        ("normal-series", "    N(x, y) ← N_0 + N_x·x + N_y·y"),
        (
            "expansion",
            "    V ← toward the eye;  turn N toward V;  I ← k_a · A",
        ),
        ("light", "    for each light"),
        (
            "to-light",
            "      L ← toward the light;  f_att ← 1/(a0 + a1·d + a2·d²)",
        ),
        ("highlight", "      H ← (L+V)/|L+V|   or   R ← 2(N·L)N − L"),
        ("series", "      T_0 … T_5 ← Taylor series of each cosine c"),
        ("edge-table", "    build the edge table"),
        ("scan-line", "    for each scan line y"),
        ("edge", "      for each active edge"),
        ("cut", "        x_4 ← where y cuts the edge"),
        ("span", "      for each span from x_4 to x_5"),
        ("pixel", "        for each pixel x_P"),
        ("depth", "          if nearer than the depth buffer"),
        (
            "differences",
            "            at the span's first pixel: c, Δc, Δ²c ← T_0 … T_5",
        ),
        (
            "increments",
            "            then, pixel by pixel: c ← c + Δc;  Δc ← Δc + Δ²c",
        ),
        (
            "sum",
            "            I_P ← I + Σ f_att · I_light · (k_d · max(0, c_d) + k_s · table(c_s))",
        ),
        ("color", "            pixel ← I_P"),
    ],
};

/// Draws the part of the stage that `focus` takes into `frame`, a band of the picture of the stage's view.
pub fn fast_phong<R: Recorder<Event>>(
    prepared: &PreparedScene,
    focus: Focus,
    frame: &mut Frame,
    recorder: &mut R,
) {
    let region = focus.region(frame);
    let (mut plain, mut textured) = (ScanLine::default(), ScanLine::default());
    let mut expansion = Expansion::default();
    let (mut corners, mut pieces) = (Vec::new(), Vec::new());
    let mut normals = OnceAVertex::default();
    let mut powers = PowerTable::new(1.0);
    let mut object = None;

    recorder.enter(|| prepared.entered().into());
    for polygon in prepared.polygons(focus, &region) {
        recorder.enter(|| polygon.entered().into());
        if object != Some(polygon.object) {
            object = Some(polygon.object);
            powers = PowerTable::new(polygon.material.shininess);
        }

        // Normal at each vertex, once for all the polygons that share it
        let texture = OnPolygon::of(prepared, &polygon);
        let uvs = texture.as_ref().map_or(&[][..], OnPolygon::corners);
        corners.clear();
        for (number, (vertex, place)) in polygon.corners().enumerate() {
            let value = normals.at(&polygon, vertex, || {
                let position = polygon.mesh.position(vertex);
                recorder.enter(|| shading::Event::Vertex { vertex, position }.into());
                let normal = vertex_normal(polygon.mesh, vertex, recorder);
                recorder.leave(|| shading::Event::VertexReady { vertex }.into());
                normal
            });
            let uv = uvs.get(number).copied().unwrap_or_default();
            corners.push(Corner {
                position: place.camera,
                value: WithUv { value, uv },
            });
        }

        for triangle in polygon.triangles() {
            // What the near plane leaves of a triangle may have four corners: again triangles
            let corner = |i: usize| corners[triangle[i] as usize];
            clip_near(
                &[corner(0), corner(1), corner(2)],
                prepared.view.near,
                &mut pieces,
            );
            for last in 2..pieces.len() {
                let piece = [pieces[0], pieces[last - 1], pieces[last]];
                recorder.enter(|| Event::Triangle { corners: triangle });
                expansion.expand(&piece, &polygon, prepared, recorder);
                match &texture {
                    None => plain.fill(
                        &piece.map(|corner| corner.with(Nothing)),
                        &prepared.view,
                        &region,
                        frame,
                        recorder,
                        |recorder, fragment| expansion.shade(fragment, &powers, recorder).whole,
                    ),
                    Some(on) => textured.fill(
                        &piece.map(|corner| corner.with(corner.value.with(Nothing))),
                        &prepared.view,
                        &region,
                        frame,
                        recorder,
                        |recorder, fragment| {
                            let WithUv { value, uv: linear } = fragment.value;
                            let intensity =
                                expansion.shade(fragment.with(value), &powers, recorder);
                            let position = fragment.position(&prepared.view);
                            recorder.step(|| shading::Event::PixelPoint { position }.into());
                            AtPixel { on, linear }.applied(intensity, position, recorder)
                        },
                    ),
                }
                recorder.leave(|| Event::TriangleDone);
            }
        }
        recorder.leave(|| prepared_scene::Event::PolygonDone.into());
    }
    recorder.leave(|| prepared_scene::Event::FrameDone.into());
}
