//! Where a picture stands in its panel, how large its pixels are, and their numbers along its sides.

use crate::figure::{Fit, View};
use crate::picture::{Ink, Picture, Rect, Style, ascent};
use glam::Vec2;

/// Least part of its room that a picture with pixels of one size fills.
const FILLED: f64 = 0.9;
/// Points a pixel from which on the pixels are told apart by a grid.
const GRID: f64 = 6.0;
/// Size of the numbers of columns and rows.
const NUMBER: f32 = 11.0;
/// Room for the numbers of rows, and for those of columns.
const NUMBERS: Vec2 = Vec2::new(30.0, 16.0);

pub(super) struct Placing {
    /// What is seen of the picture.
    pub frame: Rect,
    /// Where all of the picture lies, beyond the frame too.
    pub whole: Rect,
    pub fit: Fit,
    is_part: bool,
}

impl Placing {
    /// A picture of that size in pixels, in `area`, as the view wants it, about `middle`, in shares of the picture. None where there
    /// is nothing to see or no room.
    pub fn new(pixels: Vec2, area: Rect, view: &View, middle: Vec2) -> Option<Self> {
        if pixels.min_element() < 1.0 || area.is_empty() {
            return None;
        }
        let is_part = view.zoom > 1.0;
        let room = room(area, is_part);
        let scale = fitting(pixels, room) * f64::from(view.zoom);
        let extent = pixels * scale as f32;
        let seen = extent.min(Vec2::new(room.width, room.height));
        // On whole points, so that pixels are equally large on every screen.
        let corner = (room.center() - 0.5 * seen).floor().max(room.min());
        let frame = Rect::between(corner, corner + seen);
        let half = 0.5 * seen / extent;
        let middle = middle.clamp(half, 1.0 - half);
        let origin = frame.center() - middle * extent;
        Some(Placing {
            frame,
            whole: Rect::between(origin, origin + extent),
            fit: Fit::at_origin(origin, scale),
            is_part,
        })
    }

    /// Where a whole picture of that size stands: what zooming and dragging are reckoned by.
    pub fn of_whole(pixels: Vec2, area: Rect, is_part: bool) -> Rect {
        let room = room(area, is_part);
        let half = 0.5 * pixels * fitting(pixels, room) as f32;
        Rect::between(room.center() - half, room.center() + half)
    }

    /// The first and the last columns and rows that are seen, the last excluded.
    fn seen(&self) -> [[u32; 2]; 2] {
        let [low, high] = [self.frame.min(), self.frame.max()].map(|at| self.fit.point(at));
        let ends =
            |low: f64, high: f64| [(low + 1e-4).max(0.0) as u32, (high - 1e-4).ceil() as u32];
        [ends(low.x, high.x), ends(low.y, high.y)]
    }

    pub fn grid(&self, picture: &mut Picture) {
        if self.fit.scale < GRID {
            return;
        }
        let stroke = Ink::Rule.stroke(1.0).opacity(0.25);
        let (low, high) = (self.frame.min(), self.frame.max());
        let [columns, rows] = self.seen();
        for x in columns[0] + 1..columns[1] {
            let x = self.fit.x(x.into());
            picture.line((x, low.y), (x, high.y), stroke);
        }
        for y in rows[0] + 1..rows[1] {
            let y = self.fit.y(y.into());
            picture.line((low.x, y), (high.x, y), stroke);
        }
    }

    /// The numbers of columns above, of rows at the left, as many as there is room for; `current` stands out.
    pub fn numbers(&self, picture: &mut Picture, current: Option<(u32, u32)>) {
        if !self.is_part {
            return;
        }
        let [columns, rows] = self.seen();
        let set = Style::Body.size(NUMBER);
        let widest = set.width(&columns[1].to_string()) + 8.0;
        let [every_x, every_y] =
            [widest, NUMBER + 5.0].map(|apart| every(f64::from(apart) / self.fit.scale));
        let ink = |is_current| if is_current { Ink::This } else { Ink::Muted };
        let marked = current.map(|(x, _)| x);
        for x in numbered(columns, every_x, marked) {
            let at = self.fit.x(f64::from(x) + 0.5);
            if at < self.frame.x || at > self.frame.right() {
                continue;
            }
            let text = set.ink(ink(marked == Some(x))).middle();
            picture.text((at, self.frame.y - 4.0), x.to_string(), text);
        }
        let marked = current.map(|(_, y)| y);
        for y in numbered(rows, every_y, marked) {
            let at = self.fit.y(f64::from(y) + 0.5);
            if at < self.frame.y || at > self.frame.bottom() {
                continue;
            }
            let baseline = at + 0.5 * ascent(Style::Body, NUMBER);
            let text = set.ink(ink(marked == Some(y))).end();
            picture.text((self.frame.x - 4.0, baseline), y.to_string(), text);
        }
    }
}

/// What numbers leave of an area.
fn room(area: Rect, with_numbers: bool) -> Rect {
    let wide = area.width > 4.0 * NUMBERS.x && area.height > 4.0 * NUMBERS.y;
    if with_numbers && wide {
        Rect::between(area.min() + NUMBERS, area.max())
    } else {
        area
    }
}

/// Points a pixel: the largest whole number that fits; where that leaves much of the room empty, as many as fit, since pixels that differ
/// by one point then matter less than a picture that is too small.
pub(super) fn fitting(picture: Vec2, area: Rect) -> f64 {
    let fitting = f64::from((Vec2::new(area.width, area.height) / picture).min_element());
    if fitting.floor() >= FILLED * fitting {
        fitting.floor()
    } else {
        fitting
    }
}

/// The least of 1, 2, 5, 10 … that is not less.
fn every(least: f64) -> u32 {
    let steps = [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000];
    let fit = steps.into_iter().find(|&step| f64::from(step) >= least);
    fit.unwrap_or(10_000)
}

/// Multiples of `every` between two numbers, and the marked one in place of those that it would touch.
fn numbered([first, end]: [u32; 2], every: u32, marked: Option<u32>) -> impl Iterator<Item = u32> {
    let marked = marked.filter(|number| (first..end).contains(number));
    let apart = move |number: u32| marked.is_none_or(|marked| number.abs_diff(marked) >= every);
    let first = first.div_ceil(every) * every;
    (first..end)
        .step_by(every as usize)
        .filter(move |&number| apart(number))
        .chain(marked)
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec2;

    #[test]
    fn large_pixels_are_enlarged_by_a_whole_number_and_small_ones_as_far_as_they_fit() {
        let area = Rect::new(0.0, 0.0, 460.0, 380.0);
        assert_eq!(fitting(Vec2::new(48.0, 36.0), area), 9.0);
        assert_eq!(fitting(Vec2::new(184.0, 10.0), area), 2.5);
        assert!((fitting(Vec2::new(640.0, 480.0), area) - 460.0 / 640.0).abs() < 1e-6);
    }

    #[test]
    fn an_enlarged_picture_fills_its_frame_wherever_one_looks() {
        let (pixels, area) = (Vec2::new(48.0, 36.0), Rect::new(0.0, 0.0, 400.0, 200.0));
        for zoom in [1.0, 1.5, 4.0, 32.0] {
            for middle in [Vec2::ZERO, Vec2::splat(0.5), Vec2::new(1.0, 0.3)] {
                let view = View { zoom, center: None };
                let placing = Placing::new(pixels, area, &view, middle).unwrap();
                assert!(area.encloses(&placing.frame));
                let (frame, whole) = (placing.frame, placing.whole);
                assert!(whole.x <= frame.x + 1.0 && whole.right() >= frame.right() - 1.0);
                assert!(whole.y <= frame.y + 1.0 && whole.bottom() >= frame.bottom() - 1.0);
            }
        }
    }

    #[test]
    fn the_current_number_takes_the_place_of_its_neighbours() {
        let numbers: Vec<u32> = numbered([3, 22], 5, Some(11)).collect();
        assert_eq!(numbers, [5, 20, 11]);
        assert_eq!(numbered([3, 8], 1, None).count(), 5);
        assert_eq!((every(0.2), every(3.0), every(1e9)), (1, 5, 10_000));
    }

    #[test]
    fn a_place_is_that_of_the_pixel_drawn_there() {
        let area = Rect::new(10.0, 20.0, 400.0, 300.0);
        let view = View {
            zoom: 8.0,
            center: None,
        };
        let placing = Placing::new(Vec2::new(48.0, 36.0), area, &view, Vec2::splat(0.5)).unwrap();
        let center = placing.fit.place(DVec2::new(24.0, 18.0));
        assert!(center.distance(placing.frame.center()) < 1e-3);
    }
}
