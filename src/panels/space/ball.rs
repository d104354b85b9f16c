//! A sphere as a ray meets it: its outline is where it turns away from the viewer, divided finely enough to look round at the
//! size at which it is seen.

use crate::figure::Space;
use glam::DVec3;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// How far a side of the outline may run inside the true one, in points.
const FLATTENED: f64 = 0.1;
/// Sides of the outline, at least and at most.
const SIDES: [f64; 2] = [24.0, 240.0];
/// Sides of the outline for each ring of faces between its middle and its edge.
const SIDES_A_RING: usize = 8;

pub(super) struct Ball {
    center: DVec3,
    radius: f64,
    /// Unit, from the centre to the viewer, and two across it.
    axes: [DVec3; 3],
    /// Between the viewer and the outline, seen from the centre.
    reach: f64,
    sides: usize,
}

impl Ball {
    /// None where the viewer stands in the sphere or it reaches behind the viewer.
    pub fn seen(space: &Space, center: DVec3, radius: f64) -> Option<Self> {
        let scale = f64::from(space.scale() * space.seen(center)?.scale);
        let (toward, reach) = match space.distance {
            None => (space.toward, FRAC_PI_2),
            Some(distance) => {
                let viewer = space.pivot + distance * space.toward - center;
                if viewer.dot(space.toward) <= radius {
                    return None;
                }
                (viewer.normalize(), (radius / viewer.length()).acos())
            }
        };
        let (right, up) = toward.any_orthonormal_pair();
        let sides = PI * (scale * radius / (2.0 * FLATTENED)).sqrt();
        Some(Ball {
            center,
            radius,
            axes: [toward, right, up],
            reach,
            sides: sides.clamp(SIDES[0], SIDES[1]).ceil() as usize,
        })
    }

    /// Unit, to a point of the surface: `from_viewer` away from the middle of what is seen, and `side` sides around it.
    fn normal(&self, from_viewer: f64, side: usize) -> DVec3 {
        let [toward, right, up] = self.axes;
        let around = TAU * side as f64 / self.sides as f64;
        let across = around.cos() * right + around.sin() * up;
        from_viewer.cos() * toward + from_viewer.sin() * across
    }

    fn place(&self, normal: DVec3) -> DVec3 {
        self.center + self.radius * normal
    }

    /// The sides of the outline.
    pub fn outline(&self) -> Vec<[DVec3; 2]> {
        let corner = |side| self.place(self.normal(self.reach, side));
        let sides = 0..self.sides;
        sides.map(|side| [corner(side), corner(side + 1)]).collect()
    }

    /// The corners of each face, and the normals there: of the side that the viewer sees, or of the one that it hides.
    pub fn faces(&self, hidden: bool) -> Vec<([DVec3; 4], [DVec3; 4])> {
        let rings = self.sides / SIDES_A_RING;
        let from = if hidden { PI } else { 0.0 };
        let at = |ring: usize| from + (self.reach - from) * ring as f64 / rings as f64;
        let face = |ring: usize, side: usize| {
            let [inner, outer] = [at(ring), at(ring + 1)];
            let normals = [
                (inner, side),
                (outer, side),
                (outer, side + 1),
                (inner, side + 1),
            ];
            let normals = normals.map(|(from_viewer, side)| self.normal(from_viewer, side));
            (normals.map(|normal| self.place(normal)), normals)
        };
        let rings = 0..rings;
        rings
            .flat_map(|ring| (0..self.sides).map(move |side| face(ring, side)))
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::Fit;
    use crate::picture::Rect;
    use glam::{DVec2, Vec2};

    fn space(distance: Option<f64>, scale: f64) -> Space {
        let area = Rect::new(0.0, 0.0, 1200.0, 900.0);
        Space {
            right: DVec3::X,
            up: DVec3::Y,
            toward: DVec3::Z,
            pivot: DVec3::ZERO,
            distance,
            fit: Fit::centered(DVec2::ZERO, scale, area),
            area,
        }
    }

    #[test]
    fn the_outline_is_round_within_a_fraction_of_a_point_at_every_size() {
        for scale in [4.0, 60.0, 420.0] {
            let space = space(None, scale);
            let ball = Ball::seen(&space, DVec3::ZERO, 1.0).unwrap();
            let middle = space.place(DVec3::ZERO).unwrap();
            for side in ball.outline() {
                let [from, to] = side.map(|end| space.place(end).unwrap());
                let off = |at: Vec2| (at.distance(middle) - scale as f32).abs();
                assert!(off(from) < 1e-3 && off(from.midpoint(to)) < 0.11, "{scale}");
            }
        }
    }

    /// A line from the viewer touches the sphere where it is at right angles to the radius.
    #[test]
    fn in_perspective_the_outline_is_where_lines_of_sight_touch() {
        let space = space(Some(5.0), 100.0);
        let center = DVec3::new(0.7, -0.4, 1.0);
        let ball = Ball::seen(&space, center, 0.8).unwrap();
        for [corner, _] in ball.outline() {
            let sight = corner - DVec3::new(0.0, 0.0, 5.0);
            assert!(sight.dot(corner - center).abs() < 1e-9);
        }
    }

    #[test]
    fn the_faces_end_at_the_outline_and_their_corners_lie_on_the_sphere() {
        let space = space(Some(5.0), 100.0);
        let viewer = DVec3::new(0.0, 0.0, 5.0);
        let ball = Ball::seen(&space, DVec3::X, 0.8).unwrap();
        for hidden in [false, true] {
            for (corners, normals) in ball.faces(hidden) {
                for (corner, normal) in corners.into_iter().zip(normals) {
                    assert!((corner - DVec3::X - 0.8 * normal).length() < 1e-12);
                    let facing = normal.dot(viewer - corner);
                    assert!(if hidden {
                        facing < 1e-9
                    } else {
                        facing > -1e-9
                    });
                }
            }
        }
    }

    #[test]
    fn from_inside_there_is_no_outline() {
        let space = space(Some(5.0), 100.0);
        assert!(Ball::seen(&space, DVec3::new(0.0, 0.0, 4.8), 0.5).is_none());
    }
}
