//! What stands between two patches: which surfaces can, and how much they hide.
//!
//! Patches in one plane make a group, and a group one or more convex faces. A face can stand between i and j only where its plane parts
//! them, and where the shaft of the two (Haines & Wallace 1991, "Shaft culling for efficient ray-traced radiosity") crosses that plane
//! within the face. Where the whole shaft does so within one face, nothing passes. What the other faces leave is found by
//! `occlusion`, exactly from each point of one patch; where they are too many for that, by rays ([`super::sampled`]).

use super::closed::Closed;
use super::coincident::{self, Exposed};
use super::faces::{self, Face};
use super::groups::{Group, facets, groups};
use super::polygon::Polygon;
use super::sample::Sample;
use super::shaft::{Shaft, Sight};
use super::sheet::Sheet;
use crate::record::Listing;
use crate::scene::patches::Patches;
use crate::scene::primitives::{Primitives, Ray};
use crate::scene::{Scene, Tessellation};
use glam::DVec3;
use std::ops::Range;
use std::sync::OnceLock;

pub static PSEUDOCODE: Listing = Listing {
    name: "visibility",
    lines: &[
        ("", "visible(i, j)"),
        ("", "  {if-nothing-can-stand-between-return-1}"),
        ("", "  {for-each-point-x-of-the-receiver}"),
        (
            "seen",
            "    F_x, F_visible ← {form-factors-of-the-whole-and-of-what-no-face-hides}",
        ),
        ("visible", "  {return} Σ w F_visible / Σ w F_x"),
    ],
};

/// Above so many groups no pair is looked at group by group.
const MOST_GROUPS: usize = 4096;

/// How far from a plane counts as in it, as a share of the scene's extent: as far as rounding may have moved a corner.
const SLACK: f64 = 64.0 * f64::EPSILON;

/// How far from their patches rays begin and end, as a share of the scene's extent: so that they do not meet what they leave.
const LIFT: f64 = 4e-9;

/// The patches of a scene as they stand in each other's way. Objects that cast no shadow do not.
#[derive(Clone, Debug)]
pub struct Blockers {
    primitives: Primitives,
    casts_shadow: Vec<bool>,
    /// Patch `p` has the corners `starts[p]..starts[p + 1]`.
    starts: Vec<usize>,
    corners: Vec<DVec3>,
    groups: Vec<Group>,
    pub(super) faces: Vec<Face>,
    /// By group, those of `faces` that it is made of.
    faces_of: Vec<Range<usize>>,
    /// By patch, a bit a group: no corner behind its plane, and none in front.
    not_behind: Vec<u64>,
    not_in_front: Vec<u64>,
    strings: usize,
    has_too_many: bool,
    pub(super) exposed: Exposed,
    /// The surfaces that the patches make together, less what others lie on; and if that is anything, the whole of them.
    pub(super) sheets: Vec<Vec<Sheet>>,
    pub(super) closed: OnceLock<Option<Closed>>,
    pub(super) slack: f64,
    /// How far rays begin and end above the patches.
    lift: f64,
}

impl Blockers {
    pub fn of(scene: &Scene, patches: &Patches) -> Blockers {
        let (mut starts, mut corners) = (vec![0], Vec::new());
        for patch in 0..patches.len() {
            corners.extend(patches.pieces(patch).flat_map(|piece| piece.corners));
            starts.push(corners.len());
        }
        let extent = corners.iter().fold(0.0, |extent, corner: &DVec3| {
            corner.abs().max_element().max(extent)
        });
        let slack = SLACK * extent;
        let groups = groups(scene, patches, slack);
        let has_too_many = groups.len() > MOST_GROUPS;
        let in_place: Vec<_> = groups
            .iter()
            .flat_map(|group| faces::in_place(patches, group, slack))
            .collect();
        let exposed = coincident::exposed(patches, &in_place, slack);
        let mut sheets = vec![coincident::sheets(patches, &in_place, &exposed)];
        if exposed.iter().any(Option::is_some) {
            sheets.push(coincident::sheets(
                patches,
                &in_place,
                &vec![None; patches.len()],
            ));
        }
        // A wall of a convex room parts nothing from anything.
        let groups: Vec<Group> = groups
            .into_iter()
            .filter(|group| {
                let heights = || corners.iter().map(|&corner| group.height(corner));
                has_too_many
                    || group.is_warped()
                    || (heights().any(|height| height < -slack)
                        && heights().any(|height| height > slack))
            })
            .collect();
        let facets = facets(scene, patches, &groups);
        let primitives = Primitives::of(&facets, &Tessellation::of(&facets));
        let groups = if has_too_many { Vec::new() } else { groups };
        let mut all_faces = Vec::new();
        let faces_of = groups
            .iter()
            .map(|group| {
                let start = all_faces.len();
                all_faces.extend(faces::of_group(patches, group, slack));
                start..all_faces.len()
            })
            .collect();
        let strings = groups.len().div_ceil(64);
        let mut blockers = Blockers {
            primitives,
            casts_shadow: scene
                .objects
                .iter()
                .map(|object| object.casts_shadow)
                .collect(),
            not_behind: vec![0; strings * patches.len()],
            not_in_front: vec![0; strings * patches.len()],
            starts,
            corners,
            groups,
            faces: all_faces,
            faces_of,
            strings,
            has_too_many,
            exposed,
            sheets,
            closed: OnceLock::new(),
            slack,
            lift: LIFT * extent,
        };
        blockers.take_sides(patches.len());
        blockers
    }

    /// Says of each patch on which side of each group it lies.
    fn take_sides(&mut self, patches: usize) {
        for patch in 0..patches {
            for (number, group) in self.groups.iter().enumerate() {
                let (mut lowest, mut highest) = (f64::INFINITY, f64::NEG_INFINITY);
                for &corner in &self.corners[self.starts[patch]..self.starts[patch + 1]] {
                    let height = group.height(corner);
                    (lowest, highest) = (lowest.min(height), highest.max(height));
                }
                let (word, bit) = (patch * self.strings + number / 64, number % 64);
                let [bottom, top] = group.heights;
                self.not_behind[word] |= u64::from(lowest >= top - self.slack) << bit;
                self.not_in_front[word] |= u64::from(highest <= bottom + self.slack) << bit;
            }
        }
    }

    fn corners_of(&self, patch: usize) -> &[DVec3] {
        &self.corners[self.starts[patch]..self.starts[patch + 1]]
    }

    /// Whether every object stands in the way.
    pub fn all_block(&self) -> bool {
        self.casts_shadow.iter().all(|&casts| casts)
    }

    /// Whether an object stands in the way at all.
    pub fn includes(&self, object: u32) -> bool {
        self.casts_shadow[object as usize]
    }

    /// Whether anything can stand between two patches. False only where nothing does.
    pub fn can_stand_between(&self, i: usize, j: usize) -> bool {
        !matches!(self.between(i, j), Between::Nothing)
    }

    /// What can stand between two patches.
    pub(super) fn between(&self, i: usize, j: usize) -> Between {
        if self.has_too_many {
            return Between::TooMany;
        }
        let shaft = Shaft::of(self.corners_of(i), self.corners_of(j));
        let mut between = Vec::new();
        for word in 0..self.strings {
            let of = |bits: &[u64], patch: usize| bits[patch * self.strings + word];
            let (front_i, back_i) = (of(&self.not_behind, i), of(&self.not_in_front, i));
            let (front_j, back_j) = (of(&self.not_behind, j), of(&self.not_in_front, j));
            // On one side of the plane, or one of them in it: no ray between them crosses.
            let cannot =
                (front_i & front_j) | (back_i & back_j) | (front_i & back_i) | (front_j & back_j);
            let in_all = self.groups.len() - 64 * word;
            let all = if in_all >= 64 { !0 } else { (1 << in_all) - 1 };
            let mut can = !cannot & all;
            while can != 0 {
                let number = 64 * word + can.trailing_zeros() as usize;
                can &= can - 1;
                let group = &self.groups[number];
                if group.is_warped() && self.rises_from(i, j, group) {
                    continue;
                }
                if self.hides(number, &shaft, &mut between) {
                    return Between::Everything;
                }
            }
        }
        Between::of(between)
    }

    /// What can stand between two polygons, which need not be patches.
    pub(super) fn between_polygons(&self, a: &Polygon, b: &Polygon) -> Between {
        if self.has_too_many {
            return Between::TooMany;
        }
        let shaft = Shaft::of(&a.corners, &b.corners);
        let mut between = Vec::new();
        for (number, group) in self.groups.iter().enumerate() {
            let [bottom, top] = group.heights;
            let sides = [a, b].map(|polygon| {
                let heights = || polygon.corners.iter().map(|&corner| group.height(corner));
                let is_in_front = heights().all(|height| height >= top - self.slack);
                let is_behind = heights().all(|height| height <= bottom + self.slack);
                [is_in_front, is_behind]
            });
            let on_one_side = (0..2).any(|side| sides.iter().all(|of| of[side]));
            let lies_in_it = sides.contains(&[true, true]);
            if !on_one_side && !lies_in_it && self.hides(number, &shaft, &mut between) {
                return Between::Everything;
            }
        }
        Between::of(between)
    }

    /// Whether one face of a group hides all that the shaft joins. `between` takes the faces that may hide some of it.
    fn hides(&self, group: usize, shaft: &Shaft, between: &mut Vec<usize>) -> bool {
        for face in self.faces_of[group].clone() {
            match shaft.past(&self.faces[face], self.slack) {
                Sight::Free => {}
                Sight::Hidden => return true,
                Sight::Unclear => between.push(face),
            }
        }
        false
    }

    /// Whether every ray between two patches, one of a warped group, is steeper than the group anywhere: such a ray leaves the group and does
    /// not come back to it.
    fn rises_from(&self, i: usize, j: usize, group: &Group) -> bool {
        let heights = |patch: usize| {
            self.corners_of(patch)
                .iter()
                .map(|&corner| group.height(corner))
        };
        let rises = |from: usize, to: usize| {
            let top = heights(from).fold(f64::NEG_INFINITY, f64::max);
            let bottom = heights(to).fold(f64::INFINITY, f64::min);
            let distances = self
                .corners_of(from)
                .iter()
                .flat_map(|a| self.corners_of(to).iter().map(|b| a.distance(*b)));
            bottom - top > group.slope * distances.fold(0.0, f64::max)
        };
        (group.patches.contains(&i) && rises(i, j)) || (group.patches.contains(&j) && rises(j, i))
    }

    /// Whether a surface lies between two points of patches.
    pub fn stand_between(&self, x: &Sample, y: &Sample) -> bool {
        let [from, to] = [x, y].map(|sample| sample.point + self.lift * sample.normal);
        let distance = from.distance(to);
        distance > 0.0
            && self.primitives.blocked(
                &Ray {
                    origin: from,
                    direction: (to - from) / distance,
                },
                distance,
            )
    }
}

/// What can stand between two patches.
pub(super) enum Between {
    Nothing,
    /// One face hides all of one from the other.
    Everything,
    /// These faces, by number.
    Faces(Vec<usize>),
    /// More groups than are looked at one by one.
    TooMany,
}

impl Between {
    fn of(faces: Vec<usize>) -> Between {
        match faces.len() {
            0 => Between::Nothing,
            _ => Between::Faces(faces),
        }
    }
}
