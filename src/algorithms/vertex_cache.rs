//! What is computed once per vertex of an object, for all the polygons that share it, or once per corner where each polygon has a
//! vertex normal of its own.

use super::prepared_scene::Polygon;
use crate::scene::VertexNormals;

pub struct VertexCache<V> {
    object: Option<usize>,
    values: Vec<Option<V>>,
}

impl<V> Default for VertexCache<V> {
    fn default() -> Self {
        VertexCache {
            object: None,
            values: Vec::new(),
        }
    }
}

impl<V: Clone> VertexCache<V> {
    /// The value at a corner of the polygon, none as long as it is not computed. Objects come one after another.
    pub fn at(&mut self, polygon: &Polygon, corner: usize) -> &mut Option<V> {
        let (mesh, face) = (polygon.mesh, polygon.face);
        let is_shared = polygon.vertex_normals == VertexNormals::AVERAGED;
        if self.object != Some(polygon.object) {
            self.object = Some(polygon.object);
            self.values.clear();
            let count = match is_shared {
                true => mesh.vertex_count(),
                false => mesh.corners_before(mesh.face_count()),
            };
            self.values.resize(count, None);
        }
        let index = match is_shared {
            true => mesh.face(face)[corner] as usize,
            false => mesh.corners_before(face) + corner,
        };
        &mut self.values[index]
    }
}
