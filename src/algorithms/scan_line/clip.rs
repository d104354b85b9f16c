//! Clipping at the near plane (Sutherland & Hodgman 1974), in the camera frame, before the division by depth.

use super::corner::Corner;
use crate::numeric::Linear;
use glam::DVec3;

/// Keeps the part of `polygon` whose depth is at least `near`. The values at the corners are interpolated linearly in space.
///
/// Invariant: every corner of the result has depth ≥ `near` > 0. A concave polygon that is cut in two comes out as one,
/// joined by edges along the plane that enclose no area: even–odd filling draws nothing there.
pub fn clip_near<V: Linear>(polygon: &[Corner<V>], near: f64, clipped: &mut Vec<Corner<V>>) {
    clipped.clear();
    for (index, &corner) in polygon.iter().enumerate() {
        let previous = polygon[(index + polygon.len() - 1) % polygon.len()];
        if (previous.position.z < near) != (corner.position.z < near) {
            // Always from the hidden to the visible end, so that two polygons cut their common edge at the same point.
            let (hidden, seen) = if corner.position.z < near {
                (corner, previous)
            } else {
                (previous, corner)
            };
            let t = (near - hidden.position.z) / (seen.position.z - hidden.position.z);
            let position = hidden.position + (seen.position - hidden.position) * t;
            clipped.push(Corner {
                position: DVec3::new(position.x, position.y, near),
                value: hidden.value.plus(seen.value.minus(hidden.value).times(t)),
            });
        }
        if corner.position.z >= near {
            clipped.push(corner);
        }
    }
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
