//! Closed surfaces, and the points inside them.

use super::super::Mesh;
use glam::DVec3;
use std::f64::consts::PI;

/// Whether every edge is shared by exactly two faces, which run along it in opposite senses.
pub(super) fn is_closed(mesh: &Mesh) -> bool {
    // How often the faces around `from` run from it to `to`
    let count = |from: u32, to: u32| -> usize {
        let faces = mesh.faces_around(from).iter();
        faces
            .map(|&face| {
                let corners = mesh.face(face as usize);
                (0..corners.len())
                    .filter(|&i| corners[i] == from && corners[(i + 1) % corners.len()] == to)
                    .count()
            })
            .sum()
    };
    mesh.face_count() > 0
        && (0..mesh.face_count()).all(|face| {
            let corners = mesh.face(face);
            (0..corners.len()).all(|i| {
                let (from, to) = (corners[i], corners[(i + 1) % corners.len()]);
                count(from, to) == 1 && count(to, from) == 1
            })
        })
}

/// Whether a closed surface winds around a point: the solid angles of its triangles, seen from there, add up to 4π a turn, and
/// to 0 outside (Van Oosterom & Strackee 1983, "The Solid Angle of a Plane Triangle", equation 8).
pub(super) fn winds_around(triangles: impl Iterator<Item = [DVec3; 3]>, point: DVec3) -> bool {
    let half_angles: f64 = triangles
        .map(|corners| {
            let [a, b, c] = corners.map(|corner| (corner - point).normalize_or_zero());
            let over = a.dot(b.cross(c));
            let under = 1.0 + a.dot(b) + b.dot(c) + c.dot(a);
            over.atan2(under)
        })
        .sum();
    half_angles.abs() > PI
}

#[cfg(test)]
mod tests {
    use super::super::tests::{primitives, scene};
    use super::*;
    use crate::scene::{Scene, Shape, Tessellation};

    fn mesh(scene: &Scene) -> Mesh {
        Tessellation::of(scene).meshes.swap_remove(0)
    }

    fn cylinder(capped: bool) -> Shape {
        let (base, axis) = (DVec3::ZERO, DVec3::Y);
        Shape::Cylinder {
            base,
            axis,
            radius: 1.0,
            height: 2.0,
            capped,
        }
    }

    #[test]
    fn caps_close_a_cylinder_and_one_turned_face_opens_it() {
        let closed = mesh(&scene([cylinder(true)]));
        assert!(is_closed(&closed));
        assert!(!is_closed(&mesh(&scene([cylinder(false)]))));
        let positions: Vec<DVec3> = (0..closed.vertex_count() as u32)
            .map(|v| closed.position(v))
            .collect();
        let mut faces: Vec<Vec<u32>> = (0..closed.face_count())
            .map(|f| closed.face(f).to_vec())
            .collect();
        faces[3].reverse();
        assert!(!is_closed(&Mesh::new(&positions, &faces, &[])));
        faces[3].reverse();
        faces.push(faces[3].clone());
        assert!(!is_closed(&Mesh::new(&positions, &faces, &[])));
        assert!(!is_closed(&Mesh::default()));
    }

    #[test]
    fn what_contains_a_point_is_listed_from_outside_in() {
        let sphere = |x: f64, radius| Shape::Sphere {
            center: DVec3::new(x, 1.0, 0.0),
            radius,
        };
        let primitives = primitives([
            sphere(0.0, 0.5),
            cylinder(true),
            sphere(0.1, 0.9),
            Shape::Plane {
                point: DVec3::ZERO,
                normal: DVec3::Y,
            },
            sphere(0.0, 10.0),
            cylinder(false),
            sphere(5.0, 1.0),
        ]);
        assert_eq!(primitives.around(DVec3::new(0.0, 1.0, 0.0)), [4, 1, 2, 0]);
        assert_eq!(primitives.around(DVec3::new(0.0, 1.99, 0.0)), [4, 1]);
        assert_eq!(primitives.around(DVec3::new(0.0, 2.01, 0.0)), [4]);
        assert_eq!(primitives.around(DVec3::new(0.0, 20.0, 0.0)), [0; 0]);
    }
}
