//! The picture that a scan-line method fills: colour and depth of every pixel.

use crate::color::Rgb;
use std::ops::Range;

/// A band of whole rows of a picture, usually all of them. Pixels are stored row by row from the top.
#[derive(Clone, Debug, PartialEq)]
pub struct Frame {
    pub width: u32,
    pub rows: Range<u32>,
    pub color: Vec<Rgb>,
    /// 1/depth of what is drawn, and 0, infinitely far, where nothing is. It is linear on the screen, unlike depth itself.
    pub inverse_depth: Vec<f64>,
}

impl Frame {
    pub fn new(width: u32, rows: Range<u32>, background: Rgb) -> Self {
        let pixels = width as usize * rows.len();
        Frame {
            width,
            rows,
            color: vec![background; pixels],
            inverse_depth: vec![0.0; pixels],
        }
    }

    /// Position of pixel (x, y) of the picture among the pixels of the band.
    #[inline]
    pub fn index(&self, x: u32, y: u32) -> usize {
        (y - self.rows.start) as usize * self.width as usize + x as usize
    }

    pub fn pixel(&self, x: u32, y: u32) -> Rgb {
        self.color[self.index(x, y)]
    }
}
