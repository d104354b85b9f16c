//! A span, its pixels, and the depth test of each.
//!
//! Polygons are drawn in the order of the objects, and what is as near as what was drawn before, within rounding, does not replace it: of
//! surfaces in one plane the first in the file is in front, without stripes.

use super::edge::{Edge, first_centre};
use super::event::Event;
use super::varying::Varying;
use crate::algorithms::frame::Frame;
use crate::color::Rgb;
use crate::numeric::{Linear, Ramp};
use crate::record::Recorder;
use crate::scene::View;
use glam::{DVec2, DVec3};
use std::ops::Range;

/// The pixels `first..end` of row `y`, those whose centres lie in [x_4, x_5).
pub struct Span<V> {
    y: u32,
    pub x_4: f64,
    pub x_5: f64,
    /// The values at x_4 and x_5, as interpolated along the edges.
    pub left: V,
    pub right: V,
    inverse_depths: [f64; 2],
    depth_error: f64,
    first: u32,
    end: u32,
    /// Those of its pixels that are drawn.
    columns: Range<u32>,
}

/// A pixel inside a polygon.
#[derive(Clone, Copy, Debug)]
pub struct Pixel {
    pub x: u32,
    pub y: u32,
    /// The first pixel of its span.
    pub first: u32,
    /// 1/depth, as interpolated by increments.
    pub inverse_depth: f64,
    /// How far rounding may have put it off.
    pub depth_error: f64,
}

impl<V: Varying> Span<V> {
    pub(super) fn between(
        left: &Edge<V>,
        right: &Edge<V>,
        y: u32,
        columns: &Range<u32>,
        view: &View,
    ) -> Self {
        let (x_4, x_5) = (left.x_4, right.x_4);
        let (first, end) = (first_centre(x_4, view.width), first_centre(x_5, view.width));
        let inverse_depths = [left.inverse_depth.value, right.inverse_depth.value];
        Span {
            y,
            x_4,
            x_5,
            left: left.value.value,
            right: right.value.value,
            inverse_depths,
            depth_error: depth_error(inverse_depths, [x_4, x_5], view),
            first,
            end,
            columns: first.max(columns.start)..end.min(columns.end),
        }
    }

    pub fn entered(&self) -> Event<V::Recorded> {
        Event::Span {
            x_4: self.x_4,
            x_5: self.x_5,
            z_4: 1.0 / self.inverse_depths[0],
            z_5: 1.0 / self.inverse_depths[1],
            first: self.first,
            end: self.end,
        }
    }

    pub fn ends(&self) -> Event<V::Recorded> {
        Event::SpanEnds {
            left: self.left.recorded(),
            right: self.right.recorded(),
        }
    }

    /// The (u, v) of a texture, where there is one.
    pub fn textured(&self) -> Option<Event<V::Recorded>> {
        Some(Event::SpanTextured {
            left: self.left.texture()?,
            right: self.right.texture()?,
        })
    }

    /// A quantity that is `a_4` at the left end of the span and `a_5` at the right end, at the first pixel that is drawn.
    /// Increments count from the first pixel of the span.
    #[inline]
    pub fn ramp<T: Linear>(&self, a_4: T, a_5: T) -> Ramp<T> {
        let start = f64::from(self.first) + 0.5;
        let mut ramp = Ramp::start(a_4, self.x_4, a_5, self.x_5, start);
        for _ in self.first..self.columns.start {
            ramp.advance();
        }
        ramp
    }

    /// The pixels that are drawn, from left to right. There may be none.
    #[inline]
    pub fn pixels(&self) -> impl Iterator<Item = Pixel> + use<V> {
        let [left, right] = self.inverse_depths;
        let mut inverse_depth = self.ramp(left, right);
        let (y, first, depth_error) = (self.y, self.first, self.depth_error);
        self.columns.clone().map(move |x| {
            let pixel = Pixel {
                x,
                y,
                first,
                inverse_depth: inverse_depth.value,
                depth_error,
            };
            inverse_depth.advance();
            pixel
        })
    }
}

/// How far rounding may put 1/depth off in a span, generously: by the corners' places in the world, by the sums of increments, and by the
/// columns where the span begins and ends.
fn depth_error(inverse_depths: [f64; 2], [x_4, x_5]: [f64; 2], view: &View) -> f64 {
    const OF_SUMS: f64 = 1.0 / (1_u64 << 36) as f64;
    const OF_COLUMN: f64 = 1.0 / (1_u64 << 40) as f64;
    let [left, right] = inverse_depths;
    let largest = left.max(right);
    let of_corners = 8.0 * f64::EPSILON * view.eye.abs().max_element() * largest;
    let column = OF_COLUMN * (x_4.abs() + x_5.abs() + f64::from(view.width));
    let share = (column / (x_5 - x_4)).min(1.0);
    largest * (OF_SUMS + of_corners) + share * (right - left).abs()
}

impl Pixel {
    /// The column of its centre.
    pub fn x_p(&self) -> f64 {
        f64::from(self.x) + 0.5
    }

    /// Opens the pixel. It is closed at once where it is not nearer, by more than rounding, than what was drawn there before.
    #[inline]
    pub fn passes_depth_test<A, E: From<Event<A>>>(
        &self,
        frame: &Frame,
        recorder: &mut impl Recorder<E>,
    ) -> bool {
        let (x, y, x_p) = (self.x, self.y, self.x_p());
        recorder.enter(|| Event::Pixel { x, y, x_p }.into());
        let nearest = frame.inverse_depth[frame.index(x, y)];
        let nearer = nearest == 0.0 || self.inverse_depth - nearest > self.depth_error;
        recorder.step(|| {
            Event::DepthTested {
                z: 1.0 / self.inverse_depth,
                nearest: 1.0 / nearest,
                nearer,
            }
            .into()
        });
        if !nearer {
            recorder.leave(|| Event::PixelHidden.into());
        }
        nearer
    }

    /// Draws the pixel, and closes it.
    #[inline]
    pub fn draw<A, E: From<Event<A>>>(
        &self,
        color: Rgb,
        frame: &mut Frame,
        recorder: &mut impl Recorder<E>,
    ) {
        let index = frame.index(self.x, self.y);
        frame.inverse_depth[index] = self.inverse_depth;
        frame.color[index] = color;
        recorder.leave(|| Event::PixelColored { color }.into());
    }

    /// The point of the polygon that the pixel's centre shows, in the world. 1/depth is linear on the screen, so it lies on
    /// the polygon however much the depth changes from corner to corner.
    pub fn position(&self, view: &View) -> DVec3 {
        let centre = DVec2::new(self.x_p(), f64::from(self.y) + 0.5);
        view.from_screen(centre, 1.0 / self.inverse_depth)
    }
}
