//! The true surface behind the polygon of the step.

use super::corner::polygon;
use super::{Given, Recorded, SceneValue, index, one, value, vector};
use crate::scene::Shape;
use crate::scene::primitives::is_end;
use glam::DVec3;

pub(super) const VALUES: &[SceneValue] = &[
    value("true_center", "C", |given, recorded| {
        one(sphere(given, recorded)?.0)
    }),
    value("true_radius", "r", |given, recorded| {
        one(sphere(given, recorded)?.1)
    }),
    value("true_base", "B", |given, recorded| {
        one(side(given, recorded)?.0)
    }),
    value("true_axis", "e", |given, recorded| {
        one(side(given, recorded)?.1)
    }),
    value("true_side_radius", "r", |given, recorded| {
        one(side(given, recorded)?.2)
    }),
    // Outward: away from the other end.
    value("true_end_normal", "±e", |given, recorded| {
        let Shape::Cylinder { axis, .. } = *shape(given, recorded)? else {
            return None;
        };
        let face = face_normal(given, recorded)?;
        is_end(axis, face).then(|| vec![(axis * face.dot(axis).signum()).into()])
    }),
    value("true_patches", "S", |given, recorded| {
        match shape(given, recorded)? {
            Shape::Bezier { patches, .. } => one(patches.len() as f64),
            _ => None,
        }
    }),
    value("sees_front", "front", |given, recorded| {
        let seen = vector(recorded, "P")? - given.prepared.view.eye;
        one(seen.dot(face_normal(given, recorded)?) < 0.0)
    }),
];

fn shape<'a>(given: Given<'a>, recorded: Recorded) -> Option<&'a Shape> {
    let objects = &given.prepared.scene.objects;
    Some(&objects.get(index(recorded, "object")?)?.shape)
}

fn face_normal(given: Given, recorded: Recorded) -> Option<DVec3> {
    let polygon = polygon(given, recorded)?;
    Some(polygon.mesh.normal(polygon.face))
}

/// Centre and radius.
fn sphere(given: Given, recorded: Recorded) -> Option<(DVec3, f64)> {
    match *shape(given, recorded)? {
        Shape::Sphere { center, radius } => Some((center, radius)),
        _ => None,
    }
}

/// Base, axis and radius of a cylinder, where the polygon is part of its side.
fn side(given: Given, recorded: Recorded) -> Option<(DVec3, DVec3, f64)> {
    let Shape::Cylinder {
        base, axis, radius, ..
    } = *shape(given, recorded)?
    else {
        return None;
    };
    (!is_end(axis, face_normal(given, recorded)?)).then_some((base, axis, radius))
}
