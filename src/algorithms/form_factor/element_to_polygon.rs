//! From a differential element to a polygon, exactly, and its mean over a patch.
//!
//! F(dA, polygon) = 1/2π Σ_k N·Γ_k over the polygon's edges, Γ_k as long as the angle that the edge spans seen from dA, and normal to
//! the plane through dA and the edge (Lambert 1760; Baum, Rushmeier & Winget 1989, "Improving radiosity solutions through the use of
//! analytically determined form-factors", equation 8). The mean over the patch is taken at Gauss points.

use super::Event;
use super::polygon::Polygon;
use crate::record::{Listing, Recorder};
use glam::DVec3;
use std::f64::consts::TAU;

pub static PSEUDOCODE: Listing = Listing {
    name: "element to polygon",
    lines: &[
        ("", "elementToPolygon(i, j)"),
        ("element", "  {for-each-gauss-point-x-of-i-with-weight-w}"),
        ("", "    {for-each-edge-of-j-seen-from-x}"),
        ("edge", "      Γ_k ← {angle-between-r-k-and-the-next}"),
        ("edge-added", "      F_x ← F_x + N_i·Γ_k / 2π"),
        ("element-seen", "    A_i F_ij ← A_i F_ij + w F_x"),
    ],
};

/// A_i F_ij, at n × n Gauss points of `i`. Each lies in front of the other. `elements` counts those of the whole form factor.
pub fn exchange<R: Recorder<Event>>(
    i: &Polygon,
    j: &Polygon,
    n: usize,
    elements: &mut u32,
    recorder: &mut R,
) -> f64 {
    let mut sum = 0.0;
    i.points(n, |x, weight| {
        let element = *elements;
        *elements = element.wrapping_add(1);
        recorder.enter(|| Event::Element { element, x, weight });
        let f = from_element(x, i.normal, j, recorder);
        sum += weight * f;
        recorder.leave(|| Event::ElementSeen { f, sum });
    });
    sum
}

/// F from an element at `x` with the unit normal `n` to a polygon wholly above its horizon.
#[inline]
fn from_element<R: Recorder<Event>>(x: DVec3, n: DVec3, j: &Polygon, recorder: &mut R) -> f64 {
    let mut sum = 0.0;
    let corners = &*j.corners;
    let mut before = corners[corners.len() - 1];
    for (&corner, number) in corners.iter().zip(0..) {
        let (from, edge) = (before - x, corner - before);
        // R_k × R_k+1 = R_k × (R_k+1 − R_k), where less is lost of a short edge.
        let normal = edge.cross(from);
        let sine = normal.length();
        let angle = sine.atan2(from.dot(corner - x));
        recorder.step(|| Event::Edge {
            edge: number,
            from: before,
            to: corner,
            angle,
        });
        // An edge that points at x, or through it, spans no area.
        let term = if sine > 0.0 {
            n.dot(normal) * (angle / sine) / TAU
        } else {
            0.0
        };
        sum += term;
        recorder.step(|| Event::EdgeAdded { term, sum });
        before = corner;
    }
    sum.max(0.0)
}

/// A_i F_ij to about `tolerance`, however near the two are: the parts of `i` where the sums at three and at four Gauss points differ
/// are halved across their longest edge, as far as rounding lets the sums agree. `elements` counts as in [`exchange`].
pub fn adaptive_exchange<R: Recorder<Event>>(
    i: &Polygon,
    j: &Polygon,
    tolerance: f64,
    elements: &mut u32,
    recorder: &mut R,
) -> f64 {
    const DEEPEST: u32 = 60;
    // Two rules may agree by chance on a part that is too large to be seen through.
    const SHALLOWEST: u32 = 6;
    // Depth alone bounds nothing: there are 2^depth parts.
    const MOST_PARTS: usize = 1 << 14;
    // What the edges of a polygon around the element leave of 1/2 when they cancel.
    const ROUNDING: f64 = 16.0 * f64::EPSILON;
    let mut count = 0;
    let first = i.corners[0];
    let mut parts: Vec<([DVec3; 3], u32)> = i.corners[1..]
        .windows(2)
        .map(|pair| ([first, pair[0], pair[1]], 0))
        .collect();
    // Every part is held to a share of what is known of the sum so far, and all are positive.
    let mut whole = exchange(i, j, 3, elements, recorder);
    let mut sum = 0.0;
    while let Some((corners, depth)) = parts.pop() {
        let Some(part) = Polygon::new(corners.as_slice().into(), i.normal) else {
            continue;
        };
        let coarse = exchange(&part, j, 3, elements, recorder);
        let fine = exchange(&part, j, 4, elements, recorder);
        let share = (part.area / i.area).sqrt();
        count += 1;
        let difference = (fine - coarse).abs();
        let is_exact =
            difference <= 0.1 * tolerance * whole * share || difference <= ROUNDING * part.area;
        if (is_exact && depth >= SHALLOWEST) || depth == DEEPEST || count >= MOST_PARTS {
            sum += fine;
            whole = whole.max(sum);
            continue;
        }
        let length = |k: usize| corners[k].distance_squared(corners[(k + 1) % 3]);
        let longest = (0..3).fold(0, |best, k| if length(k) > length(best) { k } else { best });
        let [a, b, c] = [0, 1, 2].map(|k| corners[(longest + k) % 3]);
        let middle = 0.5 * (a + b);
        parts.push(([middle, b, c], depth + 1));
        parts.push(([a, middle, c], depth + 1));
    }
    sum
}
