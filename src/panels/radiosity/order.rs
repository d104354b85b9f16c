//! The painter's order: what may cover another patch on the screen is painted after it.
//!
//! Of two patches whose boxes overlap on the screen one plane decides which goes first, where the other is on one side of it
//! (Newell, Newell & Sancha 1972); what no plane decides, the distance of the centres does. Patches that cover each other in a ring
//! are not divided: the farthest goes first.

use glam::{DVec2, DVec3};
use std::collections::BTreeSet;

/// A patch that is seen from its front.
pub(super) struct Placed {
    pub corners: Vec<DVec3>,
    pub center: DVec3,
    /// Unit, toward the side of the eye.
    pub normal: DVec3,
    pub radius: f64,
    /// The box on the screen.
    pub low: DVec2,
    pub high: DVec2,
}

/// How far from a plane, in radii of the patch, a corner may lie that counts as within it.
const FLAT: f64 = 1e-6;

impl Placed {
    /// Distances from the plane of the patch, positive toward the eye, the least and the largest.
    fn sides(&self, other: &Placed) -> (f64, f64) {
        let distances = other
            .corners
            .iter()
            .map(|&corner| self.normal.dot(corner - self.center));
        distances.fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), d| {
            (least.min(d), most.max(d))
        })
    }

    /// Whether it lies behind the plane of the other, or the other in front of its own: then it cannot cover the other.
    fn may_go_before(&self, other: &Placed) -> bool {
        other.sides(self).1 <= FLAT * other.radius || self.sides(other).0 >= -FLAT * self.radius
    }

    fn overlaps(&self, other: &Placed) -> bool {
        self.low.cmplt(other.high).all() && other.low.cmplt(self.high).all()
    }
}

/// The order in which to paint patches that are given by their distance, the farthest first.
pub(super) fn painters_order(placed: &[Placed]) -> Vec<usize> {
    let mut after = vec![Vec::new(); placed.len()];
    let mut waits_for = vec![0_usize; placed.len()];
    for (a, b) in overlapping(placed) {
        let before = placed[a].may_go_before(&placed[b]);
        if before != placed[b].may_go_before(&placed[a]) {
            let (first, second) = if before { (a, b) } else { (b, a) };
            after[first].push(second);
            waits_for[second] += 1;
        }
    }
    // Topological sorting (Kahn 1962)
    let mut waiting: BTreeSet<usize> = (0..placed.len()).collect();
    let ready = waiting
        .iter()
        .copied()
        .filter(|&patch| waits_for[patch] == 0);
    let mut ready: BTreeSet<usize> = ready.collect();
    let mut order = Vec::with_capacity(placed.len());
    while let Some(next) = ready.pop_first().or_else(|| waiting.first().copied()) {
        waiting.remove(&next);
        order.push(next);
        for &patch in &after[next] {
            waits_for[patch] = waits_for[patch].saturating_sub(1);
            if waits_for[patch] == 0 && waiting.contains(&patch) {
                ready.insert(patch);
            }
        }
    }
    order
}

/// Pairs whose boxes overlap, found from left to right.
fn overlapping(placed: &[Placed]) -> Vec<(usize, usize)> {
    let mut from_left: Vec<usize> = (0..placed.len()).collect();
    from_left.sort_by(|&a, &b| placed[a].low.x.total_cmp(&placed[b].low.x));
    let mut open: Vec<usize> = Vec::new();
    let mut pairs = Vec::new();
    for a in from_left {
        open.retain(|&b| placed[b].high.x > placed[a].low.x);
        let met = open.iter().filter(|&&b| placed[a].overlaps(&placed[b]));
        pairs.extend(met.map(|&b| (a, b)));
        open.push(a);
    }
    pairs
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A square that looks along z, toward an eye far away there.
    fn square(center: [f64; 3], size: f64) -> Placed {
        let center = DVec3::from(center);
        let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
        let corners = corners.map(|[x, y]| center + 0.5 * size * DVec3::new(x, y, 0.0));
        Placed {
            low: corners[0].truncate(),
            high: corners[2].truncate(),
            corners: corners.to_vec(),
            center,
            normal: DVec3::Z,
            radius: size,
        }
    }

    #[test]
    fn what_lies_behind_a_plane_is_painted_first_whatever_the_distance() {
        // By the distance of its centre from an eye beside it, the wall comes last.
        let placed = [
            square([0.3, 0.0, 0.1], 1.0),
            square([9.0, 0.0, 5.0], 1.0),
            square([0.0, 0.0, 0.0], 2.0),
        ];
        assert_eq!(painters_order(&placed), [1, 2, 0]);
    }

    #[test]
    fn patches_of_one_plane_keep_their_order() {
        let placed = [0.0, 0.4, 0.8].map(|x| square([x, 0.0, 0.0], 1.0));
        assert_eq!(painters_order(&placed), [0, 1, 2]);
    }
}
