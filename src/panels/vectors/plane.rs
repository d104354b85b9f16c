//! The plane in which the vectors at a point are drawn, and how the pointer turns one of them in it.

use crate::replay::VectorPlane;
use crate::scene::Movable;
use glam::{DVec3, Vec2};

/// How near the pointer must be to the tip of a vector, in points.
const REACH: f32 = 14.0;

/// A vector toward something that can be moved.
pub struct Tip {
    pub held: Movable,
    pub distance: f64,
    /// Unit.
    pub direction: DVec3,
    /// Of its arrow, in units of the plane.
    pub length: f32,
}

/// A plane as it is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane {
    pub vectors: VectorPlane,
    /// Where its point is drawn.
    pub middle: Vec2,
    /// Length of a unit vector.
    pub unit: f32,
}

impl Plane {
    /// y down. What leans out of the plane is shortened.
    pub fn project(&self, vector: DVec3) -> Vec2 {
        self.vectors.project(vector)
    }

    /// The tip of a vector that is seen as `along`. Below the surface there may be room for a part of its length only.
    pub fn tip(&self, along: Vec2, below: f32) -> Vec2 {
        let below = below.max(1.0);
        let part = (below / (self.unit * along.y).max(below)).min(1.0);
        self.middle + self.unit * part * along
    }

    /// By how many degrees an arrow that points to `at` is turned from the normal: clockwise, from −180 to 180.
    pub fn degrees_toward(&self, at: Vec2) -> f64 {
        let toward = (at - self.middle).as_dvec2();
        toward.x.atan2(-toward.y).to_degrees()
    }

    /// The vector whose tip is at the pointer.
    pub fn grip(&self, tips: &[Tip], at: Vec2) -> Option<PlaneGrip> {
        let away = |tip: &Tip| {
            let place = self.middle + tip.length * self.unit * self.project(tip.direction);
            place.distance(at)
        };
        let near = tips.iter().filter(|tip| away(tip) <= REACH);
        let tip = near.min_by(|a, b| away(a).total_cmp(&away(b)))?;
        let across = self.vectors.across();
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
    pub held: Movable,
    distance: f64,
    /// The part of the unit vector that is across the plane.
    out: DVec3,
}

impl PlaneGrip {
    /// Where the light or the eye is once the pointer is at `at`: as far from the point as it was.
    pub fn position(&self, at: Vec2) -> DVec3 {
        let Plane { vectors, .. } = self.plane;
        let inside = vectors.direction(self.plane.degrees_toward(at));
        let share = (1.0 - self.out.length_squared()).max(0.0).sqrt();
        vectors.point + self.distance * (self.out + share * inside)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_vector_turns_in_the_plane_and_keeps_length_and_lean() {
        let point = DVec3::new(1.0, 2.0, 3.0);
        let plane = Plane {
            vectors: VectorPlane::new(point, DVec3::Y, DVec3::new(1.0, 1.0, 0.0)),
            middle: Vec2::ZERO,
            unit: 100.0,
        };
        let direction = DVec3::new(0.48, 0.64, 0.6);
        let tip = Tip {
            held: Movable::Light(2),
            distance: 5.0,
            direction,
            length: 1.0,
        };
        let tips = [tip];
        assert!(plane.grip(&tips, Vec2::new(48.0, -40.0)).is_none());
        let grip = plane.grip(&tips, Vec2::new(50.0, -60.0)).unwrap();
        assert_eq!(grip.held, Movable::Light(2));
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
