//! Rays, and how one leaves a surface without meeting it again.

use super::Surface;
use super::error::gamma;
use glam::DVec3;

/// A half line. Points on it are `origin + t·direction`, t > 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    pub origin: DVec3,
    /// Unit, so that t is a distance.
    pub direction: DVec3,
}

impl Ray {
    pub fn at(&self, t: f64) -> DVec3 {
        self.origin + t * self.direction
    }
}

/// The ray that leaves a surface in `direction` (unit), to whichever side that points.
///
/// Its origin is the surface's position moved along the normal until it is past the error of the position, then on to the
/// next number: so it is on the right side of the surface, and cannot meet it where it stands. (Pharr, Jakob & Humphreys
/// 2016, Physically Based Rendering, §3.9.5.)
pub fn leaving(surface: &Surface, direction: DVec3) -> Ray {
    let distance = surface.normal.abs().dot(surface.error);
    let outward = direction.dot(surface.normal) >= 0.0;
    let offset = distance
        * if outward {
            surface.normal
        } else {
            -surface.normal
        };
    let away = |moved: f64, offset: f64| match offset {
        offset if offset > 0.0 => moved.next_up(),
        offset if offset < 0.0 => moved.next_down(),
        _ => moved,
    };
    let moved = surface.position + offset;
    Ray {
        origin: DVec3::new(
            away(moved.x, offset.x),
            away(moved.y, offset.y),
            away(moved.z, offset.z),
        ),
        direction,
    }
}

/// How far a ray that left `surface` runs before it is at a point `distance` away, within rounding: what it
/// meets farther on does not lie between. Infinite where `distance` is.
pub fn short_of(ray: &Ray, surface: &Surface, distance: f64) -> f64 {
    // What stands at the point is met off by as much as the origin was moved, times 1/cos of the angle from its normal: up to 89°.
    const STEEPEST: f64 = 64.0;
    let moved = ray.origin.distance(surface.position);
    distance * (1.0 - STEEPEST * gamma(4)) - STEEPEST * moved
}
