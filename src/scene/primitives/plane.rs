//! Infinite planes.

use super::error::gamma;
use super::{ChartPart, Ray, Surface};
use glam::{DVec2, DVec3};

/// The plane through `point` across the unit vector `normal`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Plane {
    pub point: DVec3,
    pub normal: DVec3,
}

impl Plane {
    /// The t > 0 at which a ray meets the plane; none for a ray along it.
    pub fn meet(&self, ray: &Ray) -> Option<f64> {
        let t = (self.point - ray.origin).dot(self.normal) / ray.direction.dot(self.normal);
        (t > 0.0 && t.is_finite()).then_some(t)
    }

    /// The surface at a point that is on the plane but for rounding: the point is moved along the normal onto it.
    pub fn surface(&self, near: DVec3) -> Surface {
        let position = near - (near - self.point).dot(self.normal) * self.normal;
        Surface {
            position,
            normal: self.normal,
            error: gamma(12) * (position.abs() + self.point.abs()),
        }
    }

    /// Lengths from `point` along the two coordinate axes that the normal leans to least, taken in the order x, y, z and laid into
    /// the plane: x and z on a floor, x and y on a wall across z, y and z on a wall across x.
    pub fn uv(&self, position: DVec3) -> DVec2 {
        let from_point = position - self.point;
        self.axes().map(|axis| from_point.dot(axis)).into()
    }

    pub fn chart_part(&self) -> ChartPart {
        ChartPart::Plane {
            point: self.point,
            axes: self.axes(),
        }
    }

    /// The directions, unit, along which u and v are lengths.
    fn axes(&self) -> [DVec3; 2] {
        let lean = self.normal.abs();
        let (first, second) = if lean.y >= lean.x && lean.y >= lean.z {
            (DVec3::X, DVec3::Z)
        } else if lean.z >= lean.x {
            (DVec3::X, DVec3::Y)
        } else {
            (DVec3::Y, DVec3::Z)
        };
        let along_u = first.reject_from_normalized(self.normal).normalize();
        let along_v = along_u.cross(self.normal);
        [along_u, along_v * along_v.dot(second).signum()]
    }
}
