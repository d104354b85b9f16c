//! Closed surfaces, and the points inside them.

use super::super::Mesh;
use glam::DVec3;
use std::f64::consts::PI;

/// Whether a mesh bounds a body, and which way its faces look.
#[derive(Clone, Debug, PartialEq)]
pub enum Winding {
    /// The surface has a border or a fork: this edge, from vertex to vertex, has not one face on either side.
    Open { edge: [u32; 2] },
    /// Every face has a neighbour across each of its edges. Whether it must be turned to look outward, by face.
    Closed { turned: Vec<bool> },
}

impl Winding {
    /// Faces are turned that are wound against their neighbours, the fewer in each connected part; then all, where the enclosed volume
    /// is negative.
    pub fn of(mesh: &Mesh) -> Self {
        let mut turned = vec![false; mesh.face_count()];
        if edges(mesh).any(|(_, edge)| !is_paired(mesh, edge)) {
            let is_forked = |&(_, [from, to]): &(usize, [u32; 2])| {
                count(mesh, from, to) + count(mesh, to, from) != 2
            };
            if let Some((_, edge)) = edges(mesh).find(is_forked) {
                return Winding::Open { edge };
            }
            if let Err(edge) = agree(mesh, &mut turned) {
                return Winding::Open { edge };
            }
        }
        if volume(mesh, &turned) < 0.0 {
            turned.iter_mut().for_each(|turned| *turned = !*turned);
        }
        match turned.is_empty() {
            true => Winding::Open { edge: [0; 2] },
            false => Winding::Closed { turned },
        }
    }
}

/// The edges of all faces, with the face, in its sense.
fn edges(mesh: &Mesh) -> impl Iterator<Item = (usize, [u32; 2])> {
    (0..mesh.face_count()).flat_map(move |face| edges_of(mesh, face).map(move |edge| (face, edge)))
}

pub(super) fn edges_of(mesh: &Mesh, face: usize) -> impl Iterator<Item = [u32; 2]> {
    let corners = mesh.face(face);
    (0..corners.len()).map(move |i| [corners[i], corners[(i + 1) % corners.len()]])
}

/// How often faces run from one vertex to another.
fn count(mesh: &Mesh, from: u32, to: u32) -> usize {
    let around = mesh.faces_around(from).iter();
    let edges = around.flat_map(|&face| edges_of(mesh, face as usize));
    edges.filter(|&edge| edge == [from, to]).count()
}

/// Whether as many faces run along an edge in one sense as in the other.
fn is_paired(mesh: &Mesh, [from, to]: [u32; 2]) -> bool {
    count(mesh, from, to) == count(mesh, to, from)
}

/// Turns faces so that neighbours run along the edge that they share in opposite senses. An edge where they cannot, or along which a face
/// runs twice in the same sense, is the error.
fn agree(mesh: &Mesh, turned: &mut [bool]) -> Result<(), [u32; 2]> {
    let mut reached = vec![false; turned.len()];
    for start in 0..turned.len() {
        if reached[start] {
            continue;
        }
        reached[start] = true;
        let mut part = vec![start];
        let mut next = 0;
        while let Some(&face) = part.get(next) {
            next += 1;
            for [from, to] in edges_of(mesh, face) {
                if edges_of(mesh, face).filter(|&of| of == [from, to]).count() > 1 {
                    return Err([from, to]);
                }
                for &neighbour in mesh.faces_around(from) {
                    let neighbour = neighbour as usize;
                    let runs = |edge| edges_of(mesh, neighbour).any(|of| of == edge);
                    let (along, against) = (runs([from, to]), runs([to, from]));
                    if neighbour == face || !(along || against) {
                        continue;
                    }
                    let wanted = turned[face] != along;
                    if !std::mem::replace(&mut reached[neighbour], true) {
                        turned[neighbour] = wanted;
                        part.push(neighbour);
                    } else if turned[neighbour] != wanted {
                        return Err([from, to]);
                    }
                }
            }
        }
        let count = part.iter().filter(|&&face| turned[face]).count();
        if 2 * count > part.len() {
            part.iter().for_each(|&face| turned[face] = !turned[face]);
        }
    }
    Ok(())
}

/// Six times the volume that the faces enclose, positive where they look outward.
fn volume(mesh: &Mesh, turned: &[bool]) -> f64 {
    let origin = match mesh.vertex_count() {
        0 => DVec3::ZERO,
        _ => mesh.position(0),
    };
    let of_face = |face: usize| {
        let corner = |i: usize| mesh.position(mesh.face(face)[i]) - origin;
        let fan = (2..mesh.face(face).len()).map(|i| corner(0).dot(corner(i - 1).cross(corner(i))));
        let sign = if turned[face] { -1.0 } else { 1.0 };
        sign * fan.sum::<f64>()
    };
    (0..mesh.face_count()).map(of_face).sum()
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

    fn is_closed(mesh: &Mesh) -> bool {
        matches!(Winding::of(mesh), Winding::Closed { .. })
    }

    /// The same vertices, with other faces.
    fn with_faces(mesh: &Mesh, change: impl FnOnce(&mut Vec<Vec<u32>>)) -> Mesh {
        let positions: Vec<DVec3> = (0..mesh.vertex_count() as u32)
            .map(|v| mesh.position(v))
            .collect();
        let mut faces: Vec<Vec<u32>> = (0..mesh.face_count())
            .map(|f| mesh.face(f).to_vec())
            .collect();
        change(&mut faces);
        Mesh::new(&positions, &faces, &[])
    }

    #[test]
    fn caps_close_a_cylinder_and_a_missing_or_double_face_opens_it() {
        let closed = mesh(&scene([cylinder(true)]));
        assert!(is_closed(&closed));
        assert!(!is_closed(&mesh(&scene([cylinder(false)]))));
        let double = with_faces(&closed, |faces| faces.push(faces[3].clone()));
        assert!(!is_closed(&double));
        // A face that goes around twice has nothing on the other side.
        let twice = with_faces(&closed, |faces| *faces = vec![vec![0, 1, 2, 0, 1, 2]]);
        assert!(!is_closed(&twice));
        let open = with_faces(&closed, |faces| drop(faces.remove(3)));
        let Winding::Open { edge } = Winding::of(&open) else {
            panic!("a face is missing")
        };
        assert!(edges_of(&closed, 3).any(|[from, to]| [to, from] == edge));
        assert!(!is_closed(&Mesh::default()));
    }

    #[test]
    fn faces_wound_inward_are_turned() {
        let outward = mesh(&scene([cylinder(true)]));
        let count = outward.face_count();
        let turned = |mesh: &Mesh| match Winding::of(mesh) {
            Winding::Closed { turned } => turned,
            Winding::Open { edge } => panic!("open at {edge:?}"),
        };
        assert_eq!(turned(&outward), vec![false; count]);
        let inward = with_faces(&outward, |faces| {
            faces.iter_mut().for_each(|face| face.reverse())
        });
        assert_eq!(turned(&inward), vec![true; count]);
        let mixed = with_faces(&outward, |faces| {
            [3, 7, 8, 33]
                .iter()
                .for_each(|&face: &usize| faces[face].reverse());
        });
        let which: Vec<usize> = (0..count).filter(|&face| turned(&mixed)[face]).collect();
        assert_eq!(which, [3, 7, 8, 33]);
    }

    #[test]
    fn a_strip_with_half_a_twist_has_no_sides() {
        // A Möbius strip, closed by a cone over its border, is a projective plane.
        let n = 9_u32;
        let ring = |i: u32| {
            let angle = f64::from(i) * std::f64::consts::TAU / f64::from(n);
            let (sin, cos) = angle.sin_cos();
            let (s, c) = (0.5 * angle).sin_cos();
            [-0.4, 0.4].map(|w| DVec3::new((1.0 + w * c) * cos, (1.0 + w * c) * sin, w * s))
        };
        let mut positions: Vec<DVec3> = (0..n).flat_map(ring).collect();
        positions.push(DVec3::new(0.0, 0.0, 3.0));
        let tip = 2 * n;
        let mut faces: Vec<Vec<u32>> = Vec::new();
        for i in 0..n {
            let [a, b] = [2 * i, 2 * i + 1];
            // The twist joins the upper edge of the last cell to the lower edge of the first.
            let [c, d] = if i + 1 < n { [a + 2, b + 2] } else { [1, 0] };
            faces.push(vec![a, b, d, c]);
            faces.push(vec![a, c, tip]);
            faces.push(vec![b, d, tip]);
        }
        assert!(!is_closed(&Mesh::new(&positions, &faces, &[])));
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
