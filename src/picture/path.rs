//! Paths in pixels, for tiny-skia to fill and stroke.

use glam::Vec2;
use tiny_skia::{Path, PathBuilder};

use super::blit::PixelRect;
use super::rect::Rect;

/// How far a circular arc's control points stand off, in radii: 4/3·(√2 − 1).
const ARC: f32 = 0.552_284_8;

/// None through fewer than two points, or where one is not finite.
pub(super) fn path_through(points: impl IntoIterator<Item = Vec2>, closed: bool) -> Option<Path> {
    let mut path = PathBuilder::new();
    for point in points {
        if path.is_empty() {
            path.move_to(point.x, point.y);
        } else {
            path.line_to(point.x, point.y);
        }
    }
    if closed {
        path.close();
    }
    path.finish()
}

/// A rectangle `inset` within `outer`, whose corners there would have `radius`.
pub(super) fn rounded(outer: PixelRect, inset: f32, radius: f32) -> Option<Path> {
    let (left, top) = (outer.left as f32 + inset, outer.top as f32 + inset);
    let (right, bottom) = (outer.right as f32 - inset, outer.bottom as f32 - inset);
    let largest = 0.5 * (right - left).min(bottom - top);
    let r = (radius - inset).clamp(0.0, largest.max(0.0));
    let handle = r * (1.0 - ARC);
    let mut path = PathBuilder::new();
    path.move_to(left + r, top);
    path.line_to(right - r, top);
    path.cubic_to(right - handle, top, right, top + handle, right, top + r);
    path.line_to(right, bottom - r);
    path.cubic_to(
        right,
        bottom - handle,
        right - handle,
        bottom,
        right - r,
        bottom,
    );
    path.line_to(left + r, bottom);
    path.cubic_to(
        left + handle,
        bottom,
        left,
        bottom - handle,
        left,
        bottom - r,
    );
    path.line_to(left, top + r);
    path.cubic_to(left, top + handle, left + handle, top, left + r, top);
    path.close();
    path.finish()
}

/// The part of a segment within a rectangle (Liang and Barsky 1984), so that nothing is drawn or dashed unseen.
pub(super) fn segment_within(from: Vec2, to: Vec2, rect: Rect) -> Option<(Vec2, Vec2)> {
    if !from.is_finite() || !to.is_finite() {
        return None;
    }
    let along = to - from;
    let (mut enter, mut leave) = (0.0_f32, 1.0_f32);
    for axis in 0..2 {
        let low = (rect.min()[axis] - from[axis]) / along[axis];
        let high = (rect.max()[axis] - from[axis]) / along[axis];
        enter = enter.max(low.min(high));
        leave = leave.min(low.max(high));
    }
    (enter < leave).then(|| (from + enter * along, from + leave * along))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn segments_are_cut_where_they_leave() {
        let rect = Rect::new(0.0, 0.0, 10.0, 10.0);
        let within = |a: [f32; 2], b: [f32; 2]| segment_within(a.into(), b.into(), rect);
        assert_eq!(
            within([-10.0, -5.0], [20.0, 10.0]),
            Some((Vec2::new(0.0, 0.0), Vec2::new(10.0, 5.0)))
        );
        assert_eq!(
            within([2.0, 3.0], [4.0, 9.0]),
            Some((Vec2::new(2.0, 3.0), Vec2::new(4.0, 9.0)))
        );
        assert_eq!(within([-5.0, 4.0], [4.0, -6.0]), None);
        assert_eq!(within([f32::NAN, 0.0], [1.0, 1.0]), None);
    }
}
