//! The light of the step.

use super::{Given, Recorded, SceneValue, index, one, value};
use crate::scene::Light;
use glam::DVec3;

pub(super) const VALUES: &[SceneValue] = &[
    value("light_position", "light", |given, recorded| {
        one(point(given, recorded)?.0)
    }),
    value("light_a_0", "a_0", |given, recorded| {
        one(point(given, recorded)?.1[0])
    }),
    value("light_a_1", "a_1", |given, recorded| {
        one(point(given, recorded)?.1[1])
    }),
    value("light_a_2", "a_2", |given, recorded| {
        one(point(given, recorded)?.1[2])
    }),
    value("light_toward", "toward", |given, recorded| {
        match *light(given, recorded)? {
            Light::Directional { toward, .. } => one(toward),
            Light::Point { .. } => None,
        }
    }),
];

fn light<'a>(given: Given<'a>, recorded: Recorded) -> Option<&'a Light> {
    let lights = &given.prepared.scene.lights;
    lights.get(index(recorded, "light")?)
}

/// Position and attenuation of a point light.
fn point(given: Given, recorded: Recorded) -> Option<(DVec3, [f64; 3])> {
    match *light(given, recorded)? {
        Light::Point {
            position,
            attenuation,
            ..
        } => Some((position, attenuation)),
        Light::Directional { .. } => None,
    }
}
