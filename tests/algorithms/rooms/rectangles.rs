//! Form factors of rectangles along the axes, in closed form: the exact reference of the rooms.
//!
//! Ehlert & Smith, "View factors for perpendicular and parallel rectangular plates", Journal of Thermophysics and Heat Transfer 7
//! (1993), equations 1 to 4.

use std::f64::consts::PI;

/// A rectangle across `axis` at a height, seen from its inside in a box.
#[derive(Clone, Copy, Debug)]
pub struct Rectangle {
    pub axis: usize,
    pub height: f64,
    /// The intervals of the two other axes, in their order.
    pub sides: [[f64; 2]; 2],
}

impl Rectangle {
    pub fn area(&self) -> f64 {
        let [a, b] = self.sides.map(|[low, high]| high - low);
        a * b
    }

    fn interval(&self, axis: usize) -> [f64; 2] {
        let others = (0..3).filter(|&other| other != self.axis);
        let mut sides = others.zip(self.sides);
        sides.find(|&(other, _)| other == axis).unwrap().1
    }
}

/// A_i F_ij of two walls, or parts of walls, of one box.
pub fn exchange(i: &Rectangle, j: &Rectangle) -> f64 {
    if i.axis == j.axis {
        let apart = (i.height - j.height).abs();
        if apart == 0.0 {
            return 0.0;
        }
        let [[x, y], [xi, eta]] = [i.sides, j.sides];
        return alternating([x, xi, y, eta], |[x, xi, y, eta]| {
            parallel(x - xi, y - eta, apart)
        });
    }
    // Along the line in which their planes meet, and away from it in each plane.
    let along = 3 - i.axis - j.axis;
    let away = |of: &Rectangle, from: &Rectangle| {
        let [a, b] = of.interval(from.axis).map(|x| (x - from.height).abs());
        [a.min(b), a.max(b)]
    };
    let ends = [i.interval(along), j.interval(along), away(i, j), away(j, i)];
    alternating(ends, |[y, eta, x, xi]| perpendicular(y - eta, x, xi))
}

/// Σ over the ends of four intervals, of the sign of their number times `g`.
fn alternating(intervals: [[f64; 2]; 4], g: impl Fn([f64; 4]) -> f64) -> f64 {
    let corner = |bits: usize| {
        let is_even = bits.count_ones().is_multiple_of(2);
        let sign = if is_even { 1.0 } else { -1.0 };
        sign * g(std::array::from_fn(|k| intervals[k][bits >> k & 1]))
    };
    (0..16).map(corner).sum()
}

fn parallel(u: f64, v: f64, z: f64) -> f64 {
    let arctangent = |a: f64, b: f64| {
        let root = (b * b + z * z).sqrt();
        a * root * (a / root).atan()
    };
    let logarithm = 0.5 * z * z * (u * u + v * v + z * z).ln();
    (arctangent(v, u) + arctangent(u, v) - logarithm) / (2.0 * PI)
}

fn perpendicular(y: f64, x: f64, xi: f64) -> f64 {
    let square = x * x + xi * xi;
    let root = square.sqrt();
    let arctangent = if root > 0.0 {
        y * root * (y / root).atan()
    } else {
        0.0
    };
    let whole = square + y * y;
    let logarithm = if whole > 0.0 {
        0.25 * (square - y * y) * whole.ln()
    } else {
        0.0
    };
    (arctangent - logarithm) / (2.0 * PI)
}

#[test]
fn the_closed_forms_know_the_unit_cube() {
    let face = |axis, height| Rectangle {
        axis,
        height,
        sides: [[0.0, 1.0]; 2],
    };
    let opposite = exchange(&face(0, 0.0), &face(0, 1.0));
    let adjacent = exchange(&face(0, 1.0), &face(2, 0.0));
    assert!(
        (opposite - 0.199_824_895_698_387_38).abs() < 1e-14,
        "{opposite}"
    );
    assert!(
        (adjacent - 0.200_043_776_075_403_15).abs() < 1e-14,
        "{adjacent}"
    );
}
