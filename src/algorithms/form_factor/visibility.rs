//! What stands between two patches: which surfaces can, and how much they hide.
//!
//! Patches in one plane make a group. A group can stand between i and j only where its plane parts them, and where the shaft of the two
//! (Haines & Wallace 1991, "Shaft culling for efficient ray-traced radiosity") crosses that plane within the group's box. Only then are
//! rays cast, between points that a Sobol sequence spreads over both, each counted by what it would exchange.

use super::Event;
use super::area_to_area::{cosines, kernel};
use super::sample::{self, Sample};
use super::sobol::Sobol;
use crate::record::{Listing, Recorder};
use crate::scene::Scene;
use crate::scene::patch_solids::PatchSolids;
use crate::scene::patches::Patches;
use crate::scene::solids::Ray;
use glam::DVec3;

pub static PSEUDOCODE: Listing = Listing {
    name: "visibility",
    lines: &[
        "visible(i, j)",
        "  if no group of patches can stand between i and j: return 1",
        "  for each of n points (s, t, u, v) of a Sobol sequence",
        "    x ← point of i at (s, t);  y ← point of j at (u, v)",
        "    K ← cosθ_x cosθ_y / (π r²);  blocked ← whether the ray from x to y meets a surface",
        "  return Σ K over what is not blocked / Σ K",
    ],
};

/// Rays between a pair of patches: so many at first, and so many in all where they do not agree.
const RAYS: [u32; 2] = [16, 64];

/// Above so many groups no pair is looked at group by group.
const MOST_GROUPS: usize = 4096;

/// How far from a plane counts as in it, as a share of the scene's extent.
const SLACK: f64 = 1e-9;

/// The patches of a scene as they stand in each other's way. Objects that cast no shadow do not.
#[derive(Clone, Debug)]
pub struct Blockers {
    solids: PatchSolids,
    casts_shadow: Vec<bool>,
    groups: Vec<Group>,
    /// By patch, a bit a group: no corner behind its plane, and none in front.
    not_behind: Vec<u64>,
    not_in_front: Vec<u64>,
    words: usize,
    has_too_many: bool,
    slack: f64,
}

/// Patches of one object in one plane.
#[derive(Clone, Copy, Debug)]
struct Group {
    object: u32,
    normal: DVec3,
    point: DVec3,
    low: DVec3,
    high: DVec3,
}

impl Group {
    fn height(&self, point: DVec3) -> f64 {
        self.normal.dot(point - self.point)
    }
}

impl Blockers {
    pub fn of(scene: &Scene, patches: &Patches) -> Blockers {
        let solids = PatchSolids::of(scene, patches);
        let extent = (0..patches.len())
            .flat_map(|patch| corners(patches, patch))
            .fold(0.0, |extent, corner| corner.abs().max_element().max(extent));
        let slack = SLACK * extent;
        let mut groups = groups(scene, patches, slack);
        let has_too_many = groups.len() > MOST_GROUPS;
        if has_too_many {
            groups.clear();
        }
        let words = groups.len().div_ceil(64);
        let mut blockers = Blockers {
            solids,
            casts_shadow: scene
                .objects
                .iter()
                .map(|object| object.casts_shadow)
                .collect(),
            not_behind: vec![0; words * patches.len()],
            not_in_front: vec![0; words * patches.len()],
            groups,
            words,
            has_too_many,
            slack,
        };
        for patch in 0..patches.len() {
            for (number, group) in blockers.groups.iter().enumerate() {
                let heights = || corners(patches, patch).map(|corner| group.height(corner));
                let (word, bit) = (patch * words + number / 64, 1 << (number % 64));
                if heights().all(|height| height >= -slack) {
                    blockers.not_behind[word] |= bit;
                }
                if heights().all(|height| height <= slack) {
                    blockers.not_in_front[word] |= bit;
                }
            }
        }
        blockers
    }

    /// Whether an object stands in the way at all.
    pub fn includes(&self, object: u32) -> bool {
        self.casts_shadow[object as usize]
    }

    /// Whether anything can stand between two patches. False only where nothing does.
    pub fn can_stand_between(&self, patches: &Patches, i: usize, j: usize) -> bool {
        if self.has_too_many {
            return true;
        }
        (0..self.words).any(|word| {
            let of = |bits: &[u64], patch: usize| bits[patch * self.words + word];
            let (front_i, back_i) = (of(&self.not_behind, i), of(&self.not_in_front, i));
            let (front_j, back_j) = (of(&self.not_behind, j), of(&self.not_in_front, j));
            // On one side of the plane, or one of them in it: no ray between them crosses.
            let cannot =
                (front_i & front_j) | (back_i & back_j) | (front_i & back_i) | (front_j & back_j);
            let in_all = self.groups.len() - 64 * word;
            let all = if in_all >= 64 { !0 } else { (1 << in_all) - 1 };
            let mut can = !cannot & all;
            while can != 0 {
                let group = &self.groups[64 * word + can.trailing_zeros() as usize];
                if self.shaft_crosses(patches, i, j, group) {
                    return true;
                }
                can &= can - 1;
            }
            false
        })
    }

    /// Whether the convex hull of two patches crosses the plane of a group within its box.
    fn shaft_crosses(&self, patches: &Patches, i: usize, j: usize, group: &Group) -> bool {
        let (mut low, mut high) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        let all = || corners(patches, i).chain(corners(patches, j));
        for a in all() {
            let height_a = group.height(a);
            if height_a > 0.0 {
                continue;
            }
            for b in all() {
                let height_b = group.height(b);
                if height_b >= 0.0 {
                    let rise = height_b - height_a;
                    let crossing = if rise > 0.0 {
                        a - height_a / rise * (b - a)
                    } else {
                        a
                    };
                    low = low.min(crossing);
                    high = high.max(crossing);
                }
            }
        }
        (0..3).all(|axis| {
            // A box of no thickness is met, one that is only touched at its side is not.
            let slack = if group.high[axis] - group.low[axis] > 4.0 * self.slack {
                self.slack
            } else {
                -self.slack
            };
            low[axis] + slack <= group.high[axis] && group.low[axis] + slack <= high[axis]
        })
    }

    /// Whether a surface lies between two points of patches.
    pub fn stand_between(&self, x: &Sample, y: &Sample) -> bool {
        let [from, to] = [x, y].map(|sample| sample.point + 4.0 * self.slack * sample.normal);
        let distance = from.distance(to);
        distance > 0.0
            && self.solids.blocked(
                &Ray {
                    origin: from,
                    direction: (to - from) / distance,
                },
                distance,
            )
    }

    /// The share of what i and j would exchange that nothing blocks.
    pub fn share<R: Recorder<Event>>(
        &self,
        patches: &Patches,
        i: usize,
        j: usize,
        recorder: &mut R,
    ) -> f64 {
        if !self.can_stand_between(patches, i, j) {
            return 1.0;
        }
        let sobol = Sobol::new(((i as u64) << 32) | j as u64);
        let (mut whole, mut passing) = (0.0, 0.0);
        let mut cast = 0;
        for most in RAYS {
            for index in cast..most {
                let [s, t, u, v] = sobol.point(index);
                let x = sample::at(patches, i, [s, t]);
                let y = sample::at(patches, j, [u, v]);
                let [cos_x, cos_y, r2] = cosines(x.point, x.normal, y.point, y.normal);
                let exchanged = kernel(cos_x, cos_y, r2);
                if exchanged == 0.0 {
                    continue;
                }
                let blocked = self.stand_between(&x, &y);
                whole += exchanged;
                passing += if blocked { 0.0 } else { exchanged };
                recorder.step(|| Event::Sight {
                    x: x.point,
                    y: y.point,
                    blocked,
                    share: passing / whole,
                });
            }
            cast = most;
            if passing == 0.0 || passing == whole {
                break;
            }
        }
        // Where not one pair of points sees each other, there is nothing to share.
        let share = if whole > 0.0 { passing / whole } else { 1.0 };
        recorder.step(|| Event::Visible { rays: cast, share });
        share
    }
}

fn corners(patches: &Patches, patch: usize) -> impl Iterator<Item = DVec3> + Clone {
    patches
        .pieces(patch)
        .flat_map(|piece| piece.corners.iter().copied())
}

fn groups(scene: &Scene, patches: &Patches, slack: f64) -> Vec<Group> {
    let mut groups: Vec<Group> = Vec::new();
    for (number, patch) in patches.iter().enumerate() {
        if !scene.objects[patch.object as usize].casts_shadow {
            continue;
        }
        for piece in patches.pieces(number) {
            let corners = piece.corners.iter().copied();
            let low = corners.clone().fold(DVec3::INFINITY, DVec3::min);
            let high = corners.clone().fold(DVec3::NEG_INFINITY, DVec3::max);
            match groups.last_mut() {
                Some(group)
                    if group.object == patch.object
                        && corners
                            .clone()
                            .all(|corner| group.height(corner).abs() <= slack) =>
                {
                    group.low = group.low.min(low);
                    group.high = group.high.max(high);
                }
                _ => groups.push(Group {
                    object: patch.object,
                    normal: piece.normal,
                    point: piece.corners[0],
                    low,
                    high,
                }),
            }
        }
    }
    groups
}
