//! The slopes of what is linear over a triangle.

use super::Linear;
use glam::DVec2;

/// What one unit of x, and one unit of y, adds to the linear function that has these values at the corners. Not finite where
/// the triangle has no area.
pub fn slopes<A: Linear>([a, b, c]: [DVec2; 3], values: [A; 3]) -> [A; 2] {
    let (p, q) = (b - a, c - a);
    let share = 1.0 / p.perp_dot(q);
    let (p, q) = (p * share, q * share);
    let (along_p, along_q) = (values[1].minus(values[0]), values[2].minus(values[0]));
    [
        along_p.times(q.y).minus(along_q.times(p.y)),
        along_q.times(p.x).minus(along_p.times(q.x)),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn they_lead_from_corner_to_corner() {
        let corners = [[3.0, 1.0], [11.0, 4.0], [5.0, 9.0]].map(DVec2::from);
        let values = [0.25, -1.5, 4.0];
        let slopes = DVec2::from(slopes(corners, values));
        for (corner, value) in corners.into_iter().zip(values) {
            let found = values[0] + slopes.dot(corner - corners[0]);
            assert!((found - value).abs() < 1e-14);
        }
    }

    #[test]
    fn a_triangle_without_area_has_none() {
        let line = [[3.0, 1.0], [11.0, 4.0], [11.0, 4.0]].map(DVec2::from);
        let [x, y] = slopes(line, [0.25, -1.5, 4.0]);
        assert!(!x.is_finite() && !y.is_finite());
    }
}
