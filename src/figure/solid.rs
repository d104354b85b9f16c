//! Solids with their hidden parts hidden, by a depth buffer (Catmull 1974): an image, against which lines are held.
//!
//! It serves pictures of where things are. What the algorithms draw is drawn by them.

use super::space::Seen;
use crate::picture::{Image, Rect};
use glam::{Vec2, Vec3};

/// Samples a point of the figure on either axis: the image is drawn at a size of its own and shown smaller.
const SAMPLES: f32 = 2.0;
/// Steps along a line at which it is held against what lies before it, in points.
const STEP: f32 = 2.0;

/// An image of solids as it grows.
pub struct Solids {
    /// sRGB with alpha, row by row.
    pixels: Vec<[u8; 4]>,
    depths: Depths,
}

/// How near what was drawn is, sample by sample.
pub struct Depths {
    area: Rect,
    width: usize,
    height: usize,
    nearness: Vec<f32>,
}

impl Solids {
    /// Nothing so far, in `area` of the figure.
    pub fn new(area: Rect) -> Self {
        let size = |length: f32| (SAMPLES * length).round().clamp(1.0, 8192.0) as usize;
        let (width, height) = (size(area.width), size(area.height));
        Solids {
            pixels: vec![[0; 4]; width * height],
            depths: Depths {
                area,
                width,
                height,
                nearness: vec![f32::NEG_INFINITY; width * height],
            },
        }
    }

    /// A triangle. `paint` takes the shares of its corners at a point of it, and gives the colour there in 8-bit sRGB.
    pub fn triangle(&mut self, corners: [Seen; 3], paint: impl Fn(Vec3) -> [u8; 3]) {
        self.fill(corners, |pixel, nearness, before, shares| {
            *pixel = opaque(paint(shares));
            *before = nearness;
        });
    }

    /// A triangle through which one sees what lies behind: it hides nothing.
    pub fn veil(&mut self, corners: [Seen; 3], [r, g, b]: [u8; 3], opacity: f32) {
        self.fill(corners, |pixel, _, _, _| {
            let covered = f32::from(pixel[3]) / 255.0;
            let total = opacity + (1.0 - opacity) * covered;
            let share = opacity / total.max(1e-6);
            for (channel, over) in pixel.iter_mut().zip([r, g, b]) {
                *channel = (f32::from(*channel) * (1.0 - share) + f32::from(over) * share) as u8;
            }
            pixel[3] = (255.0 * total).round() as u8;
        });
    }

    /// Visits the pixels whose centres lie in a triangle, on its left or upper edges too, and that nothing drawn before hides.
    fn fill(
        &mut self,
        corners: [Seen; 3],
        mut draw: impl FnMut(&mut [u8; 4], f32, &mut f32, Vec3),
    ) {
        let depths = &mut self.depths;
        let places = corners.map(|corner| SAMPLES * (corner.at - depths.area.min()));
        let [a, b, c] = places;
        let area = (b - a).perp_dot(c - a);
        if !area.is_finite() || area == 0.0 {
            return;
        }
        // The share of each corner: linear on the figure, 1 at the corner and 0 on the edge across.
        let share = |from: Vec2, to: Vec2| {
            let along = (to - from) / area;
            (Vec2::new(-along.y, along.x), from.perp_dot(to) / area)
        };
        let shares = [share(b, c), share(c, a), share(a, b)];
        let nearness = Vec3::from(corners.map(|corner| corner.nearness));
        let scale = Vec3::from(corners.map(|corner| corner.scale));
        let is_flat = scale.max_element() == scale.min_element();
        let low = a.min(b).min(c).y;
        let high = a.max(b).max(c).y;
        let rows = pixels_between(low, high, depths.height);
        for y in rows {
            let middle = y as f32 + 0.5;
            let (mut first, mut end) = (0.0_f32, depths.width as f32);
            for (slope, constant) in shares {
                let at_zero = slope.y * middle + constant;
                let crossing = -at_zero / slope.x;
                if slope.x > 0.0 {
                    first = first.max(crossing);
                } else if slope.x < 0.0 {
                    end = end.min(crossing);
                } else if at_zero < 0.0 || at_zero == 0.0 && slope.y < 0.0 {
                    end = first;
                }
            }
            for x in pixels_between(first, end, depths.width) {
                let at = Vec2::new(x as f32 + 0.5, middle);
                let here = Vec3::from(shares.map(|(slope, constant)| slope.dot(at) + constant));
                let near = here.dot(nearness);
                let index = y * depths.width + x;
                if near <= depths.nearness[index] {
                    continue;
                }
                let true_shares = if is_flat {
                    here
                } else {
                    here * scale / here.dot(scale)
                };
                draw(
                    &mut self.pixels[index],
                    near,
                    &mut depths.nearness[index],
                    true_shares,
                );
            }
        }
    }

    /// The image, to be shown in the area, and what lines are held against.
    pub fn finish(self) -> (Image, Depths) {
        let Depths { width, height, .. } = self.depths;
        let pixels = self.pixels.into_flattened();
        (Image::new(width as u32, height as u32, pixels), self.depths)
    }
}

impl Depths {
    /// What of a line is in sight, and what is hidden, piece by piece. Surfaces that are nearer by less than `tolerance` hide
    /// nothing: lines lie on them.
    pub fn pieces(&self, [from, to]: [Seen; 2], tolerance: f32) -> Vec<([Vec2; 2], bool)> {
        let steps = (from.at.distance(to.at) / STEP).ceil().max(1.0);
        let mut pieces: Vec<([Vec2; 2], bool)> = Vec::new();
        for step in 0..steps as usize {
            let place = |share: f32| from.at.lerp(to.at, share / steps);
            let middle = (step as f32 + 0.5) / steps;
            let near = from.nearness + middle * (to.nearness - from.nearness);
            let is_in_sight = !self.hides(from.at.lerp(to.at, middle), near + tolerance);
            let end = place(step as f32 + 1.0);
            match pieces.last_mut() {
                Some((ends, in_sight)) if *in_sight == is_in_sight => ends[1] = end,
                _ => pieces.push(([place(step as f32), end], is_in_sight)),
            }
        }
        pieces
    }

    /// Whether something drawn lies before a point.
    pub fn hides(&self, at: Vec2, nearness: f32) -> bool {
        let at = SAMPLES * (at - self.area.min());
        if at.min_element() < 0.0 {
            return false;
        }
        let (x, y) = (at.x as usize, at.y as usize);
        x < self.width && y < self.height && self.nearness[y * self.width + x] > nearness
    }
}

fn opaque([r, g, b]: [u8; 3]) -> [u8; 4] {
    [r, g, b, 255]
}

/// The pixels with their middles from `low` on and before `high`.
fn pixels_between(low: f32, high: f32, count: usize) -> std::ops::Range<usize> {
    let number = |at: f32| ((at - 0.5).ceil().max(0.0) as usize).min(count);
    number(low)..number(high)
}

#[cfg(test)]
mod tests {
    use super::*;

    const AREA: Rect = Rect {
        x: 10.0,
        y: 20.0,
        width: 8.0,
        height: 6.0,
    };

    fn seen(x: f32, y: f32, nearness: f32) -> Seen {
        Seen {
            at: AREA.min() + Vec2::new(x, y),
            nearness,
            scale: 1.0,
        }
    }

    fn rectangle(nearness: f32) -> [[Seen; 3]; 2] {
        let [a, b] = [seen(0.0, 0.0, nearness), seen(8.0, 0.0, nearness)];
        let [c, d] = [seen(8.0, 6.0, nearness), seen(0.0, 6.0, nearness)];
        [[a, b, c], [a, c, d]]
    }

    #[test]
    fn two_triangles_with_a_common_edge_cover_each_pixel_once() {
        let mut solids = Solids::new(AREA);
        for triangle in rectangle(0.0) {
            solids.veil(triangle, [200, 100, 0], 0.5);
        }
        let all = solids.pixels.iter();
        assert!(all.clone().all(|&pixel| pixel == [200, 100, 0, 128]));
        assert_eq!(all.len(), 16 * 12);
    }

    #[test]
    fn what_is_nearer_hides_what_is_drawn_before_and_after() {
        for order in [[0, 1], [1, 0]] {
            let mut solids = Solids::new(AREA);
            for which in order {
                let color = [[255, 0, 0], [0, 0, 255]][which];
                for triangle in rectangle(which as f32) {
                    solids.triangle(triangle, |_| color);
                }
            }
            assert!(solids.pixels.iter().all(|&pixel| pixel == [0, 0, 255, 255]));
        }
    }

    #[test]
    fn a_line_is_divided_where_it_is_hidden() {
        let mut solids = Solids::new(AREA);
        let half = [
            seen(4.0, -9.0, 1.0),
            seen(12.0, 3.0, 1.0),
            seen(4.0, 15.0, 1.0),
        ];
        solids.triangle(half, |_| [9; 3]);
        let line = [seen(0.0, 3.0, 0.0), seen(8.0, 3.0, 0.0)];
        let (_, depths) = solids.finish();
        let pieces = depths.pieces(line, 0.1);
        assert_eq!(pieces.len(), 2);
        assert!(pieces[0].1 && !pieces[1].1);
        assert_eq!(pieces[0].0[1], AREA.min() + Vec2::new(4.0, 3.0));
        assert_eq!(depths.pieces(line, 2.0).len(), 1, "it lies on the surface");
    }

    #[test]
    fn shares_are_those_of_the_surface_in_perspective() {
        let mut solids = Solids::new(AREA);
        let far = seen(0.0, 0.0, 0.0);
        let near = |y| Seen {
            scale: 3.0,
            ..seen(8.0, y, 1.0)
        };
        // Halfway on the figure, three quarters of the way belong to the corners three times as near.
        solids.triangle([far, near(0.0), near(6.0)], |shares| {
            [(255.0 * shares.x).round() as u8, 0, 0]
        });
        let middle = solids.pixels[2 * 16 + 8];
        let share = f32::from(middle[0]) / 255.0;
        assert!((share - 0.25).abs() < 0.06, "{share}");
    }
}
