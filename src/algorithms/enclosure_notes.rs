//! What of a scene has no effect on its radiosity.

use crate::color::Rgb;
use crate::scene::{Light, Note, Scene};

/// Input that radiosity does not use, and why nothing may be lit.
pub fn notes(scene: &Scene) -> Vec<Note> {
    let mut notes = Vec::new();
    let mut emitted = scene
        .objects
        .iter()
        .map(|object| scene.materials[object.material].emission);
    if emitted.all(|emission| emission == Rgb::BLACK) {
        notes.push(Note::new(
            "objects",
            "no surface has an `emission` other than 0",
            "in radiosity light comes from `emission` alone, so that everything is black",
        ));
    }
    for (number, light) in scene.lights.iter().enumerate() {
        let kind = match light {
            Light::Point { .. } => "a point light",
            Light::Directional { .. } => "a directional light",
        };
        notes.push(Note::new(
            format_args!("lights[{number}]"),
            kind,
            "radiosity takes light from the `emission` of surfaces alone",
        ));
    }
    notes
}
