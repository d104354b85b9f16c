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
