//! The convex faces of the patches that stand in the way: of patches in one plane, as many together as make a convex polygon.

use super::groups::Group;
use super::polygon::Polygon;
use super::view::Blocker;
use crate::scene::patches::Patches;
use glam::DVec3;
use std::ops::Range;

/// A convex planar polygon made of whole pieces of patches.
#[derive(Clone, Debug)]
pub struct Face {
    pub outline: Blocker,
    /// By edge, the unit normal in the plane, toward the inside.
    pub inward: Vec<DVec3>,
    pub low: DVec3,
    pub high: DVec3,
}

/// So many pieces are tried together at most, where not all of them are one face.
const MOST_TOGETHER: usize = 4096;

/// The faces of a group, with the patches that they are made of: by the patch, where patches of the group may lie on each other.
pub fn in_place(patches: &Patches, group: &Group, slack: f64) -> Vec<(Face, Range<usize>)> {
    let mut faces = of_group(patches, group, slack);
    if faces.len() == 1 && !group.is_warped() {
        return vec![(faces.remove(0), group.patches.clone())];
    }
    let each = group.patches.clone().flat_map(|patch| {
        let pieces = patches.pieces(patch).enumerate();
        let own = pieces.filter(|&(number, _)| group.piece.is_none_or(|one| one == number));
        own.map(move |(_, piece)| {
            (
                Face::new(piece.corners.to_vec(), piece.normal),
                patch..patch + 1,
            )
        })
    });
    each.collect()
}

/// The faces of a group. Together they cover exactly its pieces, where corners lie within `slack` of their place.
pub fn of_group(patches: &Patches, group: &Group, slack: f64) -> Vec<Face> {
    let pieces: Vec<(&[DVec3], f64, DVec3)> = group
        .patches
        .clone()
        .flat_map(|patch| patches.pieces(patch).enumerate())
        .filter(|&(number, _)| group.piece.is_none_or(|one| one == number))
        .map(|(_, piece)| (piece.corners, piece.area, piece.normal))
        .collect();
    let mut faces = Vec::new();
    let mut start = 0;
    while start < pieces.len() {
        let (first, area, normal) = pieces[start];
        let mut best = (first.to_vec(), start + 1);
        let mut hull = Hull {
            corners: first.to_vec(),
            normal,
            slack,
        };
        let mut sum = area;
        if !group.is_warped() {
            for (end, &(corners, area, _)) in
                (start + 2..).zip(&pieces[start + 1..]).take(MOST_TOGETHER)
            {
                corners.iter().for_each(|&corner| hull.add(corner));
                sum += area;
                if (hull.area() - sum).abs() <= slack * hull.perimeter() {
                    best = (hull.corners.clone(), end);
                }
            }
        }
        faces.push(Face::new(best.0, normal));
        start = best.1;
    }
    faces
}

impl Face {
    fn new(corners: Vec<DVec3>, normal: DVec3) -> Face {
        let next = corners.iter().cycle().skip(1);
        let inward = corners.iter().zip(next);
        Face {
            inward: inward
                .map(|(&from, &to)| normal.cross(to - from).normalize_or_zero())
                .collect(),
            low: corners.iter().copied().fold(DVec3::INFINITY, DVec3::min),
            high: corners
                .iter()
                .copied()
                .fold(DVec3::NEG_INFINITY, DVec3::max),
            outline: Blocker { corners, normal },
        }
    }

    /// None where rounding left no area.
    pub fn polygon(&self) -> Option<Polygon<'static>> {
        Polygon::new(self.outline.corners.clone().into(), self.outline.normal)
    }

    pub fn height(&self, point: DVec3) -> f64 {
        self.outline.normal.dot(point - self.outline.corners[0])
    }
}

/// A convex polygon that grows by points of its plane.
struct Hull {
    /// Counter-clockwise about the normal.
    corners: Vec<DVec3>,
    normal: DVec3,
    slack: f64,
}

impl Hull {
    /// Twice the area of a triangle, positive where it is counter-clockwise.
    fn turn(&self, a: DVec3, b: DVec3, c: DVec3) -> f64 {
        (b - a).cross(c - a).dot(self.normal)
    }

    fn add(&mut self, point: DVec3) {
        let n = self.corners.len();
        let at = |k: usize| self.corners[k % n];
        let sees = |k: usize| self.turn(at(k), at(k + 1), point) < 0.0;
        // The edges that the point sees follow each other, and give way to two that lead to it and from it.
        let Some(first) = (0..n).find(|&k| sees(k) && !sees(k + n - 1)) else {
            return;
        };
        let count = (1..n).find(|&more| !sees(first + more)).unwrap_or(n);
        let mut corners: Vec<DVec3> = (first + count..=first + n).map(at).collect();
        corners.push(point);
        // What has come to lie on a straight line is no corner.
        let m = corners.len();
        let is_corner = |k: usize| {
            let (before, after) = (corners[(k + m - 1) % m], corners[(k + 1) % m]);
            self.turn(before, corners[k], after) > self.slack * before.distance(after)
        };
        let kept: Vec<DVec3> = (0..m)
            .filter(|&k| is_corner(k))
            .map(|k| corners[k])
            .collect();
        if kept.len() >= 3 {
            self.corners = kept;
        }
    }

    fn perimeter(&self) -> f64 {
        let next = self.corners.iter().cycle().skip(1);
        self.corners
            .iter()
            .zip(next)
            .map(|(from, to)| from.distance(*to))
            .sum()
    }

    fn area(&self) -> f64 {
        let first = self.corners[0];
        0.5 * self.corners[1..]
            .windows(2)
            .map(|pair| self.turn(first, pair[0], pair[1]))
            .sum::<f64>()
    }
}
