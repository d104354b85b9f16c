//! What an element sees of a polygon past convex blockers, exactly.
//!
//! From a point x a convex blocker hides the cone of all rays through it. The polygon is clipped by the planes through x and the blocker's
//! edges (Nishita & Nakamae 1985, "Continuous tone representation of three-dimensional objects taking account of shadows and
//! interreflection"): what lies inside all of them is hidden, and what remains is divided into convex parts for the next blocker. As all
//! planes pass through x, the light of a part is Lambert's contour sum over its edges, cut edges included.

use glam::DVec3;
use std::f64::consts::TAU;
use std::ops::Range;

/// A convex polygon that hides what is behind it, on both sides. It lies in front of the element and in front of the polygon.
#[derive(Clone, Debug)]
pub struct Blocker {
    pub corners: Vec<DVec3>,
    /// Unit.
    pub normal: DVec3,
}

impl Blocker {
    /// Whether the line through two points meets it.
    pub fn is_met(&self, from: DVec3, to: DVec3) -> bool {
        let along = to - from;
        let share = self.normal.dot(self.corners[0] - from) / self.normal.dot(along);
        let point = from + share * along;
        let next = self.corners.iter().cycle().skip(1);
        self.corners
            .iter()
            .zip(next)
            .all(|(&corner, &next)| (next - corner).cross(point - corner).dot(self.normal) >= 0.0)
    }
}

/// The working memory of a view: corners are relative to the element.
#[derive(Clone, Debug, Default)]
pub struct View {
    /// The convex parts that are still seen.
    parts: Parts,
    next: Parts,
    /// The sides of the cones that cut the polygon, one cone after the other, and where each ends.
    sides: Vec<Side>,
    cones: Vec<usize>,
    inside: Vec<DVec3>,
    scratch: Vec<DVec3>,
}

/// Convex polygons, one after the other, and where each ends.
#[derive(Clone, Debug, Default)]
struct Parts {
    corners: Vec<DVec3>,
    ends: Vec<usize>,
}

impl Parts {
    fn clear(&mut self) {
        self.corners.clear();
        self.ends.clear();
    }

    fn push(&mut self, corners: &[DVec3]) {
        self.corners.extend_from_slice(corners);
        self.ends.push(self.corners.len());
    }

    fn iter(&self) -> impl Iterator<Item = &[DVec3]> {
        let starts = std::iter::once(0).chain(self.ends.iter().copied());
        starts
            .zip(&self.ends)
            .map(|(start, &end)| &self.corners[start..end])
    }
}

/// A plane through the element and an edge of a blocker.
#[derive(Clone, Copy, Debug)]
struct Side {
    /// Toward the inside of the cone; of no unit length.
    normal: DVec3,
    /// Heights that rounding cannot tell from 0.
    slack: f64,
}

impl Side {
    /// The lowest and the highest corner.
    fn heights(&self, corners: &[DVec3]) -> [f64; 2] {
        let heights = corners.iter().map(|&corner| self.normal.dot(corner));
        // Comparisons, since `min` and `max` take longer for the sake of NaN.
        heights.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], height| {
            [
                if height < low { height } else { low },
                if height > high { height } else { high },
            ]
        })
    }
}

/// No less than the length of a vector.
fn span(vector: DVec3) -> f64 {
    vector.abs().element_sum()
}

/// F of the whole polygon, and of what is seen of it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Seen {
    pub whole: f64,
    pub visible: f64,
}

impl View {
    /// From an element at `x` with the unit normal `n` to a polygon that lies wholly above its horizon and shows it its front.
    /// `slack` is how far rounding may have moved a corner.
    pub fn of(
        &mut self,
        x: DVec3,
        n: DVec3,
        polygon: &[DVec3],
        blockers: &[Blocker],
        slack: f64,
    ) -> Seen {
        self.parts.clear();
        self.parts
            .corners
            .extend(polygon.iter().map(|&corner| corner - x));
        self.parts.ends.push(polygon.len());
        let whole = light(n, &self.parts.corners);
        if whole <= 0.0 {
            return Seen::default();
        }
        let reach = self
            .parts
            .corners
            .iter()
            .map(|&corner| span(corner))
            .fold(0.0, f64::max);
        if self.set_cones(x, blockers, reach, slack) {
            return Seen {
                whole,
                visible: 0.0,
            };
        }
        let mut hidden = 0.0;
        let mut start = 0;
        for number in 0..self.cones.len() {
            let end = self.cones[number];
            hidden += self.hide(n, start..end, [number == 0, number + 1 == self.cones.len()]);
            start = end;
        }
        // Nothing is left where every part was hidden, whatever the rounding of the sums.
        let visible = match self.parts.ends.is_empty() {
            true => 0.0,
            false => (whole - hidden).max(0.0),
        };
        Seen { whole, visible }
    }

    /// The cones of the blockers that hide a part of the polygon. True where one of them hides all of it.
    fn set_cones(&mut self, x: DVec3, blockers: &[Blocker], reach: f64, slack: f64) -> bool {
        let View {
            parts,
            sides,
            cones,
            ..
        } = self;
        sides.clear();
        cones.clear();
        for blocker in blockers {
            let height = blocker.normal.dot(x - blocker.corners[0]);
            // Seen edge-on, it hides nothing.
            if height.abs() <= slack {
                continue;
            }
            let start = sides.len();
            let mut before = blocker.corners[blocker.corners.len() - 1] - x;
            let mut length_before = span(before);
            let mut is_outside = false;
            for &corner in &blocker.corners {
                let corner = corner - x;
                let length = span(corner);
                // Counter-clockwise as x sees it, whichever side it sees.
                let normal = match height > 0.0 {
                    true => corner.cross(before),
                    false => before.cross(corner),
                };
                let longer = if length > length_before {
                    length
                } else {
                    length_before
                };
                let slack = slack * (reach * longer + length * length_before);
                let side = Side { normal, slack };
                let [lowest, highest] = side.heights(&parts.corners);
                is_outside = highest <= slack && lowest < -slack;
                if is_outside {
                    break;
                }
                // A side that holds all of the polygon divides nothing.
                if lowest < -slack {
                    sides.push(side);
                }
                (before, length_before) = (corner, length);
            }
            if is_outside {
                sides.truncate(start);
            } else if sides.len() == start {
                return true;
            } else {
                cones.push(sides.len());
            }
        }
        false
    }

    /// Takes what is in the cone away from the parts, and returns its light. The parts are only counted if no other cone follows.
    fn hide(&mut self, n: DVec3, cone: Range<usize>, [is_first, is_last]: [bool; 2]) -> f64 {
        let View {
            parts,
            next,
            sides,
            inside,
            scratch,
            ..
        } = self;
        let cone = &sides[cone];
        next.clear();
        let mut hidden = 0.0;
        for part in parts.iter() {
            let place = if is_first {
                Place::Cut
            } else {
                of_cone(part, cone)
            };
            match place {
                Place::Outside => next.push(part),
                Place::Inside => hidden += light(n, part),
                Place::Cut => {
                    inside.clear();
                    inside.extend_from_slice(part);
                    for side in cone.iter() {
                        clip(
                            inside,
                            scratch,
                            |corner| side.normal.dot(corner),
                            side.slack,
                        );
                        std::mem::swap(inside, scratch);
                    }
                    if inside.len() < 3 {
                        next.push(part);
                        continue;
                    }
                    hidden += light(n, inside);
                    if is_last {
                        next.push(part);
                    } else {
                        divide(part, cone, inside, scratch, next);
                    }
                }
            }
        }
        std::mem::swap(parts, next);
        hidden
    }
}

enum Place {
    Outside,
    Inside,
    Cut,
}

fn of_cone(part: &[DVec3], cone: &[Side]) -> Place {
    let mut is_inside = true;
    for side in cone {
        let [lowest, highest] = side.heights(part);
        is_inside &= lowest >= -side.slack;
        if highest <= side.slack && lowest < -side.slack {
            return Place::Outside;
        }
    }
    if is_inside { Place::Inside } else { Place::Cut }
}

/// The parts of a part outside a cone: each outside one side, and inside those before.
fn divide(
    part: &[DVec3],
    cone: &[Side],
    rest: &mut Vec<DVec3>,
    scratch: &mut Vec<DVec3>,
    parts: &mut Parts,
) {
    rest.clear();
    rest.extend_from_slice(part);
    for side in cone {
        clip(rest, scratch, |corner| -side.normal.dot(corner), side.slack);
        if scratch.len() >= 3 {
            parts.push(scratch);
        }
        clip(rest, scratch, |corner| side.normal.dot(corner), side.slack);
        std::mem::swap(rest, scratch);
        if rest.len() < 3 {
            break;
        }
    }
}

/// The part of a convex polygon where `height` > 0, into `part`; nothing where it is nowhere above `slack`, and the whole where it is
/// nowhere below.
fn clip(corners: &[DVec3], part: &mut Vec<DVec3>, height: impl Fn(DVec3) -> f64, slack: f64) {
    part.clear();
    let Some(&last) = corners.last() else {
        return;
    };
    let mut before = last;
    let mut height_before = height(before);
    let mut highest = f64::NEG_INFINITY;
    for &corner in corners {
        let height = height(corner);
        highest = if height > highest { height } else { highest };
        // A corner within the slack lies in the plane, and belongs to both sides.
        if (height_before < -slack && height > slack) || (height_before > slack && height < -slack)
        {
            part.push(before + height_before / (height_before - height) * (corner - before));
        }
        if height >= -slack {
            part.push(corner);
        }
        (before, height_before) = (corner, height);
    }
    if highest <= slack {
        part.clear();
    }
}

/// F from an element at `x` with the unit normal `n` to a polygon above its horizon that shows it its front.
pub fn from_element(x: DVec3, n: DVec3, corners: &[DVec3]) -> f64 {
    let relative: Vec<DVec3> = corners.iter().map(|&corner| corner - x).collect();
    light(n, &relative)
}

/// F from an element at the origin with the unit normal `n` to a polygon above its horizon (Lambert 1760).
#[inline]
fn light(n: DVec3, corners: &[DVec3]) -> f64 {
    let mut sum = 0.0;
    let mut before = corners[corners.len() - 1];
    for &corner in corners {
        let normal = (corner - before).cross(before);
        sum += n.dot(normal) * angle_by_sine(normal.length_squared(), before.dot(corner));
        before = corner;
    }
    (sum / TAU).max(0.0)
}

/// The angle between two vectors over the length of their cross product, of its square and their dot product; 0 where they are parallel.
#[inline]
fn angle_by_sine(sine2: f64, cosine: f64) -> f64 {
    // Of a small angle, the series of the arc tangent: the first term left out is below 1e-16.
    if cosine > 0.0 && sine2 < 0.01 * cosine * cosine {
        let t2 = sine2 / (cosine * cosine);
        let series = [
            1.0 / 15.0,
            1.0 / 13.0,
            1.0 / 11.0,
            1.0 / 9.0,
            1.0 / 7.0,
            1.0 / 5.0,
            1.0 / 3.0,
            1.0,
        ];
        return series.iter().fold(0.0, |sum, term| term - t2 * sum) / cosine;
    }
    let sine = sine2.sqrt();
    if sine > 0.0 {
        sine.atan2(cosine) / sine
    } else {
        0.0
    }
}
