//! What polygons exchange where nothing is in the way, and what a point sees of one.

use lightwalk::algorithms::form_factor::gauss::gauss;
use std::f64::consts::TAU;

type Point = [f64; 3];

fn minus(a: Point, b: Point) -> Point {
    std::array::from_fn(|k| a[k] - b[k])
}

fn dot(a: Point, b: Point) -> f64 {
    (0..3).map(|k| a[k] * b[k]).sum()
}

fn cross(a: Point, b: Point) -> Point {
    std::array::from_fn(|k| a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3])
}

fn edges(corners: &[Point]) -> impl Iterator<Item = [Point; 2]> {
    (0..corners.len()).map(|k| [corners[k], corners[(k + 1) % corners.len()]])
}

pub fn area(corners: &[Point]) -> f64 {
    let of = |[from, to]: [Point; 2]| cross(minus(from, corners[0]), minus(to, corners[0]));
    let sum = edges(corners).map(of).fold([0.0; 3], |sum, part| {
        std::array::from_fn(|k| sum[k] + part[k])
    });
    0.5 * dot(sum, sum).sqrt()
}

/// Parts of an edge, and Gauss points in each, of the contour integral.
const PARTS: usize = 12;
const POINTS: usize = 8;

fn points([from, to]: [Point; 2]) -> impl Iterator<Item = (Point, f64)> {
    let along = minus(to, from);
    (0..PARTS).flat_map(move |part| {
        gauss(POINTS).iter().map(move |&[t, weight]| {
            let t = (part as f64 + t) / PARTS as f64;
            let at = std::array::from_fn(|k| from[k] + t * along[k]);
            (at, weight / PARTS as f64)
        })
    })
}

/// A_i F_ij of polygons that do not touch and lie in front of each other: 1/2π ∮∮ ln r dx·dy (Sparrow 1963).
pub fn exchange(i: &[Point], j: &[Point]) -> f64 {
    let mut sum = 0.0;
    for a in edges(i) {
        for b in edges(j) {
            let cosine = dot(minus(a[1], a[0]), minus(b[1], b[0]));
            for (x, weight_x) in points(a) {
                for (y, weight_y) in points(b) {
                    let r = minus(x, y);
                    sum += 0.5 * cosine * weight_x * weight_y * dot(r, r).ln();
                }
            }
        }
    }
    sum / TAU
}

/// F from an element at `x` with the unit normal `n` to a polygon above its horizon that shows it its front (Lambert 1760).
pub fn from_point(x: Point, n: Point, corners: &[Point]) -> f64 {
    let term = |[from, to]: [Point; 2]| {
        let [from, to] = [minus(from, x), minus(to, x)];
        let normal = cross(to, from);
        let sine = dot(normal, normal).sqrt();
        match sine > 0.0 {
            true => dot(n, normal) / sine * sine.atan2(dot(from, to)),
            false => 0.0,
        }
    };
    edges(corners).map(term).sum::<f64>() / TAU
}

/// The mean of `f` over intervals that follow each other, each in `parts` parts.
pub fn mean(ends: &[f64], parts: usize, f: impl Fn(f64) -> f64) -> f64 {
    let mut sum = 0.0;
    for ends in ends.windows(2) {
        let width = (ends[1] - ends[0]) / parts as f64;
        for part in 0..parts {
            for &[t, weight] in gauss(4) {
                sum += weight * width * f(ends[0] + (part as f64 + t) * width);
            }
        }
    }
    sum / (ends[ends.len() - 1] - ends[0])
}

#[test]
fn unit_squares_exchange_as_the_closed_form_says() {
    use super::{UNIT, floor, lid};
    let [floor, lid] = [floor(UNIT, 0.0, UNIT), lid(UNIT, 1.0, UNIT)];
    const RIGHT: f64 = 0.199_824_895_698_387_38;
    let by_contour = exchange(&floor, &lid);
    assert!((by_contour - RIGHT).abs() < 1e-13, "{by_contour}");
    let from = |x: f64| mean(&UNIT, 4, |z| from_point([x, 0.0, z], [0.0, 1.0, 0.0], &lid));
    let by_points = mean(&UNIT, 4, from);
    assert!((by_points - RIGHT).abs() < 1e-10, "{by_points}");
    assert!((area(&floor) - 1.0).abs() < 1e-15);
}
