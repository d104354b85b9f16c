//! The hemicube: a half cube over a point of i, whose pixels each stand for a known share of the point's light.
//!
//! Cohen & Greenberg 1985, "The hemi-cube: a radiosity solution for complex environments", equations 11 and 12. The surfaces nearest to the point
//! are found pixel by pixel in a depth buffer. Taken at the centre alone, the result does not improve with the resolution: what one point sees
//! is not what the patch sees. Several points do.

use super::Event;
use super::sample::{self, Sample};
use super::visibility::Blockers;
use crate::record::{Listing, Recorder};
use crate::scene::patches::{Patches, Piece};
use glam::DVec3;
use std::f64::consts::PI;

pub static PSEUDOCODE: Listing = Listing {
    name: "hemicube",
    lines: &[
        ("", "hemicube(i, j)"),
        ("hemicube", "  {for-each-of-n-by-n-points-x-of-i}"),
        ("", "    {draw-what-stands-in-the-way-onto-the-five-faces}"),
        (
            "",
            "    {for-each-pixel-u-v-whose-centre-j-covers-nearest-of-all}",
        ),
        (
            "pixel",
            "      F_x ← F_x + ΔF,  ΔF = ΔA/(π(u² + v² + 1)²) {on-top},  v ΔA/(π(u² + v² + 1)²) {at-the-sides}",
        ),
        ("hemicube-seen", "    F_ij ← F_ij + F_x / n²"),
    ],
};

/// How the hemicubes of a patch are made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Hemicubes {
    /// Pixels along an edge of the top, an even number.
    pub resolution: u32,
    /// Hemicubes along each side of the patch: one stands at the centre.
    pub points: u32,
}

/// A face: directions `forward` + u·`right` + v·`up`, −1 ≤ u ≤ 1.
#[derive(Clone, Copy, Debug)]
struct Face {
    right: DVec3,
    up: DVec3,
    forward: DVec3,
    /// The rows of pixels that lie above the horizon, of those from v = −1 to 1.
    first_row: u32,
}

impl Hemicubes {
    /// F_ij, with the patches that `blocks` names in the way.
    pub fn form_factor<R: Recorder<Event>>(
        self,
        patches: &Patches,
        [i, j]: [usize; 2],
        blockers: Option<&Blockers>,
        recorder: &mut R,
    ) -> f64 {
        let mut mean = 0.0;
        let mut number = 0;
        self.each_point(patches, i, blockers, |x, faces, depths, share| {
            recorder.enter(|| Event::Hemicube {
                hemicube: number,
                x,
                resolution: self.resolution,
            });
            number += 1;
            let f = self.seen(patches, j, x, (faces, depths), blockers, recorder);
            mean += share * f;
            recorder.leave(|| Event::HemicubeSeen { f, mean });
        });
        mean
    }

    /// F_ij for every j.
    pub fn row(self, patches: &Patches, i: usize, blockers: Option<&Blockers>, row: &mut [f64]) {
        row.fill(0.0);
        self.each_point(patches, i, blockers, |x, faces, depths, share| {
            for (j, f) in row.iter_mut().enumerate() {
                if j != i {
                    *f += share
                        * self.seen(
                            patches,
                            j,
                            x,
                            (faces, depths),
                            blockers,
                            &mut crate::record::Unrecorded,
                        );
                }
            }
        });
    }

    /// Shows the point, the faces, their depth buffers and the share of each hemicube.
    fn each_point(
        self,
        patches: &Patches,
        i: usize,
        blockers: Option<&Blockers>,
        mut at: impl FnMut(DVec3, &[Face; 5], &[f64], f64),
    ) {
        let n = self.points;
        let side = self.resolution as usize;
        let mut depths = vec![f64::INFINITY; 5 * side * side];
        let blocks = |k: usize| blockers.is_some_and(|all| all.includes(patches[k].object));
        let in_the_way: Vec<usize> = (0..patches.len())
            .filter(|&k| k != i && blocks(k))
            .collect();
        for row in 0..n {
            for column in 0..n {
                let place = [column, row].map(|k| (f64::from(k) + 0.5) / f64::from(n));
                let Sample { point: x, normal } = sample::at(patches, i, place);
                if blockers.is_some_and(|blockers| !blockers.is_exposed(patches, i, x)) {
                    continue;
                }
                let faces = faces(normal, self.resolution);
                depths.fill(f64::INFINITY);
                for &k in &in_the_way {
                    for piece in patches.pieces(k) {
                        self.cover(&piece, x, &faces, |pixel, _, t| {
                            depths[pixel] = depths[pixel].min(t);
                        });
                    }
                }
                at(x, &faces, &depths, 1.0 / f64::from(n * n));
            }
        }
    }

    /// F from the point to the front of patch j.
    fn seen<R: Recorder<Event>>(
        self,
        patches: &Patches,
        j: usize,
        x: DVec3,
        (faces, depths): (&[Face; 5], &[f64]),
        blockers: Option<&Blockers>,
        recorder: &mut R,
    ) -> f64 {
        let mut sum = 0.0;
        for piece in patches.pieces(j) {
            if piece.normal.dot(x - piece.corners[0]) <= 0.0 {
                continue;
            }
            self.cover(&piece, x, faces, |pixel, [face, column, row], t| {
                let is_hidden = |blockers: &Blockers| {
                    let y = x + t * self.direction(&faces[face as usize], column, row);
                    !blockers.is_exposed(patches, j, y)
                };
                if t > depths[pixel] * (1.0 + 1e-9) || blockers.is_some_and(is_hidden) {
                    return;
                }
                let delta = self.delta(face, column, row);
                sum += delta;
                recorder.step(|| Event::Pixel {
                    face,
                    x: column,
                    y: row,
                    delta,
                    sum,
                });
            });
        }
        sum
    }

    /// Through the centre of a pixel, as long as the depth of the face is 1.
    fn direction(self, face: &Face, column: u32, row: u32) -> DVec3 {
        face.forward + self.at(column) * face.right + self.at(row) * face.up
    }

    /// u or v at the centre of a column or row.
    fn at(self, pixel: u32) -> f64 {
        (f64::from(pixel) + 0.5) * 2.0 / f64::from(self.resolution) - 1.0
    }

    /// ΔF of a pixel.
    fn delta(self, face: u32, column: u32, row: u32) -> f64 {
        let (u, v) = (self.at(column), self.at(row));
        let size = 2.0 / f64::from(self.resolution);
        let r2 = u * u + v * v + 1.0;
        let cosine = if face == 0 { 1.0 } else { v };
        cosine * size * size / (PI * r2 * r2)
    }

    /// Calls `covers` for each pixel whose centre sees the piece: its place in the buffers, [face, column, row], and the depth.
    fn cover(
        self,
        piece: &Piece,
        x: DVec3,
        faces: &[Face; 5],
        mut covers: impl FnMut(usize, [u32; 3], f64),
    ) {
        let height = piece.normal.dot(piece.corners[0] - x);
        if height == 0.0 {
            return;
        }
        let side = self.resolution;
        for (face, number) in faces.iter().zip(0_u32..) {
            let Some([columns, rows]) = self.bounds(piece, x, face) else {
                continue;
            };
            for row in rows[0].max(face.first_row)..rows[1] {
                for column in columns[0]..columns[1] {
                    let direction = self.direction(face, column, row);
                    if is_inside(piece, x, direction, height > 0.0) {
                        let pixel = ((number * side + row) * side + column) as usize;
                        let t = height / piece.normal.dot(direction);
                        covers(pixel, [number, column, row], t);
                    }
                }
            }
        }
    }

    /// The columns and rows that a piece may cover.
    fn bounds(self, piece: &Piece, x: DVec3, face: &Face) -> Option<[[u32; 2]; 2]> {
        let side = f64::from(self.resolution);
        let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        let (mut ahead, mut behind) = (false, false);
        for &corner in piece.corners {
            let r = corner - x;
            let depth = face.forward.dot(r);
            if depth <= 1e-9 * r.length() {
                behind = true;
                continue;
            }
            ahead = true;
            for (axis, along) in [face.right, face.up].into_iter().enumerate() {
                let pixel = (along.dot(r) / depth + 1.0) * 0.5 * side;
                low[axis] = low[axis].min(pixel);
                high[axis] = high[axis].max(pixel);
            }
        }
        if !ahead {
            return None;
        }
        // What reaches behind the face may be seen anywhere on it.
        let range = |axis: usize| {
            if behind {
                [0, self.resolution]
            } else {
                let within = |pixel: f64| pixel.clamp(0.0, side) as u32;
                [
                    within((low[axis] - 1.0).floor()),
                    within((high[axis] + 1.0).ceil()),
                ]
            }
        };
        Some([range(0), range(1)])
    }
}

/// The top, and the sides above the horizon.
fn faces(normal: DVec3, resolution: u32) -> [Face; 5] {
    let (a, b) = normal.any_orthonormal_pair();
    let side = |right: DVec3, forward: DVec3| Face {
        right,
        up: normal,
        forward,
        first_row: resolution / 2,
    };
    [
        Face {
            right: a,
            up: b,
            forward: normal,
            first_row: 0,
        },
        side(a, b),
        side(b, -a),
        side(-a, -b),
        side(-b, a),
    ]
}

/// Whether a ray from `x` meets the piece, seen from behind or from its front. Of two pieces with a common edge exactly one is met there.
fn is_inside(piece: &Piece, x: DVec3, direction: DVec3, from_behind: bool) -> bool {
    let mut before = piece.corners[piece.corners.len() - 1] - x;
    let sign = if from_behind { 1.0 } else { -1.0 };
    piece.normal.dot(direction) * sign > 0.0
        && piece.corners.iter().all(|&corner| {
            let after = corner - x;
            let across = sign * before.cross(after);
            before = after;
            let side = across.dot(direction);
            side > 0.0 || (side == 0.0 && across.to_array() > [0.0; 3])
        })
}
