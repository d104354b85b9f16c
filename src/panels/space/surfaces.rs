//! The surfaces of the scene: objects in their material's colours under a light at the viewer, or patches in their own light.

use super::ball::Ball;
use crate::algorithms::enclosure::Enclosure;
use crate::algorithms::prepared_scene::PreparedScene;
use crate::color::Rgb;
use crate::figure::{Solids, Space};
use crate::scene::primitives::FaceChart;
use crate::scene::{Material, Mesh, Object, Shape};
use glam::{DVec3, Vec3};

/// Faces that meet at less than this angle are one smooth surface, others meet in an edge: its cosine.
pub(super) const SMOOTH: f64 = 0.76;
/// How much of transparent objects covers what lies behind, a layer.
const VEIL: f32 = 0.22;
/// Of a surface that light only grazes.
const LEAST_LIGHT: f64 = 0.35;
/// Of what is mirrored, as if all around were of this grey.
const MIRROR: f64 = 0.5;
/// Of what transmits alone.
const CLEAR: Rgb = Rgb::splat(0.62);

/// The objects, opaque ones first. `reach` is how far planes are drawn from the pivot; `round` says that spheres are what they
/// are, not polygons in their place.
pub(super) fn objects(
    solids: &mut Solids,
    space: &Space,
    prepared: &PreparedScene,
    reach: f64,
    round: bool,
) {
    let scene = &prepared.scene;
    let is_clear = |object: &Object| scene.materials[object.material].transmission != Rgb::BLACK;
    for clear in [false, true] {
        for (object, mesh) in scene.objects.iter().zip(&prepared.tessellation.meshes) {
            if is_clear(object) != clear {
                continue;
            }
            let paint = Paint::of(&scene.materials[object.material], clear);
            match object.shape {
                Shape::Plane { point, normal } => {
                    let corners = plane(space, point, normal, reach);
                    if sees_into(space, corners[0], normal) {
                        continue;
                    }
                    let chart = FaceChart::new(&object.shape, mesh, 0);
                    paint.face(solids, space, &corners, &[normal; 4], Some(&chart));
                }
                Shape::Sphere { center, radius } if round => {
                    match Ball::seen(space, center, radius) {
                        Some(ball) => round_faces(solids, space, object, mesh, &paint, &ball),
                        None => faces(solids, space, object, mesh, &paint),
                    }
                }
                _ => faces(solids, space, object, mesh, &paint),
            }
        }
    }
}

fn faces(solids: &mut Solids, space: &Space, object: &Object, mesh: &Mesh, paint: &Paint) {
    let is_sheet = matches!(object.shape, Shape::Polygon { .. });
    for face in 0..mesh.face_count() {
        let corners: Vec<DVec3> = places(mesh, face);
        if is_sheet && sees_into(space, corners[0], mesh.normal(face)) {
            continue;
        }
        let normals: Vec<DVec3> = mesh
            .face(face)
            .iter()
            .map(|&vertex| smooth_normal(mesh, face, vertex))
            .collect();
        let chart = paint
            .material
            .texture
            .map(|_| FaceChart::new(&object.shape, mesh, face));
        paint.face(solids, space, &corners, &normals, chart.as_ref());
    }
}

fn round_faces(
    solids: &mut Solids,
    space: &Space,
    object: &Object,
    mesh: &Mesh,
    paint: &Paint,
    ball: &Ball,
) {
    let chart = FaceChart::new(&object.shape, mesh, 0);
    let chart = paint.material.texture.map(|_| &chart);
    // What an opaque ball hides of itself is never seen.
    let sides: &[bool] = if paint.clear {
        &[true, false]
    } else {
        &[false]
    };
    for &hidden in sides {
        for (corners, normals) in ball.faces(hidden) {
            paint.face(solids, space, &corners, &normals, chart);
        }
    }
}

pub(super) fn places(mesh: &Mesh, face: usize) -> Vec<DVec3> {
    let vertices = mesh.face(face).iter();
    vertices.map(|&vertex| mesh.position(vertex)).collect()
}

/// The fronts of the patches in the given colours. Whoever stands outside looks through the backs of near walls into the room.
pub(super) fn patches(solids: &mut Solids, space: &Space, room: &Enclosure, colors: &[Rgb]) {
    for (patch, color) in colors.iter().enumerate() {
        let color = color.to_srgb8();
        for piece in room.patches.pieces(patch) {
            if faces_viewer(space, piece.corners[0], piece.normal) {
                fan(solids, space, piece.corners, |solids, _, corners| {
                    solids.triangle(corners, |_| color);
                });
            }
        }
    }
}

pub(super) fn faces_viewer(space: &Space, point: DVec3, normal: DVec3) -> bool {
    normal.dot(to_viewer(space, point)) > 0.0
}

/// Toward the viewer from a point; not of unit length.
fn to_viewer(space: &Space, point: DVec3) -> DVec3 {
    match space.distance {
        Some(distance) => space.pivot + distance * space.toward - point,
        None => space.toward,
    }
}

/// What a lamp at the viewer gives a surface, on whichever side it is seen.
pub(super) fn light_from(space: &Space, point: DVec3, normal: DVec3) -> f64 {
    let to_viewer = to_viewer(space, point).normalize_or_zero();
    LEAST_LIGHT + (1.0 - LEAST_LIGHT) * normal.dot(to_viewer).abs()
}

/// Whether a sheet stands between the viewer and the scene with its back to the viewer: one looks through it, as into a room.
pub(super) fn sees_into(space: &Space, point: DVec3, normal: DVec3) -> bool {
    !faces_viewer(space, point, normal) && (space.pivot - point).dot(normal) > 0.0
}

/// Corners of a square of a plane about the foot of the pivot.
pub(super) fn plane(space: &Space, point: DVec3, normal: DVec3, reach: f64) -> [DVec3; 4] {
    let foot = space.pivot - (space.pivot - point).dot(normal) * normal;
    let lean = normal.abs();
    let axis = if lean.x <= lean.y && lean.x <= lean.z {
        DVec3::X
    } else if lean.z <= lean.y {
        DVec3::Z
    } else {
        DVec3::Y
    };
    let u = reach * axis.reject_from_normalized(normal).normalize();
    let v = normal.cross(u);
    [foot - u - v, foot + u - v, foot + u + v, foot - u + v]
}

/// The mean normal of the faces around a vertex that go on smoothly from `face`.
fn smooth_normal(mesh: &Mesh, face: usize, vertex: u32) -> DVec3 {
    let own = mesh.normal(face);
    let around = mesh.faces_around(vertex).iter();
    let smooth = around
        .map(|&other| mesh.normal(other as usize))
        .filter(|normal| normal.dot(own) > SMOOTH);
    smooth.sum::<DVec3>().try_normalize().unwrap_or(own)
}

/// What faces of an object are painted with.
struct Paint<'a> {
    material: &'a Material,
    color: Rgb,
    clear: bool,
}

impl<'a> Paint<'a> {
    fn of(material: &'a Material, clear: bool) -> Self {
        // A mirror is as bright as what it mirrors may be.
        let color = material.diffuse + material.emission + material.reflection * MIRROR;
        let color = match color.max_channel() {
            0.0 => CLEAR,
            brightest if brightest > 1.0 => color / brightest,
            _ => color,
        };
        Paint {
            material,
            color,
            clear,
        }
    }

    fn face(
        &self,
        solids: &mut Solids,
        space: &Space,
        corners: &[DVec3],
        normals: &[DVec3],
        chart: Option<&FaceChart>,
    ) {
        let lit = corners.iter().zip(normals);
        let light: Vec<f64> = lit
            .map(|(&corner, &normal)| light_from(space, corner, normal))
            .collect();
        let texture = self.material.texture.zip(chart);
        fan(solids, space, corners, |solids, places, seen| {
            let light =
                places.map(|(corner, _)| corner.map_or(LEAST_LIGHT, |corner| light[corner]));
            let mean = light.iter().sum::<f64>() / 3.0;
            if self.clear {
                return solids.veil(seen, (self.color * mean).to_srgb8(), VEIL);
            }
            match texture {
                Some((texture, chart)) => {
                    let places = places.map(|(_, place)| place);
                    solids.triangle(seen, |shares| {
                        let [a, b, c] = shares.as_dvec3().to_array();
                        let place = a * places[0] + b * places[1] + c * places[2];
                        let tint = texture.color_at(chart.uv(place));
                        tinted(self.color, tint, mean).to_srgb8()
                    });
                }
                None => {
                    let [a, b, c] = light.map(|light| encoded(self.color * light));
                    solids.triangle(seen, |shares| {
                        let color = shares.x * a + shares.y * b + shares.z * c;
                        color.to_array().map(|channel| channel.round() as u8)
                    });
                }
            }
        });
    }
}

fn tinted(color: Rgb, tint: Rgb, light: f64) -> Rgb {
    let [color, tint] = [color.channels(), tint.channels()];
    Rgb::from(std::array::from_fn(|channel| {
        light * color[channel] * tint[channel]
    }))
}

/// In 8-bit sRGB, as numbers between which one can go.
fn encoded(color: Rgb) -> Vec3 {
    Vec3::from(color.to_srgb8().map(f32::from))
}

/// The triangles of a convex polygon, as far as they lie before the viewer: with each corner's place in the world, and its
/// number where it is one of the polygon's.
fn fan(
    solids: &mut Solids,
    space: &Space,
    corners: &[DVec3],
    mut draw: impl FnMut(&mut Solids, [(Option<usize>, DVec3); 3], [crate::figure::Seen; 3]),
) {
    let seen = space.polygon(corners);
    let number = |place: DVec3| corners.iter().position(|&corner| corner == place);
    for i in 1..seen.len().saturating_sub(1) {
        let three = [seen[0], seen[i], seen[i + 1]];
        let places = three.map(|(place, _)| (number(place), place));
        draw(solids, places, three.map(|(_, seen)| seen));
    }
}
