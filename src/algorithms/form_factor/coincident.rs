//! Patches that lie in one place and face the same way: the one of the lower number is in front, and hides the other as far as it reaches.
//!
//! Surfaces that lie back to back, as the two sides of a thin wall, hide nothing of each other's front.

use super::faces::Face;
use super::polygon::{Polygon, polygons};
use super::sheet::Sheet;
use crate::scene::patches::Patches;
use glam::DVec3;
use std::ops::Range;

/// By patch, the convex parts that nothing of a lower number lies on; none where that is all of it.
pub type Exposed = Vec<Option<Vec<Polygon<'static>>>>;

/// `faces` are made of the patches in the ranges beside them. `slack` is how far rounding may have moved a corner.
pub fn exposed(patches: &Patches, faces: &[(Face, Range<usize>)], slack: f64) -> Exposed {
    let mut exposed: Exposed = vec![None; patches.len()];
    let boxes: Vec<[DVec3; 2]> = (0..patches.len())
        .map(|patch| {
            let corners = || {
                patches
                    .pieces(patch)
                    .flat_map(|piece| piece.corners)
                    .copied()
            };
            [
                corners().fold(DVec3::INFINITY, DVec3::min) - slack,
                corners().fold(DVec3::NEG_INFINITY, DVec3::max) + slack,
            ]
        })
        .collect();
    // Sorted along x: what may touch a face lies in a window that is as wide as the widest patch and the face.
    let mut order: Vec<usize> = (0..patches.len()).collect();
    order.sort_by(|&a, &b| boxes[a][0].x.total_cmp(&boxes[b][0].x));
    let widest = boxes
        .iter()
        .map(|[low, high]| high.x - low.x)
        .fold(0.0, f64::max);
    for (face, range) in faces {
        let start = order.partition_point(|&patch| boxes[patch][0].x < face.low.x - widest);
        let near = order[start..]
            .iter()
            .take_while(|&&patch| boxes[patch][0].x <= face.high.x);
        for &patch in near.filter(|&&patch| patch >= range.end) {
            let [low, high] = boxes[patch];
            if low.cmple(face.high).all() && high.cmpge(face.low).all() {
                cover(patches, patch, face, &mut exposed[patch], slack);
            }
        }
    }
    exposed
}

/// The surfaces that the patches make together, less what others lie on.
pub fn sheets(patches: &Patches, faces: &[(Face, Range<usize>)], exposed: &Exposed) -> Vec<Sheet> {
    let mut sheets: Vec<Polygon> = exposed.iter().flatten().flatten().cloned().collect();
    for (face, range) in faces {
        if range.clone().all(|patch| exposed[patch].is_none()) {
            sheets.extend(face.polygon());
        } else if range.len() > 1 {
            let bare = range.clone().filter(|&patch| exposed[patch].is_none());
            sheets.extend(bare.flat_map(|patch| polygons(patches, patch).map(Polygon::into_owned)));
        }
    }
    sheets.into_iter().map(Sheet::new).collect()
}

/// Takes a face away from a patch, as far as it lies on it.
fn cover(
    patches: &Patches,
    patch: usize,
    face: &Face,
    exposed: &mut Option<Vec<Polygon<'static>>>,
    slack: f64,
) {
    let Some(of_face) = face.polygon() else {
        return;
    };
    let whole = || polygons(patches, patch).map(Polygon::into_owned).collect();
    let parts: Vec<Polygon> = exposed.clone().unwrap_or_else(whole);
    let mut is_covered = false;
    let mut left = Vec::new();
    for part in parts {
        if !lies_on(&part, face, slack) {
            left.push(part);
            continue;
        }
        let (inside, outside) = part.parted_by(&of_face, slack);
        is_covered |= inside.is_some();
        left.extend(outside);
    }
    if is_covered {
        *exposed = Some(left);
    }
}

/// Whether a polygon lies in the plane of a face and looks the same way. The larger of the two knows its plane better.
fn lies_on(part: &Polygon, face: &Face, slack: f64) -> bool {
    let outline = &face.outline;
    let faces_alike = part.normal.dot(outline.normal) > 0.5;
    let in_plane = |corners: &[DVec3], normal: DVec3, point: DVec3| {
        corners
            .iter()
            .all(|&corner| normal.dot(corner - point).abs() <= slack)
    };
    faces_alike
        && (in_plane(&part.corners, outline.normal, outline.corners[0])
            || in_plane(&outline.corners, part.normal, part.corners[0]))
}
