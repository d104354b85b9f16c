//! Vertex normals weighted by the areas of the faces, where the mean is meant to be unweighted.

use crate::algorithms::prepared_scene::PreparedScene;
use crate::scene::{Mesh, Scene, Shape, VertexNormals};
use glam::DVec3;

/// The scene with such normals, in place of those that are averaged over all faces around a vertex. Textured objects without texture
/// coordinates of their own keep theirs.
pub fn weighted_by_area(prepared: &PreparedScene) -> Scene {
    let mut scene = prepared.scene.clone();
    let materials = &scene.materials;
    for (object, mesh) in scene.objects.iter_mut().zip(&prepared.tessellation.meshes) {
        let is_textured = materials[object.material].texture.is_some();
        let keeps_texture = !is_textured || mesh.has_uvs();
        let is_divided = !matches!(object.shape, Shape::Plane { .. });
        if object.vertex_normals == VertexNormals::AVERAGED && keeps_texture && is_divided {
            object.shape = Shape::Mesh(with_weighted_normals(mesh));
            object.vertex_normals = VertexNormals::File;
        }
    }
    scene
}

fn with_weighted_normals(mesh: &Mesh) -> Mesh {
    let points: Vec<DVec3> = (0..mesh.vertex_count() as u32)
        .map(|vertex| mesh.position(vertex))
        .collect();
    let faces = || (0..mesh.face_count()).map(|face| mesh.face(face));
    let uvs: Vec<_> = (0..mesh.face_count())
        .flat_map(|face| mesh.face_uvs(face).iter().copied())
        .collect();
    let normal = |&vertex: &u32| {
        let around = mesh.faces_around(vertex).iter();
        let weighted = around.map(|&face| area(mesh, face as usize) * mesh.normal(face as usize));
        weighted.sum::<DVec3>().normalize_or_zero()
    };
    let normals: Vec<DVec3> = faces().flatten().map(normal).collect();
    Mesh::with_normals(&points, faces(), &uvs, &normals)
}

pub fn area(mesh: &Mesh, face: usize) -> f64 {
    let corners: Vec<DVec3> = mesh
        .face(face)
        .iter()
        .map(|&vertex| mesh.position(vertex))
        .collect();
    let from_first = |corner: DVec3| corner - corners[0];
    let pieces = corners.windows(2).skip(1);
    let sum: DVec3 = pieces
        .map(|pair| from_first(pair[0]).cross(from_first(pair[1])))
        .sum();
    0.5 * sum.length()
}
