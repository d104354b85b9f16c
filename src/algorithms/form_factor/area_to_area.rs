//! The double area integral, by Gauss points on both patches.
//!
//! A_i F_ij = ∫∫ cosθ_x cosθ_y / (π r²) dA_y dA_x (Goral, Torrance, Greenberg & Battaile 1984, "Modeling the interaction of light between
//! diffuse surfaces", equation 5). Good where the distance is large against the sizes, wrong where patches touch.

use super::Event;
use super::polygon::Polygon;
use crate::record::{Listing, Recorder};
use glam::DVec3;
use std::f64::consts::PI;

pub static PSEUDOCODE: Listing = Listing {
    name: "area to area",
    lines: &[
        ("", "areaToArea(i, j)"),
        ("", "  {for-each-gauss-point-x-of-i-with-weight-w-x}"),
        ("", "    {for-each-gauss-point-y-of-j-with-weight-w-y}"),
        ("points", "      r ← y − x"),
        (
            "pair",
            "      A_i F_ij ← A_i F_ij + w_x w_y cosθ_x cosθ_y / (π r²)",
        ),
    ],
};

/// A_i F_ij at `n_i`² × `n_j`² pairs of points. Each lies in front of the other.
pub fn exchange<R: Recorder<Event>>(
    i: &Polygon,
    j: &Polygon,
    [n_i, n_j]: [usize; 2],
    recorder: &mut R,
) -> f64 {
    let mut points = Vec::new();
    j.points(n_j, |y, weight| points.push((y, weight)));
    let mut sum = 0.0;
    i.points(n_i, |x, weight_x| {
        for &(y, weight_y) in &points {
            recorder.step(|| Event::Points { x, y });
            let [cos_x, cos_y, r2] = cosines(x, i.normal, y, j.normal);
            let term = weight_x * weight_y * kernel(cos_x, cos_y, r2);
            sum += term;
            recorder.step(|| Event::Pair {
                cos_x: cos_x / r2.sqrt(),
                cos_y: cos_y / r2.sqrt(),
                r: r2.sqrt(),
                weights: [weight_x, weight_y],
                term,
                sum,
            });
        }
    });
    sum
}

/// r cosθ_x, r cosθ_y and r².
#[inline]
pub fn cosines(x: DVec3, n_x: DVec3, y: DVec3, n_y: DVec3) -> [f64; 3] {
    let r = y - x;
    [
        r.dot(n_x).max(0.0),
        (-r.dot(n_y)).max(0.0),
        r.length_squared(),
    ]
}

/// cosθ_x cosθ_y / (π r²), of what [`cosines`] gives.
#[inline]
pub fn kernel(cos_x: f64, cos_y: f64, r2: f64) -> f64 {
    if r2 > 0.0 {
        (cos_x / r2) * (cos_y / r2) / PI
    } else {
        0.0
    }
}
