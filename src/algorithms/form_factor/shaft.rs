//! The shaft of two patches, the convex hull of both (Haines & Wallace 1991), and where a face stands in it.

use super::faces::Face;
use super::polygon::Polygon;
use super::view::Blocker;
use glam::DVec3;

/// How a face stands between two patches.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sight {
    /// Not at all.
    Free,
    /// It hides all of one from all of the other.
    Hidden,
    /// It may hide something.
    Unclear,
}

/// The corners of two patches.
pub struct Shaft<'a> {
    of: [&'a [DVec3]; 2],
    low: DVec3,
    high: DVec3,
}

const MOST_CORNERS: usize = 16;
const MOST_CROSSINGS: usize = MOST_CORNERS * (MOST_CORNERS - 1) / 2;

impl<'a> Shaft<'a> {
    pub fn of(i: &'a [DVec3], j: &'a [DVec3]) -> Self {
        let all = || i.iter().chain(j).copied();
        Shaft {
            of: [i, j],
            low: all().fold(DVec3::INFINITY, DVec3::min),
            high: all().fold(DVec3::NEG_INFINITY, DVec3::max),
        }
    }

    /// `slack` is how far rounding may have moved a corner.
    pub fn past(&self, face: &Face, slack: f64) -> Sight {
        let apart = self.low.cmpge(face.high + slack) | self.high.cmple(face.low - slack);
        if apart.any() {
            return Sight::Free;
        }
        let [of_i, of_j] = self.of;
        let count = of_i.len() + of_j.len();
        if count > MOST_CORNERS {
            return Sight::Unclear;
        }
        let mut corners = [(DVec3::ZERO, 0.0); MOST_CORNERS];
        let (mut lowest, mut highest) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for (k, &corner) in of_i.iter().chain(of_j).enumerate() {
            let height = face.height(corner);
            corners[k] = (corner, height);
            let patch = usize::from(k >= of_i.len());
            lowest[patch] = lowest[patch].min(height);
            highest[patch] = highest[patch].max(height);
        }
        let in_front = |patch: usize| lowest[patch] >= -slack;
        let behind = |patch: usize| highest[patch] <= slack;
        if (in_front(0) && in_front(1))
            || (behind(0) && behind(1))
            || (in_front(0) && behind(0))
            || (in_front(1) && behind(1))
        {
            return Sight::Free;
        }
        // Where the plane parts the two, the shaft crosses it in the hull of the crossings from each corner of i to each of j.
        let parted = |a: usize, b: usize| lowest[a] > slack && highest[b] < -slack;
        let is_parted = parted(0, 1) || parted(1, 0);
        match count {
            ..=8 => self.at_plane::<28>(&corners[..count], face, is_parted, slack),
            _ => self.at_plane::<MOST_CROSSINGS>(&corners[..count], face, is_parted, slack),
        }
    }

    /// The same by `corners` and their heights above the plane of the face, of which no more than `N` pairs have it between them.
    fn at_plane<const N: usize>(
        &self,
        corners: &[(DVec3, f64)],
        face: &Face,
        is_parted: bool,
        slack: f64,
    ) -> Sight {
        let (first, count) = (self.of[0].len(), corners.len());
        // Where lines from corner to corner cross the plane, by axis.
        let mut crossings = [[0.0; N]; 3];
        let mut met = 0;
        for (k, &(a, height_a)) in corners.iter().enumerate() {
            let others = match is_parted {
                true if k >= first => break,
                true => first..count,
                false => k + 1..count,
            };
            for &(b, height_b) in &corners[others] {
                if (height_a > 0.0) == (height_b > 0.0) && height_a != 0.0 && height_b != 0.0 {
                    continue;
                }
                let rise = height_b - height_a;
                let share = if rise == 0.0 { 0.0 } else { -height_a / rise };
                let crossing = a + share * (b - a);
                for axis in 0..3 {
                    crossings[axis][met] = crossing[axis];
                }
                met += 1;
            }
        }
        let mut is_within = is_parted;
        let [xs, ys, zs] = crossings.each_ref().map(|axis| &axis[..met]);
        for (inward, corner) in face.inward.iter().zip(&face.outline.corners) {
            let of_corner = inward.dot(*corner);
            let (mut least, mut most) = (f64::INFINITY, f64::NEG_INFINITY);
            for ((x, y), z) in xs.iter().zip(ys).zip(zs) {
                let depth = inward.x * x + inward.y * y + inward.z * z - of_corner;
                least = if depth < least { depth } else { least };
                most = if depth > most { depth } else { most };
            }
            if most <= slack {
                return Sight::Free;
            }
            is_within &= least >= -slack;
        }
        match is_within {
            true => Sight::Hidden,
            false => Sight::Unclear,
        }
    }
}

/// How far a shadow reaches over either of two polygons in units of its size, seen from the other: of the blocker with the smallest shadow.
pub fn spreads(a: &Polygon, b: &Polygon, blockers: &[Blocker]) -> [f64; 2] {
    let mut spreads = [f64::INFINITY; 2];
    for blocker in blockers {
        let height = |polygon: &Polygon| {
            blocker
                .normal
                .dot(polygon.center - blocker.corners[0])
                .abs()
                .max(1e-3 * polygon.radius)
        };
        let ratio = (b.radius / a.radius) * (height(a) / height(b));
        spreads[0] = spreads[0].min(ratio);
        spreads[1] = spreads[1].min(1.0 / ratio);
    }
    spreads
}

/// The most blockers that lie in one plane.
pub fn most_in_a_plane(blockers: &[Blocker], slack: f64) -> usize {
    let in_plane = |plane: &Blocker| {
        let height = |at: &DVec3| plane.normal.dot(*at - plane.corners[0]).abs();
        let lies = |other: &&Blocker| other.corners.iter().all(|at| height(at) <= slack);
        blockers.iter().filter(lies).count()
    };
    blockers.iter().map(in_plane).max().unwrap_or(0)
}

/// Above so many parts a receiver is not divided further.
const MOST_PARTS: usize = 16;

/// A receiver, divided along the lines where blockers stand on it: what is seen changes at once there.
pub fn divided<'a>(receiver: Polygon<'a>, blockers: &[Blocker], slack: f64) -> Vec<Polygon<'a>> {
    let normal = receiver.normal;
    let origin = receiver.corners[0];
    let mut parts = vec![receiver];
    for blocker in blockers {
        let on = blocker
            .corners
            .iter()
            .filter(|corner| normal.dot(**corner - origin).abs() <= slack);
        if on.count() < 2 || parts.len() >= MOST_PARTS {
            continue;
        }
        let plane = |turned: f64| Polygon::plane(blocker.corners[0], turned * blocker.normal);
        parts = parts
            .into_iter()
            .flat_map(|part| {
                [1.0, -1.0].map(|turned| part.clone().in_front_of(&plane(turned), slack))
            })
            .flatten()
            .collect();
    }
    parts
}
