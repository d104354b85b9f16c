//! An axis-aligned rectangle in logical points, x to the right, y down.

use glam::Vec2;

/// A rectangle by its upper left corner and its size; the size is never negative.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct Rect {
    pub x: f32,
    pub y: f32,
    pub width: f32,
    pub height: f32,
}

impl Rect {
    pub fn new(x: f32, y: f32, width: f32, height: f32) -> Self {
        Rect {
            x,
            y,
            width: width.max(0.0),
            height: height.max(0.0),
        }
    }

    /// The rectangle between two opposite corners, whichever they are.
    pub fn between(a: impl Into<Vec2>, b: impl Into<Vec2>) -> Self {
        let (a, b) = (a.into(), b.into());
        let (low, size) = (a.min(b), (a - b).abs());
        Rect::new(low.x, low.y, size.x, size.y)
    }

    /// The smallest rectangle around `points`; none around no points.
    pub fn around(points: impl IntoIterator<Item = Vec2>) -> Option<Self> {
        points
            .into_iter()
            .map(|point| (point, point))
            .reduce(|(low, high), (point, _)| (low.min(point), high.max(point)))
            .map(|(low, high)| Rect::between(low, high))
    }

    pub fn right(&self) -> f32 {
        self.x + self.width
    }

    pub fn bottom(&self) -> f32 {
        self.y + self.height
    }

    pub fn min(&self) -> Vec2 {
        Vec2::new(self.x, self.y)
    }

    pub fn max(&self) -> Vec2 {
        Vec2::new(self.right(), self.bottom())
    }

    pub fn center(&self) -> Vec2 {
        0.5 * (self.min() + self.max())
    }

    pub fn is_empty(&self) -> bool {
        self.width <= 0.0 || self.height <= 0.0
    }

    /// Half-open: the left and upper edges belong to it, the right and lower ones do not.
    pub fn contains(&self, point: Vec2) -> bool {
        point.cmpge(self.min()).all() && point.cmplt(self.max()).all()
    }

    /// Moved by `offset`.
    pub fn shifted(&self, offset: Vec2) -> Rect {
        Rect::new(
            self.x + offset.x,
            self.y + offset.y,
            self.width,
            self.height,
        )
    }

    /// Every edge moved outwards by `distance`, inwards if negative (at most to the centre).
    pub fn grown(&self, distance: f32) -> Rect {
        let distance = distance.max(-0.5 * self.width.min(self.height));
        Rect::new(
            self.x - distance,
            self.y - distance,
            self.width + 2.0 * distance,
            self.height + 2.0 * distance,
        )
    }

    /// The common part, of zero size where there is none.
    pub fn intersection(&self, other: &Rect) -> Rect {
        let low = self.min().max(other.min());
        let size = self.max().min(other.max()) - low;
        Rect::new(low.x, low.y, size.x, size.y)
    }

    /// The smallest rectangle around both.
    pub fn union(&self, other: &Rect) -> Rect {
        Rect::between(self.min().min(other.min()), self.max().max(other.max()))
    }

    /// Whether `other` lies inside, edges included.
    pub fn encloses(&self, other: &Rect) -> bool {
        other.min().cmpge(self.min()).all() && other.max().cmple(self.max()).all()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn neighbours_share_no_point() {
        let (left, right) = (
            Rect::new(0.0, 0.0, 2.0, 2.0),
            Rect::between([4.0, 2.0], [2.0, 0.0]),
        );
        let border = Vec2::new(2.0, 1.0);
        assert!(!left.contains(border) && right.contains(border));
        assert!(left.intersection(&right).is_empty());
        assert_eq!(left.union(&right), Rect::new(0.0, 0.0, 4.0, 2.0));
        assert_eq!(left.grown(-5.0), Rect::new(1.0, 1.0, 0.0, 0.0));
    }
}
