//! Mesh files: what they hold, whichever format they are written in.

mod gltf_file;
mod kind;
mod lines;
mod list;
mod obj;
mod path;
mod statements;

pub use path::mesh_path_is_inside;

pub(super) use kind::misplaced;
pub(super) use path::{Format, mesh_format};

use super::Mesh;
use glam::{DAffine3, DVec2, DVec3};

/// The faces of a mesh file, each index known to be in range and each number to be finite.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshData {
    positions: Vec<DVec3>,
    /// The first is (0, 0), for corners without one.
    uvs: Vec<DVec2>,
    /// Unit vectors; the first is zero, for corners without one.
    normals: Vec<DVec3>,
    /// Face `f` has the corners `starts[f]..starts[f + 1]`: three or more.
    starts: Vec<u32>,
    /// Indices into `positions`, `uvs` and `normals`.
    corners: Vec<[u32; 3]>,
    triangles: u64,
    /// What the file says that is not used, each thing once.
    pub remarks: Vec<Remark>,
}

/// Something in a mesh file that has no effect, or was repaired.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Remark {
    pub what: String,
    pub why: &'static str,
}

impl Remark {
    pub(super) fn new(what: impl Into<String>, why: &'static str) -> Self {
        Remark {
            what: what.into(),
            why,
        }
    }
}

impl Default for MeshData {
    fn default() -> Self {
        MeshData {
            positions: Vec::new(),
            uvs: vec![DVec2::ZERO],
            normals: vec![DVec3::ZERO],
            starts: vec![0],
            corners: Vec::new(),
            triangles: 0,
            remarks: Vec::new(),
        }
    }
}

impl MeshData {
    /// Reads a mesh file.
    ///
    /// Errors: what the file is instead of a mesh, the first line or part that is wrong, no faces at all, or more than
    /// `max_triangles`, as a sentence.
    pub(super) fn read(
        bytes: &[u8],
        format: Format,
        max_triangles: u64,
    ) -> Result<MeshData, String> {
        match format {
            Format::Obj => obj::read(bytes, max_triangles),
            Format::Gltf => gltf_file::read(bytes, max_triangles),
        }
    }

    pub fn face_count(&self) -> usize {
        self.starts.len() - 1
    }

    /// Σ (corners − 2) over the faces.
    pub fn triangles(&self) -> u64 {
        self.triangles
    }

    pub fn corner_count(&self) -> usize {
        self.corners.len()
    }

    pub fn has_normals(&self) -> bool {
        self.normals.len() > 1
    }

    /// How many corners have no normal.
    pub fn corners_without_normal(&self) -> usize {
        let without = |corner: &&[u32; 3]| self.normals[corner[2] as usize] == DVec3::ZERO;
        self.corners.iter().filter(without).count()
    }

    /// The mesh in world coordinates, its vertices welded, and with the normals of its corners where wanted. `to_world` turns, moves, and
    /// scales equally in all directions.
    pub fn mesh(&self, to_world: &DAffine3, with_normals: bool) -> Mesh {
        // Positions that no face refers to are left out.
        const UNUSED: u32 = u32::MAX;
        let mut numbers = vec![UNUSED; self.positions.len()];
        let mut positions = Vec::new();
        let vertices: Vec<u32> = (self.corners.iter())
            .map(|&[position, ..]| {
                let number = &mut numbers[position as usize];
                if *number == UNUSED {
                    *number = positions.len() as u32;
                    positions.push(to_world.transform_point3(self.positions[position as usize]));
                }
                *number
            })
            .collect();
        let mut uvs = Vec::new();
        if self.corners.iter().any(|&[_, uv, _]| uv > 0) {
            uvs.extend((self.corners.iter()).map(|&[_, uv, _]| self.uvs[uv as usize]));
        }
        let mut normals = Vec::new();
        if with_normals {
            let turned = self
                .normals
                .iter()
                .map(|&normal| to_world.transform_vector3(normal));
            let turned: Vec<DVec3> = turned.map(DVec3::normalize_or_zero).collect();
            normals.extend(
                self.corners
                    .iter()
                    .map(|&[.., normal]| turned[normal as usize]),
            );
        }
        let faces = self.starts.windows(2);
        let faces = faces.map(|ends| &vertices[ends[0] as usize..ends[1] as usize]);
        Mesh::with_normals(&positions, faces, &uvs, &normals)
    }
}

#[cfg(test)]
mod tests;
