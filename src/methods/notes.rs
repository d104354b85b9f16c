//! Input of a scene that has no effect when a method draws it.

use super::{Family, Method, Setup};
use crate::algorithms::enclosure_notes;
use crate::scene::{Note, Object, Scene, Shape};

impl Setup {
    /// What the scene says without effect, whatever the method, and then what has none when `method` draws it.
    pub fn notes(&self, method: Method) -> Vec<Note> {
        let scene = &self.prepared.scene;
        let mut notes = scene.notes.clone();
        match method.family() {
            Family::Exchange => notes.extend(enclosure_notes::notes(scene)),
            Family::Polygons | Family::Rays => {}
        }
        notes
    }
}

/// What a scene says without effect that no method was chosen for: of radiosity too, where the scene is made for it.
pub fn notes_of(scene: &Scene) -> Vec<Note> {
    let mut notes = scene.notes.clone();
    if is_for_radiosity(scene) {
        notes.extend(enclosure_notes::notes(scene));
    }
    notes
}

/// Whether it has what only radiosity reads: objects that are divided into patches, or a reflectance of its own.
fn is_for_radiosity(scene: &Scene) -> bool {
    let is_divided = |object: &Object| match object.shape {
        Shape::Sphere { .. } => object.patches != Object::SPHERE_PATCHES,
        _ => object.patches != [1, 1],
    };
    let reflects = |object: &Object| {
        let material = &scene.materials[object.material];
        let diffuse = material.diffuse.channels();
        material.reflectance.channels() != diffuse.map(|k_d| k_d.min(1.0))
    };
    let mut objects = scene.objects.iter();
    objects.any(|object| is_divided(object) || reflects(object))
}
