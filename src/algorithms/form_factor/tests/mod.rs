//! Form factors against closed forms, against each other, and against the laws of closed scenes.

mod closed_forms;
mod coincident;
mod ends;
mod occluded;
mod pairs;
mod scenes;
mod strings;

use super::hemicube::Hemicubes;
use super::*;
use glam::DVec3;

/// A planar convex polygon.
fn polygon(corners: &[DVec3]) -> Polygon<'_> {
    let normal = (1..corners.len() - 1)
        .map(|k| (corners[k] - corners[0]).cross(corners[k + 1] - corners[0]))
        .sum::<DVec3>()
        .normalize();
    Polygon::new(corners.into(), normal).unwrap()
}

fn parallelogram(origin: DVec3, along: DVec3, across: DVec3) -> [DVec3; 4] {
    [
        origin,
        origin + along,
        origin + along + across,
        origin + across,
    ]
}

/// F from the first polygon to the second.
fn automatic(i: &[DVec3], j: &[DVec3], tolerance: f64) -> f64 {
    let (i, j) = (polygon(i), polygon(j));
    let area = i.area;
    facing(i, j).map_or(0.0, |[i, j]| {
        auto::exchange(&i, &j, tolerance, &mut 0, &mut Unrecorded) / area
    })
}
