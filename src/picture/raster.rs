//! From a display list to pixels.
//!
//! Straight edges that lie along the pixel grid are moved onto it, so that rules and frames are crisp at any scale; all other
//! lines are anti-aliased. Images keep hard pixels. Text stands on whole pixels vertically, on quarters horizontally.

mod lines;
mod paths;

use glam::Vec2;
use tiny_skia::{Mask, PathBuilder, Pixmap};

use super::Picture;
use super::blit::{self, PixelRect, Rgba};
use super::font::{OFFSETS, glyphs};
use super::ink::{Dash, Ink, Paint};
use super::path::{path_through, rounded};
use super::rect::Rect;
use super::shape::{Item, Shape};
use super::text::{Text, place};
use super::theme::Theme;

/// The largest side, in pixels, and the largest area.
const LARGEST_SIDE: f32 = 16_384.0;
const LARGEST_AREA: f32 = (1 << 26) as f32;

/// Why a picture could not be rasterised.
#[derive(Clone, Copy, PartialEq, Debug, thiserror::Error)]
pub enum RasterError {
    #[error(
        "a picture of {width}×{height} pixels is too large: at most {LARGEST_SIDE} a side and {LARGEST_AREA} in all"
    )]
    TooLarge { width: f32, height: f32 },
    #[error("a picture's size and scale must be finite: {width}×{height} points at scale {scale}")]
    NotFinite { width: f32, height: f32, scale: f32 },
}

/// Draws a picture on [`Ink::Surface`]. The result, opaque, has size · `scale` pixels, rounded, and at least one.
pub fn rasterize(picture: &Picture, theme: Theme, scale: f32) -> Result<Pixmap, RasterError> {
    let size = Vec2::new(picture.width, picture.height);
    let [width, height] = raster_size(size, scale)?;
    let too_large = || RasterError::TooLarge {
        width: width as f32,
        height: height as f32,
    };
    let mut pixmap = Pixmap::new(width, height).ok_or_else(too_large)?;
    let all = PixelRect::whole(&pixmap);
    blit::fill(&mut pixmap, all, rgba(theme, Ink::Surface, 1.0));
    draw_over(&mut pixmap, &picture.items, theme, scale);
    Ok(pixmap)
}

/// Width and height in pixels of a picture so many points large. Errors: no picture of that size is drawn.
pub fn raster_size(size: Vec2, scale: f32) -> Result<[u32; 2], RasterError> {
    let [width, height] = size.to_array();
    if !(size * scale).is_finite() {
        return Err(RasterError::NotFinite {
            width,
            height,
            scale,
        });
    }
    let [width, height] = (size * scale).round().max(Vec2::ONE).to_array();
    match width.max(height) > LARGEST_SIDE || width * height > LARGEST_AREA {
        true => Err(RasterError::TooLarge { width, height }),
        false => Ok([width as u32, height as u32]),
    }
}

/// Draws items over what a pixmap already shows: highlights over a picture, for one.
pub fn draw_over(pixmap: &mut Pixmap, items: &[Item], theme: Theme, scale: f32) {
    let mut canvas = Canvas {
        clip: PixelRect::whole(pixmap),
        mask: None,
        pixmap,
        theme,
        scale,
    };
    for item in items {
        canvas.item(item);
    }
}

/// A PNG of a pixmap.
pub fn to_png(pixmap: &Pixmap) -> Vec<u8> {
    crate::color::png_rgba8(pixmap.width(), pixmap.height(), &blit::straight(pixmap))
}

/// The pixels of an opaque pixmap, RGB row by row.
pub fn to_rgb8(pixmap: &Pixmap) -> Vec<u8> {
    let pixels = pixmap.data().chunks_exact(4);
    pixels.flat_map(|pixel| &pixel[..3]).copied().collect()
}

fn rgba(theme: Theme, ink: Ink, opacity: f32) -> Rgba {
    let [r, g, b] = theme.color(ink);
    [r, g, b, (opacity.clamp(0.0, 1.0) * 255.0).round() as u8]
}

struct Canvas<'a> {
    pixmap: &'a mut Pixmap,
    theme: Theme,
    scale: f32,
    /// Within the pixmap.
    clip: PixelRect,
    /// The clip as a mask, once a shape has needed it.
    mask: Option<(PixelRect, Mask)>,
}

impl Canvas<'_> {
    fn item(&mut self, item: &Item) {
        let all = PixelRect::whole(self.pixmap);
        self.clip = item
            .clip
            .map_or(all, |clip| all.intersection(self.snapped(clip)));
        // One pixel for anti-aliasing; text may lean out of its box.
        let seen = item.shape.bounds().grown(2.0 + 1.0 / self.scale);
        if self.clip.intersection(self.snapped(seen)).is_empty() {
            return;
        }
        match &item.shape {
            Shape::Rect {
                rect,
                radius,
                paint,
            } => self.rect(*rect, *radius, paint),
            Shape::Polyline { points, stroke } => self.polyline(points, stroke),
            Shape::Polygon { points, paint } => self.polygon(points, paint),
            Shape::Circle {
                center,
                radius,
                paint,
            } => {
                let center = *center * self.scale;
                let path = PathBuilder::from_circle(center.x, center.y, radius * self.scale);
                self.path(path, paint);
            }
            Shape::Text { at, text, set } => self.text(*at, text, set),
            Shape::Image { rect, image, .. } => {
                let frame = self.snapped(*rect);
                blit::image(self.pixmap, self.clip, frame, image);
            }
        }
    }

    /// A rectangle on whole pixels. Its size is rounded by itself, so that equal sizes stay equal wherever they are.
    fn snapped(&self, rect: Rect) -> PixelRect {
        // Far outside any pixmap, and safe to add to.
        let pixel = |v: f32| (v * self.scale).round().clamp(-1e8, 1e8) as i32;
        let (left, top) = (pixel(rect.x), pixel(rect.y));
        let size = |length: f32| pixel(length).max(i32::from(length > 0.0));
        PixelRect {
            left,
            top,
            right: left + size(rect.width),
            bottom: top + size(rect.height),
        }
    }

    /// A line's width in whole pixels, at least one.
    fn whole_width(&self, width: f32) -> i32 {
        (width * self.scale).round().clamp(1.0, LARGEST_SIDE) as i32
    }

    fn rect(&mut self, rect: Rect, radius: f32, paint: &Paint) {
        let outer = self.snapped(rect);
        let radius = radius * self.scale;
        if let Some(fill) = paint.fill {
            let color = rgba(self.theme, fill.ink, fill.opacity);
            if radius > 0.0 {
                self.fill_path(rounded(outer, 0.0, radius), color);
            } else {
                self.fill_rect(outer, color);
            }
        }
        let Some(stroke) = paint.stroke else {
            return;
        };
        let width = self.whole_width(stroke.width);
        if radius > 0.0 || stroke.dash != Dash::Solid {
            let path = rounded(outer, 0.5 * width as f32, radius);
            self.stroke_path(path, &stroke, width as f32);
            return;
        }
        let color = rgba(self.theme, stroke.ink, stroke.opacity);
        let PixelRect {
            left,
            top,
            right,
            bottom,
        } = outer;
        // Four sides that share no pixel, so that a translucent frame is even.
        let under = (top + width).min(bottom);
        let over = (bottom - width).max(under);
        let inner_left = (left + width).min(right);
        let inner_right = (right - width).max(inner_left);
        for (left, top, right, bottom) in [
            (left, top, right, under),
            (left, over, right, bottom),
            (left, under, inner_left, over),
            (inner_right, under, right, over),
        ] {
            let side = PixelRect {
                left,
                top,
                right,
                bottom,
            };
            self.fill_rect(side, color);
        }
    }

    fn polygon(&mut self, points: &[Vec2], paint: &Paint) {
        let mut points = self.scaled(points);
        if let Some(fill) = paint.fill {
            let path = path_through(points.iter().copied(), true);
            self.fill_path(path, rgba(self.theme, fill.ink, fill.opacity));
        }
        if let (Some(stroke), Some(&first)) = (paint.stroke, points.first()) {
            points.push(first);
            self.joined(&points, true, &stroke);
        }
    }

    fn scaled(&self, points: &[Vec2]) -> Vec<Vec2> {
        points.iter().map(|&point| point * self.scale).collect()
    }

    fn fill_rect(&mut self, rect: PixelRect, color: Rgba) {
        let area = self.clip.intersection(rect);
        blit::fill(self.pixmap, area, color);
    }

    fn text(&mut self, at: Vec2, text: &str, set: &Text) {
        let color = rgba(self.theme, set.ink, 1.0);
        let mut placed = Vec::with_capacity(text.len());
        let mut glyphs = glyphs();
        let width = place(&mut glyphs, text, set.style, set.size, |glyph| {
            placed.push(glyph);
        });
        let start = (at.x - set.anchor.share() * width) * self.scale;
        let baseline = (at.y * self.scale).round();
        for one in placed {
            let quarters = ((start + one.x * self.scale) * OFFSETS as f32).round() as i32;
            let pen = (
                quarters.div_euclid(OFFSETS),
                (baseline - one.rise * self.scale).round() as i32,
            );
            let mask = glyphs.coverage(
                one.glyph,
                one.size * self.scale,
                quarters.rem_euclid(OFFSETS),
            );
            blit::coverage(self.pixmap, self.clip, mask, pen, color);
        }
    }
}

#[cfg(test)]
mod tests;
