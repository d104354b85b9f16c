//! Spheres, and the visible balls of lights.

use super::error::gamma;
use super::{Ray, Surface};
use crate::numeric::sphere_roots;
use glam::{DVec2, DVec3};
use std::f64::consts::{PI, TAU};

/// The nearest t > 0 at which a ray meets a ball's surface, from outside or inside.
pub fn meet_ball(center: DVec3, radius: f64, ray: &Ray) -> Option<f64> {
    let from_center = ray.origin - center;
    sphere_roots(from_center.to_array(), ray.direction.to_array(), radius)?
        .into_iter()
        .find(|&t| t > 0.0)
}

/// The surface at a point that is on the sphere but for rounding: the point is moved along its radius onto it.
///
/// The error has a part for the position, and one for the next ray's test, which takes the origin's distance from the sphere out of
/// f·f − r²: eight roundings of values about r².
pub(super) fn surface(center: DVec3, radius: f64, near: DVec3) -> Surface {
    let normal = ((near - center) / radius).normalize_or(DVec3::Y);
    let position = center + radius * normal;
    Surface {
        position,
        normal,
        error: gamma(4) * (position.abs() + center.abs()) + gamma(24) * radius * normal.abs(),
    }
}

/// u = longitude/2π, from the z axis toward the x axis; v = latitude/π, from the north pole (+y) down. Both in [0, 1].
pub(super) fn uv(center: DVec3, position: DVec3) -> DVec2 {
    let outward = (position - center).normalize_or(DVec3::Y);
    let longitude = outward.x.atan2(outward.z).rem_euclid(TAU);
    // The angle from the y axis by its tangent, which keeps its digits near the poles.
    let latitude = outward.x.hypot(outward.z).atan2(outward.y);
    DVec2::new(longitude / TAU, latitude / PI)
}
