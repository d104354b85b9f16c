//! Transparent surfaces that have no inside, or show it: what rays make of them.

use super::primitives::Winding;
use super::tessellation::mesh_of;
use super::{Mesh, Note, Object, Scene, Shape};
use crate::color::Rgb;

/// A note on every transparent object that is not a body with its faces outward.
pub fn body_notes(scene: &Scene) -> Vec<Note> {
    let objects = scene.objects.iter().enumerate();
    let transparent = objects.filter(|(_, object)| {
        let material = &scene.materials[object.material];
        material.transmission != Rgb::BLACK
    });
    let note = |(number, object): (usize, &Object)| {
        let (what, why) = finding(object)?;
        Some(Note::new(format_args!("objects[{number}]"), what, why))
    };
    transparent.filter_map(note).collect()
}

const PANE: &str =
    "it is taken for a thin pane: rays go through it undeviated, and enter no medium";

fn finding(object: &Object) -> Option<(String, String)> {
    let open = |what: &str| Some((format!("a transparent {what}"), PANE.into()));
    match &object.shape {
        Shape::Sphere { .. } | Shape::Cylinder { capped: true, .. } => None,
        Shape::Cylinder { capped: false, .. } => open("cylinder without ends"),
        Shape::Plane { .. } => open("plane"),
        Shape::Polygon { .. } => open("polygon"),
        Shape::Bezier { .. } => of_mesh(&mesh_of(&object.shape, object.divisions)),
        Shape::Mesh(mesh) => of_mesh(mesh),
    }
}

fn of_mesh(mesh: &Mesh) -> Option<(String, String)> {
    match Winding::of(mesh) {
        Winding::Open { edge } => {
            let [from, to] = edge.map(|vertex| mesh.position(vertex).to_array());
            let what = format!(
                "a transparent surface that is not closed at the edge from {from:?} to {to:?}"
            );
            Some((what, PANE.into()))
        }
        Winding::Closed { turned } => {
            let (count, all) = (
                turned.iter().filter(|&&turned| turned).count(),
                turned.len(),
            );
            let what = match count {
                0 => return None,
                _ if count == all => "a closed surface wound inward".into(),
                _ => format!("a closed surface with {count} of its {all} faces wound inward"),
            };
            Some((
                what,
                "rays take these faces turned, so that they look outward".into(),
            ))
        }
    }
}
