//! Pictures: display lists that panels return, and their rasteriser.
//!
//! A panel adds shapes to a [`Picture`], in logical points and in [`Ink`]s that name a meaning; items may carry a [`Tag`] that
//! says what they show. The same picture becomes the window's panel, a PNG, a test's evidence; tags make it answer to the
//! pointer. A picture knows neither the theme nor the screen: [`rasterize`] does.
//!
//! ```
//! use lightwalk::picture::{Ink, Picture, Rect, Style, Tag, Theme, rasterize};
//!
//! let mut picture = Picture::new(200.0, 80.0);
//! picture.text((12.0, 24.0), "Scan line", Style::Bold.size(15.0));
//! picture.tagged(Tag::ScanLine(15), |picture| {
//!     picture.line((12.0, 50.0), (188.0, 50.0), Ink::This.stroke(1.5).dashed());
//!     picture.text((188.0, 66.0), "y_4 = 15", Style::Label.size(13.0).ink(Ink::This).end());
//! });
//! assert_eq!(picture.hit((100.0, 52.0)), Some(Tag::ScanLine(15)));
//! let pixels = rasterize(&picture, Theme::Light, 2.0)?;
//! assert_eq!((pixels.width(), pixels.height()), (400, 160));
//! # Ok::<(), lightwalk::picture::RasterError>(())
//! ```

mod blit;
mod font;
mod hit;
mod ink;
mod line;
mod math;
mod path;
mod raster;
mod rect;
mod shape;
mod svg;
mod tag;
mod text;
mod theme;

use glam::Vec2;

pub use ink::{Dash, Fill, Ink, Paint, Stroke};
pub use math::{Run, Script, braced, math, plain, prose, symbol};
pub use raster::{RasterError, draw_over, raster_size, rasterize, to_png, to_rgb8};
pub use rect::Rect;
pub use shape::{Image, Item, Shape};
pub use svg::{svg_element, to_svg};
pub use tag::Tag;
pub use text::{Anchor, Style, Text, ascent, descent, elide, font_file, measure, wrap};
pub use theme::Theme;

/// A display list: what stands later in `items` lies on top. Sizes are in logical points.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Picture {
    pub width: f32,
    pub height: f32,
    pub items: Vec<Item>,
    /// What the picture says, in words, for who cannot see it.
    pub alt: String,
}

impl Picture {
    pub fn new(width: f32, height: f32) -> Self {
        Picture {
            width,
            height,
            ..Picture::default()
        }
    }

    /// The whole picture's rectangle.
    pub fn bounds(&self) -> Rect {
        Rect::new(0.0, 0.0, self.width, self.height)
    }

    /// Adds a shape as it is, untagged and unclipped.
    pub fn push(&mut self, shape: Shape) -> &mut Self {
        self.items.push(Item {
            shape,
            tag: None,
            clip: None,
        });
        self
    }

    /// A rectangle; an outline lies inside its edges.
    pub fn rect(&mut self, rect: Rect, paint: impl Into<Paint>) -> &mut Self {
        self.rounded_rect(rect, 0.0, paint)
    }

    /// A rectangle with rounded corners.
    pub fn rounded_rect(&mut self, rect: Rect, radius: f32, paint: impl Into<Paint>) -> &mut Self {
        let paint = paint.into();
        self.push(Shape::Rect {
            rect,
            radius,
            paint,
        })
    }

    pub fn line(
        &mut self,
        from: impl Into<Vec2>,
        to: impl Into<Vec2>,
        stroke: Stroke,
    ) -> &mut Self {
        self.polyline([from.into(), to.into()], stroke)
    }

    /// An open line through points.
    pub fn polyline<P: Into<Vec2>>(
        &mut self,
        points: impl IntoIterator<Item = P>,
        stroke: Stroke,
    ) -> &mut Self {
        let points = points.into_iter().map(Into::into).collect();
        self.push(Shape::Polyline { points, stroke })
    }

    /// A closed polygon.
    pub fn polygon<P: Into<Vec2>>(
        &mut self,
        points: impl IntoIterator<Item = P>,
        paint: impl Into<Paint>,
    ) -> &mut Self {
        let points = points.into_iter().map(Into::into).collect();
        let paint = paint.into();
        self.push(Shape::Polygon { points, paint })
    }

    pub fn circle(
        &mut self,
        center: impl Into<Vec2>,
        radius: f32,
        paint: impl Into<Paint>,
    ) -> &mut Self {
        let (center, paint) = (center.into(), paint.into());
        self.push(Shape::Circle {
            center,
            radius,
            paint,
        })
    }

    /// A line with a head at its end: a vector. The head grows with the line's width, and shrinks with a short line.
    pub fn arrow(
        &mut self,
        from: impl Into<Vec2>,
        to: impl Into<Vec2>,
        stroke: Stroke,
    ) -> &mut Self {
        let (from, to) = (from.into(), to.into());
        let along = (to - from).normalize_or_zero();
        let head = (5.0 + 2.5 * stroke.width).min(from.distance(to));
        let neck = to - head * along;
        let side = 0.42 * head * along.perp();
        self.line(from, neck + 0.25 * head * along, stroke);
        let fill = stroke.ink.fill().opacity(stroke.opacity);
        self.polygon([to, neck + side, neck - side], fill)
    }

    /// One line of text with its baseline at `at`.
    pub fn text(&mut self, at: impl Into<Vec2>, text: impl Into<String>, set: Text) -> &mut Self {
        let (at, text) = (at.into(), text.into());
        self.push(Shape::Text { at, text, set })
    }

    /// One line of text in a box: from its left edge, centre or right edge, as the text is anchored; capitals in mid-height.
    pub fn text_in(&mut self, rect: Rect, text: impl Into<String>, set: Text) -> &mut Self {
        let x = rect.x + set.anchor.share() * rect.width;
        let y = rect.center().y + set.baseline_below_middle();
        self.text((x, y), text, set)
    }

    /// An image that fills `rect`. Whole multiples of its pixels on the screen look best.
    pub fn image(&mut self, rect: Rect, image: Image) -> &mut Self {
        self.push(Shape::Image {
            rect,
            image,
            first_pixel: None,
        })
    }

    /// Pixels of the rendered image, each of which can be pointed at; the upper left one is pixel `first`.
    pub fn pixels(&mut self, rect: Rect, image: Image, first: (u32, u32)) -> &mut Self {
        self.push(Shape::Image {
            rect,
            image,
            first_pixel: Some(first),
        })
    }

    /// Everything that `draw` adds shows `tag`, unless it already has a tag of its own.
    pub fn tagged(&mut self, tag: Tag, draw: impl FnOnce(&mut Picture)) -> &mut Self {
        for item in self.added(draw) {
            item.tag.get_or_insert(tag);
        }
        self
    }

    /// Everything that `draw` adds is cut off at `rect`, to whole pixels.
    pub fn clipped(&mut self, rect: Rect, draw: impl FnOnce(&mut Picture)) -> &mut Self {
        for item in self.added(draw) {
            item.clip = Some(item.clip.map_or(rect, |clip| clip.intersection(&rect)));
        }
        self
    }

    /// Another picture with its upper left corner at `at`, clipped to its size.
    pub fn place(&mut self, at: impl Into<Vec2>, picture: Picture) -> &mut Self {
        let at = at.into();
        let frame = picture.bounds().shifted(at);
        self.clipped(frame, |this| {
            this.items.extend(picture.items.into_iter().map(|mut item| {
                item.shape.shift(at);
                item.clip = item.clip.map(|clip| clip.shifted(at));
                item
            }));
        })
    }

    fn added(&mut self, draw: impl FnOnce(&mut Picture)) -> &mut [Item] {
        let before = self.items.len();
        draw(self);
        &mut self.items[before..]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn inner_tags_and_clips_go_before_outer_ones() {
        let mut picture = Picture::new(100.0, 100.0);
        picture.tagged(Tag::Polygon(1), |picture| {
            picture.rect(Rect::new(0.0, 0.0, 9.0, 9.0), Ink::Faint);
            picture.clipped(Rect::new(0.0, 0.0, 50.0, 50.0), |picture| {
                picture.clipped(Rect::new(20.0, 0.0, 80.0, 20.0), |picture| {
                    picture.tagged(Tag::Edge(2), |picture| {
                        picture.line((0.0, 0.0), (90.0, 90.0), Ink::Text.stroke(1.0));
                    });
                });
            });
        });
        assert_eq!(picture.items[0].tag, Some(Tag::Polygon(1)));
        assert_eq!(picture.items[1].tag, Some(Tag::Edge(2)));
        assert_eq!(
            picture.items[1].clip,
            Some(Rect::new(20.0, 0.0, 30.0, 20.0))
        );
    }

    #[test]
    fn a_placed_picture_moves_with_all_it_has() {
        let mut inner = Picture::new(10.0, 10.0);
        inner.clipped(Rect::new(0.0, 0.0, 5.0, 20.0), |inner| {
            inner.circle((5.0, 5.0), 2.0, Ink::This);
        });
        let mut sheet = Picture::new(100.0, 100.0);
        sheet.place((30.0, 40.0), inner);
        let item = &sheet.items[0];
        assert_eq!(item.shape.bounds(), Rect::new(33.0, 43.0, 4.0, 4.0));
        assert_eq!(item.clip, Some(Rect::new(30.0, 40.0, 5.0, 10.0)));
    }
}
