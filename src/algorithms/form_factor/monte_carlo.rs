//! Rays of a cosine distribution: F_ij is the share of them that meet j.
//!
//! From points of i, stratified by a Sobol sequence, in directions with the density cosθ/π (Malley 1988; Sillion & Puech 1994, Radiosity and
//! Global Illumination, §4.3). The error falls with the number of rays alone, be the patches near or far.

use super::Event;
use super::batches::batches;
use super::sample::{self, Sample};
use super::sobol::Sobol;
use super::visibility::Blockers;
use crate::record::{Listing, Recorder};
use crate::scene::patches::Patches;
use glam::DVec3;
use std::f64::consts::TAU;

pub static PSEUDOCODE: Listing = Listing {
    name: "Monte Carlo",
    lines: &[
        ("", "monteCarlo(i, j)"),
        (
            "rays",
            "  {for-each-of-n-points-s-t-u-v-of-a-sobol-sequence}",
        ),
        ("", "    x ← {the-point-of-i-at-s-t}"),
        (
            "",
            "    {direction} ← √u (cos 2πv, sin 2πv) {across-n-i}, √(1 − u) {along-it}",
        ),
        (
            "ray",
            "    {if-the-ray-meets-the-front-of-j-and-nothing-before} hits ← hits + 1",
        ),
        (
            "rays-cast",
            "    {after-16-64-256-samples} F ← hits / n;  s ← √(F (1 − F) / n)",
        ),
        ("", "  {return} hits / n"),
    ],
};

/// F_ij by so many rays.
pub fn form_factor<R: Recorder<Event>>(
    patches: &Patches,
    [i, j]: [usize; 2],
    rays: u32,
    seed: u64,
    blockers: Option<&Blockers>,
    recorder: &mut R,
) -> f64 {
    let sobol = Sobol::new(seed ^ ((i as u64) << 32));
    let mut hits = 0;
    for batch in batches(rays) {
        let [first, last] = [batch.start + 1, batch.end];
        recorder.enter(|| Event::Rays { first, last });
        for index in batch {
            let [s, t, u, v] = sobol.point(index);
            let sample = sample::at(patches, i, [s, t]);
            let (across, along) = sample.normal.any_orthonormal_pair();
            let (sin, cos) = (TAU * v).sin_cos();
            let direction = (u.sqrt() * (cos * across + sin * along)
                + (1.0 - u).sqrt() * sample.normal)
                .normalize();
            let met = meets(patches, j, sample.point, direction).is_some_and(|y| {
                blockers.is_none_or(|blockers| {
                    blockers.is_exposed(patches, i, sample.point)
                        && blockers.is_exposed(patches, j, y.point)
                        && !blockers.stand_between(&sample, &y)
                })
            });
            hits += u32::from(met);
            recorder.step(|| Event::Ray {
                x: sample.point,
                direction,
                met,
                hits,
            });
        }
        recorder.leave(|| {
            let f = f64::from(hits) / f64::from(last);
            Event::RaysCast {
                rays: last,
                f,
                error: (f * (1.0 - f) / f64::from(last)).sqrt(),
            }
        });
    }
    f64::from(hits) / f64::from(rays)
}

/// Where a ray meets the front of a patch.
fn meets(patches: &Patches, j: usize, x: DVec3, direction: DVec3) -> Option<Sample> {
    patches.pieces(j).find_map(|piece| {
        let facing = -piece.normal.dot(direction);
        let t = piece.normal.dot(x - piece.corners[0]) / facing;
        if !(facing > 0.0 && t > 0.0) {
            return None;
        }
        let y = x + t * direction;
        let last = piece.corners[piece.corners.len() - 1];
        let mut before = last;
        let inside = piece.corners.iter().all(|&corner| {
            let left = (corner - before).cross(y - before).dot(piece.normal) >= 0.0;
            before = corner;
            left
        });
        inside.then_some(Sample {
            point: y,
            normal: piece.normal,
        })
    })
}
