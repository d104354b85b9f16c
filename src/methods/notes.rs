//! Input of a scene that has no effect when a method draws it.

use super::{Family, Method, Setup};
use crate::algorithms::{enclosure_notes, lamp_notes};
use crate::color::Rgb;
use crate::scene::patch_primitives::PatchPrimitives;
use crate::scene::patches::Patches;
use crate::scene::{Note, Object, Scene, Shape, View, body_notes, replaced};

impl Setup {
    /// What the scene says without effect, whatever the method, and then what has none when `method` draws it.
    pub fn notes(&self, method: Method) -> Vec<Note> {
        let scene = &self.prepared.scene;
        let mut notes = scene.notes.clone();
        match method.family() {
            Family::Exchange | Family::Hierarchy => {
                notes.extend(enclosure_notes::notes(scene));
                if let Ok(enclosure) = self.enclosure() {
                    let (patches, primitives) = (&enclosure.patches, &enclosure.primitives);
                    notes.extend(lamp_notes::notes(scene, patches, primitives));
                }
            }
            // What is seen in mirrors has an effect wherever it is.
            Family::Rays if method == Method::RayTracing && has_mirrors(scene) => {}
            Family::Polygons | Family::Rays => notes.extend(outside(scene, &self.prepared.view)),
        }
        if method == Method::RayTracing {
            notes.extend(body_notes(scene));
        }
        notes
    }

    /// The round shapes for which `method` draws polygons.
    pub fn replaced(&self, method: Method) -> Vec<Note> {
        let is_replaced = |shape: &Shape| {
            method.family() != Family::Rays || matches!(shape, Shape::Bezier { .. })
        };
        let by_patches = method.family().exchanges_light();
        replaced(&self.prepared.scene, method.name(), by_patches, is_replaced)
    }
}

/// In which a scene is looked at that no method was chosen for.
const SIZE: [u32; 2] = [640, 480];

/// What a scene says without effect that no method was chosen for: of radiosity, where the scene is made for it, else of its picture.
pub fn notes_of(scene: &Scene, max_patches: u64) -> Vec<Note> {
    let mut notes = scene.notes.clone();
    if is_for_radiosity(scene) {
        notes.extend(enclosure_notes::notes(scene));
        if let Ok(patches) = Patches::of(scene, max_patches) {
            let primitives = PatchPrimitives::of(scene, &patches);
            notes.extend(lamp_notes::notes(scene, &patches, &primitives));
        }
    } else if let Some(camera) = &scene.camera {
        notes.extend(outside(scene, &View::new(camera, SIZE[0], SIZE[1])));
    }
    notes.extend(body_notes(scene));
    notes.extend(replaced(scene, "each scan-line method", false, |_| true));
    notes
}

fn outside(scene: &Scene, view: &View) -> Vec<Note> {
    let objects = scene.objects.iter().enumerate();
    let outside = objects.filter(|(_, object)| view.leaves_out(object));
    let note = |(number, object): (usize, &Object)| {
        let what = format!("the object {:?}", object.name);
        let why = "it lies outside the camera's view, and is seen at most by its shadow or in a mirror, by ray tracing";
        Note::new(format_args!("objects[{number}]"), what, why)
    };
    outside.map(note).collect()
}

/// Whether a mirrored or refracted ray may leave the picture.
fn has_mirrors(scene: &Scene) -> bool {
    let mut objects = scene.objects.iter();
    objects.any(|object| {
        let material = &scene.materials[object.material];
        material.reflection != Rgb::BLACK || material.transmission != Rgb::BLACK
    })
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
