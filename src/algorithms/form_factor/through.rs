//! What polygons in between take away from the exchange of two patches, found without a look from either of them: an integral over
//! the polygons that block. It shares nothing with the methods that are compared with it.
//!
//! The exchange A_i F_ij is the measure of the lines from i to j, cos θ dω dA / π across any surface that they pass (Lambert 1760;
//! Santaló, "Integral Geometry and Geometric Probability", 1976, §12). So a polygon c blocks
//!
//! ∫_c F_y dA_y,
//!
//! where F_y is the form factor from an element of c at y to the part of j that lies behind y as seen from i: the image of i through
//! y on the plane of j, cut to j. Where several polygons block, a line counts at the first of them in the list alone.

use super::facing;
use super::polygon::{Polygon, cut};
use super::visibility::Blockers;
use crate::scene::patches::Patches;
use glam::DVec3;
use std::f64::consts::TAU;

/// How much above a point a corner must lie to have an image through it, as a share of the point's height.
const ABOVE: f64 = 1e-9;

/// How often triangles are divided at most, and into how many cells a blocker is.
const DEEPEST: u32 = 12;
const MOST_CELLS: usize = 2000;

/// More blockers than this are not looked through.
const MOST_BLOCKERS: usize = 32;

/// How much of F_ij other patches take away, to about `tolerance`. None where too many may stand between, or one lies on i or on j.
pub fn blocked_share(
    patches: &Patches,
    blockers: &Blockers,
    [i, j]: [usize; 2],
    tolerance: f64,
) -> Option<f64> {
    if !blockers.can_stand_between(i, j) {
        return Some(0.0);
    }
    let polygons = |patch: usize| {
        let pieces = patches.pieces(patch);
        pieces.filter_map(|piece| Polygon::new(piece.corners.into(), piece.normal))
    };
    let bounds = |corners: &mut dyn Iterator<Item = DVec3>| {
        corners.fold([DVec3::INFINITY, DVec3::NEG_INFINITY], |[low, high], at| {
            [low.min(at), high.max(at)]
        })
    };
    let ends = [i, j].into_iter().flat_map(|patch| patches.pieces(patch));
    let [low, high] = bounds(&mut ends.flat_map(|piece| piece.corners.iter().copied()));
    let slack = 1e-9 * low.distance(high);
    let mut between = Vec::new();
    let others = (0..patches.len()).filter(|&patch| patch != i && patch != j);
    for patch in others.filter(|&patch| blockers.includes(patches[patch].object)) {
        for polygon in polygons(patch) {
            let [from, to] = bounds(&mut polygon.corners.iter().copied());
            if from.cmpgt(high + slack).any() || to.cmplt(low - slack).any() {
                continue;
            }
            let lies_on = |plane: Polygon| {
                let height = |corner: &DVec3| plane.normal.dot(*corner - plane.corners[0]).abs();
                polygon.corners.iter().all(|corner| height(corner) <= slack)
            };
            if polygons(i).any(lies_on) || polygons(j).any(lies_on) {
                return None;
            }
            between.push(polygon);
        }
    }
    if between.len() > MOST_BLOCKERS {
        return None;
    }
    let area = patches[i].area;
    let mut sum = 0.0;
    for of_i in polygons(i) {
        for of_j in polygons(j) {
            if let Some([of_i, of_j]) = facing(of_i.clone(), of_j) {
                sum += blocked(&of_i, &of_j, &between, tolerance * area);
            }
        }
    }
    Some(sum / area)
}

/// How much of A_i F_ij `blockers` take away, to an absolute `tolerance`. `i` and `j` lie in front of each other. The blockers are convex.
pub fn blocked(i: &Polygon, j: &Polygon, blockers: &[Polygon], tolerance: f64) -> f64 {
    let slack = 1e-12 * (i.radius + j.radius + i.center.distance(j.center));
    let between = |blocker: &Polygon<'_>| {
        let blocker = blocker.clone().in_front_of(i, slack)?;
        let blocker = blocker.in_front_of(j, slack)?;
        Polygon::new(blocker.corners.into_owned().into(), blocker.normal)
    };
    let blockers: Vec<Polygon> = blockers.iter().filter_map(between).collect();
    let all: f64 = blockers.iter().map(|blocker| blocker.area).sum();
    let mut sum = 0.0;
    for (number, blocker) in blockers.iter().enumerate() {
        let lines = Lines {
            i,
            j,
            normal: blocker.normal,
            before: &blockers[..number],
        };
        let share = tolerance * blocker.area / all;
        for cell in lines.cells(blocker) {
            for pair in cell[1..].windows(2) {
                let triangle = [cell[0], pair[0], pair[1]];
                sum += integral(&|y| lines.through(y), triangle, share / blocker.area.sqrt());
            }
        }
    }
    sum
}

/// The lines from i to j that pass a polygon, and none before it in the list.
struct Lines<'a> {
    i: &'a Polygon<'a>,
    j: &'a Polygon<'a>,
    /// Of the polygon.
    normal: DVec3,
    before: &'a [Polygon<'a>],
}

impl Lines<'_> {
    /// A blocker in parts within which F_y is smooth: cut where the image of a corner crosses an edge, in the planes of a corner of one
    /// polygon and an edge of another.
    fn cells(&self, blocker: &Polygon) -> Vec<Vec<DVec3>> {
        let mut cells = vec![blocker.corners.to_vec()];
        let polygons: Vec<&Polygon> = [self.i, self.j].into_iter().chain(self.before).collect();
        for (k, of_corner) in polygons.iter().enumerate() {
            let others = polygons.iter().enumerate().filter(|&(other, _)| other != k);
            for [from, to] in others.flat_map(|(_, other)| other.edges()) {
                for &corner in of_corner.corners.iter() {
                    let normal = (from - corner).cross(to - corner).normalize_or_zero();
                    if cells.len() > MOST_CELLS || normal == DVec3::ZERO {
                        continue;
                    }
                    cells = (cells.into_iter())
                        .flat_map(|cell| halves(cell, |p| normal.dot(p - corner)))
                        .collect();
                }
            }
        }
        cells
    }

    fn height(&self, point: DVec3) -> f64 {
        self.j.normal.dot(point - self.j.corners[0])
    }

    /// F_y.
    fn through(&self, y: DVec3) -> f64 {
        if self.height(y) <= 0.0 {
            return 0.0;
        }
        let mut seen: Vec<Vec<DVec3>> = vec![self.within(self.image(&self.i.corners, y, 1.0))];
        for other in self.before {
            for side in [1.0, -1.0] {
                let hidden = self.image(&other.corners, y, side);
                seen = seen
                    .into_iter()
                    .flat_map(|part| self.without(part, &hidden))
                    .collect();
            }
        }
        seen.iter().map(|part| self.form_factor(y, part)).sum()
    }

    /// The image through y, on the plane of j, of what lies above y, or with `side` −1 below it.
    fn image(&self, corners: &[DVec3], y: DVec3, side: f64) -> Vec<DVec3> {
        let of_y = self.height(y);
        let part = cut(corners, |p| side * (self.height(p) - of_y) - ABOVE * of_y);
        let image = |&p: &DVec3| {
            let of_p = self.height(p);
            p + of_p / (of_p - of_y) * (y - p)
        };
        let mut image: Vec<DVec3> = part.iter().map(image).collect();
        if area(&image, self.j.normal) < 0.0 {
            image.reverse();
        }
        image
    }

    /// The part of a polygon in the plane of j that lies in j.
    fn within(&self, part: Vec<DVec3>) -> Vec<DVec3> {
        let edges = self.j.edges();
        edges.fold(part, |part, edge| cut(&part, |p| self.left_of(edge, p)))
    }

    /// A convex polygon without another, in convex parts.
    fn without(&self, mut part: Vec<DVec3>, hidden: &[DVec3]) -> Vec<Vec<DVec3>> {
        if hidden.len() < 3 {
            return vec![part];
        }
        let mut parts = Vec::new();
        for k in 0..hidden.len() {
            let edge = [hidden[k], hidden[(k + 1) % hidden.len()]];
            parts.push(cut(&part, |p| -self.left_of(edge, p)));
            part = cut(&part, |p| self.left_of(edge, p));
        }
        parts
    }

    /// How far to the left of an edge, in units of its length.
    fn left_of(&self, [from, to]: [DVec3; 2], point: DVec3) -> f64 {
        self.j.normal.cross(to - from).dot(point - from)
    }

    /// F from an element of the polygon at y, on whichever side, to a part of j.
    fn form_factor(&self, y: DVec3, part: &[DVec3]) -> f64 {
        let on_side = |normal: DVec3| {
            let above = cut(part, |p| normal.dot(p - y));
            let edges = (0..above.len()).map(|k| [above[k] - y, above[(k + 1) % above.len()] - y]);
            let terms = edges.map(|[a, b]| {
                let across = a.cross(b);
                let sine = across.length();
                match sine > 0.0 {
                    true => normal.dot(across) * sine.atan2(a.dot(b)) / sine,
                    false => 0.0,
                }
            });
            terms.sum::<f64>().abs() / TAU
        };
        on_side(self.normal) + on_side(-self.normal)
    }
}

/// Both sides of a plane, where a polygon has both.
fn halves(cell: Vec<DVec3>, height: impl Fn(DVec3) -> f64) -> Vec<Vec<DVec3>> {
    let size = cell
        .iter()
        .map(|at| at.distance(cell[0]))
        .fold(0.0, f64::max);
    let slack = 1e-9 * size;
    let is_cut =
        cell.iter().any(|&at| height(at) > slack) && cell.iter().any(|&at| height(at) < -slack);
    match is_cut {
        true => vec![cut(&cell, &height), cut(&cell, |p| -height(p))],
        false => vec![cell],
    }
}

/// Twice the area of a polygon, positive where it runs counter-clockwise about `normal`.
fn area(corners: &[DVec3], normal: DVec3) -> f64 {
    let Some(&first) = corners.first() else {
        return 0.0;
    };
    let fan = corners[1..].windows(2);
    fan.map(|pair| (pair[0] - first).cross(pair[1] - first).dot(normal))
        .sum()
}

/// ∫ f over a triangle, which is divided in four where that changes the sum by more than `tolerance` times the length of a part.
fn integral(f: &impl Fn(DVec3) -> f64, triangle: [DVec3; 3], tolerance: f64) -> f64 {
    let mut parts = vec![(triangle, by_points(f, triangle), 0)];
    let mut sum = 0.0;
    while let Some(([a, b, c], coarse, depth)) = parts.pop() {
        let [ab, bc, ca] = [a.midpoint(b), b.midpoint(c), c.midpoint(a)];
        let quarters = [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]];
        let finer = quarters.map(|quarter| (quarter, by_points(f, quarter), depth + 1));
        let fine: f64 = finer.iter().map(|(_, part, _)| part).sum();
        let length = (0.5 * (b - a).cross(c - a).length()).sqrt();
        // Too large a part may agree by chance.
        if depth == DEEPEST || (depth >= 1 && (fine - coarse).abs() <= tolerance * length) {
            sum += fine;
        } else {
            parts.extend(finer);
        }
    }
    sum
}

/// ∫ f over a triangle by seven points, exact for polynomials of degree 5 (Radon 1948).
fn by_points(f: &impl Fn(DVec3) -> f64, [a, b, c]: [DVec3; 3]) -> f64 {
    let root = 15_f64.sqrt();
    let middle = (a + b + c) / 3.0;
    let of_corners = |toward: f64| -> f64 {
        let at = |corner: DVec3| f(middle + toward * (corner - middle));
        at(a) + at(b) + at(c)
    };
    let inner = (155.0 + root) / 1200.0 * of_corners((-1.0 - root) / 7.0);
    let outer = (155.0 - root) / 1200.0 * of_corners((root - 1.0) / 7.0);
    let area = 0.5 * (b - a).cross(c - a).length();
    area * (0.225 * f(middle) + inner + outer)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A square above the plane y = 0, from (x, x) to (x + side, x + side), facing down; the floor faces up.
    fn square(x: f64, side: f64, y: f64, up: bool) -> Polygon<'static> {
        let at = |u: f64, v: f64| DVec3::new(x + u * side, y, x + v * side);
        let mut corners = vec![at(0.0, 0.0), at(1.0, 0.0), at(1.0, 1.0), at(0.0, 1.0)];
        if up {
            corners.reverse();
        }
        let normal = if up { DVec3::Y } else { DVec3::NEG_Y };
        Polygon::new(corners.into(), normal).unwrap()
    }

    /// F between unit squares at distance 1.
    const WHOLE: f64 = 0.199_824_895_698_387_38;

    fn blocked_by(blockers: &[Polygon], tolerance: f64) -> f64 {
        let (lamp, floor) = (square(0.0, 1.0, 1.0, false), square(0.0, 1.0, 0.0, true));
        blocked(&lamp, &floor, blockers, tolerance)
    }

    #[test]
    fn a_card_that_every_line_passes_blocks_the_whole_exchange() {
        for y in [0.3, 0.5] {
            let found = blocked_by(&[square(0.0, 1.0, y, true)], 1e-7);
            assert!((found - WHOLE).abs() < 1e-6, "{found} at {y}");
        }
        // Aslant, and larger than it need be.
        let corners = [
            [-1., 0.2, -1.],
            [2., 0.8, -1.],
            [2., 0.8, 2.],
            [-1., 0.2, 2.],
        ];
        let corners = corners.map(DVec3::from).to_vec();
        let normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
        let aslant = Polygon::new(corners.into(), normal.normalize()).unwrap();
        let found = blocked_by(&[aslant], 1e-7);
        assert!((found - WHOLE).abs() < 1e-6, "{found}");
    }

    #[test]
    fn a_small_card_half_way_blocks_what_a_sum_over_the_lamp_says() {
        // ∫ over the lamp of F to the card's shadow on the floor, a rectangle, whose form factor has a closed form: by 40 × 40 Gauss
        // points on each quarter of the lamp, in 16 digits.
        const BLOCKED: f64 = 0.100_318_601_099_402_6;
        let card = square(0.25, 0.5, 0.5, false);
        let found = blocked_by(std::slice::from_ref(&card), 1e-8);
        assert!((found - BLOCKED).abs() < 1e-7, "{found}");
        // In any order, what lies in the shadow of another blocks nothing more.
        let hidden = square(0.4, 0.2, 0.55, true);
        for cards in [[card.clone(), hidden.clone()], [hidden, card]] {
            assert!((blocked_by(&cards, 1e-8) - BLOCKED).abs() < 1e-7);
        }
    }
}
