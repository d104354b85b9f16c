//! A parallel projection in which both patches of a pair are seen well.

use crate::figure::Projection;
use crate::picture::Rect;
use crate::scene::patches::Patches;
use glam::DVec3;
use std::f64::consts::{GOLDEN_RATIO, TAU};

/// Directions that are tried.
const TRIED: u32 = 400;

/// Of the two patches, with some room around them.
pub fn view(patches: &Patches, [i, j]: [usize; 2], up: DVec3, area: Rect) -> Projection {
    let toward = toward_viewer(patches, [i, j], up);
    let across = up
        .cross(toward)
        .normalize_or(toward.any_orthonormal_vector());
    let up = toward.cross(across);
    let corners = [i, j].into_iter().flat_map(|patch| {
        let pieces = patches.pieces(patch);
        pieces.flat_map(|piece| piece.corners.to_vec())
    });
    let inner = area.grown(-(0.12 * area.width.min(area.height)));
    Projection::around(across, up, corners, inner)
}

/// The direction, of many all around, that is most across the line of centres while neither patch is seen from its edge, rather from
/// the front and a little from above.
fn toward_viewer(patches: &Patches, pair: [usize; 2], up: DVec3) -> DVec3 {
    let [i, j] = pair.map(|patch| &patches[patch]);
    let line = (j.center - i.center).normalize_or_zero();
    let seen = |normal: DVec3, toward: DVec3| {
        let cosine = normal.dot(toward);
        let facing = if cosine > 0.0 { 1.0 } else { 0.7 };
        facing * cosine.abs().min(0.5)
    };
    let score = |toward: DVec3| {
        let along = line.dot(toward);
        let [a, b] = [i.normal, j.normal].map(|normal| seen(normal, toward));
        1.0 - along * along + 2.0 * a.min(b) + 0.5 * (a + b) - (up.dot(toward) - 0.3).abs()
    };
    // Points of a spiral, evenly spread over the sphere.
    let directions = (0..TRIED).map(|k| {
        let z = 1.0 - (2.0 * f64::from(k) + 1.0) / f64::from(TRIED);
        let turn = TAU * f64::from(k) / GOLDEN_RATIO;
        let r = (1.0 - z * z).sqrt();
        DVec3::new(r * turn.cos(), r * turn.sin(), z)
    });
    directions
        .max_by(|a, b| score(*a).total_cmp(&score(*b)))
        .unwrap_or(DVec3::Z)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algorithms::focus::Focus;
    use crate::panels::fixtures::{FLOOR, LAMP, WALLS, open_room};

    #[test]
    fn neither_patch_is_seen_from_its_edge_nor_along_the_line_of_centres() {
        let fixture = open_room(Default::default(), Focus::FormFactor { i: 0, j: 1 });
        let room = fixture.run.enclosure().expect("it is a room");
        let pairs = [WALLS, [FLOOR[0], WALLS[0]], [FLOOR[1], LAMP], FLOOR];
        for [i, j] in pairs.map(|pair| pair.map(|patch| patch as usize)) {
            let patches = &room.patches;
            let toward = toward_viewer(patches, [i, j], DVec3::Y);
            let line = (patches[j].center - patches[i].center).normalize();
            assert!(toward.is_normalized() && line.dot(toward).abs() < 0.9);
            for patch in [i, j] {
                assert!(patches[patch].normal.dot(toward).abs() > 0.1, "{i} {j}");
            }
        }
    }
}
