//! What is computed once per vertex of an object, for all the polygons that share it.

use super::prepared_scene::Polygon;

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
    /// The value at a vertex of the polygon's object, none as long as it is not computed. Objects come one after another.
    pub fn at(&mut self, polygon: &Polygon, vertex: u32) -> &mut Option<V> {
        if self.object != Some(polygon.object) {
            self.object = Some(polygon.object);
            self.values.clear();
            self.values.resize(polygon.mesh.vertex_count(), None);
        }
        &mut self.values[vertex as usize]
    }
}
