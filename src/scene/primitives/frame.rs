//! The unit box of a hierarchy, in which everything fits f32 whatever the scene's unit is.

use super::Ray;
use glam::{DVec3, Vec3};

/// A cube around something finite, and the way from world coordinates to [−1, 1]³.
#[derive(Clone, Copy, Debug)]
pub(super) struct Frame {
    center: DVec3,
    /// Half an edge.
    half: f64,
    /// A power of two, so that scaling is exact; `half·scale` is in (0.5, 1].
    scale: f64,
}

/// A ray with its origin near a box.
#[derive(Clone, Copy, Debug)]
pub(super) struct Near {
    pub ray: Ray,
    /// How far the origin was moved along the ray.
    pub moved: f64,
}

impl Near {
    /// A distance along the ray as it was, along the ray as it is now; rounded up.
    pub fn reach(&self, distance: f64) -> f64 {
        distance - self.moved + 4.0 * f64::EPSILON * self.moved
    }
}

/// How many half edges from the centre, along an axis, an origin may be.
const FAR: f64 = 4.0;

impl Frame {
    pub fn around(low: DVec3, high: DVec3) -> Self {
        const SMALLEST: f64 = 1e-290;
        let center = 0.5 * low + 0.5 * high;
        let half = (high - center).max(center - low).max_element();
        let half = (half * (1.0 + 4.0 * f64::EPSILON)).max(SMALLEST);
        const SIGN_AND_EXPONENT: u64 = 0xfff << 52;
        Frame {
            center,
            half,
            scale: f64::from_bits((1.0 / half).to_bits() & SIGN_AND_EXPONENT),
        }
    }

    /// The ray as it comes near: as it is, unless its origin is far away for this box. Then the origin is moved along it to where
    /// what follows is exact at the scale of the box. None for a ray that passes by at a distance.
    ///
    /// Every test of a primitive takes this ray, with a hierarchy or without, so that both see the same bits.
    pub fn near(&self, ray: &Ray) -> Option<Near> {
        let from_center = ray.origin - self.center;
        let is_near = |from_center: DVec3| from_center.abs().max_element() <= FAR * self.half;
        if is_near(from_center) {
            return Some(Near {
                ray: *ray,
                moved: 0.0,
            });
        }
        // The box is within √3 of its centre; moved to 3 ahead of the point nearest to the centre, a ray that can meet it is
        // within √(3 + 9) < 4.
        let moved = -from_center.dot(ray.direction) - 3.0 * self.half;
        let origin = ray.at(moved);
        (moved > 0.0 && is_near(origin - self.center)).then_some(Near {
            ray: Ray { origin, ..*ray },
            moved,
        })
    }

    /// A point in this frame.
    pub fn unit_point(&self, point: DVec3) -> Vec3 {
        ((point - self.center) * self.scale).as_vec3()
    }

    /// A length that is lost in the margins around boxes.
    pub fn sliver(&self) -> f64 {
        self.half / f64::from(1 << 24)
    }

    /// A length in this frame.
    pub fn unit_length(&self, length: f64) -> f32 {
        (length * self.scale) as f32
    }
}
