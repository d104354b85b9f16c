//! Fast Phong shading: the cosines of Phong's model as a Taylor series of second order over a triangle
//! (Bishop & Weimer, "Fast Phong Shading", SIGGRAPH 1986).
//!
//! Phong interpolates N and brings it to unit length at every pixel: N·L/|N|, a division and a square root. With N(x, y) linear
//! on the screen over a triangle, that cosine is a function of x and y, expanded here about the triangle's middle:
//! T_5·x² + T_4·xy + T_3·y² + T_2·x + T_1·y + T_0. Along a span, forward differences evaluate it with two additions a pixel; the
//! highlight's cosine takes two more, and its power comes from a table.
//!
//! As in the paper, L, V and the attenuation are those of the point of expansion, for the whole triangle, however near the light or
//! the eye is. N is turned toward the eye once per triangle, at that point: were it turned vertex by vertex, N would pass through
//! zero inside a triangle on the outline, and the series with it. A polygon is divided into triangles first. One that reaches behind the eye
//! is cut to what the picture shows, and its pieces are expanded about one point, the middle of that. A texture multiplies the diffuse
//! part, as elsewhere.

mod event;
mod expansion;
mod listing;

use super::focus::Focus;
use super::frame::Frame;
use super::phong::find_normal;
use super::prepared_scene;
use super::scan_line::{Corner, EdgeTable, clip_near, clip_to_picture};
use super::shading::{self, ShadedScene};
use super::texture::PolygonTexture;
use super::vertex_cache::VertexCache;
use crate::numeric::PowerTable;
use crate::record::Recorder;
use expansion::{Expansion, Middle};

pub use event::{Cosine, Event};
pub use listing::{FastPhong, PSEUDOCODE};

#[cfg(test)]
mod tests;

/// Draws what `focus` selects of the scene into `frame`, a band of its picture.
pub fn fast_phong<R: Recorder<Event>>(
    scene: &ShadedScene,
    focus: Focus,
    frame: &mut Frame,
    recorder: &mut R,
) {
    let prepared = scene.prepared;
    let (region, view) = (focus.region(frame), &prepared.view);
    let mut cache = VertexCache::default();
    let mut corners = Vec::new();
    let (mut cut, mut visible) = (Vec::new(), Vec::new());
    let (mut pieces, mut numbers) = (Vec::new(), Vec::new());
    let mut plain = EdgeTable::new(view, &region);
    let mut textured = EdgeTable::new(view, &region);
    let mut expansion = Expansion::default();
    let mut powers = PowerTable::new(1.0);
    let mut object = None;

    recorder.enter(|| prepared.entered().into());
    for polygon in prepared.polygons(focus, &region) {
        recorder.enter(|| polygon.entered().into());
        if object != Some(polygon.object) {
            object = Some(polygon.object);
            powers = PowerTable::new(polygon.material.shininess);
        }

        // The normal at each vertex, once for all the polygons that share it
        let texture = scene.texture(&polygon);
        let uvs = texture.as_ref().map_or(&[][..], PolygonTexture::corners);
        corners.clear();
        for (corner, (_, place)) in polygon.corners().enumerate() {
            let normal = cache
                .at(&polygon, corner)
                .get_or_insert_with(|| find_normal::<FastPhong, _>(corner, &polygon, recorder));
            let uv = uvs.get(corner).copied().unwrap_or_default();
            corners.push(Corner {
                position: place.camera,
                value: (*normal, uv),
            });
        }

        // What the near plane leaves of a triangle may have more corners: again triangles
        pieces.clear();
        numbers.clear();
        let is_cut = corners.iter().any(|corner| corner.position.z < view.near);
        for triangle in polygon.triangles() {
            let whole = triangle.map(|corner| corners[corner as usize]);
            visible.clear();
            visible.extend(whole);
            if is_cut {
                clip_near(&whole, view.near, &mut cut);
                clip_to_picture(&cut, view, &mut visible);
            }
            for last in 2..visible.len() {
                pieces.push([visible[0], visible[last - 1], visible[last]]);
                numbers.push(triangle);
            }
        }
        // Beside the eye, the middle of a piece would be far outside the picture, and another for each piece
        let common = is_cut.then(|| Middle::of_pieces(&pieces, view)).flatten();

        for ((piece, &corners), triangle) in pieces.iter().zip(&numbers).zip(0..) {
            recorder.enter(|| Event::Triangle { triangle, corners });
            let with_normals = piece.map(|corner| corner.map(|(normal, _)| normal));
            let middle = common.unwrap_or_else(|| Middle::of(piece, view));
            expansion.expand(&with_normals, middle, &polygon, prepared, recorder);
            match &texture {
                None => {
                    let corners = piece.map(|corner| corner.map(|_| ()));
                    plain.fill(corners, frame, recorder, |recorder, pixel, ()| {
                        let [rest, diffuse] = expansion.shade(pixel, &powers, recorder);
                        rest + diffuse
                    });
                }
                Some(texture) => {
                    let corners = piece.map(|corner| corner.map(|(_, uv)| uv));
                    textured.fill(corners, frame, recorder, |recorder, pixel, uv| {
                        let parts = expansion.shade(pixel, &powers, recorder);
                        let position = pixel.position(view);
                        recorder.step(|| shading::Event::PixelPoint { position }.into());
                        texture.applied(parts, position, uv, recorder)
                    });
                }
            }
            recorder.leave(|| Event::TriangleDone);
        }
        recorder.leave(|| prepared_scene::Event::PolygonDone.into());
    }
    recorder.leave(|| prepared_scene::Event::FrameDone.into());
}
