//! Points of a patch at (s, t) in [0, 1]², evenly spread over its area.

use crate::scene::patches::{Patches, Piece};
use glam::DVec3;

/// A point of a patch, with the unit normal there.
#[derive(Clone, Copy, Debug)]
pub struct Sample {
    pub point: DVec3,
    pub normal: DVec3,
}

/// The point of `patch` at (s, t). Equal areas of the square go to equal areas of the patch.
pub fn at(patches: &Patches, patch: usize, [mut s, t]: [f64; 2]) -> Sample {
    let area = patches[patch].area;
    let mut chosen = None;
    // s chooses the piece, and what is left of it a place there.
    for piece in patches.pieces(patch) {
        let share = piece.area / area;
        chosen = Some((piece, (s / share).min(1.0)));
        if s < share {
            break;
        }
        s -= share;
    }
    match chosen {
        Some((piece, s)) => Sample {
            point: on_piece(&piece, s, t),
            normal: piece.normal,
        },
        None => Sample {
            point: patches[patch].center,
            normal: patches[patch].normal,
        },
    }
}

fn on_piece(piece: &Piece, mut s: f64, t: f64) -> DVec3 {
    let corners = piece.corners;
    if let [a, b, c, d] = *corners
        && (a + c).distance(b + d) <= 1e-9 * a.distance(c)
    {
        return a + s * (b - a) + t * (d - a);
    }
    let first = corners[0];
    let mut point = first;
    for pair in corners[1..].windows(2) {
        let (b, c) = (pair[0] - first, pair[1] - first);
        let share = 0.5 * b.cross(c).length() / piece.area;
        let along = (s / share).min(1.0);
        // Even over a triangle (Turk 1990, "Generating random points in triangles").
        let out = along.sqrt();
        point = first + out * ((1.0 - t) * b + t * c);
        if s < share {
            break;
        }
        s -= share;
    }
    point
}
