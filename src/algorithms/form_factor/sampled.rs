//! Visibility by rays.

use super::area_to_area::{cosines, kernel};
use super::batches::batches;
use super::polygon::Polygon;
use super::sample::{self, Sample};
use super::sobol::Sobol;
use super::visibility::Blockers;
use super::{Event, view};
use crate::record::{Listing, Recorder};
use crate::scene::patches::Patches;

pub static PSEUDOCODE: Listing = Listing {
    name: "visibility by rays",
    lines: &[
        ("", "visibleByRays(i, j)"),
        (
            "sights",
            "  {for-each-of-n-points-s-t-u-v-of-a-sobol-sequence}",
        ),
        ("", "    x ← {point-of-i-at-s-t};  y ← {point-of-j-at-u-v}"),
        (
            "sight",
            "    K ← cosθ_x cosθ_y / (π r²);  blocked ← {whether-the-ray-from-x-to-y-meets-a-surface}",
        ),
        (
            "sights-taken",
            "    {after-16-64-256-samples} V ← Σ v_k / Σ w_k;  s ← √Σ (v_k − V w_k)² / Σ w_k",
        ),
        ("", "  {return} Σ K {over-what-is-not-blocked} / Σ K"),
    ],
};

/// Rays for a form factor of 1: a pair gets its share of them, so that a row takes no more, within [`LEAST_RAYS`] and [`MOST_RAYS`].
const RAYS_A_ROW: f64 = 65_536.0;
const LEAST_RAYS: u32 = 16;
const MOST_RAYS: u32 = 16_384;
/// So many of them leave from each point.
const RAYS_A_POINT: u32 = 8;

/// The share of what i and j would exchange that nothing blocks, and its standard error. `f` is the larger of their form factors if
/// nothing did.
///
/// A point of i counts by its exact form factor to j, a ray by its share of the rays of its point: no weight is singular where i and j touch.
/// The number of rays does not depend on what they meet, which would favour what the first of them say.
pub fn share<R: Recorder<Event>>(
    blockers: &Blockers,
    patches: &Patches,
    [i, j]: [usize; 2],
    f: f64,
    recorder: &mut R,
) -> [f64; 2] {
    let rays = ((f * RAYS_A_ROW) as u32)
        .clamp(LEAST_RAYS, MOST_RAYS)
        .next_power_of_two();
    // One sequence for the points of i and one for those of j: every eighth point of a sequence covers a part of the square only.
    let seed = ((i as u64) << 32) | j as u64;
    let [of_i, of_j] = [seed, !seed].map(Sobol::new);
    let others = blockers.polygons(patches, j);
    // By point: its weight, and the part of it that arrives.
    let mut points: Vec<[f64; 2]> = Vec::new();
    let (mut whole, mut passing) = (0.0, 0.0);
    for batch in batches(rays) {
        let [first, last] = [batch.start + 1, batch.end];
        recorder.enter(|| Event::Sights { first, last });
        for number in batch.start / RAYS_A_POINT..batch.end / RAYS_A_POINT {
            let [s, t, ..] = of_i.point(number);
            let x = sample::at(patches, i, [s, t]);
            if !blockers.is_exposed(patches, i, x.point) {
                continue;
            }
            let weight: f64 = others.iter().map(|other| from_element(&x, other)).sum();
            let (mut of_all, mut of_free) = (0.0, 0.0);
            for ray in 0..RAYS_A_POINT {
                let [u, v, ..] = of_j.point(number * RAYS_A_POINT + ray);
                let y = sample::at(patches, j, [u, v]);
                let [cos_x, cos_y, r2] = cosines(x.point, x.normal, y.point, y.normal);
                let exchanged = kernel(cos_x, cos_y, r2);
                if exchanged == 0.0 || !blockers.is_exposed(patches, j, y.point) {
                    continue;
                }
                let blocked = blockers.stand_between(&x, &y);
                of_all += exchanged;
                of_free += if blocked { 0.0 } else { exchanged };
                recorder.step(|| Event::Sight {
                    x: x.point,
                    y: y.point,
                    blocked,
                    share: (passing + weight * of_free / of_all) / (whole + weight),
                });
            }
            if of_all > 0.0 && weight > 0.0 {
                points.push([weight, weight * of_free / of_all]);
                whole += weight;
                passing += weight * of_free / of_all;
            }
        }
        recorder.leave(|| {
            let [share, error] = estimate(&points, [whole, passing]);
            Event::SightsTaken {
                rays: last,
                share,
                error,
            }
        });
    }
    let [share, spread] = estimate(&points, [whole, passing]);
    // Where all agree, one more point could still have said otherwise.
    let error = spread.max(1.0 / f64::from(rays));
    recorder.step(|| Event::Visible { rays, share });
    [share, error]
}

/// The share that passes, and its standard error: that of a ratio of two sums (Cochran 1977, Sampling Techniques, §2.11).
fn estimate(points: &[[f64; 2]], [whole, passing]: [f64; 2]) -> [f64; 2] {
    let share = if whole > 0.0 { passing / whole } else { 0.0 };
    let square = |[weight, free]: &[f64; 2]| (free - share * weight).powi(2);
    let spread = points.iter().map(square).sum::<f64>().sqrt();
    [share, spread / whole.max(f64::MIN_POSITIVE)]
}

/// F from an element to the part of a polygon above its horizon.
fn from_element(x: &Sample, other: &Polygon) -> f64 {
    if other.normal.dot(x.point - other.corners[0]) <= 0.0 {
        return 0.0;
    }
    let horizon = Polygon::plane(x.point, x.normal);
    let above = other.clone().in_front_of(&horizon, 0.0);
    above.map_or(0.0, |above| {
        view::from_element(x.point, x.normal, &above.corners)
    })
}
