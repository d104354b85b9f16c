//! Polygon meshes with vertices welded by place, so that neighbouring faces know of each other.

use glam::{DVec2, DVec3};
use std::collections::HashMap;

/// Faces of three corners or more over shared vertices.
///
/// Invariant: no two vertices have the same place; a face has three corners or more, neighbouring ones at different places.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct Mesh {
    positions: Vec<DVec3>,
    /// Face `f` has the corners `starts[f]..starts[f + 1]`.
    starts: Vec<u32>,
    /// Indices into `positions`.
    corners: Vec<u32>,
    /// One a corner, or none at all.
    uvs: Vec<DVec2>,
    /// Unit normals, one a corner, or none at all; zero at corners without one.
    corner_normals: Vec<DVec3>,
    /// Unit normals, one a face; zero where a face has no area.
    normals: Vec<DVec3>,
    /// The faces around vertex `v` are `around[around_starts[v]..around_starts[v + 1]]`.
    around_starts: Vec<u32>,
    around: Vec<u32>,
}

impl Mesh {
    /// Welds vertices at exactly one place. Corners of a face that repeat the one before are dropped, and so are faces
    /// with fewer than three corners left.
    ///
    /// `faces` index `positions`; `uvs`, where not empty, has one entry a corner in the order of `faces`.
    pub fn new(
        positions: &[DVec3],
        faces: impl IntoIterator<Item = impl AsRef<[u32]>>,
        uvs: &[DVec2],
    ) -> Self {
        Mesh::with_normals(positions, faces, uvs, &[])
    }

    /// The same with unit normals of the corners, in the order of `faces`; zero at corners without one.
    pub fn with_normals(
        positions: &[DVec3],
        faces: impl IntoIterator<Item = impl AsRef<[u32]>>,
        uvs: &[DVec2],
        normals: &[DVec3],
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
            for &index in face.as_ref() {
                let vertex = welded[index as usize];
                if mesh.corners[start..].last() != Some(&vertex) {
                    mesh.corners.push(vertex);
                    mesh.uvs.extend(uvs.get(corner));
                    mesh.corner_normals.extend(normals.get(corner));
                }
                corner += 1;
            }
            let closed = mesh.corners.len() - start > 1
                && mesh.corners[start..].last() == Some(&mesh.corners[start]);
            let end = mesh.corners.len() - usize::from(closed);
            let end = if end - start < 3 { start } else { end };
            mesh.corners.truncate(end);
            mesh.uvs.truncate(end);
            mesh.corner_normals.truncate(end);
            if end > start {
                mesh.starts.push(end as u32);
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

    /// Whether its corners have texture coordinates.
    pub fn has_uvs(&self) -> bool {
        !self.uvs.is_empty()
    }

    /// Texture coordinates of a face, a pair a corner; empty where the mesh has none.
    pub fn face_uvs(&self, face: usize) -> &[DVec2] {
        if self.uvs.is_empty() {
            &[]
        } else {
            &self.uvs[self.starts[face] as usize..self.starts[face + 1] as usize]
        }
    }

    /// How many corners stand before those of a face, in the order of the faces; of the number of faces, how many there are.
    pub fn corners_before(&self, face: usize) -> usize {
        self.starts.get(face).map_or(0, |&start| start as usize)
    }

    /// The unit normals that its corners were given, zero at corners without one; empty where the mesh has none.
    pub fn face_normals(&self, face: usize) -> &[DVec3] {
        if self.corner_normals.is_empty() {
            &[]
        } else {
            &self.corner_normals[self.starts[face] as usize..self.starts[face + 1] as usize]
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

    /// A face that passes a vertex twice, as one with a hole cut into it does, stands there once.
    fn index_faces_around(&mut self) {
        const NONE: u32 = u32::MAX;
        let mut starts = vec![0_u32; self.positions.len() + 1];
        let mut last = vec![NONE; self.positions.len()];
        let mut around = Vec::new();
        for counting in [true, false] {
            last.fill(NONE);
            let mut next = starts.clone();
            for face in 0..self.face_count() as u32 {
                for &vertex in self.face(face as usize) {
                    let vertex = vertex as usize;
                    if std::mem::replace(&mut last[vertex], face) == face {
                        continue;
                    }
                    if counting {
                        starts[vertex + 1] += 1;
                    } else {
                        around[next[vertex] as usize] = face;
                        next[vertex] += 1;
                    }
                }
            }
            if counting {
                for vertex in 1..starts.len() {
                    starts[vertex] += starts[vertex - 1];
                }
                around = vec![NONE; starts[self.positions.len()] as usize];
            }
        }
        (self.around_starts, self.around) = (starts, around);
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
    fn a_face_may_come_back_to_a_vertex() {
        // A square with a triangular hole, joined to the rim by a bridge from corner 0 to corner 4
        let positions = [
            [0.0, 0.0],
            [9.0, 0.0],
            [9.0, 9.0],
            [0.0, 9.0],
            [2.0, 2.0],
            [2.0, 5.0],
            [5.0, 2.0],
        ]
        .map(|[x, y]| DVec3::new(x, y, 0.0));
        let mesh = Mesh::new(&positions, [[0, 1, 2, 3, 0, 4, 5, 6, 4]], &[]);
        assert_eq!(mesh.face(0), [0, 1, 2, 3, 0, 4, 5, 6, 4]);
        assert_eq!(mesh.faces_around(0), [0]);
        assert_eq!(mesh.faces_around(4), [0]);
    }

    #[test]
    fn corners_repeated_in_a_row_are_dropped_with_their_texture_coordinates() {
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
