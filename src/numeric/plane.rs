//! Linear functions over a triangle.

use super::Linear;
use glam::DVec2;

/// A quantity that is linear in the plane.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Plane<A> {
    pub origin: DVec2,
    pub at_origin: A,
    pub dx: A,
    pub dy: A,
}

/// A triangle of the plane, made ready for linear functions over it.
#[derive(Clone, Copy, Debug)]
pub struct Setup {
    origin: DVec2,
    /// Edges from the origin, divided by twice the area.
    p: DVec2,
    q: DVec2,
}

impl Setup {
    #[inline]
    pub fn new([a, b, c]: [DVec2; 3]) -> Self {
        let (p, q) = (b - a, c - a);
        let share = 1.0 / p.perp_dot(q);
        Setup {
            origin: a,
            p: p * share,
            q: q * share,
        }
    }

    /// The function that has these values at the corners, with its origin at the first. Its slopes are not finite where the
    /// triangle has no area.
    #[inline]
    pub fn plane<A: Linear>(&self, values: [A; 3]) -> Plane<A> {
        let (along_p, along_q) = (values[1] - values[0], values[2] - values[0]);
        Plane {
            origin: self.origin,
            at_origin: values[0],
            dx: along_p * self.q.y - along_q * self.p.y,
            dy: along_q * self.p.x - along_p * self.q.x,
        }
    }
}

impl<A: Linear> Plane<A> {
    #[inline]
    pub fn at(&self, x: f64, y: f64) -> A {
        self.at_origin + self.dx * (x - self.origin.x) + self.dy * (y - self.origin.y)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_meets_the_values_at_the_corners() {
        let corners = [[3.0, 1.0], [11.0, 4.0], [5.0, 9.0]].map(DVec2::from);
        let values = [0.25, -1.5, 4.0];
        let plane = Setup::new(corners).plane(values);
        for (corner, value) in corners.into_iter().zip(values) {
            assert!((plane.at(corner.x, corner.y) - value).abs() < 1e-14);
        }
        let line = Setup::new([corners[0], corners[1], corners[1]]).plane(values);
        assert!(!line.dx.is_finite());
    }
}
