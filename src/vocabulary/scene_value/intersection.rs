//! The surface that a ray is tested against, or met, in the terms of its equation.

use super::{Given, Recorded, SceneValue, number, one, value, vector};
use crate::record::Value;
use crate::scene::Light;
use crate::scene::primitives::{Part, Ray};
use glam::DVec3;

pub(super) const VALUES: &[SceneValue] = &[
    value("sphere_center", "C", |given, recorded| {
        one(sphere(given, recorded)?.0)
    }),
    value("sphere_radius", "r", |given, recorded| {
        one(sphere(given, recorded)?.1)
    }),
    value("plane_point", "A", |given, recorded| {
        one(plane(given, recorded)?[0])
    }),
    value("plane_normal", "n", |given, recorded| {
        one(plane(given, recorded)?[1])
    }),
    value("corner_a", "A", |given, recorded| {
        one(triangle(given, recorded)?.0[0])
    }),
    value("corner_b", "B", |given, recorded| {
        one(triangle(given, recorded)?.0[1])
    }),
    value("corner_c", "C", |given, recorded| {
        one(triangle(given, recorded)?.0[2])
    }),
    value("whole_face_normal", "N_{face}", |given, recorded| {
        one(triangle(given, recorded)?.1?)
    }),
    value("side_base", "B", |given, recorded| {
        one(side(given, recorded)?.0[0])
    }),
    value("side_axis", "e", |given, recorded| {
        one(side(given, recorded)?.0[1])
    }),
    value("side_radius", "r", |given, recorded| {
        one(side(given, recorded)?.1)
    }),
    value("end_base", "B", |given, recorded| {
        one(end(given, recorded)?.0[0])
    }),
    value("end_axis", "e", |given, recorded| {
        one(end(given, recorded)?.0[1])
    }),
    value("end_height", "h", |given, recorded| {
        one(end(given, recorded)?.1)
    }),
    // Outward: away from the other end.
    value("end_normal", "±e", |given, recorded| {
        let ([_, axis], height) = end(given, recorded)?;
        one(if height > 0.0 { axis } else { -axis })
    }),
    value("meets_second_root", "t_2", |given, recorded| {
        let t = number(recorded, "t")?;
        let [origin, direction] = ray(given, recorded)?;
        let (from, along, radius) = match part(given, recorded)? {
            Part::Sphere { center, radius } => (origin - center, direction, radius),
            Part::Side { base, axis, radius } => {
                let across = |vector: DVec3| vector.reject_from_normalized(axis);
                (across(origin - base), across(direction), radius)
            }
            _ => return None,
        };
        // The roots are as far to both sides of the point that is nearest to the middle.
        let nearest = -from.dot(along) / along.length_squared();
        one(radius > 0.0 && t > nearest)
    }),
];

/// Origin and direction of the ray of the step: to a light, where it looks for what is in between.
fn ray(given: Given, recorded: Recorded) -> Option<[DVec3; 2]> {
    let looks_for_light = given.own.get("blocks").is_some();
    let direction = if looks_for_light { "L" } else { "u" };
    Some([vector(recorded, "O")?, vector(recorded, direction)?])
}

/// What the step tests or met. Of an object of many parts none where all are missed.
fn part(given: Given, recorded: Recorded) -> Option<Part> {
    let primitives = given.prepared.primitives();
    let number_of = |name| match given.own.get(name)? {
        Value::Integer(number) => usize::try_from(number).ok(),
        _ => None,
    };
    let Some(object) = number_of("object") else {
        return match *given.prepared.scene.lights.get(number_of("light")?)? {
            Light::Point {
                position, radius, ..
            } => Some(Part::Sphere {
                center: position,
                radius,
            }),
            Light::Directional { .. } => None,
        };
    };
    let t = number(recorded, "t").filter(|_| given.own.get("t").is_some());
    let t = t.or_else(|| number(recorded, "NearestT"))?;
    if t.is_infinite() {
        return primitives.single_part(object);
    }
    // A surface that touches the one that the ray leaves is met before anything else.
    if t == 0.0 {
        return primitives.flat_part(object);
    }
    let triangle = triangle_met(given, object, ray(given, recorded)?, t)?;
    primitives.part(object, triangle)
}

/// The triangle of the object, or the part of it, that the ray from an origin in a direction met at t.
pub(super) fn triangle_met(
    given: Given,
    object: usize,
    [origin, direction]: [DVec3; 2],
    t: f64,
) -> Option<u32> {
    let hit = given
        .prepared
        .primitives()
        .meet(object, &Ray { origin, direction })?;
    (hit.t == t).then_some(hit.triangle)
}

fn sphere(given: Given, recorded: Recorded) -> Option<(DVec3, f64)> {
    match part(given, recorded)? {
        Part::Sphere { center, radius } => Some((center, radius)),
        _ => None,
    }
}

fn plane(given: Given, recorded: Recorded) -> Option<[DVec3; 2]> {
    match part(given, recorded)? {
        Part::Plane { point, normal } => Some([point, normal]),
        _ => None,
    }
}

fn triangle(given: Given, recorded: Recorded) -> Option<([DVec3; 3], Option<DVec3>)> {
    match part(given, recorded)? {
        Part::Triangle { corners, normal } => Some((corners, normal)),
        _ => None,
    }
}

/// Base and axis, and the radius.
fn side(given: Given, recorded: Recorded) -> Option<([DVec3; 2], f64)> {
    match part(given, recorded)? {
        Part::Side { base, axis, radius } => Some(([base, axis], radius)),
        _ => None,
    }
}

/// Base and axis, and the height.
fn end(given: Given, recorded: Recorded) -> Option<([DVec3; 2], f64)> {
    match part(given, recorded)? {
        Part::End { base, axis, height } => Some(([base, axis], height)),
        _ => None,
    }
}
