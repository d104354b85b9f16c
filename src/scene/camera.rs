//! The camera, and its projection to pixels.

use glam::{DVec2, DVec3};

/// A perspective camera: eye, target, up, and the whole horizontal angle in radians, in (0, π).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    pub eye: DVec3,
    pub target: DVec3,
    pub up: DVec3,
    pub fov_x: f64,
}

/// A camera in front of a picture of `width`×`height` square pixels.
///
/// Camera frame: x to the right, y up, z (called depth, the `w` of homogeneous coordinates) forward.
/// Screen frame: pixels, x to the right, y down, (0, 0) the top left corner of the top left pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    pub eye: DVec3,
    /// Unit.
    pub right: DVec3,
    /// Unit; the up' of the contract.
    pub up: DVec3,
    /// Unit.
    pub forward: DVec3,
    /// Distance from the eye to the picture, in pixels.
    pub focal: f64,
    pub width: u32,
    pub height: u32,
    /// Depth of the near plane: 10⁻⁶ until it is set by what stands nearest to the eye.
    pub near: f64,
}

impl View {
    pub fn new(camera: &Camera, width: u32, height: u32) -> Self {
        let to_target = camera.target - camera.eye;
        let forward = to_target.normalize();
        let right = forward.cross(camera.up).normalize();
        View {
            eye: camera.eye,
            right,
            up: right.cross(forward),
            forward,
            focal: 0.5 * f64::from(width) / (0.5 * camera.fov_x).tan(),
            width,
            height,
            near: 1e-6,
        }
    }

    /// A point of the world in the camera frame.
    pub fn to_camera(&self, point: DVec3) -> DVec3 {
        let d = point - self.eye;
        DVec3::new(d.dot(self.right), d.dot(self.up), d.dot(self.forward))
    }

    /// A point of the camera frame, of positive depth, on the screen.
    pub fn to_screen(&self, point: DVec3) -> DVec2 {
        let scale = self.focal / point.z;
        DVec2::new(
            0.5 * f64::from(self.width) + scale * point.x,
            0.5 * f64::from(self.height) - scale * point.y,
        )
    }

    /// The point of the world at that depth that stands at a place of the screen.
    pub fn from_screen(&self, screen: DVec2, depth: f64) -> DVec3 {
        let scale = depth / self.focal;
        let x = scale * (screen.x - 0.5 * f64::from(self.width));
        let y = scale * (0.5 * f64::from(self.height) - screen.y);
        self.eye + (x * self.right + y * self.up + depth * self.forward)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_field_of_view_spans_the_width() {
        let camera = Camera {
            eye: DVec3::new(0.0, 0.0, -2.0),
            target: DVec3::ZERO,
            up: DVec3::Y,
            fov_x: std::f64::consts::FRAC_PI_2,
        };
        let view = View::new(&camera, 64, 48);
        // Looking along +z with y up, x points to the left of the picture.
        assert!(view.right.distance(DVec3::NEG_X) < 1e-15);
        let corner = view.to_screen(view.to_camera(DVec3::new(-2.0, 1.5, 0.0)));
        assert!(corner.distance(DVec2::new(64.0, 0.0)) < 1e-12);
        assert_eq!(
            view.to_screen(view.to_camera(DVec3::ZERO)),
            DVec2::new(32.0, 24.0)
        );
    }

    #[test]
    fn a_point_is_found_again_from_its_place_on_the_screen_and_its_depth() {
        let camera = Camera {
            eye: DVec3::new(3.0, -1.0, 2.0),
            target: DVec3::new(0.5, 0.2, -4.0),
            up: DVec3::new(0.1, 1.0, 0.3),
            fov_x: 0.9,
        };
        let view = View::new(&camera, 640, 480);
        for point in [[0.0, 0.0, 0.0], [-3.0, 2.0, -9.0], [2.9, -1.2, 1.0]].map(DVec3::from) {
            let seen = view.to_camera(point);
            let found = view.from_screen(view.to_screen(seen), seen.z);
            assert!(found.distance(point) < 1e-14 * point.distance(camera.eye).max(10.0));
        }
    }
}
