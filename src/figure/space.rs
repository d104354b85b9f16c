//! A view of space: a parallel or a perspective projection onto a part of a figure, which also knows what lies nearer.

use super::fit::Fit;
use super::labels::within;
use crate::picture::Rect;
use glam::{DVec2, DVec3, Vec2};

/// What lies nearer to the viewer than this share of the viewer's distance is cut off.
const NEAREST: f64 = 0.02;

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Space {
    /// Unit, to the right.
    pub right: DVec3,
    /// Unit, upward.
    pub up: DVec3,
    /// Unit, toward the viewer.
    pub toward: DVec3,
    /// The point that the viewer looks at.
    pub pivot: DVec3,
    /// From the pivot to the viewer; none of a parallel projection.
    pub distance: Option<f64>,
    /// From lengths at the pivot to points of the figure.
    pub fit: Fit,
    /// Nothing is drawn outside.
    pub area: Rect,
}

/// A point of the world as it is seen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Seen {
    /// In the figure.
    pub at: Vec2,
    /// Larger is nearer, in lengths of the world about the pivot; linear on the figure along lines and over planes.
    pub nearness: f32,
    /// How much larger things are drawn than at the pivot.
    pub scale: f32,
}

impl Space {
    /// x to the right, y up, z toward the viewer, from the pivot.
    pub fn seen_from(&self, point: DVec3) -> DVec3 {
        let from_pivot = point - self.pivot;
        DVec3::new(
            from_pivot.dot(self.right),
            from_pivot.dot(self.up),
            from_pivot.dot(self.toward),
        )
    }

    /// A direction on the figure, y down; of a parallel projection.
    pub fn flat(&self, direction: DVec3) -> Vec2 {
        DVec2::new(direction.dot(self.right), -direction.dot(self.up)).as_vec2()
    }

    /// None of a point too near to the viewer, or behind.
    pub fn seen(&self, point: DVec3) -> Option<Seen> {
        let point = self.seen_from(point);
        (self.depth(point) >= 0.0).then(|| self.projected(point))
    }

    pub fn place(&self, point: DVec3) -> Option<Vec2> {
        Some(self.seen(point)?.at)
    }

    /// The part of a line that lies before the viewer and in the area.
    pub fn line(&self, from: DVec3, to: DVec3) -> Option<[Seen; 2]> {
        let ends = [from, to].map(|end| self.seen_from(end));
        let depths = ends.map(|end| self.depth(end));
        let cut = |inside: usize| {
            let share = depths[inside] / (depths[inside] - depths[1 - inside]);
            ends[inside].lerp(ends[1 - inside], share)
        };
        let [from, to] = match depths.map(|depth| depth >= 0.0) {
            [true, true] => ends,
            [true, false] => [ends[0], cut(0)],
            [false, true] => [cut(1), ends[1]],
            [false, false] => return None,
        }
        .map(|end| self.projected(end));
        let [start, end] = within([from.at, to.at], self.area)?;
        if !(start.is_finite() && end.is_finite()) {
            return None;
        }
        let along = to.at - from.at;
        let length = along.length_squared();
        let at = |place: Vec2| {
            let share = if length > 0.0 {
                ((place - from.at).dot(along) / length).clamp(0.0, 1.0)
            } else {
                0.0
            };
            Seen {
                at: place,
                nearness: from.nearness + share * (to.nearness - from.nearness),
                scale: from.scale + share * (to.scale - from.scale),
            }
        };
        Some([at(start), at(end)])
    }

    /// The part of a convex polygon that lies before the viewer (Sutherland & Hodgman 1974): the place of each corner in the
    /// world, and as it is seen.
    pub fn polygon(&self, corners: &[DVec3]) -> Vec<(DVec3, Seen)> {
        let placed = |corner: DVec3| (corner, self.projected(self.seen_from(corner)));
        let depth = |corner: DVec3| self.depth(self.seen_from(corner));
        if corners.iter().all(|&corner| depth(corner) >= 0.0) {
            return corners.iter().map(|&corner| placed(corner)).collect();
        }
        let mut kept = Vec::with_capacity(corners.len() + 1);
        for (i, &to) in corners.iter().enumerate() {
            let from = corners[(i + corners.len() - 1) % corners.len()];
            let (before, after) = (depth(from), depth(to));
            if (before < 0.0) != (after < 0.0) {
                kept.push(placed(from.lerp(to, before / (before - after))));
            }
            if after >= 0.0 {
                kept.push(placed(to));
            }
        }
        kept
    }

    /// The point of the world at a place of the figure, as far from the viewer as `beside`.
    pub fn lift(&self, at: Vec2, beside: DVec3) -> DVec3 {
        let z = self.seen_from(beside).z;
        let flat = self.fit.point(at.clamp(self.area.min(), self.area.max())) / self.magnified(z);
        self.pivot + flat.x * self.right - flat.y * self.up + z * self.toward
    }

    /// Points a length of the world at the pivot.
    pub fn scale(&self) -> f32 {
        self.fit.scale as f32
    }

    /// Before the viewer; negative what is too near or behind.
    fn depth(&self, seen: DVec3) -> f64 {
        self.distance
            .map_or(1.0, |distance| (1.0 - NEAREST) * distance - seen.z)
    }

    fn magnified(&self, z: f64) -> f64 {
        self.distance
            .map_or(1.0, |distance| distance / (distance - z))
    }

    fn projected(&self, seen: DVec3) -> Seen {
        let scale = self.magnified(seen.z);
        Seen {
            at: self.fit.place(scale * DVec2::new(seen.x, -seen.y)),
            nearness: (scale * seen.z) as f32,
            scale: scale as f32,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn space(distance: Option<f64>) -> Space {
        let area = Rect::new(0.0, 0.0, 200.0, 100.0);
        Space {
            right: DVec3::X,
            up: DVec3::Y,
            toward: DVec3::Z,
            pivot: DVec3::new(1.0, 2.0, 3.0),
            distance,
            fit: Fit::centered(DVec2::ZERO, 10.0, area),
            area,
        }
    }

    #[test]
    fn what_lies_nearer_is_larger_in_perspective_alone() {
        let point = DVec3::new(2.0, 4.0, 5.0);
        let parallel = space(None).seen(point).unwrap();
        assert_eq!(parallel.at, Vec2::new(110.0, 30.0));
        assert_eq!((parallel.nearness, parallel.scale), (2.0, 1.0));
        // 2 before the pivot, which is 4 away: twice as large.
        let perspective = space(Some(4.0)).seen(point).unwrap();
        assert_eq!(perspective.at, Vec2::new(120.0, 10.0));
        assert_eq!(perspective.scale, 2.0);
    }

    #[test]
    fn a_place_lifted_back_is_the_point_it_was() {
        let point = DVec3::new(3.5, 1.0, 4.5);
        for space in [space(None), space(Some(6.0))] {
            let lifted = space.lift(space.place(point).unwrap(), point);
            assert!(lifted.distance(point) < 1e-6, "{lifted}");
        }
    }

    #[test]
    fn nearness_is_linear_on_the_figure() {
        let space = space(Some(6.0));
        let ends = [DVec3::new(-1.0, 1.0, 1.0), DVec3::new(5.0, 3.0, 6.0)];
        let [from, to] = ends.map(|end| space.seen(end).unwrap());
        let middle = space.seen(ends[0].lerp(ends[1], 0.3)).unwrap();
        let share = middle.at.distance(from.at) / to.at.distance(from.at);
        let linear = from.nearness + share * (to.nearness - from.nearness);
        assert!((middle.nearness - linear).abs() < 1e-4);
    }

    #[test]
    fn what_passes_the_viewer_is_cut_off() {
        let space = space(Some(4.0));
        let (before, behind) = (DVec3::new(1.0, 2.0, 0.0), DVec3::new(1.5, 2.0, 20.0));
        assert!(space.seen(behind).is_none());
        let [from, to] = space.line(before, behind).unwrap();
        assert_eq!(from, space.seen(before).unwrap());
        assert!(space.area.contains(to.at) && to.at.x > from.at.x);
        let triangle = space.polygon(&[before, behind, DVec3::new(0.0, 2.0, 0.0)]);
        assert_eq!(triangle.len(), 4);
        assert!(triangle.iter().all(|(corner, _)| corner.z <= 3.0 + 4.0));
    }
}
