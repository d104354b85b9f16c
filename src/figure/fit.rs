//! From places of what is shown, be it the screen of the rendered picture or the world, to points in a figure.

use crate::picture::Rect;
use glam::{DVec2, DVec3, Vec2};

/// A scale and an offset.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fit {
    /// Points a pixel.
    pub scale: f64,
    offset: DVec2,
}

impl Fit {
    /// The part of the screen from `low` to `high` as large as it fits into `area`, in its middle. A part without extent is
    /// taken to be a tenth of a pixel large.
    pub fn new(low: DVec2, high: DVec2, area: Rect) -> Self {
        Fit::at_least(0.1, [low, high], area)
    }

    /// All points as large as they fit into `area`.
    pub fn around(points: impl IntoIterator<Item = DVec2>, area: Rect) -> Self {
        let [low, high] = ends(points);
        Fit::new(low, high, area)
    }

    /// A part that is taken to be at least so large.
    fn at_least(least: f64, [low, high]: [DVec2; 2], area: Rect) -> Self {
        let size = (high - low).max(DVec2::splat(least));
        let scale = (DVec2::new(area.width.into(), area.height.into()) / size).min_element();
        Fit::centered(0.5 * (low + high), scale, area)
    }

    /// The point `center` of the screen in the middle of `area`, at `scale` points a pixel.
    pub fn centered(center: DVec2, scale: f64, area: Rect) -> Self {
        Fit {
            scale,
            offset: area.center().as_dvec2() - center * scale,
        }
    }

    /// `scale` points a pixel, with the screen's upper left corner at `origin`.
    pub fn at_origin(origin: Vec2, scale: f64) -> Self {
        Fit {
            scale,
            offset: origin.as_dvec2(),
        }
    }

    pub fn x(&self, x: f64) -> f32 {
        (self.offset.x + self.scale * x) as f32
    }

    pub fn y(&self, y: f64) -> f32 {
        (self.offset.y + self.scale * y) as f32
    }

    pub fn place(&self, point: DVec2) -> Vec2 {
        Vec2::new(self.x(point.x), self.y(point.y))
    }

    /// The point that lies at a place: the inverse of [`Fit::place`].
    pub fn point(&self, place: Vec2) -> DVec2 {
        (place.as_dvec2() - self.offset) / self.scale
    }

    /// Pixels `first..end` of row `y`.
    pub fn pixels(&self, first: u32, end: u32, y: u32) -> Rect {
        let low = DVec2::new(first.into(), y.into());
        let high = DVec2::new(end.into(), f64::from(y) + 1.0);
        Rect::between(self.place(low), self.place(high))
    }
}

/// A parallel projection of the world onto a figure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Projection {
    /// Unit, to the right.
    pub across: DVec3,
    /// Unit, upward.
    pub up: DVec3,
    pub fit: Fit,
}

impl Projection {
    /// All points as large as they fit into `area`.
    pub fn around(
        across: DVec3,
        up: DVec3,
        points: impl IntoIterator<Item = DVec3>,
        area: Rect,
    ) -> Self {
        let flat = points.into_iter().map(|point| flat(across, up, point));
        let [low, high] = ends(flat);
        // The unit of length of a scene may be anything.
        let least = match (high - low).max_element() {
            0.0 => 1.0,
            size => 1e-3 * size,
        };
        let fit = Fit::at_least(least, [low, high], area);
        Projection { across, up, fit }
    }

    /// y down, as on the screen; before it is fitted.
    pub fn flat(&self, vector: DVec3) -> DVec2 {
        flat(self.across, self.up, vector)
    }

    pub fn place(&self, point: DVec3) -> Vec2 {
        self.fit.place(self.flat(point))
    }

    pub fn toward_viewer(&self) -> DVec3 {
        self.across.cross(self.up)
    }
}

/// The least and the largest coordinates.
fn ends(points: impl IntoIterator<Item = DVec2>) -> [DVec2; 2] {
    let points = points.into_iter().map(|point| [point; 2]);
    let ends = points.reduce(|[low, high], [point, _]| [low.min(point), high.max(point)]);
    ends.unwrap_or_default()
}

fn flat(across: DVec3, up: DVec3, vector: DVec3) -> DVec2 {
    DVec2::new(vector.dot(across), -vector.dot(up))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_part_fills_one_side_and_keeps_its_shape() {
        let area = Rect::new(10.0, 20.0, 200.0, 100.0);
        let (low, high) = (DVec2::new(4.0, 6.0), DVec2::new(14.0, 16.0));
        let fit = Fit::new(low, high, area);
        assert_eq!(fit.scale, 10.0);
        assert_eq!(fit.place(low), Vec2::new(60.0, 20.0));
        assert_eq!(fit.place(high), Vec2::new(160.0, 120.0));
        assert_eq!(fit.pixels(4, 6, 7), Rect::new(60.0, 30.0, 20.0, 10.0));
        assert!(fit.point(fit.place(low)).distance(low) < 1e-6);
        assert!(Fit::new(low, low, area).place(low).is_finite());
    }
}
