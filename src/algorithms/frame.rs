//! The picture that a scan-line method fills: colour and depth of every pixel.

use crate::color::Rgb;

/// `width`×`height` pixels, row by row from the top.
#[derive(Clone, Debug, PartialEq)]
pub struct Frame {
    pub width: u32,
    pub height: u32,
    pub color: Vec<Rgb>,
    /// 1/depth of what is drawn, 0 where nothing is: infinitely far. Linear on the screen, as depth itself is not.
    pub inverse_depth: Vec<f64>,
}

impl Frame {
    pub fn new(width: u32, height: u32, background: Rgb) -> Self {
        let pixels = width as usize * height as usize;
        Frame {
            width,
            height,
            color: vec![background; pixels],
            inverse_depth: vec![0.0; pixels],
        }
    }

    /// Position of pixel (x, y) in the rows.
    #[inline]
    pub fn index(&self, x: u32, y: u32) -> usize {
        y as usize * self.width as usize + x as usize
    }

    pub fn pixel(&self, x: u32, y: u32) -> Rgb {
        self.color[self.index(x, y)]
    }
}
