//! The edges of objects: where a surface ends, bends sharply, or turns away from the viewer.

use super::ball::Ball;
use super::surfaces::{SMOOTH, faces_viewer, plane};
use crate::algorithms::prepared_scene::PreparedScene;
use crate::figure::Space;
use crate::scene::{Mesh, Shape};
use glam::DVec3;

/// Meshes with more faces are drawn without edges.
const MOST_FACES: usize = 20_000;

/// The ends of each edge of an object; `round` says that spheres are what they are, not polygons in their place.
pub(super) fn edges(
    space: &Space,
    prepared: &PreparedScene,
    object: usize,
    reach: f64,
    round: bool,
) -> Vec<[DVec3; 2]> {
    let mesh = &prepared.tessellation.meshes[object];
    let shape = &prepared.scene.objects[object].shape;
    if let &Shape::Sphere { center, radius } = shape
        && round
        && let Some(ball) = Ball::seen(space, center, radius)
    {
        return ball.outline();
    }
    match *shape {
        Shape::Plane { point, normal } => {
            let corners = plane(space, point, normal, reach);
            (0..4).map(|i| [corners[i], corners[(i + 1) % 4]]).collect()
        }
        _ if mesh.face_count() > MOST_FACES => Vec::new(),
        _ => of_mesh(space, mesh),
    }
}

/// Each edge once: of the two faces at it the lower one gives it.
fn of_mesh(space: &Space, mesh: &Mesh) -> Vec<[DVec3; 2]> {
    let front: Vec<bool> = (0..mesh.face_count())
        .map(|face| {
            let corner = mesh.position(mesh.face(face)[0]);
            faces_viewer(space, corner, mesh.normal(face))
        })
        .collect();
    let mut edges = Vec::new();
    for face in 0..mesh.face_count() {
        let corners = mesh.face(face);
        let next = corners.iter().cycle().skip(1);
        for (&from, &to) in corners.iter().zip(next) {
            let mut others = mesh.faces_around(from).iter().filter(|&&other| {
                other as usize != face && mesh.face(other as usize).contains(&to)
            });
            let is_edge = match others.next() {
                None => true,
                Some(&other) => {
                    let other = other as usize;
                    let bends = mesh.normal(face).dot(mesh.normal(other)) < SMOOTH;
                    face < other && (front[face] != front[other] || bends)
                }
            };
            if is_edge {
                edges.push([mesh.position(from), mesh.position(to)]);
            }
        }
    }
    edges
}
