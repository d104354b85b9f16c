//! The patches of a room as its camera sees them, in the painter's order.
//!
//! Only fronts are seen. Whoever stands outside looks through the backs of the near walls into the room.

use super::order::{Placed, painters_order};
use crate::algorithms::enclosure::Enclosure;
use crate::algorithms::prepared_scene::PreparedScene;
use crate::figure::Fit;
use crate::picture::Rect;
use crate::scene::View;
use glam::{DVec2, DVec3};

/// A patch that shows its front, as far as it lies in the camera's picture.
pub struct Seen {
    pub patch: usize,
    /// On the screen.
    pub pieces: Vec<Vec<DVec2>>,
}

pub struct RoomView<'a> {
    room: &'a Enclosure,
    pub view: View,
    /// The part of the screen that is shown.
    pub low: DVec2,
    pub high: DVec2,
    /// In the order in which they are painted.
    pub seen: Vec<Seen>,
}

impl<'a> RoomView<'a> {
    pub fn new(prepared: &PreparedScene, room: &'a Enclosure) -> Self {
        let view = prepared.view;
        let frame = DVec2::new(view.width.into(), view.height.into());
        let mut whole = RoomView {
            room,
            view,
            low: DVec2::ZERO,
            high: frame,
            seen: Vec::new(),
        };
        whole.seen = whole.in_order();
        let corners = whole
            .seen
            .iter()
            .flat_map(|seen| seen.pieces.iter().flatten());
        let (low, high) = corners.fold(
            (DVec2::INFINITY, DVec2::NEG_INFINITY),
            |(low, high), &corner| (low.min(corner), high.max(corner)),
        );
        if low.cmple(high).all() {
            (whole.low, whole.high) = (low, high);
        }
        whole
    }

    pub fn fit(&self, area: Rect) -> Fit {
        Fit::new(self.low, self.high, area)
    }

    /// How many corners all patches have together.
    pub fn corners(&self) -> usize {
        let pieces = self.seen.iter().flat_map(|seen| &seen.pieces);
        pieces.map(Vec::len).sum()
    }

    pub fn shows(&self, patch: usize) -> bool {
        self.seen.iter().any(|seen| seen.patch == patch)
    }

    /// The outlines of a patch on the screen, seen from its front or not.
    pub fn outlines(&self, patch: usize) -> Vec<Vec<DVec2>> {
        let pieces = self.room.patches.pieces(patch);
        let outlines = pieces.map(|piece| self.on_screen(piece.corners));
        outlines.filter(|outline| outline.len() > 2).collect()
    }

    /// None of a patch whose centre lies behind the camera.
    pub fn center(&self, patch: usize) -> Option<DVec2> {
        self.point(self.room.patches[patch].center)
    }

    /// None of a point that lies behind the camera.
    pub fn point(&self, point: DVec3) -> Option<DVec2> {
        let center = self.view.to_camera(point);
        (center.z >= self.view.near).then(|| self.view.to_screen(center))
    }

    fn in_order(&self) -> Vec<Seen> {
        let eye = self.view.eye;
        let patches = &self.room.patches;
        let mut seen: Vec<Seen> = (0..patches.len())
            .map(|patch| {
                let fronts = patches
                    .pieces(patch)
                    .filter(|piece| piece.normal.dot(eye - piece.corners[0]) > 0.0);
                let outlines = fronts.map(|piece| self.on_screen(piece.corners));
                Seen {
                    patch,
                    pieces: outlines.filter(|outline| outline.len() > 2).collect(),
                }
            })
            .filter(|seen| !seen.pieces.is_empty())
            .collect();
        let distance = |seen: &Seen| patches[seen.patch].center.distance_squared(eye);
        seen.sort_by(|a, b| distance(b).total_cmp(&distance(a)));
        let placed: Vec<Placed> = seen.iter().map(|seen| self.placed(seen)).collect();
        let mut seen: Vec<Option<Seen>> = seen.into_iter().map(Some).collect();
        painters_order(&placed)
            .into_iter()
            .filter_map(|next| seen[next].take())
            .collect()
    }

    fn placed(&self, seen: &Seen) -> Placed {
        let patch = &self.room.patches[seen.patch];
        let pieces = self.room.patches.pieces(seen.patch);
        let nothing = (DVec2::INFINITY, DVec2::NEG_INFINITY);
        let (low, high) = seen
            .pieces
            .iter()
            .flatten()
            .fold(nothing, |(low, high), &at| (low.min(at), high.max(at)));
        Placed {
            corners: pieces.flat_map(|piece| piece.corners).copied().collect(),
            center: patch.center,
            normal: patch.normal,
            radius: patch.radius,
            low,
            high,
        }
    }

    /// The part of a convex polygon that lies in front of the near plane and within what is shown.
    pub fn on_screen(&self, corners: &[DVec3]) -> Vec<DVec2> {
        let View { focal, near, .. } = self.view;
        let middle = 0.5 * DVec2::new(self.view.width.into(), self.view.height.into());
        let (left, top) = (self.low - middle).into();
        let (right, bottom) = (self.high - middle).into();
        let mut part: Vec<DVec3> = corners.iter().map(|&p| self.view.to_camera(p)).collect();
        part = cut(&part, |p| p.z - near);
        part = cut(&part, |p| focal * p.x - left * p.z);
        part = cut(&part, |p| right * p.z - focal * p.x);
        part = cut(&part, |p| -focal * p.y - top * p.z);
        part = cut(&part, |p| bottom * p.z + focal * p.y);
        part.into_iter().map(|p| self.view.to_screen(p)).collect()
    }
}

/// The part of a convex polygon where `inside`, which is linear, is not negative (Sutherland & Hodgman 1974).
fn cut(corners: &[DVec3], inside: impl Fn(DVec3) -> f64) -> Vec<DVec3> {
    let mut kept = Vec::with_capacity(corners.len() + 1);
    for (i, &to) in corners.iter().enumerate() {
        let from = corners[(i + corners.len() - 1) % corners.len()];
        let (before, after) = (inside(from), inside(to));
        if (before < 0.0) != (after < 0.0) {
            kept.push(from.lerp(to, before / (before - after)));
        }
        if after >= 0.0 {
            kept.push(to);
        }
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_lies_beyond_the_edge_is_cut_off() {
        let square = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]]
            .map(|[x, y]| DVec3::new(x, y, 2.0));
        let right = cut(&square, |p| p.x - 0.5);
        assert_eq!(right.len(), 4);
        assert!(right.iter().all(|p| p.x >= 0.5));
        assert_eq!(cut(&square, |p| p.x + 3.0), square);
        assert!(cut(&square, |p| p.x - 3.0).is_empty());
    }
}
