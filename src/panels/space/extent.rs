//! How much room a scene takes, and how a view is fitted around it.

use super::orbit::target;
use crate::algorithms::prepared_scene::PreparedScene;
use crate::scene::{Light, Shape};
use glam::{DVec2, DVec3};

/// By how much a side of the view moves out for lights beyond it, in sizes of the view. There are few such places, so that the
/// view stays as it is while a light is moved a little; lights further out are not shown in their place.
const GROWTH: [f64; 5] = [0.15, 0.4, 0.7, 1.1, 1.6];

/// The part of a view that shows `shown`, and `lights` where they are not too far outside; low and high.
pub(super) fn around(shown: &[DVec2], lights: &[DVec2]) -> [DVec2; 2] {
    let nothing = [DVec2::INFINITY, DVec2::NEG_INFINITY];
    let [low, high] = shown.iter().fold(nothing, |[low, high], &place| {
        [low.min(place), high.max(place)]
    });
    let size = (high - low).max_element();
    let farthest = DVec2::splat(GROWTH[GROWTH.len() - 1] * size);
    let [mut shown_low, mut shown_high] = [low, high];
    for &light in lights {
        if light.cmplt(low - farthest).any() || light.cmpgt(high + farthest).any() {
            continue;
        }
        shown_low = shown_low.min(low - (low - light).map(|beyond| grown(beyond, size)));
        shown_high = shown_high.max(high + (light - high).map(|beyond| grown(beyond, size)));
    }
    [shown_low, shown_high]
}

/// By how much a side moves out for a light so far beyond it.
fn grown(beyond: f64, size: f64) -> f64 {
    let growth = GROWTH.into_iter().map(|growth| growth * size);
    let enough = growth.into_iter().find(|&growth| growth >= beyond);
    enough.filter(|_| beyond > 0.0).unwrap_or(0.0)
}

/// Corners of the room that eye, target and finite objects take, cut off `reach` times the distance from eye to target
/// around the target.
pub(super) fn objects(prepared: &PreparedScene, reach: f64) -> Vec<DVec3> {
    let eye = prepared.view.eye;
    let target = target(prepared);
    let reach = DVec3::splat(reach * eye.distance(target));
    let mut places = vec![eye, target];
    for (object, mesh) in prepared
        .scene
        .objects
        .iter()
        .zip(&prepared.tessellation.meshes)
    {
        let [low, high] = match &object.shape {
            Shape::Sphere { center, radius } => [*center - *radius, *center + *radius],
            Shape::Plane { .. } => continue,
            _ => bounds((0..mesh.vertex_count() as u32).map(|vertex| mesh.position(vertex))),
        };
        let (low, high) = (low.max(target - reach), high.min(target + reach));
        if low.cmple(high).all() {
            places.extend([low, high]);
            // All corners: the view's axes are not those of the world.
            for corner in 1..7 {
                let mask = DVec3::new(
                    f64::from(corner & 1),
                    f64::from(corner >> 1 & 1),
                    f64::from(corner >> 2),
                );
                places.push(low + mask * (high - low));
            }
        }
    }
    places
}

/// The corners of the box around points; without any, the low one lies above the high one.
pub(super) fn bounds(points: impl IntoIterator<Item = DVec3>) -> [DVec3; 2] {
    let nothing = [DVec3::INFINITY, DVec3::NEG_INFINITY];
    let points = points.into_iter();
    points.fold(nothing, |[low, high], point| {
        [low.min(point), high.max(point)]
    })
}

/// Where the point lights are.
pub(super) fn lights(prepared: &PreparedScene) -> Vec<DVec3> {
    let positions = prepared
        .scene
        .lights
        .iter()
        .filter_map(|light| match *light {
            Light::Point { position, .. } => Some(position),
            Light::Directional { .. } => None,
        });
    positions.collect()
}
