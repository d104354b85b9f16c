//! Polygons for the scan-line methods: every object but the infinite planes as a mesh.

use super::division::divided;
use super::{Mesh, Object, Scene, Shape};
use glam::{DVec2, DVec3};
use std::f64::consts::{PI, TAU};

pub const CYLINDER_SIDES: u32 = 32;

/// The objects of a scene as meshes. Polygons are counted from 0 over all objects in the order of the file.
#[derive(Clone, Debug, PartialEq)]
pub struct Tessellation {
    /// One an object; that of a plane is empty.
    pub meshes: Vec<Mesh>,
    /// The indices of the planes, which have no end and are left out.
    pub skipped: Vec<usize>,
    /// The polygons of object `i` are `starts[i]..starts[i + 1]`.
    starts: Vec<usize>,
}

impl Tessellation {
    /// How many polygons a scene divides into, before any of them takes memory.
    pub fn count(scene: &Scene) -> u64 {
        let polygons = |object: &Object| match &object.shape {
            Shape::Sphere { .. } => 2 * u64::from(object.divisions).pow(2),
            Shape::Plane { .. } => 0,
            Shape::Polygon { vertices } => polygon(vertices).face_count() as u64,
            Shape::Cylinder { capped, .. } => u64::from(CYLINDER_SIDES) + 2 * u64::from(*capped),
            Shape::Bezier { patches, divisions } => {
                patches.len() as u64 * u64::from(*divisions).pow(2)
            }
            Shape::Mesh(mesh) => mesh.face_count() as u64,
        };
        scene.objects.iter().map(polygons).sum()
    }

    pub fn of(scene: &Scene) -> Self {
        let meshes: Vec<Mesh> = scene
            .objects
            .iter()
            .map(|object| mesh_of(&object.shape, object.divisions))
            .collect();
        let skipped = (0..meshes.len())
            .filter(|&i| matches!(scene.objects[i].shape, Shape::Plane { .. }))
            .collect();
        let mut starts = vec![0];
        let mut count = 0;
        starts.extend(meshes.iter().map(|mesh| {
            count += mesh.face_count();
            count
        }));
        Tessellation {
            meshes,
            skipped,
            starts,
        }
    }

    /// Over all objects.
    pub fn polygon_count(&self) -> usize {
        self.first_polygon(self.meshes.len())
    }

    /// The number of an object's first polygon.
    pub fn first_polygon(&self, object: usize) -> usize {
        self.starts[object]
    }

    /// The object that a polygon belongs to, and which face of its mesh it is.
    pub fn locate(&self, polygon: usize) -> Option<(usize, usize)> {
        let object = self.starts.partition_point(|&start| start <= polygon) - 1;
        (object < self.meshes.len()).then(|| (object, polygon - self.starts[object]))
    }
}

/// Faces are counter-clockwise seen from outside, or from a polygon's front. Of a sphere, `divisions` from pole to pole.
pub(super) fn mesh_of(shape: &Shape, divisions: u32) -> Mesh {
    match shape {
        Shape::Sphere { center, radius } => sphere(*center, *radius, [2 * divisions, divisions]),
        Shape::Plane { .. } => Mesh::default(),
        Shape::Polygon { vertices } => polygon(vertices),
        Shape::Cylinder {
            base,
            axis,
            radius,
            height,
            capped,
        } => cylinder(*base, *axis, *radius, *height, *capped),
        Shape::Bezier { patches, divisions } => bezier(patches, *divisions),
        Shape::Mesh(mesh) => mesh.clone(),
    }
}

/// The one face of a polygon, divided where it is not planar or crosses itself.
pub(super) fn polygon(vertices: &[DVec3]) -> Mesh {
    let face: Vec<u32> = (0..vertices.len() as u32).collect();
    let mesh = Mesh::new(vertices, [face], &[]);
    // A polygon that cannot be divided is refused where scenes are read.
    divided(mesh.clone()).map_or(mesh, |divided| divided.mesh)
}

/// The poles on the y axis; longitudes from z toward x, latitudes from the north pole (+y) down. Faces latitude by latitude.
pub fn sphere(center: DVec3, radius: f64, [longitudes, latitudes]: [u32; 2]) -> Mesh {
    let mut positions = Vec::new();
    for i in 0..=latitudes {
        let (sin_theta, cos_theta) = match i {
            0 => (0.0, 1.0),
            i if i == latitudes => (0.0, -1.0),
            i => (PI * f64::from(i) / f64::from(latitudes)).sin_cos(),
        };
        for j in 0..longitudes {
            let (sin_phi, cos_phi) = (TAU * f64::from(j) / f64::from(longitudes)).sin_cos();
            let outward = DVec3::new(sin_theta * sin_phi, cos_theta, sin_theta * cos_phi);
            positions.push(center + radius * outward);
        }
    }
    // Both lower corners at the south pole, or both upper ones at the north pole, weld: a triangle is left.
    let at = |i: u32, j: u32| i * longitudes + j % longitudes;
    let faces = (0..latitudes).flat_map(|i| {
        (0..longitudes).map(move |j| [at(i + 1, j), at(i + 1, j + 1), at(i, j + 1), at(i, j)])
    });
    Mesh::new(&positions, faces, &[])
}

/// Texture coordinates: u = longitude/2π, v = the share of the height.
fn cylinder(base: DVec3, axis: DVec3, radius: f64, height: f64, capped: bool) -> Mesh {
    let sides = CYLINDER_SIDES;
    let [u, v] = ring_axes(axis);
    let ring = |level: DVec3| {
        (0..sides).map(move |i| {
            let (sin, cos) = (TAU * f64::from(i) / f64::from(sides)).sin_cos();
            level + radius * (cos * u + sin * v)
        })
    };
    let positions: Vec<DVec3> = ring(base).chain(ring(base + height * axis)).collect();
    let mut faces: Vec<Vec<u32>> = (0..sides)
        .map(|i| {
            let next = (i + 1) % sides;
            vec![i, next, sides + next, sides + i]
        })
        .collect();
    if capped {
        faces.push((0..sides).rev().collect());
        faces.push((sides..2 * sides).collect());
    }
    let at = |i: u32, v: f64| DVec2::new(f64::from(i) / f64::from(sides), v);
    let around = (0..sides).flat_map(|i| [at(i, 0.0), at(i + 1, 0.0), at(i + 1, 1.0), at(i, 1.0)]);
    let caps = (0..sides)
        .rev()
        .map(|i| at(i, 0.0))
        .chain((0..sides).map(|i| at(i, 1.0)));
    let uvs: Vec<DVec2> = around.chain(caps.filter(|_| capped)).collect();
    Mesh::new(&positions, faces, &uvs)
}

/// Two directions, unit, across the axis of a cylinder: its ring runs from the first toward the second, counter-clockwise seen from the
/// tip of the axis.
pub fn ring_axes(axis: DVec3) -> [DVec3; 2] {
    let (u, v) = axis.any_orthonormal_pair();
    let v = if u.cross(v).dot(axis) < 0.0 { -v } else { v };
    [u, v]
}

/// With u along the rows of control points and v from row to row, the front is where ∂P/∂u × ∂P/∂v points. Texture coordinates: (u, v).
fn bezier(patches: &[[DVec3; 16]], divisions: u32) -> Mesh {
    let n = divisions;
    let weights: Vec<[f64; 4]> = (0..=n).map(|i| grid_weights(i, n)).collect();
    let mut positions = Vec::new();
    for points in patches {
        for across in &weights {
            for along in &weights {
                positions.push(patch_point(points, along, across));
            }
        }
    }
    let points_a_patch = (n + 1) * (n + 1);
    let faces = (0..patches.len() as u32).flat_map(|patch| {
        let at = move |i: u32, j: u32| patch * points_a_patch + i * (n + 1) + j;
        (0..n).flat_map(move |i| {
            (0..n).map(move |j| [at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)])
        })
    });
    let share = |i: u32| f64::from(i) / f64::from(n);
    let uv = |i: u32, j: u32| DVec2::new(share(j), share(i));
    let uvs: Vec<DVec2> = (0..patches.len())
        .flat_map(|_| (0..n).flat_map(|i| (0..n).map(move |j| (i, j))))
        .flat_map(|(i, j)| [uv(i, j), uv(i, j + 1), uv(i + 1, j + 1), uv(i + 1, j)])
        .collect();
    Mesh::new(&positions, faces, &uvs)
}

/// The weights of control points at i/n.
///
/// Counted from the other end they come out in reverse order to the last bit, so that neighbours that run through their
/// common edge in opposite directions weld.
pub fn grid_weights(i: u32, n: u32) -> [f64; 4] {
    bernstein(f64::from(i) / f64::from(n), f64::from(n - i) / f64::from(n))
}

/// The cubic Bernstein polynomials at t, with s = 1 − t.
pub(super) fn bernstein(t: f64, s: f64) -> [f64; 4] {
    [
        s * (s * s),
        3.0 * (t * (s * s)),
        3.0 * (s * (t * t)),
        t * (t * t),
    ]
}

/// The point of a patch with such weights along its rows and from row to row.
pub fn patch_point(points: &[DVec3; 16], along: &[f64; 4], across: &[f64; 4]) -> DVec3 {
    let row = |row: usize| {
        combine(
            along,
            std::array::from_fn(|column| points[4 * row + column]),
        )
    };
    combine(across, std::array::from_fn(row))
}

/// Summed from both ends, for the same reason.
fn combine(weights: &[f64; 4], points: [DVec3; 4]) -> DVec3 {
    let term = |k: usize| weights[k] * points[k];
    (term(0) + term(3)) + (term(1) + term(2))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Object;
    use std::collections::HashSet;

    /// V − E + F: 2 for a closed surface without handles (Euler).
    fn euler_characteristic(mesh: &Mesh) -> i64 {
        let mut edges = HashSet::new();
        for face in 0..mesh.face_count() {
            let corners = mesh.face(face);
            for (i, &from) in corners.iter().enumerate() {
                let to = corners[(i + 1) % corners.len()];
                edges.insert((from.min(to), from.max(to)));
            }
        }
        mesh.vertex_count() as i64 - edges.len() as i64 + mesh.face_count() as i64
    }

    /// How far the face with the least such lean faces away from `center`: 1 for straight.
    fn least_outward(mesh: &Mesh, center: DVec3) -> f64 {
        (0..mesh.face_count())
            .map(|face| {
                let corners = mesh.face(face);
                let sum: DVec3 = corners.iter().map(|&v| mesh.position(v)).sum();
                let outward = (sum / corners.len() as f64 - center).normalize();
                mesh.normal(face).dot(outward)
            })
            .fold(1.0, f64::min)
    }

    #[test]
    fn a_sphere_is_closed_and_faces_outward() {
        let center = DVec3::new(-1.3, 0.8, 0.5);
        let mesh = sphere(center, 0.8, [32, 16]);
        assert_eq!(mesh.face_count(), 512);
        // 15 rings of 32 and the two poles.
        assert_eq!(mesh.vertex_count(), 482);
        assert_eq!(euler_characteristic(&mesh), 2);
        assert!(least_outward(&mesh, center) > 0.99);
        assert_eq!(mesh.face(0).len(), 3);
        assert_eq!(mesh.face(32).len(), 4);
        for v in 0..482 {
            assert!((mesh.position(v).distance(center) - 0.8).abs() < 1e-15);
        }
    }

    #[test]
    fn a_capped_cylinder_is_closed_and_an_open_one_has_two_rims() {
        for axis in [DVec3::Y, DVec3::NEG_Z, DVec3::new(1.0, -2.0, 2.0) / 3.0] {
            let base = DVec3::new(1.0, 2.0, 3.0);
            let mesh = cylinder(base, axis, 0.5, 2.0, true);
            assert_eq!((mesh.vertex_count(), mesh.face_count()), (64, 34));
            assert_eq!(euler_characteristic(&mesh), 2);
            assert!(least_outward(&mesh, base + axis) > 0.99);
            assert!(mesh.normal(32).distance(-axis) < 1e-15);
            assert!(mesh.normal(33).distance(axis) < 1e-15);
            let open = cylinder(base, axis, 0.5, 2.0, false);
            assert_eq!(euler_characteristic(&open), 0);
        }
    }

    /// Control points of a flat square that P(u, v) = origin + 3u·along + 3v·across.
    fn flat(origin: DVec3, along: DVec3, across: DVec3) -> [DVec3; 16] {
        std::array::from_fn(|i| origin + (i % 4) as f64 * along + (i / 4) as f64 * across)
    }

    #[test]
    fn a_flat_bezier_patch_is_divided_evenly() {
        let mesh = bezier(&[flat(DVec3::ZERO, DVec3::X, DVec3::Y)], 6);
        assert_eq!((mesh.vertex_count(), mesh.face_count()), (49, 36));
        for v in 0..49 {
            let expected = DVec3::new(f64::from(v % 7), f64::from(v / 7), 0.0) * 0.5;
            // Two sums of weights, each of some ten roundings, over values up to 3: 60 ε/2.
            assert!(mesh.position(v).distance(expected) < 30.0 * f64::EPSILON);
        }
        assert!((0..36).all(|face| mesh.normal(face).distance(DVec3::Z) < 1e-12));
    }

    #[test]
    fn texture_coordinates_of_divided_shapes_follow_their_parameters() {
        let mesh = bezier(&[flat(DVec3::X, DVec3::X, DVec3::Y); 2], 3);
        for face in 0..mesh.face_count() {
            for (&vertex, &uv) in mesh.face(face).iter().zip(mesh.face_uvs(face)) {
                let place = (mesh.position(vertex) - DVec3::X) / 3.0;
                assert!(place.truncate().distance(uv) < 1e-14);
            }
        }
        for capped in [true, false] {
            let mesh = cylinder(DVec3::ZERO, DVec3::Y, 1.0, 2.0, capped);
            let first = mesh.position(0);
            for face in 0..mesh.face_count() {
                for (&vertex, &uv) in mesh.face(face).iter().zip(mesh.face_uvs(face)) {
                    let place = mesh.position(vertex);
                    assert!((place.y - 2.0 * uv.y).abs() < 1e-14);
                    let turned = glam::DQuat::from_axis_angle(DVec3::Y, TAU * uv.x) * first;
                    assert!(turned.distance(place.with_y(0.0)) < 1e-14);
                }
            }
            assert_eq!(mesh.face_uvs(31)[1], DVec2::new(1.0, 0.0));
        }
    }

    #[test]
    fn bezier_patches_weld_along_an_edge_whichever_way_they_run() {
        let bent: [DVec3; 16] = std::array::from_fn(|i| {
            let (x, y) = ((i % 4) as f64, (i / 4) as f64);
            DVec3::new(0.1 + x * 1.1, 0.7 * y + 0.3 * x, (x * y * 0.37).sin())
        });
        // The row of each neighbour that lies on the last row of `bent`: as it is, turned round, and as a column.
        let last = |i: usize| bent[12 + i];
        let away = |point: DVec3, steps: usize| point + DVec3::Y * steps as f64;
        let same: [DVec3; 16] = std::array::from_fn(|i| away(last(i % 4), i / 4));
        let turned: [DVec3; 16] = std::array::from_fn(|i| away(last(3 - i % 4), i / 4));
        let column: [DVec3; 16] = std::array::from_fn(|i| away(last(3 - i / 4), i % 4));
        for divisions in [1, 3, 7, 10] {
            for neighbour in [same, turned, column] {
                let mesh = bezier(&[bent, neighbour], divisions);
                let a_side = divisions as usize + 1;
                assert_eq!(mesh.vertex_count(), 2 * a_side * a_side - a_side);
                assert_eq!(euler_characteristic(&mesh), 1);
            }
        }
    }

    #[test]
    fn polygons_are_counted_over_all_objects_and_before_they_are_made() {
        let vertices = vec![DVec3::ZERO, DVec3::X, DVec3::Y];
        let (point, normal) = (DVec3::ZERO, DVec3::Y);
        let shapes = [
            Shape::Polygon { vertices },
            Shape::Plane { point, normal },
            Shape::Sphere {
                center: point,
                radius: 1.0,
            },
            Shape::Cylinder {
                base: point,
                axis: normal,
                radius: 1.0,
                height: 1.0,
                capped: true,
            },
        ];
        let scene = Scene {
            objects: shapes.map(|shape| Object::new("", 0, shape)).into(),
            ..Scene::default()
        };
        assert_eq!(Tessellation::count(&scene), 1 + 512 + 34);
        let tessellation = Tessellation::of(&scene);
        assert_eq!(tessellation.skipped, [1]);
        assert_eq!(tessellation.polygon_count(), 1 + 512 + 34);
        assert_eq!(tessellation.first_polygon(2), 1);
        assert_eq!(tessellation.locate(0), Some((0, 0)));
        assert_eq!(tessellation.locate(1), Some((2, 0)));
        assert_eq!(tessellation.locate(512), Some((2, 511)));
        assert_eq!(tessellation.locate(546), Some((3, 33)));
        assert_eq!(tessellation.locate(547), None);
    }
}
