//! The method by distance and contact.
//!
//! The integrands are analytic but where the two patches meet, so the error of n Gauss points falls like σ^(−2n), with σ larger the farther
//! the other patch is, in units of the half extent ([`super::gauss::points_needed`]). That says how many points each method needs,
//! and so which one is the cheapest.

use super::gauss::points_needed;
use super::polygon::Polygon;
use super::{Event, area_to_area, contour, element_to_polygon};
use crate::record::{Listing, Recorder};

pub static PSEUDOCODE: Listing = Listing {
    name: "auto",
    lines: &[
        ("", "auto(i, j)"),
        ("", "  {clip-each-to-the-front-of-the-other}"),
        ("centers", "  d ← |C_j − C_i|"),
        ("area_to_area", "  {far-area-to-area}"),
        ("element_to_polygon", "  {apart-element-to-polygon}"),
        ("contour", "  {near-or-touching-contour}"),
    ],
};

/// How much one evaluation of each kind costs, in units of one pair of points.
const SAFETY: f64 = 0.1;
const EDGE_COST: f64 = 6.0;
const CONTOUR_COST: f64 = 15.0 * 6.0;

/// A_i F_ij of two convex polygons, each in front of the other, to a relative `tolerance`. `elements` counts as in
/// [`element_to_polygon::exchange`].
pub fn exchange<R: Recorder<Event>>(
    i: &Polygon,
    j: &Polygon,
    tolerance: f64,
    elements: &mut u32,
    recorder: &mut R,
) -> f64 {
    // The smaller sees the other more evenly.
    let (small, large) = if i.area <= j.area { (i, j) } else { (j, i) };
    let distance = small.center.distance(large.center);
    let points = |receiver: &Polygon, other: &Polygon| {
        let x = (distance - other.radius) / receiver.radius;
        if x <= 1.0 {
            return f64::INFINITY;
        }
        // Low above the other's plane the cosine varies by as much as itself.
        let height = (receiver.center - other.center).dot(other.normal);
        let grazing = (height / distance).clamp(1e-9, 1.0);
        points_needed(x + (x * x - 1.0).sqrt(), SAFETY * tolerance * grazing)
    };
    let (n_small, n_large) = (points(small, large), points(large, small));
    let pairs = n_small * n_small * n_large * n_large;
    let edges = n_small * n_small * large.corners.len() as f64 * EDGE_COST;
    let contours = (small.corners.len() * large.corners.len()) as f64 * CONTOUR_COST;
    recorder.step(|| Event::Centers {
        i: i.center,
        j: j.center,
    });
    let chosen = |method, points: f64| Event::Chosen {
        method,
        distance,
        radii: [i.radius, j.radius],
        points: points as u32,
    };
    if pairs <= edges && pairs <= contours {
        recorder.step(|| chosen("area_to_area", pairs));
        let n = [n_small as usize, n_large as usize];
        return area_to_area::exchange(small, large, n, recorder);
    }
    if edges <= contours {
        recorder.step(|| chosen("element_to_polygon", n_small * n_small));
        let n = n_small as usize;
        return element_to_polygon::exchange(small, large, n, elements, recorder);
    }
    // A first idea of the sum, so that its error can be a share of it; what rounding does to the contour integral is known.
    let unrecorded = &mut crate::record::Unrecorded;
    let estimate = element_to_polygon::exchange(small, large, 2, &mut 0, unrecorded);
    let perimeters = small.radius * large.radius * 16.0;
    let rounding = 4.0 * f64::EPSILON * perimeters;
    if rounding > tolerance.max(1e-5) * estimate {
        recorder.step(|| chosen("element_to_polygon", 0.0));
        let tolerance = tolerance.max(1e-7);
        return element_to_polygon::adaptive_exchange(small, large, tolerance, elements, recorder);
    }
    recorder.step(|| chosen("contour", 0.0));
    contour::exchange(small, large, 0.2 * tolerance * estimate, recorder)
}
