//! The shapes of a display list, in logical points, x to the right, y down.

use std::sync::Arc;

use glam::Vec2;

use super::ink::{Paint, Stroke};
use super::rect::Rect;
use super::tag::Tag;
use super::text::Text;

/// A shape with what it shows and the part of the picture that it may touch.
#[derive(Clone, PartialEq, Debug)]
pub struct Item {
    pub shape: Shape,
    pub tag: Option<Tag>,
    pub clip: Option<Rect>,
}

#[derive(Clone, PartialEq, Debug)]
pub enum Shape {
    /// A rectangle, its corners rounded by `radius`. Edges are drawn on whole pixels, an outline lies inside them.
    Rect {
        rect: Rect,
        radius: f32,
        paint: Paint,
    },
    /// An open line through two points or more. A horizontal or vertical one is drawn on whole pixels.
    Polyline { points: Vec<Vec2>, stroke: Stroke },
    /// A closed polygon, also concave or crossing itself (non-zero winding).
    Polygon { points: Vec<Vec2>, paint: Paint },
    Circle {
        center: Vec2,
        radius: f32,
        paint: Paint,
    },
    /// One line of text, its baseline at `at`.
    Text { at: Vec2, text: String, set: Text },
    /// Pixels, never blurred. With `first_pixel` they are pixels of the rendered image, and can be pointed at: the upper left
    /// one is that pixel.
    Image {
        rect: Rect,
        image: Image,
        first_pixel: Option<(u32, u32)>,
    },
}

/// Pixels of 8-bit sRGB, row by row from the top; cheap to clone.
#[derive(Clone, PartialEq, Debug)]
pub struct Image {
    width: u32,
    height: u32,
    pixels: Arc<[u8]>,
}

impl Image {
    /// Three bytes a pixel (RGB) or four (RGBA, straight alpha).
    ///
    /// # Panics
    /// Where the number of bytes is neither 3 nor 4 times `width` × `height`.
    pub fn new(width: u32, height: u32, pixels: impl Into<Arc<[u8]>>) -> Self {
        let pixels = pixels.into();
        let count = width as usize * height as usize;
        assert!(
            pixels.len() == 3 * count || pixels.len() == 4 * count,
            "{width}×{height} pixels in {} bytes",
            pixels.len()
        );
        Image {
            width,
            height,
            pixels,
        }
    }

    pub fn width(&self) -> u32 {
        self.width
    }

    pub fn height(&self) -> u32 {
        self.height
    }

    /// Bytes a pixel: 3, or 4 with alpha.
    pub(super) fn channels(&self) -> usize {
        let count = self.width as usize * self.height as usize;
        self.pixels.len().checked_div(count).unwrap_or(3)
    }

    /// The bytes of a row of pixels, counted from the top.
    pub fn row(&self, y: usize) -> &[u8] {
        let bytes = self.width as usize * self.channels();
        &self.pixels[y * bytes..(y + 1) * bytes]
    }
}

impl Shape {
    /// The part of the picture that the shape may touch, anti-aliased borders aside.
    pub fn bounds(&self) -> Rect {
        let outline = |paint: &Paint| paint.stroke.map_or(0.0, |stroke| 0.5 * stroke.width);
        let around = |points: &[Vec2], distance: f32| {
            let bounds = Rect::around(points.iter().copied()).unwrap_or_default();
            bounds.grown(distance)
        };
        match self {
            Shape::Rect { rect, .. } | Shape::Image { rect, .. } => *rect,
            Shape::Polyline { points, stroke } => around(points, 0.5 * stroke.width),
            Shape::Polygon { points, paint } => around(points, outline(paint)),
            Shape::Circle {
                center,
                radius,
                paint,
            } => Rect::between(*center, *center).grown(radius + outline(paint)),
            Shape::Text { at, text, set } => set.bounds(*at, text),
        }
    }

    /// Moved by `offset`.
    pub fn shift(&mut self, offset: Vec2) {
        match self {
            Shape::Rect { rect, .. } | Shape::Image { rect, .. } => *rect = rect.shifted(offset),
            Shape::Polyline { points, .. } | Shape::Polygon { points, .. } => {
                points.iter_mut().for_each(|point| *point += offset);
            }
            Shape::Circle { center, .. } => *center += offset,
            Shape::Text { at, .. } => *at += offset,
        }
    }
}
