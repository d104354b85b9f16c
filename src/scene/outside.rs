//! Objects that no pixel can show.

use super::{Object, Shape, View};
use glam::DVec3;

impl View {
    /// Whether an object lies outside the picture entirely: on the far side of one of the planes through the eye and a border of the
    /// picture, or behind the eye. An object that is not outside may still be hidden, or pass by a corner.
    pub fn leaves_out(&self, object: &Object) -> bool {
        let Some((points, radius)) = hull(&object.shape) else {
            return false;
        };
        let points: Vec<DVec3> = points.iter().map(|&point| self.to_camera(point)).collect();
        let half = [self.width, self.height].map(|side| 0.5 * f64::from(side) / self.focal);
        let borders = [
            DVec3::new(1.0, 0.0, half[0]),
            DVec3::new(-1.0, 0.0, half[0]),
            DVec3::new(0.0, 1.0, half[1]),
            DVec3::new(0.0, -1.0, half[1]),
            DVec3::Z,
        ];
        borders.into_iter().any(|inward| {
            let inward = inward.normalize();
            points.iter().all(|point| point.dot(inward) + radius < 0.0)
        })
    }
}

/// Points such that balls of a radius about them have a convex hull around the shape; none where it has no end.
fn hull(shape: &Shape) -> Option<(Vec<DVec3>, f64)> {
    match shape {
        Shape::Sphere { center, radius } => Some((vec![*center], *radius)),
        Shape::Plane { .. } => None,
        Shape::Polygon { vertices } => Some((vertices.clone(), 0.0)),
        Shape::Cylinder {
            base,
            axis,
            radius,
            height,
            ..
        } => Some((vec![*base, *base + *height * *axis], *radius)),
        Shape::Bezier { patches, .. } => Some((patches.iter().flatten().copied().collect(), 0.0)),
        Shape::Mesh(mesh) => {
            let vertices = 0..mesh.vertex_count() as u32;
            Some((vertices.map(|vertex| mesh.position(vertex)).collect(), 0.0))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Camera;

    #[test]
    fn what_lies_beside_or_behind_is_outside_and_what_a_border_cuts_is_not() {
        let camera = Camera {
            eye: DVec3::ZERO,
            target: DVec3::NEG_Z,
            up: DVec3::Y,
            fov_x: std::f64::consts::FRAC_PI_2,
        };
        let view = View::new(&camera, 200, 100);
        let outside = |x: f64, y: f64, z: f64| {
            let center = DVec3::new(x, y, z);
            let ball = Shape::Sphere {
                center,
                radius: 0.5,
            };
            view.leaves_out(&Object::new("ball", 0, ball))
        };
        // At a distance of 4 the picture is 8 wide and 4 high; its side planes are at 45° and at 26.6°.
        assert!(!outside(0.0, 0.0, -4.0) && !outside(4.6, 0.0, -4.0) && !outside(0.0, -2.5, -4.0));
        assert!(outside(4.8, 0.0, -4.0) && outside(-4.8, 0.0, -4.0));
        assert!(outside(0.0, 2.7, -4.0) && outside(0.0, -2.7, -4.0) && outside(0.0, 0.0, 0.6));
        // A plane has no end, and a wall may surround the whole picture.
        let plane = Shape::Plane {
            point: DVec3::Z,
            normal: DVec3::Z,
        };
        assert!(!view.leaves_out(&Object::new("plane", 0, plane)));
        let wall =
            [[-9., -9.], [9., -9.], [9., 9.], [-9., 9.]].map(|[x, y]| DVec3::new(x, y, -1.0));
        let vertices = wall.to_vec();
        assert!(!view.leaves_out(&Object::new("wall", 0, Shape::Polygon { vertices })));
    }
}
