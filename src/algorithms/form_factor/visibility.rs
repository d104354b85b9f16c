//! What stands between two patches: which surfaces can, and how much they hide.
//!
//! Patches in one plane make a group. A group can stand between i and j only where its plane parts them, and where the shaft of the two
//! (Haines & Wallace 1991, "Shaft culling for efficient ray-traced radiosity") crosses that plane within the group's box. Only then are
//! rays cast, between points that a Sobol sequence spreads over both, each counted by what it would exchange.

use super::Event;
use super::area_to_area::{cosines, kernel};
use super::groups::{Group, groups};
use super::sample::{self, Sample};
use super::sobol::Sobol;
use crate::record::{Listing, Recorder};
use crate::scene::patches::Patches;
use crate::scene::primitives::{Primitives, Ray};
use crate::scene::{Mesh, Scene, Shape, Tessellation};
use glam::DVec3;

pub static PSEUDOCODE: Listing = Listing {
    name: "visibility",
    lines: &[
        ("", "visible(i, j)"),
        ("", "  {if-nothing-can-stand-between-return-1}"),
        ("", "  {for-each-of-n-points-s-t-u-v-of-a-sobol-sequence}"),
        ("", "    x ← {point-of-i-at-s-t};  y ← {point-of-j-at-u-v}"),
        (
            "sight",
            "    K ← cosθ_x cosθ_y / (π r²);  blocked ← {whether-the-ray-from-x-to-y-meets-a-surface}",
        ),
        ("visible", "  {return} Σ K {over-what-is-not-blocked} / Σ K"),
    ],
};

/// Rays for a form factor of 1: a pair gets its share of them, so that a row takes no more, within [`LEAST_RAYS`] and [`MOST_RAYS`].
const RAYS_A_ROW: f64 = 32_768.0;
const LEAST_RAYS: u32 = 8;
const MOST_RAYS: u32 = 1024;

/// So many times as many where the first ones do not agree.
const UNCLEAR: u32 = 4;

/// Above so many groups no pair is looked at group by group.
const MOST_GROUPS: usize = 4096;

/// How far from a plane counts as in it, as a share of the scene's extent.
const SLACK: f64 = 1e-9;

/// The patches of a scene as they stand in each other's way. Objects that cast no shadow do not.
#[derive(Clone, Debug)]
pub struct Blockers {
    primitives: Primitives,
    casts_shadow: Vec<bool>,
    /// Patch `p` has the corners `starts[p]..starts[p + 1]`.
    starts: Vec<usize>,
    corners: Vec<DVec3>,
    groups: Vec<Group>,
    /// By patch, a bit a group: no corner behind its plane, and none in front.
    not_behind: Vec<u64>,
    not_in_front: Vec<u64>,
    strings: usize,
    has_too_many: bool,
    slack: f64,
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
            strings,
            has_too_many,
            slack,
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
        if self.has_too_many {
            return true;
        }
        (0..self.strings).any(|word| {
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
                let group = &self.groups[64 * word + can.trailing_zeros() as usize];
                let crosses = match group.is_warped() {
                    true => !self.rises_from(i, j, group),
                    false => self.shaft_crosses(i, j, group),
                };
                if crosses {
                    return true;
                }
                can &= can - 1;
            }
            false
        })
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

    /// Whether the convex hull of two patches crosses the plane of a group within its box.
    fn shaft_crosses(&self, i: usize, j: usize, group: &Group) -> bool {
        const MOST_CORNERS: usize = 16;
        let [of_i, of_j] = [i, j].map(|patch| self.corners_of(patch));
        let count = of_i.len() + of_j.len();
        if count > MOST_CORNERS {
            return true;
        }
        let mut corners = [(DVec3::ZERO, 0.0); MOST_CORNERS];
        for (place, &corner) in corners.iter_mut().zip(of_i.iter().chain(of_j)) {
            *place = (corner, group.height(corner));
        }
        let (mut low, mut high) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        for &(a, height_a) in &corners[..count] {
            if height_a > 0.0 {
                continue;
            }
            for &(b, height_b) in &corners[..count] {
                if height_b >= 0.0 {
                    let rise = height_b - height_a;
                    let share = if rise > 0.0 { -height_a / rise } else { 0.0 };
                    let crossing = a + share * (b - a);
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
            && self.primitives.blocked(
                &Ray {
                    origin: from,
                    direction: (to - from) / distance,
                },
                distance,
            )
    }

    /// The share of what i and j would exchange that nothing blocks, found by rays, and its standard error. `f` is the larger of their form factors if nothing did.
    pub fn share<R: Recorder<Event>>(
        &self,
        patches: &Patches,
        [i, j]: [usize; 2],
        f: f64,
        recorder: &mut R,
    ) -> [f64; 2] {
        let rays = ((f * RAYS_A_ROW) as u32)
            .clamp(LEAST_RAYS, MOST_RAYS)
            .next_power_of_two();
        let sobol = Sobol::new(((i as u64) << 32) | j as u64);
        let (mut whole, mut passing) = (0.0, 0.0);
        let mut cast = 0;
        while cast < rays || (cast < UNCLEAR * rays && passing > 0.0 && passing < whole) {
            let [s, t, u, v] = sobol.point(cast);
            cast += 1;
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
        // Where not one pair of points faces each other, nothing is known to be hidden.
        let share = if whole > 0.0 { passing / whole } else { 1.0 };
        recorder.step(|| Event::Visible { rays: cast, share });
        [share, (share * (1.0 - share) / f64::from(cast)).sqrt()]
    }
}

/// The groups as a scene: every object a mesh of those of its patches that stand in the way.
fn facets(scene: &Scene, patches: &Patches, groups: &[Group]) -> Scene {
    let mut scene = scene.clone();
    let mut meshes: Vec<(Vec<DVec3>, Vec<Vec<u32>>)> =
        vec![Default::default(); scene.objects.len()];
    for group in groups {
        let (positions, faces) = &mut meshes[group.object as usize];
        let pieces = (group.patches.clone()).flat_map(|patch| patches.pieces(patch).enumerate());
        for (_, piece) in pieces.filter(|&(number, _)| group.piece.is_none_or(|one| one == number))
        {
            let first = positions.len() as u32;
            positions.extend(piece.corners);
            faces.push((first..positions.len() as u32).collect());
        }
    }
    for (object, (positions, faces)) in scene.objects.iter_mut().zip(meshes) {
        object.shape = Shape::Mesh(Mesh::new(&positions, faces, &[]));
    }
    scene
}
