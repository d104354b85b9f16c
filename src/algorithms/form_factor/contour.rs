//! The double contour integral.
//!
//! A_i F_ij = 1/2π ∮∮ ln r dx·dy around both patches (Stokes; Sparrow 1963, "A new and simpler formulation for radiative angle factors",
//! Journal of Heat Transfer 85.2). Of every two edges the integral along the longer is exact, that along the shorter is by Gauss points on
//! parts whose length falls off toward where the integrand is singular. Of edges on one line both are exact, be they apart, touching or
//! one: ∫∫ ln|s − t| over one edge of length L is L² ln L − 3L²/2. Edges at right angles exchange nothing.

use super::Event;
use super::gauss::{gauss, points_needed};
use super::polygon::Polygon;
use crate::record::{Listing, Recorder};
use glam::DVec3;
use std::f64::consts::TAU;

pub static PSEUDOCODE: Listing = Listing {
    name: "contour",
    lines: &[
        ("", "contour(i, j)"),
        ("", "  {for-each-edge-of-i-with-direction-e}"),
        ("", "    {for-each-edge-of-j-with-direction-f}"),
        (
            "",
            "      I ← ∫∫ ln r ds dt:  {exact-along-s-else-by-gauss-points}",
        ),
        ("edge-pair", "      A_i F_ij ← A_i F_ij + e·f I / 2π"),
    ],
};

/// Edges whose distance from one line is below this share of their extent lie on it.
const ON_LINE: f64 = 4e-15;

/// The most parts of an edge. Toward a singularity their length falls off by four, so few are needed unless rounding hides the end.
const MOST_PARTS: usize = 2048;

/// The most Gauss points on one part of an edge.
const POINTS_A_PART: f64 = 12.0;

/// A_i F_ij with an error of about `error`. Each polygon lies in front of the other.
pub fn exchange<R: Recorder<Event>>(i: &Polygon, j: &Polygon, error: f64, recorder: &mut R) -> f64 {
    // Seen from the middle, in units of the extent: as edges close up, the logarithm of the unit cancels, and rounding is least.
    let origin = 0.5 * (i.center + j.center);
    let unit = i.center.distance(j.center).max(i.radius).max(j.radius);
    let local = |[from, to]: [DVec3; 2]| Edge::new((from - origin) / unit, (to - origin) / unit);
    let error = TAU * error / (unit * unit) / (i.corners.len() * j.corners.len()) as f64;
    let mut sum = 0.0;
    for (edge_i, number_i) in i.edges().map(local).zip(0..) {
        for (edge_j, number_j) in j.edges().map(local).zip(0..) {
            let cosine = edge_i.direction.dot(edge_j.direction);
            let (integral, way) = if cosine == 0.0 {
                (0.0, "at right angles")
            } else {
                edge_i.with(&edge_j, error / cosine.abs())
            };
            sum += cosine * integral / TAU;
            recorder.step(|| Event::EdgePair {
                edges: [number_i, number_j],
                cosine,
                way,
                integral,
                sum: sum * unit * unit,
            });
        }
    }
    (sum * unit * unit).max(0.0)
}

/// `from + t·direction`, 0 ≤ t ≤ `length`.
#[derive(Clone, Copy, Debug)]
struct Edge {
    from: DVec3,
    /// Unit.
    direction: DVec3,
    length: f64,
}

impl Edge {
    fn new(from: DVec3, to: DVec3) -> Self {
        let length = from.distance(to);
        Edge {
            from,
            direction: (to - from) / length.max(f64::MIN_POSITIVE),
            length,
        }
    }

    /// ∫∫ ln r ds dt along both edges, and how it was found.
    fn with(&self, other: &Edge, error: f64) -> (f64, &'static str) {
        let (outer, inner) = if self.length <= other.length {
            (self, other)
        } else {
            (other, self)
        };
        let [start, end] = [outer.from, outer.from + outer.length * outer.direction]
            .map(|point| (point - inner.from).dot(inner.direction));
        let off_line = inner
            .off_line(outer.from)
            .max(inner.off_line(outer.from + outer.length * outer.direction));
        if off_line <= ON_LINE {
            return (on_one_line([start, end], inner.length), "on one line");
        }
        (inner.along(outer, error), "by Gauss points")
    }

    fn off_line(&self, point: DVec3) -> f64 {
        (point - self.from).cross(self.direction).length()
    }

    /// ∫ ln |p − q(s)| ds along this edge, exactly: of the antiderivative u ln r − u + h atan(u/h), with h the distance from the line and
    /// u the way along it.
    #[inline]
    fn logarithm(&self, p: DVec3) -> f64 {
        let w = p - self.from;
        let u = w.dot(self.direction);
        let (u1, u2) = (-u, self.length - u);
        let h = w.cross(self.direction).length();
        let h2 = h * h;
        let term = |u: f64| {
            let r2 = u * u + h2;
            if r2 > 0.0 { 0.5 * u * r2.ln() } else { 0.0 }
        };
        term(u2) - term(u1) - self.length + h * (h * self.length).atan2(h2 + u1 * u2)
    }

    /// ∫ of [`Self::logarithm`] along `outer`.
    fn along(&self, outer: &Edge, error: f64) -> f64 {
        let singular = self.singularities(outer);
        let size = self.length.max(1e-300);
        let mut parts = [[0.0; 2]; 64];
        parts[0] = [0.0, outer.length];
        let mut waiting = 1;
        let mut count = 0;
        let mut sum = 0.0;
        while waiting > 0 {
            waiting -= 1;
            count += 1;
            let [start, end] = parts[waiting];
            let (middle, half) = (0.5 * (start + end), 0.5 * (end - start));
            let nearest = singular
                .iter()
                .map(|z| (z.ellipse(middle, half), z))
                .min_by(|a, b| a.0.total_cmp(&b.0));
            let (sigma, z) = match nearest {
                Some((sigma, z)) => (sigma, *z),
                None => (f64::INFINITY, Singularity::default()),
            };
            let points = points_needed(sigma, error / (size * half));
            // What is left out next to a singularity u ln u shrinks with the square of the part.
            let is_negligible = half * half * 0.02 <= error;
            let is_last = waiting + 2 > parts.len() || count >= MOST_PARTS;
            if points <= POINTS_A_PART || is_negligible || is_last {
                let n = points.min(POINTS_A_PART) as usize;
                let along: f64 = gauss(n)
                    .iter()
                    .map(|&[t, weight]| {
                        let t = start + t * (end - start);
                        weight * self.logarithm(outer.from + t * outer.direction)
                    })
                    .sum();
                sum += (end - start) * along;
                continue;
            }
            let split = z.split(start, end);
            // The part next to the singularity comes first, so that few are waiting.
            parts[waiting] = [start, split];
            parts[waiting + 1] = [split, end];
            if (z.re - start).abs() < (end - z.re).abs() {
                parts.swap(waiting, waiting + 1);
            }
            waiting += 2;
        }
        sum
    }

    /// Where the integral along this edge is singular, as a function of the way along `outer`: at distance 0 from an end of the edge, or
    /// from its line. Each with its conjugate.
    fn singularities(&self, outer: &Edge) -> [Singularity; 3] {
        let at = |q: DVec3| {
            let w = q - outer.from;
            Singularity {
                re: w.dot(outer.direction),
                im: w.cross(outer.direction).length(),
            }
        };
        let across = outer.direction.cross(self.direction);
        let sine2 = across.length_squared();
        let w = self.from - outer.from;
        let of_lines = if sine2 > 0.0 {
            Singularity {
                re: w.cross(self.direction).dot(across) / sine2,
                im: w.dot(across).abs() / sine2,
            }
        } else {
            Singularity {
                re: 0.0,
                im: f64::INFINITY,
            }
        };
        [
            at(self.from),
            at(self.from + self.length * self.direction),
            of_lines,
        ]
    }
}

/// A point `re ± i·im` of the complex plane of t.
#[derive(Clone, Copy, Debug, Default)]
struct Singularity {
    re: f64,
    im: f64,
}

impl Singularity {
    /// The sum of the semi-axes of the ellipse through it with foci at the ends of an interval, in units of its half.
    #[inline]
    fn ellipse(&self, middle: f64, half: f64) -> f64 {
        let (x, y) = ((self.re - middle) / half, self.im / half);
        if !(x.is_finite() && y.is_finite()) {
            return f64::INFINITY;
        }
        let y2 = y * y;
        let a = 0.5 * (((x + 1.0) * (x + 1.0) + y2).sqrt() + ((x - 1.0) * (x - 1.0) + y2).sqrt());
        a + (a * a - 1.0).max(0.0).sqrt()
    }

    /// Where to divide an interval that is too near: across from the singularity, or a quarter away from the end that is nearest to it.
    fn split(&self, start: f64, end: f64) -> f64 {
        let quarter = 0.25 * (end - start);
        let past = 1e-3 * quarter;
        if self.re <= start + past {
            start + quarter
        } else if self.re >= end - past {
            end - quarter
        } else {
            self.re
        }
    }
}

/// ∫∫ ln|s − t| over 0 ≤ s ≤ `length` and t between `start` and `end`: differences of −φ, φ(u) = u² ln|u| / 2 − 3u²/4.
fn on_one_line([start, end]: [f64; 2], length: f64) -> f64 {
    let phi = |u: f64| {
        let u2 = u * u;
        if u2 > 0.0 {
            u2 * (0.25 * u2.ln() - 0.75)
        } else {
            0.0
        }
    };
    let along = phi(end) - phi(start) + phi(length - start) - phi(length - end);
    if end < start { -along } else { along }
}
