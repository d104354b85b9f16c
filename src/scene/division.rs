//! The faces of meshes and polygons as all methods draw them: each is planar, and winds once around what is inside.
//!
//! - A face of four or more corners that is not planar becomes triangles: of corners 0-1-2 and 0-2-3 where it has four, else a fan
//!   around the first corner where it is convex along its mean normal, else ears.
//! - A planar face that crosses itself becomes the regions that the even-odd rule fills.

use super::Mesh;
use super::even_odd::{Outline, Place, outline};
use super::primitives::polygon::Polygon;
use glam::{DVec2, DVec3};

/// How many pairs of edges are compared in one mesh before it is refused.
const MOST_PAIRS: usize = 1 << 26;

/// A mesh whose faces are planar and do not cross themselves.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Divided {
    pub mesh: Mesh,
    /// How many faces were not planar.
    pub bent: usize,
    /// How many faces crossed themselves.
    pub crossing: usize,
}

/// Divides the faces of a mesh that are not planar or cross themselves; all others stay as they are.
///
/// Errors: a face that meets itself too often, as a sentence.
pub(super) fn divided(mesh: Mesh) -> Result<Divided, String> {
    let mut parts = Parts::default();
    let mut pairs = MOST_PAIRS;
    for face in (0..mesh.face_count()).filter(|&face| mesh.face(face).len() > 3) {
        let polygon = Polygon::of_face(&mesh, face);
        let Some(normal) = polygon.facing() else {
            continue;
        };
        let polygon = polygon.with_normal(normal);
        if !polygon.is_nearly_planar() {
            parts.bent += 1;
            let triangles = polygon
                .triangles()
                .into_iter()
                .map(|triangle| triangle.map(|edge| Place { edge, share: 0.0 }).to_vec());
            parts.of_faces.push((face, triangles.collect()));
            continue;
        }
        if polygon.is_surely_simple() {
            continue;
        }
        match outline(&polygon.flattened(), &mut pairs) {
            Outline::Simple => {}
            Outline::Crossing(regions) => {
                parts.crossing += 1;
                parts.of_faces.push((face, regions));
            }
            Outline::TooOften => {
                return Err(format!(
                    "face {} has {} corners and meets itself too often to be filled; divide it",
                    face + 1,
                    mesh.face(face).len()
                ));
            }
        }
    }
    Ok(Divided {
        bent: parts.bent,
        crossing: parts.crossing,
        mesh: parts.put_in_place(mesh),
    })
}

/// What some faces are divided into.
#[derive(Default)]
struct Parts {
    /// In ascending order of the faces.
    of_faces: Vec<(usize, Vec<Vec<Place>>)>,
    bent: usize,
    crossing: usize,
}

impl Parts {
    fn put_in_place(self, mesh: Mesh) -> Mesh {
        if self.of_faces.is_empty() {
            return mesh;
        }
        let mut positions: Vec<DVec3> = (0..mesh.vertex_count() as u32)
            .map(|vertex| mesh.position(vertex))
            .collect();
        let mut faces = Faces::default();
        let mut parts = self.of_faces.into_iter().peekable();
        for face in 0..mesh.face_count() {
            let corners = mesh.face(face);
            let Some((_, regions)) = parts.next_if(|(divided, _)| *divided == face) else {
                faces.uvs.extend(mesh.face_uvs(face));
                faces.normals.extend(mesh.face_normals(face));
                faces.vertices.push(corners.to_vec());
                continue;
            };
            for region in regions {
                let vertices = region.iter().map(|&Place { edge, share }| {
                    let [from, to] = ends(corners.len(), edge);
                    if let uvs @ [_, ..] = mesh.face_uvs(face) {
                        faces.uvs.push(uvs[from].lerp(uvs[to], share));
                    }
                    if let normals @ [_, ..] = mesh.face_normals(face) {
                        let mixed = normals[from].lerp(normals[to], share);
                        faces.normals.push(mixed.normalize_or_zero());
                    }
                    if share == 0.0 {
                        return corners[from];
                    }
                    let [from, to] = [from, to].map(|corner| positions[corners[corner] as usize]);
                    positions.push(from.lerp(to, share));
                    positions.len() as u32 - 1
                });
                faces.vertices.push(vertices.collect());
            }
        }
        Mesh::with_normals(&positions, &faces.vertices, &faces.uvs, &faces.normals)
    }
}

#[derive(Default)]
struct Faces {
    vertices: Vec<Vec<u32>>,
    uvs: Vec<DVec2>,
    normals: Vec<DVec3>,
}

/// The corners at the ends of an edge of a face.
fn ends(count: usize, edge: u32) -> [usize; 2] {
    [edge as usize, (edge as usize + 1) % count]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn one_face(corners: &[[f64; 3]], uvs: &[DVec2]) -> Divided {
        let positions: Vec<DVec3> = corners.iter().copied().map(DVec3::from).collect();
        let face: Vec<u32> = (0..corners.len() as u32).collect();
        divided(Mesh::new(&positions, [face], uvs)).unwrap()
    }

    fn areas(mesh: &Mesh) -> Vec<DVec3> {
        let area = |face: usize| {
            let at: Vec<DVec3> = mesh
                .face(face)
                .iter()
                .map(|&vertex| mesh.position(vertex))
                .collect();
            let fan = (2..at.len()).map(|i| 0.5 * (at[i - 1] - at[0]).cross(at[i] - at[0]));
            fan.sum()
        };
        (0..mesh.face_count()).map(area).collect()
    }

    #[test]
    fn a_face_that_is_not_planar_becomes_triangles() {
        let quadrilateral = [[0., 0., 0.], [1., 0., 0.], [1., 1., 0.5], [0., 1., 0.]];
        let divided = one_face(&quadrilateral, &[]);
        assert_eq!((divided.bent, divided.crossing), (1, 0));
        let mesh = &divided.mesh;
        assert_eq!(
            (mesh.face(0), mesh.face(1)),
            (&[0, 1, 2][..], &[0, 2, 3][..])
        );
        let hexagon: [[f64; 3]; 6] = std::array::from_fn(|i| {
            let (sin, cos) = (i as f64 * std::f64::consts::FRAC_PI_3).sin_cos();
            [cos, sin, if i % 2 == 0 { 0.1 } else { -0.1 }]
        });
        let divided = one_face(&hexagon, &[DVec2::ONE; 6]);
        assert_eq!((divided.bent, divided.mesh.face_count()), (1, 4));
        assert!(areas(&divided.mesh).iter().all(|area| area.z > 0.0));
        assert_eq!(divided.mesh.face_uvs(3), [DVec2::ONE; 3]);
    }

    #[test]
    fn faces_that_are_planar_but_for_few_digits_stay_whole() {
        let planar = [[0., 0., 0.], [1., 0., 0.], [1., 1., 0.00004], [0., 1., 0.]];
        assert_eq!(one_face(&planar, &[]).mesh.face_count(), 1);
        let dart = [[4., 0., 0.], [4., 4., 0.00004], [0., 4., 0.], [3., 3., 0.]];
        assert_eq!(one_face(&dart, &[]).mesh.face_count(), 1);
        let hole = [
            [0., 0., 7.],
            [9., 0., 7.],
            [9., 9., 7.],
            [0., 9., 7.],
            [0., 0., 7.],
            [2., 2., 7.],
            [2., 5., 7.],
            [5., 2., 7.],
            [2., 2., 7.],
        ];
        assert_eq!(one_face(&hole, &[]).mesh.face_count(), 1);
    }

    #[test]
    fn the_parts_of_a_face_that_crosses_itself_look_one_way_and_have_its_texture_coordinates() {
        // A bow-tie whose parts of the area cancel out, so that it has no normal of its own
        let bow_tie = [[1., 0., 0.], [1., 1., 1.], [1., 1., 0.], [1., 0., 1.]];
        let uvs = bow_tie.map(|[_, y, z]| DVec2::new(y, z));
        let divided = one_face(&bow_tie, &uvs);
        assert_eq!((divided.bent, divided.crossing), (0, 1));
        let areas = areas(&divided.mesh);
        assert_eq!(areas.len(), 2);
        // The first turn, from (0, 1, 1) to (0, 0, -1), is clockwise about +x.
        assert!(
            areas
                .iter()
                .all(|area| area.distance(DVec3::new(-0.25, 0.0, 0.0)) < 1e-15)
        );
        for face in 0..2 {
            for (&vertex, uv) in divided
                .mesh
                .face(face)
                .iter()
                .zip(divided.mesh.face_uvs(face))
            {
                let place = divided.mesh.position(vertex);
                assert!(uv.distance(DVec2::new(place.y, place.z)) < 1e-15);
            }
        }
        assert_eq!(divided.mesh.vertex_count(), 5);
    }

    #[test]
    fn a_polygon_on_a_line_is_left_to_others() {
        let line = [[0., 0., 0.], [1., 0., 0.], [2., 0., 0.], [0.5, 0., 0.]];
        let divided = one_face(&line, &[]);
        assert_eq!(
            (divided.bent, divided.crossing, divided.mesh.face_count()),
            (0, 0, 1)
        );
    }
}
