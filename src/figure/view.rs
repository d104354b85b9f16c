//! How much of a figure is looked at: a choice of the viewer, which changes nothing of what it shows.

use crate::picture::Rect;
use glam::Vec2;

/// The part of a figure that is drawn, and how large.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// 1 where the whole fits, at most [`View::LARGEST`].
    pub zoom: f32,
    /// The place in the middle, as shares of the figure's width and height; none where nobody has chosen one.
    pub center: Option<Vec2>,
}

impl View {
    pub const LARGEST: f32 = 32.0;
    pub const WHOLE: View = View {
        zoom: 1.0,
        center: None,
    };

    /// `factor` times as large about its middle.
    pub fn zoomed(&self, factor: f32) -> Self {
        let zoom = (self.zoom * factor).clamp(1.0, View::LARGEST);
        let center = self.center.filter(|_| zoom > 1.0);
        View {
            zoom,
            center: center.map(|center| within(center, zoom)),
        }
    }

    /// `factor` times as large about a place, where `middle` is in the middle now. The place is `from_middle` points from the
    /// middle of an area `size` points large.
    pub fn zoomed_about(&self, factor: f32, middle: Vec2, from_middle: Vec2, size: Vec2) -> Self {
        let zoomed = self.zoomed(factor);
        if zoomed.zoom == 1.0 {
            return zoomed;
        }
        let kept = middle + from_middle / (self.zoom * size);
        let center = kept - from_middle / (zoomed.zoom * size);
        View {
            center: Some(within(center, zoomed.zoom)),
            ..zoomed
        }
    }

    /// Dragged by so many points.
    pub fn dragged(&self, by: Vec2, middle: Vec2, size: Vec2) -> Self {
        let center = within(middle - by / (self.zoom * size), self.zoom);
        View {
            center: Some(center).filter(|_| self.zoom > 1.0),
            ..*self
        }
    }

    /// The middle of the part that is drawn, where nothing else chooses one.
    pub fn middle(&self) -> Vec2 {
        self.center.unwrap_or(Vec2::splat(0.5))
    }

    /// The part that is drawn, in shares of the figure.
    pub fn part(&self) -> Rect {
        let half = Vec2::splat(0.5 / self.zoom);
        Rect::between(self.middle() - half, self.middle() + half)
    }
}

/// The nearest middle that shows nothing beyond the figure.
fn within(center: Vec2, zoom: f32) -> Vec2 {
    let half = 0.5 / zoom;
    center.clamp(Vec2::splat(half), Vec2::splat(1.0 - half))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_under_the_pointer_stays_there() {
        let (size, from_middle) = (Vec2::new(400.0, 300.0), Vec2::new(60.0, -40.0));
        let view = View::WHOLE.zoomed(4.0);
        let middle = Vec2::new(0.5, 0.4);
        let place = middle + from_middle / (view.zoom * size);
        let nearer = view.zoomed_about(1.5, middle, from_middle, size);
        let after = nearer.center.unwrap() + from_middle / (nearer.zoom * size);
        assert!(place.distance(after) < 1e-6);
    }

    #[test]
    fn nothing_beyond_the_figure_is_shown_and_the_whole_has_no_place_of_its_own() {
        let size = Vec2::new(400.0, 300.0);
        let middle = Vec2::splat(0.5);
        let view = View::WHOLE
            .zoomed(2.0)
            .dragged(Vec2::splat(1e6), middle, size);
        assert_eq!(view.center, Some(Vec2::splat(0.25)));
        assert_eq!(view.part(), Rect::new(0.0, 0.0, 0.5, 0.5));
        assert_eq!(view.zoomed(0.1), View::WHOLE);
        assert_eq!(View::WHOLE.dragged(Vec2::X, middle, size), View::WHOLE);
    }
}
