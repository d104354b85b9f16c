//! Clipping at the near plane and at the sides of the picture (Sutherland & Hodgman 1974, "Reentrant Polygon Clipping"), in the camera frame,
//! before the division by depth.

use super::corner::Corner;
use crate::numeric::Linear;
use crate::scene::View;
use glam::DVec3;

/// Keeps the part of `polygon` whose depth is at least `near`. The values at the corners are interpolated linearly in space.
///
/// Invariant: every corner of the result has depth ≥ `near` > 0. A concave polygon that is cut in two comes out as one,
/// joined by edges along the plane that enclose no area: even–odd filling draws nothing there.
pub fn clip_near<V: Linear>(polygon: &[Corner<V>], near: f64, clipped: &mut Vec<Corner<V>>) {
    clip(polygon, |position| position.z - near, clipped);
    for corner in clipped {
        corner.position.z = corner.position.z.max(near);
    }
}

/// Keeps the part of `polygon`, which lies in front of the eye, that the picture shows, and a margin of a pixel.
pub fn clip_to_picture<V: Linear>(
    polygon: &[Corner<V>],
    view: &View,
    clipped: &mut Vec<Corner<V>>,
) {
    const MARGIN: f64 = 1.0;
    let half = |pixels: u32| (0.5 * f64::from(pixels) + MARGIN) / view.focal;
    let (right, top) = (half(view.width), half(view.height));
    let mut polygon = polygon.to_vec();
    for side in [DVec3::X, DVec3::NEG_X, DVec3::Y, DVec3::NEG_Y] {
        let reach = right * side.x.abs() + top * side.y.abs();
        clip(
            &polygon,
            |position| reach * position.z - side.dot(position),
            clipped,
        );
        std::mem::swap(&mut polygon, clipped);
    }
    *clipped = polygon;
}

/// Keeps the part of `polygon` where `inside`, which is linear, is not negative.
fn clip<V: Linear>(
    polygon: &[Corner<V>],
    inside: impl Fn(DVec3) -> f64,
    clipped: &mut Vec<Corner<V>>,
) {
    clipped.clear();
    let inside = |corner: usize| inside(polygon[corner].position);
    clipped.extend(kept(polygon.len(), inside).map(|kept| match kept {
        Kept::Corner(corner) => polygon[corner],
        // Always from the hidden to the visible end, so that two polygons cut their common edge at the same point.
        Kept::Cut { hidden, seen } => {
            let t = inside(hidden) / (inside(hidden) - inside(seen));
            let (hidden, seen) = (polygon[hidden], polygon[seen]);
            Corner {
                position: hidden.position + (seen.position - hidden.position) * t,
                value: hidden.value.plus(seen.value.minus(hidden.value).times(t)),
            }
        }
    }));
}

/// A corner of a clipped polygon: one of its own, or where an edge between two of them is cut.
pub enum Kept {
    Corner(usize),
    Cut { hidden: usize, seen: usize },
}

/// The corners of a polygon of `count` corners that is clipped where `inside` of a corner is negative: from each corner back to the one
/// before, then the corner.
pub fn kept(count: usize, inside: impl Fn(usize) -> f64) -> impl Iterator<Item = Kept> {
    (0..count).flat_map(move |here| {
        let before = (here + count - 1) % count;
        let cut = match (inside(before) < 0.0, inside(here) < 0.0) {
            (true, false) => Some([before, here]),
            (false, true) => Some([here, before]),
            _ => None,
        };
        let cut = cut.map(|[hidden, seen]| Kept::Cut { hidden, seen });
        let corner = (inside(here) >= 0.0).then_some(Kept::Corner(here));
        cut.into_iter().chain(corner)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_triangle_with_one_corner_behind_becomes_a_quadrilateral() {
        let corner = |x: f64, y: f64, z: f64| Corner {
            position: DVec3::new(x, y, z),
            value: z,
        };
        let mut clipped = Vec::new();
        clip_near(
            &[
                corner(0.0, 0.0, -1.0),
                corner(2.0, 0.0, 1.0),
                corner(0.0, 2.0, 1.0),
            ],
            0.5,
            &mut clipped,
        );
        let places: Vec<DVec3> = clipped.iter().map(|corner| corner.position).collect();
        assert_eq!(
            places,
            [
                [0.0, 1.5, 0.5],
                [1.5, 0.0, 0.5],
                [2.0, 0.0, 1.0],
                [0.0, 2.0, 1.0]
            ]
            .map(DVec3::from)
        );
        assert!(
            clipped
                .iter()
                .all(|corner| corner.value == corner.position.z)
        );
        clip_near(
            &[
                corner(0.0, 0.0, -1.0),
                corner(2.0, 0.0, 0.1),
                corner(0.0, 2.0, 0.2),
            ],
            0.5,
            &mut clipped,
        );
        assert!(clipped.is_empty());
    }
}
