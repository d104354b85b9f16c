//! Polygons with the boxes that hold them.

use super::polygon::Polygon;
use glam::DVec3;

/// A convex polygon, and the box that holds it.
#[derive(Clone, Debug)]
pub struct Sheet {
    pub polygon: Polygon<'static>,
    pub low: DVec3,
    pub high: DVec3,
}

impl Sheet {
    pub fn new(polygon: Polygon<'static>) -> Sheet {
        let corners = || polygon.corners.iter().copied();
        Sheet {
            low: corners().fold(DVec3::INFINITY, DVec3::min),
            high: corners().fold(DVec3::NEG_INFINITY, DVec3::max),
            polygon,
        }
    }

    /// Whether their boxes are no farther apart than `slack`.
    pub fn is_near(&self, other: &Sheet, slack: f64) -> bool {
        (self.low.cmple(other.high + slack) & self.high.cmpge(other.low - slack)).all()
    }

    /// Whether they lie in one plane and look at opposite sides.
    pub fn is_opposite(&self, other: &Sheet, slack: f64) -> bool {
        let [a, b] = [&self.polygon, &other.polygon];
        let height = |corner: &DVec3| a.normal.dot(*corner - a.corners[0]).abs();
        a.normal.dot(b.normal) < -0.5 && b.corners.iter().all(|corner| height(corner) <= slack)
    }
}
