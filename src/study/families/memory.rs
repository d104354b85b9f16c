//! Bytes of the structures that a run needs, counted from their sizes and numbers; what an allocator adds is not counted.

use crate::algorithms::prepared_scene::{PreparedScene, PreparedVertex};
use crate::color::Rgb;
use crate::scene::Mesh;
use glam::DVec3;

/// Colour and depth of every pixel.
pub fn frame([width, height]: [u32; 2]) -> u64 {
    u64::from(width) * u64::from(height) * (size_of::<Rgb>() + size_of::<f64>()) as u64
}

/// Vertices in the world and on the screen, faces with their normals, corners, and the faces around each vertex.
pub fn polygons(prepared: &PreparedScene) -> u64 {
    let meshes = prepared.tessellation.meshes.iter();
    meshes.map(of_mesh).sum()
}

fn of_mesh(mesh: &Mesh) -> u64 {
    let corners: usize = (0..mesh.face_count())
        .map(|face| mesh.face(face).len())
        .sum();
    let vertex = size_of::<DVec3>() + size_of::<PreparedVertex>() + size_of::<u32>();
    let face = size_of::<DVec3>() + size_of::<u32>();
    // A corner, and that the face is around its vertex
    let corner = 2 * size_of::<u32>();
    (mesh.vertex_count() * vertex + mesh.face_count() * face + corners * corner) as u64
}
