//! The plane in which the vectors at a point are drawn, and how the pointer turns one of them in it.

use glam::{DVec3, Vec2};

/// How near the pointer must be to the tip of a vector, in points.
const REACH: f32 = 14.0;

/// What can be moved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Held {
    /// By its index.
    Light(usize),
    Eye,
}

/// A vector toward something that can be moved.
pub(super) struct Tip {
    pub held: Held,
    pub distance: f64,
    /// Unit.
    pub direction: DVec3,
    /// Of its arrow, in units of the plane.
    pub length: f32,
}

/// A plane through a point and its normal, as it is drawn: the normal is up.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Plane {
    point: DVec3,
    normal: DVec3,
    /// Unit, along the surface.
    along: DVec3,
    pub middle: Vec2,
    /// Length of a unit vector.
    pub unit: f32,
}

impl Plane {
    /// The plane in which `right` lies, which leans to the right.
    pub fn new(point: DVec3, normal: DVec3, right: DVec3, middle: Vec2, unit: f32) -> Self {
        let along = (right - right.dot(normal) * normal).try_normalize();
        Plane {
            point,
            normal,
            // Where it is the normal itself, every plane will do.
            along: along.unwrap_or_else(|| normal.any_orthonormal_vector()),
            middle,
            unit,
        }
    }

    /// y down. What leans out of the plane is shortened.
    pub fn project(&self, vector: DVec3) -> Vec2 {
        Vec2::new(
            vector.dot(self.along) as f32,
            -vector.dot(self.normal) as f32,
        )
    }

    /// The vector whose tip is at the pointer.
    pub fn grip(&self, tips: &[Tip], at: Vec2) -> Option<PlaneGrip> {
        let away = |tip: &Tip| {
            let place = self.middle + tip.length * self.unit * self.project(tip.direction);
            place.distance(at)
        };
        let near = tips.iter().filter(|tip| away(tip) <= REACH);
        let tip = near.min_by(|a, b| away(a).total_cmp(&away(b)))?;
        let across = self.along.cross(self.normal);
        Some(PlaneGrip {
            plane: *self,
            held: tip.held,
            distance: tip.distance,
            out: tip.direction.dot(across) * across,
        })
    }
}

/// A vector that the pointer holds: it turns in the plane, and leans out of it as far as it did.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlaneGrip {
    plane: Plane,
    pub held: Held,
    distance: f64,
    /// The part of the unit vector that is across the plane.
    out: DVec3,
}

impl PlaneGrip {
    /// Where the light or the eye is once the pointer is at `at`: as far from the point as it was.
    pub fn position(&self, at: Vec2) -> DVec3 {
        let Plane {
            point,
            normal,
            along,
            middle,
            ..
        } = self.plane;
        let toward = (at - middle).as_dvec2().normalize_or(-glam::DVec2::Y);
        let inside = toward.x * along - toward.y * normal;
        let share = (1.0 - self.out.length_squared()).max(0.0).sqrt();
        point + self.distance * (self.out + share * inside)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_vector_turns_in_the_plane_and_keeps_length_and_lean() {
        let point = DVec3::new(1.0, 2.0, 3.0);
        let plane = Plane::new(
            point,
            DVec3::Y,
            DVec3::new(1.0, 1.0, 0.0),
            Vec2::ZERO,
            100.0,
        );
        let direction = DVec3::new(0.48, 0.64, 0.6);
        let tip = Tip {
            held: Held::Light(2),
            distance: 5.0,
            direction,
            length: 1.0,
        };
        let tips = [tip];
        assert!(plane.grip(&tips, Vec2::new(48.0, -40.0)).is_none());
        let grip = plane.grip(&tips, Vec2::new(50.0, -60.0)).unwrap();
        assert_eq!(grip.held, Held::Light(2));
        // To the left, level with the surface: 0.8 of the unit vector lies in the plane, 0.6 across it.
        let moved = grip.position(Vec2::new(-70.0, 0.0)) - point;
        assert!(
            moved.distance(5.0 * DVec3::new(-0.8, 0.0, 0.6)) < 1e-12,
            "{moved}"
        );
        // Where it was, it stays.
        let stays = grip.position(Vec2::new(48.0, -64.0)) - point;
        assert!(stays.distance(5.0 * direction) < 1e-6, "{stays}");
    }
}
