use super::{Mesh, Scene, Shape};
#[derive(Clone, Debug)]
pub struct Tessellation {
    pub meshes: Vec<Mesh>,
    first: Vec<usize>,
}
impl Tessellation {
    pub fn of(scene: &Scene) -> Self {
        let meshes: Vec<Mesh> = scene
            .objects
            .iter()
            .map(|o| match &o.shape {
                Shape::Polygon { vertices } => Mesh::new(
                    vertices,
                    [(0..vertices.len() as u32).collect::<Vec<_>>()],
                    &[],
                ),
                Shape::Mesh(mesh) => mesh.clone(),
                _ => Mesh::default(),
            })
            .collect();
        let mut first = vec![0];
        for m in &meshes {
            first.push(first[first.len() - 1] + m.face_count());
        }
        Self { meshes, first }
    }
    pub fn polygon_count(&self) -> usize {
        *self.first.last().unwrap()
    }
    pub fn locate(&self, polygon: usize) -> Option<(usize, usize)> {
        if polygon >= self.polygon_count() {
            return None;
        }
        let object = self.first.partition_point(|&f| f <= polygon) - 1;
        Some((object, polygon - self.first[object]))
    }
}
