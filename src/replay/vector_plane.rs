//! The plane in which the directions at a point of a surface are seen: the normal is up, and what leans out of the plane is
//! shortened. Where a ray meets the surface it is the plane of incidence, with u from left to right; at a point of a polygon that
//! of N and V, with V to the right.

use super::Run;
use crate::record::Value;
use glam::{DVec2, DVec3, Vec2};

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VectorPlane {
    pub point: DVec3,
    /// Unit: N_geometric of rays, N of polygons.
    pub normal: DVec3,
    /// Unit, along the surface, to the right.
    pub along: DVec3,
}

impl VectorPlane {
    /// The plane in which `right` lies, which leans to the right.
    pub fn new(point: DVec3, normal: DVec3, right: DVec3) -> Self {
        let along = (right - right.dot(normal) * normal).try_normalize();
        VectorPlane {
            point,
            normal,
            // Where it is the normal itself, every plane will do.
            along: along.unwrap_or_else(|| normal.any_orthonormal_vector()),
        }
    }

    /// At the surface that `step` of a run is about. None where it is about no surface.
    pub fn at(run: &Run, step: usize) -> Option<Self> {
        let walk = run.walk();
        let vector = |step: usize, name: &str| match walk.own_fields(step).get(name) {
            Some(Value::Vector(vector)) => Some(vector),
            _ => None,
        };
        let around = |step: usize, kind: &str| {
            let mut scopes = std::iter::once(step).chain(walk.outline().scopes(step));
            scopes.find(|&scope| walk.kind(scope) == kind)
        };
        if run.rays().is_none() {
            let point = around(step, "Illumination")?;
            let (position, normal) = (vector(point, "P")?, vector(point, "N")?);
            let to_eye = run.prepared().view.eye - position;
            return Some(VectorPlane::new(position, normal, to_eye));
        }
        // Rays that this one has sent on meet surfaces of their own.
        let ray = around(step, "Ray")?;
        let is_its =
            |step: &usize| walk.kind(*step) == "SurfaceMet" && around(*step, "Ray") == Some(ray);
        let met = (ray..=step).find(is_its)?;
        Some(VectorPlane::new(
            vector(met, "P")?,
            vector(met, "N_geometric")?,
            vector(ray, "u")?,
        ))
    }

    /// A direction as it is drawn, y down.
    pub fn project(&self, direction: DVec3) -> Vec2 {
        let [x, y] = [self.along, -self.normal].map(|axis| direction.dot(axis) as f32);
        Vec2::new(x, y)
    }

    /// A unit direction across the plane, out of it.
    pub fn across(&self) -> DVec3 {
        self.along.cross(self.normal)
    }

    /// By how many degrees a direction is turned from the normal as it is drawn: clockwise, from −180 to 180.
    pub fn degrees(&self, direction: DVec3) -> f64 {
        let [right, up] = [self.along, self.normal].map(|axis| direction.dot(axis));
        right.atan2(up).to_degrees()
    }

    /// The unit direction in the plane that is turned by so many degrees from the normal.
    pub fn direction(&self, degrees: f64) -> DVec3 {
        let DVec2 { x: up, y: right } = DVec2::from_angle(degrees.to_radians());
        right * self.along + up * self.normal
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn degrees_count_clockwise_from_the_normal() {
        let right = DVec3::new(3.0, 5.0, 0.0);
        let plane = VectorPlane::new(DVec3::ZERO, DVec3::Y, right);
        for (direction, degrees) in [
            (DVec3::Y, 0.0),
            (DVec3::X, 90.0),
            (DVec3::NEG_X, -90.0),
            (DVec3::new(1.0, -1.0, 0.0).normalize(), 135.0),
        ] {
            assert!((plane.degrees(direction) - degrees).abs() < 1e-12);
            assert!(plane.direction(degrees).distance(direction) < 1e-12);
        }
        // What leans out of the plane is seen in it.
        let leaning = DVec3::new(1.0, 1.0, 7.0);
        assert!((plane.degrees(leaning) - 45.0).abs() < 1e-12);
        assert_eq!(plane.project(leaning), Vec2::new(1.0, -1.0));
    }

    #[test]
    fn along_the_normal_there_still_is_a_plane() {
        let plane = VectorPlane::new(DVec3::ZERO, DVec3::Z, DVec3::NEG_Z);
        assert!(plane.along.is_normalized() && plane.along.dot(DVec3::Z).abs() < 1e-12);
    }
}
