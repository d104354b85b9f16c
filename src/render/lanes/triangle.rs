//! A triangle of the screen: its spans, and what is linear over it.

use super::Lanes;
use crate::algorithms::scan_line::first_centre;
use crate::numeric::Plane;
pub use crate::numeric::Setup;
use glam::{DVec2, DVec3};
use std::ops::Range;

/// A triangle before the eye.
pub struct Triangle {
    /// On the screen.
    pub corners: [DVec2; 3],
    pub inverse_depths: [f64; 3],
    /// Colours or normals.
    pub values: [DVec3; 3],
    pub object: usize,
    pub face_normal: DVec3,
}

/// A quantity along a span: at its first pixel, and what a pixel to the right adds.
#[derive(Clone, Copy, Debug, Default)]
pub struct Along {
    pub start: f32,
    pub step: f32,
}

impl Triangle {
    pub fn setup(&self) -> Setup {
        Setup::new(self.corners)
    }

    /// The rows of the picture that it reaches.
    pub fn rows(&self, height: u32) -> Range<u32> {
        let ys = self.corners.map(|corner| corner.y);
        let (top, bottom) = (ys[0].min(ys[1]).min(ys[2]), ys[0].max(ys[1]).max(ys[2]));
        first_centre(top, height)..first_centre(bottom, height)
    }

    /// Its rows within `band`, each with the columns whose centres lie between two edges: those of the textbook's edge table, bit for bit.
    pub fn spans(&self, width: u32, band: &Range<u32>, mut span: impl FnMut(u32, Range<u32>)) {
        let [a, b, c] = self.corners;
        let (a, b) = if b.y < a.y { (b, a) } else { (a, b) };
        let (b, c) = if c.y < b.y { (c, b) } else { (b, c) };
        let (top, middle, bottom) = if b.y < a.y { (b, a, c) } else { (a, b, c) };
        let row = |corner: DVec2| first_centre(corner.y, band.end).max(band.start);
        let [first, turn, end] = [top, middle, bottom].map(row);
        let slope = |upper: DVec2, lower: DVec2| (lower.x - upper.x) / (lower.y - upper.y);
        let long = slope(top, bottom);
        for (rows, upper, lower) in [(first..turn, top, middle), (turn..end, middle, bottom)] {
            let short = slope(upper, lower);
            for y in rows {
                let y_4 = f64::from(y) + 0.5;
                let one = first_centre(top.x + (y_4 - top.y) * long, width);
                let two = first_centre(upper.x + (y_4 - upper.y) * short, width);
                span(y, one.min(two)..one.max(two));
            }
        }
    }
}

impl Along {
    /// The three parts of a vector along a span that starts at (x, y).
    #[inline]
    pub fn of(plane: &Plane<DVec3>, x: f64, y: f64) -> [Along; 3] {
        let start = plane.at(x, y).as_vec3().to_array();
        let step = plane.dx.as_vec3().to_array();
        std::array::from_fn(|i| Along {
            start: start[i],
            step: step[i],
        })
    }

    #[inline(always)]
    pub fn at(&self, offset: &Lanes, values: &mut Lanes) {
        for (value, offset) in values.iter_mut().zip(offset) {
            *value = self.start + self.step * offset;
        }
    }
}
