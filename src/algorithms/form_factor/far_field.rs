//! Far pairs by the row: the double area integral at 2 × 2 Gauss points a patch, for one i and many j at a time.
//!
//! The same sum as [`super::area_to_area`], laid out so that several j go through the processor at once. Which pairs are far enough is
//! decided as in [`super::auto`].

use crate::scene::patches::Patches;
use glam::DVec3;
use std::f64::consts::PI;
use std::ops::Range;

const POINTS: usize = 4;
/// How many j go together.
const LANES: usize = 8;

/// The patches of a scene, one array a quantity.
#[derive(Clone, Debug, Default)]
pub struct Far {
    center: [Vec<f64>; 3],
    normal: [Vec<f64>; 3],
    /// Infinite for patches that are never far: those of several pieces, or of more than four corners.
    radius: Vec<f64>,
    /// Half the sides of a rectangle about the centre that holds the patch.
    sides: [[Vec<f64>; 3]; 2],
    points: [[Vec<f64>; 3]; POINTS],
    weights: [Vec<f64>; POINTS],
    slack: f64,
}

type Lanes = [f64; LANES];

impl Far {
    pub fn of(patches: &Patches) -> Far {
        let mut far = Far::default();
        let mut extent = 0.0_f64;
        for (number, patch) in patches.iter().enumerate() {
            let (points, is_simple) = points(patches, number);
            let sides = sides(patches, number);
            push(&mut far.center, patch.center);
            push(&mut far.normal, patch.normal);
            for (arrays, side) in far.sides.iter_mut().zip(sides) {
                push(arrays, side);
            }
            far.radius.push(if is_simple {
                patch.radius
            } else {
                f64::INFINITY
            });
            extent = extent.max(patch.center.abs().max_element() + patch.radius);
            for (k, (point, weight)) in points.into_iter().enumerate() {
                push(&mut far.points[k], point);
                far.weights[k].push(weight);
            }
        }
        far.slack = 16.0 * f64::EPSILON * extent;
        far
    }

    /// A_i F_ij for j in `range`; NaN where the two are not far enough for `tolerance`.
    pub fn row(&self, i: usize, range: Range<usize>, tolerance: f64, out: &mut [f64]) {
        let mut start = range.start;
        for out in out.chunks_mut(LANES) {
            // The last lanes of the last chunk repeat the last patch.
            let found = self.lanes(i, start, range.end - 1, tolerance);
            out.copy_from_slice(&found[..out.len()]);
            start += LANES;
        }
    }

    #[inline(always)]
    fn lanes(&self, i: usize, start: usize, last: usize, tolerance: f64) -> Lanes {
        if start + LANES <= last + 1 {
            self.exchange(i, tolerance, |of| {
                let mut lanes = [0.0; LANES];
                lanes.copy_from_slice(&of[start..start + LANES]);
                lanes
            })
        } else {
            self.exchange(i, tolerance, |of| {
                std::array::from_fn(|lane| of[(start + lane).min(last)])
            })
        }
    }

    #[inline(always)]
    fn exchange(&self, i: usize, tolerance: f64, load: impl Fn(&[f64]) -> Lanes) -> Lanes {
        let [cx, cy, cz] = [0, 1, 2].map(|axis| load(&self.center[axis]));
        let [nx, ny, nz] = [0, 1, 2].map(|axis| load(&self.normal[axis]));
        let radius_j = load(&self.radius);
        let [ix, iy, iz] = [0, 1, 2].map(|axis| self.center[axis][i]);
        let [ax, ay, az] = [0, 1, 2].map(|axis| self.normal[axis][i]);
        let radius_i = self.radius[i];
        let sides_i = [0, 1].map(|side| [0, 1, 2].map(|axis| self.sides[side][axis][i]));
        let sides_j = [0, 1].map(|side| [0, 1, 2].map(|axis| load(&self.sides[side][axis])));
        let mut state: Lanes = [0.0; LANES];
        let mut some_far = false;
        for lane in 0..LANES {
            let (dx, dy, dz) = (cx[lane] - ix, cy[lane] - iy, cz[lane] - iz);
            let distance = (dx * dx + dy * dy + dz * dz).sqrt();
            let height_j = ax * dx + ay * dy + az * dz;
            let height_i = -(nx[lane] * dx + ny[lane] * dy + nz[lane] * dz);
            // How far a patch reaches on both sides of its centre, along the other's normal.
            let rise_i: f64 = sides_i
                .iter()
                .map(|[x, y, z]| (nx[lane] * x + ny[lane] * y + nz[lane] * z).abs())
                .sum();
            let rise_j: f64 = sides_j
                .iter()
                .map(|[x, y, z]| (ax * x[lane] + ay * y[lane] + az * z[lane]).abs())
                .sum();
            let behind = height_j + rise_j <= self.slack || height_i + rise_i <= self.slack;
            let in_front = height_j >= rise_j - self.slack && height_i >= rise_i - self.slack;
            let radius = radius_i.max(radius_j[lane]);
            let x = distance / radius - 0.5;
            let height = height_i.min(height_j);
            let is_far =
                in_front && x > 2.0 && x * x * x * x * height * tolerance >= FAR * distance;
            state[lane] = if behind {
                0.0
            } else if is_far {
                1.0
            } else {
                f64::NAN
            };
            some_far |= is_far;
        }
        if !some_far {
            return state;
        }
        // N_i·(y − x) is the same for all x, N_j·(x − y) for all y.
        let mut sum: Lanes = [0.0; LANES];
        for l in 0..POINTS {
            let [yx, yy, yz] = [0, 1, 2].map(|axis| load(&self.points[l][axis]));
            let weight = load(&self.weights[l]);
            let mut of_l: Lanes = [0.0; LANES];
            for k in 0..POINTS {
                let [px, py, pz] = [0, 1, 2].map(|axis| self.points[k][axis][i]);
                let weight_k = self.weights[k][i];
                for lane in 0..LANES {
                    let (rx, ry, rz) = (px - yx[lane], py - yy[lane], pz - yz[lane]);
                    let r2 = rx * rx + ry * ry + rz * rz;
                    let cos_y = nx[lane] * rx + ny[lane] * ry + nz[lane] * rz;
                    of_l[lane] += weight_k * cos_y / (r2 * r2);
                }
            }
            for lane in 0..LANES {
                let cos_x = ax * (yx[lane] - ix) + ay * (yy[lane] - iy) + az * (yz[lane] - iz);
                sum[lane] += of_l[lane] * weight[lane] * cos_x;
            }
        }
        for lane in 0..LANES {
            // Zero and NaN stay what they are.
            state[lane] = if state[lane] == 1.0 {
                sum[lane] / PI
            } else {
                state[lane]
            };
        }
        state
    }
}

fn push(arrays: &mut [Vec<f64>; 3], vector: DVec3) {
    for (array, coordinate) in arrays.iter_mut().zip(vector.to_array()) {
        array.push(coordinate);
    }
}

/// By how much (R/d)⁴ · d/h stands below the tolerance in a far pair: found by measuring, see the tests.
const FAR: f64 = 0.15;

/// Half the sides, one of them along the first edge, of a rectangle about the centre that holds the patch.
///
/// Without end where the patch is not planar: neither in front of another nor behind it.
fn sides(patches: &Patches, patch: usize) -> [DVec3; 2] {
    if patches.pieces(patch).len() > 1 {
        return [DVec3::INFINITY; 2];
    }
    let center = patches[patch].center;
    let corners = || patches.pieces(patch).flat_map(|piece| piece.corners);
    let first = patches.pieces(patch).next().map_or(DVec3::X, |piece| {
        (piece.corners[1] - piece.corners[0]).normalize_or(DVec3::X)
    });
    [first, patches[patch].normal.cross(first)].map(|side| {
        let reach = corners().map(|&corner| (corner - center).dot(side).abs());
        reach.fold(0.0, f64::max) * side
    })
}

/// Four points exact to the third degree, and whether they are the patch's.
fn points(patches: &Patches, patch: usize) -> ([(DVec3, f64); POINTS], bool) {
    let mut pieces = patches.pieces(patch);
    let mut found = [(patches[patch].center, 0.0); POINTS];
    let is_single = pieces.len() == 1;
    let Some(piece) = pieces.next().filter(|_| is_single) else {
        return (found, false);
    };
    match *piece.corners {
        [a, b, c] => {
            found = triangle_points([a, b, c], piece.area);
            (found, true)
        }
        [a, b, c, d] => (
            quadrilateral_points([a, b, c, d], piece.normal),
            is_almost_a_parallelogram([a, b, c, d]),
        ),
        _ => (found, false),
    }
}

/// How far a fourth corner may be from where it would make a parallelogram, as a share of the shortest side: the size of the element of area
/// then varies so little that it takes no point more.
const ALMOST: f64 = 1e-3;

fn is_almost_a_parallelogram([a, b, c, d]: [DVec3; 4]) -> bool {
    let shortest = [b - a, c - b, d - c, a - d]
        .into_iter()
        .map(DVec3::length)
        .fold(f64::INFINITY, f64::min);
    (a - b + c - d).length() <= ALMOST * shortest
}

/// Two points of Gauss each way of the bilinear map, weighted by its element of area.
fn quadrilateral_points([a, b, c, d]: [DVec3; 4], normal: DVec3) -> [(DVec3, f64); POINTS] {
    let half = 0.5 / 3.0_f64.sqrt();
    std::array::from_fn(|k| {
        let [u, v] = [k % 2, k / 2].map(|side| if side == 0 { 0.5 - half } else { 0.5 + half });
        let along_u = (1.0 - v) * (b - a) + v * (c - d);
        let along_v = (1.0 - u) * (d - a) + u * (c - b);
        let point = (1.0 - v) * (a + u * (b - a)) + v * (d + u * (c - d));
        (point, 0.25 * along_u.cross(along_v).dot(normal))
    })
}

/// The conical product of two points of Gauss and two of Gauss & Jacobi with the weight 1 − v (Stroud 1971, Approximate Calculation of Multiple Integrals, §2.4).
fn triangle_points([a, b, c]: [DVec3; 3], area: f64) -> [(DVec3, f64); POINTS] {
    let root = 6.0_f64.sqrt();
    let rows = [
        ((4.0 - root) / 10.0, (9.0 + root) / 36.0),
        ((4.0 + root) / 10.0, (9.0 - root) / 36.0),
    ];
    let half = 0.5 / 3.0_f64.sqrt();
    std::array::from_fn(|k| {
        let (v, weight) = rows[k / 2];
        let u = if k % 2 == 0 { 0.5 - half } else { 0.5 + half };
        (a + (1.0 - v) * u * (b - a) + v * (c - a), weight * area)
    })
}
