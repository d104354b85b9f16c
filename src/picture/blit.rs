//! Whole pixels moved fast: solid rectangles, images and glyph masks, straight into a pixmap's rows.

use std::ops::Range;

use tiny_skia::{Pixmap, PremultipliedColorU8};

use super::font::Coverage;
use super::rect::Rect;
use super::shape::Image;

/// A rectangle of whole pixels: `left` and `top` belong to it, `right` and `bottom` do not.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct PixelRect {
    pub left: i32,
    pub top: i32,
    pub right: i32,
    pub bottom: i32,
}

impl PixelRect {
    pub(super) fn whole(pixmap: &Pixmap) -> Self {
        PixelRect {
            left: 0,
            top: 0,
            right: pixmap.width() as i32,
            bottom: pixmap.height() as i32,
        }
    }

    /// The smallest around a rectangle in pixels.
    pub(super) fn around(rect: Rect) -> Self {
        // Far outside any pixmap, and safe to add to.
        let pixel = |v: f32| v.clamp(-1e8, 1e8) as i32;
        PixelRect {
            left: pixel(rect.x.floor()),
            top: pixel(rect.y.floor()),
            right: pixel(rect.right().ceil()),
            bottom: pixel(rect.bottom().ceil()),
        }
    }

    pub(super) fn to_rect(self) -> Rect {
        Rect::new(
            self.left as f32,
            self.top as f32,
            self.width() as f32,
            self.height() as f32,
        )
    }

    /// The common part, always within this one; where there is none, one without pixels.
    pub(super) fn intersection(self, other: Self) -> Self {
        let left = other.left.clamp(self.left, self.right);
        let top = other.top.clamp(self.top, self.bottom);
        PixelRect {
            left,
            top,
            right: self.right.min(other.right).max(left),
            bottom: self.bottom.min(other.bottom).max(top),
        }
    }

    pub(super) fn is_empty(self) -> bool {
        self.left >= self.right || self.top >= self.bottom
    }

    pub(super) fn width(self) -> i32 {
        self.right - self.left
    }

    pub(super) fn height(self) -> i32 {
        self.bottom - self.top
    }
}

/// An 8-bit sRGB colour with straight alpha.
pub(super) type Rgba = [u8; 4];

/// The pixels of row `y` within `area`, four bytes each; `area` lies within the pixmap.
fn row(pixmap: &mut Pixmap, area: PixelRect, y: i32) -> &mut [[u8; 4]] {
    let width = pixmap.width() as usize;
    let (pixels, _) = pixmap.data_mut().as_chunks_mut();
    &mut pixels[y as usize * width..][area.left as usize..area.right as usize]
}

/// Fills `area`, which must lie within the pixmap.
pub(super) fn fill(pixmap: &mut Pixmap, area: PixelRect, color: Rgba) {
    for y in area.top..area.bottom {
        let row = row(pixmap, area, y);
        if color[3] == 255 {
            row.fill(color);
        } else {
            row.iter_mut().for_each(|pixel| over(pixel, color, 255));
        }
    }
}

/// Draws `image` into `frame`. Each pixel takes the image's pixel under its centre, or where the image is drawn smaller than it is
/// the mean of those that it covers, so that no thin line is lost; `clip` lies within the pixmap.
pub(super) fn image(pixmap: &mut Pixmap, clip: PixelRect, frame: PixelRect, image: &Image) {
    let area = clip.intersection(frame);
    if area.is_empty() || image.width() == 0 || image.height() == 0 {
        return;
    }
    let columns: Vec<Range<usize>> = (area.left..area.right)
        .map(|x| covered(x - frame.left, frame.width(), image.width()))
        .collect();

    let mut line = vec![[0; 4]; columns.len()];
    let mut line_of = 0..0;
    for y in area.top..area.bottom {
        let rows = covered(y - frame.top, frame.height(), image.height());
        if line_of != rows {
            match image.channels() {
                3 => means::<3>(image, rows.clone(), &columns, &mut line),
                _ => means::<4>(image, rows.clone(), &columns, &mut line),
            }
            line_of = rows;
        }
        let row = row(pixmap, area, y);
        if image.channels() == 3 {
            row.copy_from_slice(&line);
        } else {
            for (pixel, &color) in row.iter_mut().zip(&line) {
                over(pixel, color, 255);
            }
        }
    }
}

/// Which of the image's `count` columns or rows lie under pixel `at` of `length`; always one at least.
fn covered(at: i32, length: i32, count: u32) -> Range<usize> {
    let (at, length, count) = (i64::from(at), i64::from(length), i64::from(count));
    if count <= length {
        // Twice the centre and twice the frame's size keep the arithmetic whole.
        let under = ((2 * at + 1) * count / (2 * length)) as usize;
        return under..under + 1;
    }
    (at * count / length) as usize..((at + 1) * count / length) as usize
}

/// The mean colours of some rows of an image of `N` channels, by columns: of encoded values, as [`over`] mixes them, each as much as
/// it covers.
fn means<const N: usize>(
    image: &Image,
    rows: Range<usize>,
    columns: &[Range<usize>],
    line: &mut [[u8; 4]],
) {
    let alpha = |pixel: &[u8; N]| pixel.get(3).map_or(255, |&alpha| u64::from(alpha));
    let full = |[r, g, b, a]: [u64; 4], pixels: u64| {
        // The sums of channels are weighted by the sum of alphas.
        let mean = |sum: u64| ((sum + a / 2) / a.max(1)) as u8;
        [mean(r), mean(g), mean(b), ((a + pixels / 2) / pixels) as u8]
    };
    if rows.len() == 1 && columns.iter().all(|columns| columns.len() == 1) {
        let (pixels, _) = image.row(rows.start).as_chunks::<N>();
        for (color, columns) in line.iter_mut().zip(columns) {
            let pixel = &pixels[columns.start];
            *color = [pixel[0], pixel[1], pixel[2], alpha(pixel) as u8];
        }
        return;
    }
    let mut sums = vec![[0; 4]; columns.len()];
    for row in rows.clone() {
        let (pixels, _) = image.row(row).as_chunks::<N>();
        for (sum, columns) in sums.iter_mut().zip(columns) {
            for pixel in &pixels[columns.clone()] {
                let alpha = alpha(pixel);
                for (sum, &channel) in sum.iter_mut().zip(&pixel[..3]) {
                    *sum += u64::from(channel) * alpha;
                }
                sum[3] += alpha;
            }
        }
    }
    for ((color, sum), columns) in line.iter_mut().zip(sums).zip(columns) {
        *color = full(sum, (rows.len() * columns.len()) as u64);
    }
}

/// Inks one pixel, which must lie within the pixmap.
pub(super) fn dot(pixmap: &mut Pixmap, x: i32, y: i32, color: Rgba, coverage: u8) {
    let at = y as usize * pixmap.width() as usize + x as usize;
    let (pixels, _) = pixmap.data_mut().as_chunks_mut();
    over(&mut pixels[at], color, coverage);
}

/// Draws a glyph or another shape's coverage, its pen in pixel (x, y); `clip` lies within the pixmap.
pub(super) fn coverage(
    pixmap: &mut Pixmap,
    clip: PixelRect,
    mask: &Coverage,
    (x, y): (i32, i32),
    color: Rgba,
) {
    if mask.width == 0 {
        return;
    }
    let (left, top) = (x.saturating_add(mask.left), y.saturating_add(mask.top));
    let area = clip.intersection(PixelRect {
        left,
        top,
        right: left.saturating_add(mask.width as i32),
        bottom: top.saturating_add((mask.bytes.len() / mask.width) as i32),
    });
    if area.is_empty() {
        return;
    }
    for y in area.top..area.bottom {
        let start = (y - top) as usize * mask.width + (area.left - left) as usize;
        for (pixel, &covered) in row(pixmap, area, y).iter_mut().zip(&mask.bytes[start..]) {
            if covered != 0 {
                over(pixel, color, covered);
            }
        }
    }
}

/// Porter and Duff's `over`, on encoded values as everything else here and in browsers.
fn over(pixel: &mut [u8; 4], [r, g, b, a]: Rgba, coverage: u8) {
    if a == 255 && coverage == 255 {
        *pixel = [r, g, b, a];
        return;
    }
    let alpha = divided_by_255(u32::from(a) * u32::from(coverage));
    for (channel, color) in pixel.iter_mut().zip([r, g, b, 255]) {
        let (below, above) = (u32::from(*channel), u32::from(color));
        *channel = divided_by_255(above * alpha + below * (255 - alpha)) as u8;
    }
}

/// Rounded x / 255, exact for all products of two bytes.
fn divided_by_255(x: u32) -> u32 {
    let x = x + 128;
    (x + (x >> 8)) >> 8
}

/// The straight colours of a pixmap, four bytes a pixel.
pub(super) fn straight(pixmap: &Pixmap) -> Vec<u8> {
    let straight = |pixel: &PremultipliedColorU8| {
        let color = pixel.demultiply();
        [color.red(), color.green(), color.blue(), color.alpha()]
    };
    pixmap.pixels().iter().flat_map(straight).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_common_part_lies_within_the_first_rectangle_wherever_the_other_is() {
        let rect = |left, top, right, bottom| PixelRect {
            left,
            top,
            right,
            bottom,
        };
        let clip = rect(0, 0, 64, 48);
        for x in [-200, -10, 0, 30, 63, 64, 65, 151] {
            for y in [-200, 0, 47, 48, 300] {
                let common = clip.intersection(rect(x, y, x + 20, y + 30));
                assert!(common.left >= 0 && common.right <= 64 && common.width() >= 0);
                assert!(common.top >= 0 && common.bottom <= 48 && common.height() >= 0);
                let mut pixmap = Pixmap::new(64, 48).unwrap();
                fill(&mut pixmap, common, [255; 4]);
            }
        }
        assert_eq!(
            clip.intersection(rect(60, 40, 90, 90)),
            rect(60, 40, 64, 48)
        );
    }

    #[test]
    fn division_by_255_rounds() {
        for x in 0..=255 * 255 {
            assert_eq!(divided_by_255(x), (f64::from(x) / 255.0).round() as u32);
        }
    }

    #[test]
    fn whole_zooms_repeat_each_pixel_as_often() {
        let mut pixmap = Pixmap::new(8, 8).unwrap();
        let all = PixelRect::whole(&pixmap);
        let picture = Image::new(2, 2, vec![10, 0, 0, 20, 0, 0, 30, 0, 0, 40, 0, 0]);
        // Partly off the pixmap, to the upper left.
        let frame = PixelRect {
            left: -1,
            top: -1,
            right: 7,
            bottom: 7,
        };
        image(&mut pixmap, all, frame, &picture);
        let red = |x, y| pixmap.pixel(x, y).unwrap().red();
        let top: Vec<u8> = (0..8).map(|x| red(x, 2)).collect();
        assert_eq!(top, [10, 10, 10, 20, 20, 20, 20, 0]);
        assert_eq!((red(0, 3), red(3, 6), red(3, 7)), (30, 40, 0));
    }

    #[test]
    fn an_image_drawn_smaller_shows_the_mean_of_what_it_covers() {
        let mut pixmap = Pixmap::new(2, 1).unwrap();
        let all = PixelRect::whole(&pixmap);
        let lines = Image::new(4, 2, [0, 90, 30, 30, 0, 0, 60, 60].map(|v| [v; 3]).concat());
        image(&mut pixmap, all, all, &lines);
        let red = |x| pixmap.pixel(x, 0).unwrap().red();
        assert_eq!((red(0), red(1)), (23, 45));
        // What is not to be seen has no colour.
        let clear = [[200, 200, 200, 255], [0, 0, 0, 0]].concat();
        let mut pixmap = Pixmap::new(1, 1).unwrap();
        let all = PixelRect::whole(&pixmap);
        fill(&mut pixmap, all, [200, 200, 200, 255]);
        image(&mut pixmap, all, all, &Image::new(2, 1, clear));
        assert_eq!(pixmap.pixel(0, 0).unwrap().red(), 200);
    }

    #[test]
    fn translucent_images_and_fills_mix_with_what_lies_below() {
        let mut pixmap = Pixmap::new(2, 1).unwrap();
        let all = PixelRect::whole(&pixmap);
        fill(&mut pixmap, all, [255, 255, 255, 255]);
        let half = Image::new(2, 1, vec![0, 0, 0, 128, 9, 9, 9, 0]);
        image(&mut pixmap, all, all, &half);
        assert_eq!(pixmap.data(), [127, 127, 127, 255, 255, 255, 255, 255]);
        fill(&mut pixmap, all, [0, 0, 255, 51]);
        assert_eq!(pixmap.data(), [102, 102, 153, 255, 204, 204, 255, 255]);
    }
}
