//! From the screen of the rendered picture, in pixels, to places in a panel, in points.

use crate::algorithms::prepared_scene::PreparedScene;
use crate::picture::Rect;
use crate::replay::shading::State;
use glam::{DVec2, Vec2};

/// A scale and an offset.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Fit {
    /// Points a pixel.
    pub scale: f64,
    offset: DVec2,
}

impl Fit {
    /// The part of the screen from `low` to `high` as large as it fits into `area`, in its middle. A part without extent is
    /// taken to be a tenth of a pixel large.
    pub fn new(low: DVec2, high: DVec2, area: Rect) -> Self {
        let size = (high - low).max(DVec2::splat(0.1));
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

/// The corners of the current polygon on the screen: as they were recorded, and before that as they are prepared.
pub(super) fn outline(state: &State) -> Vec<DVec2> {
    if !state.edges.is_empty() {
        let corners = state.corners.iter();
        return corners
            .map(|corner| DVec2::new(corner.x, corner.y))
            .collect();
    }
    state.polygon.map_or_else(Vec::new, |polygon| {
        staged(&state.prepared, polygon.polygon as usize)
    })
}

/// The corners of a polygon of the scene, on the screen; those before the near plane have no place there.
pub(super) fn staged(prepared: &PreparedScene, polygon: usize) -> Vec<DVec2> {
    prepared.polygon(polygon).map_or_else(Vec::new, |polygon| {
        let corners = polygon.corners().map(|(_, vertex)| vertex);
        corners
            .filter(|vertex| vertex.camera.z >= prepared.view.near)
            .map(|vertex| vertex.screen)
            .collect()
    })
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
