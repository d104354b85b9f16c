//! Polygon meshes with vertices welded by place, so that neighbouring faces know of each other.

use glam::{DVec2, DVec3};
use std::collections::{HashMap, HashSet};

/// Faces of three corners or more over shared vertices.
///
/// Invariant: no two vertices have the same place, and the corners of one face are distinct and at least three.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct Mesh {
    positions: Vec<DVec3>,
    /// Face `f` has the corners `starts[f]..starts[f + 1]`.
    starts: Vec<u32>,
    /// Indices into `positions`.
    corners: Vec<u32>,
    /// One a corner, or none at all.
    uvs: Vec<DVec2>,
    /// Unit normals, one a face; zero where a face has no area.
    normals: Vec<DVec3>,
    /// The faces around vertex `v` are `around[around_starts[v]..around_starts[v + 1]]`.
    around_starts: Vec<u32>,
    around: Vec<u32>,
}

impl Mesh {
    /// Welds vertices at exactly one place. Faces that have fewer than three distinct places left are dropped.
    ///
    /// `faces` index `positions`; `uvs`, where not empty, has one entry a corner in the order of `faces`.
    pub fn new(
        positions: &[DVec3],
        faces: impl IntoIterator<Item = impl AsRef<[u32]>>,
        uvs: &[DVec2],
    ) -> Self {
        let mut mesh = Mesh {
            starts: vec![0],
            ..Mesh::default()
        };
        let mut at_place = HashMap::with_capacity(positions.len());
        let welded: Vec<u32> = positions
            .iter()
            .map(|&position| {
                *at_place.entry(place(position)).or_insert_with(|| {
                    mesh.positions.push(position);
                    mesh.positions.len() as u32 - 1
                })
            })
            .collect();
        let mut corner = 0;
        for face in faces {
            let start = mesh.corners.len();
            let mut taken = Taken::default();
            for &index in face.as_ref() {
                let vertex = welded[index as usize];
                if taken.insert(&mesh.corners[start..], vertex) {
                    mesh.corners.push(vertex);
                    mesh.uvs.extend(uvs.get(corner));
                }
                corner += 1;
            }
            if mesh.corners.len() - start < 3 {
                mesh.corners.truncate(start);
                mesh.uvs.truncate(if uvs.is_empty() { 0 } else { start });
            } else {
                mesh.starts.push(mesh.corners.len() as u32);
            }
        }
        mesh.normals = (0..mesh.face_count())
            .map(|face| mesh.area_vector(face).normalize_or_zero())
            .collect();
        mesh.index_faces_around();
        mesh
    }

    pub fn vertex_count(&self) -> usize {
        self.positions.len()
    }

    pub fn face_count(&self) -> usize {
        self.starts.len().saturating_sub(1)
    }

    pub fn position(&self, vertex: u32) -> DVec3 {
        self.positions[vertex as usize]
    }

    /// The vertices of a face, counter-clockwise seen from its front.
    pub fn face(&self, face: usize) -> &[u32] {
        &self.corners[self.starts[face] as usize..self.starts[face + 1] as usize]
    }

    /// Texture coordinates of a face, a pair a corner; empty where the mesh has none.
    pub fn face_uvs(&self, face: usize) -> &[DVec2] {
        if self.uvs.is_empty() {
            &[]
        } else {
            &self.uvs[self.starts[face] as usize..self.starts[face + 1] as usize]
        }
    }

    /// The unit normal of a face, zero where it has no area.
    pub fn normal(&self, face: usize) -> DVec3 {
        self.normals[face]
    }

    /// The faces that share a vertex, in ascending order.
    pub fn faces_around(&self, vertex: u32) -> &[u32] {
        let vertex = vertex as usize;
        &self.around[self.around_starts[vertex] as usize..self.around_starts[vertex + 1] as usize]
    }

    /// Twice the vector area of a face (Newell's method, taken from the first corner, so that it stays exact far from the origin).
    fn area_vector(&self, face: usize) -> DVec3 {
        let corners = self.face(face);
        let origin = self.position(corners[0]);
        corners[1..]
            .windows(2)
            .map(|pair| (self.position(pair[0]) - origin).cross(self.position(pair[1]) - origin))
            .sum()
    }

    fn index_faces_around(&mut self) {
        let mut starts = vec![0_u32; self.positions.len() + 1];
        for &vertex in &self.corners {
            starts[vertex as usize + 1] += 1;
        }
        for vertex in 1..starts.len() {
            starts[vertex] += starts[vertex - 1];
        }
        let mut next = starts.clone();
        let mut around = vec![0; self.corners.len()];
        for face in 0..self.face_count() {
            for &vertex in self.face(face) {
                around[next[vertex as usize] as usize] = face as u32;
                next[vertex as usize] += 1;
            }
        }
        (self.around_starts, self.around) = (starts, around);
    }
}

/// The corners that a face has so far: looked through while they are few, so that most faces need no memory, and hashed after.
#[derive(Default)]
struct Taken(HashSet<u32>);

impl Taken {
    /// Whether `vertex` is none of `corners`, to which it is then added.
    fn insert(&mut self, corners: &[u32], vertex: u32) -> bool {
        const FEW: usize = 16;
        if corners.len() < FEW {
            return !corners.contains(&vertex);
        }
        if self.0.is_empty() {
            self.0.extend(corners);
        }
        self.0.insert(vertex)
    }
}

/// A key that is equal for equal coordinates: −0 and 0 are one place.
fn place(position: DVec3) -> [u64; 3] {
    (position + DVec3::ZERO).to_array().map(f64::to_bits)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_triangles_share_the_vertices_of_their_edge() {
        let positions = [
            [0.0, 0.0, 0.0],
            [1.0, 0.0, 0.0],
            [1.0, 1.0, 0.0],
            [-0.0, 0.0, 0.0],
            [1.0, 1.0, 0.0],
            [0.0, 1.0, 0.0],
        ]
        .map(DVec3::from);
        let mesh = Mesh::new(&positions, [[0, 1, 2], [3, 4, 5]], &[]);
        assert_eq!(mesh.vertex_count(), 4);
        assert_eq!(mesh.faces_around(0), [0, 1]);
        assert_eq!(mesh.faces_around(1), [0]);
        assert_eq!(mesh.normal(1), DVec3::Z);
    }

    #[test]
    fn corners_of_a_large_face_repeat_as_little_as_those_of_a_small_one() {
        let parabola: Vec<DVec3> = (0..200_000)
            .map(|i| DVec3::new(f64::from(i), f64::from(i).powi(2), 0.0))
            .collect();
        let face: Vec<u32> = (0..200_000).chain([0, 17, 199_999]).collect();
        let mesh = Mesh::new(&parabola, [face], &[]);
        assert_eq!(mesh.face(0).len(), 200_000);
    }

    #[test]
    fn repeated_corners_are_dropped_with_their_texture_coordinates() {
        let positions = [
            [0.0, 0.0, 0.0],
            [1.0, 0.0, 0.0],
            [1.0, 0.0, 0.0],
            [0.0, 1.0, 0.0],
        ]
        .map(DVec3::from);
        let uvs: Vec<DVec2> = (0..7).map(|i| DVec2::splat(f64::from(i))).collect();
        let faces: [&[u32]; 2] = [&[1, 2, 1], &[0, 1, 2, 3]];
        let mesh = Mesh::new(&positions, faces, &uvs);
        assert_eq!(mesh.face_count(), 1);
        assert_eq!(mesh.face(0), [0, 1, 2]);
        assert_eq!(mesh.face_uvs(0), [3.0, 4.0, 6.0].map(DVec2::splat));
    }
}
