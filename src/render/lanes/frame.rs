//! The picture that is filled in lanes, and how one span of it is.

use super::{LANES, Lanes, Shade};
use crate::color::Rgb;
use crate::numeric::Plane;
use std::ops::Range;

/// Eight pixels in a row, from a column that is a multiple of eight.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Block {
    inverse_depth: Lanes,
    color: [Lanes; 3],
}

/// Linear RGB and depth in f32, of whole blocks.
#[derive(Clone, Debug, PartialEq)]
pub struct LaneFrame {
    width: u32,
    height: u32,
    blocks_a_row: usize,
    blocks: Vec<Block>,
}

/// 0, 1, … 7
const OFFSETS: Lanes = [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0];

/// Rows that are drawn together, so that their pixels stay in the cache of one core until they are done.
pub(super) fn band_rows(width: u32) -> u32 {
    const CACHE: usize = 128 * 1024;
    let row = (width as usize).div_ceil(LANES) * size_of::<Block>();
    (CACHE / row.max(1)).clamp(1, 64) as u32
}

impl LaneFrame {
    pub fn new(width: u32, height: u32) -> Self {
        let blocks_a_row = (width as usize).div_ceil(LANES);
        let empty = Block {
            inverse_depth: [0.0; LANES],
            color: [[0.0; LANES]; 3],
        };
        LaneFrame {
            width,
            height,
            blocks_a_row,
            blocks: vec![empty; blocks_a_row * height as usize],
        }
    }

    pub fn pixel(&self, x: u32, y: u32) -> [f32; 3] {
        let (block, lane) = (x as usize / LANES, x as usize % LANES);
        self.blocks[y as usize * self.blocks_a_row + block]
            .color
            .map(|channel| channel[lane])
    }

    pub(super) fn width(&self) -> u32 {
        self.width
    }

    pub(super) fn band(&self, number: u32) -> Range<u32> {
        let rows = band_rows(self.width);
        number * rows..((number + 1) * rows).min(self.height)
    }

    pub(super) fn clear(&mut self, rows: &Range<u32>, background: Rgb) {
        let at = |row: u32| row as usize * self.blocks_a_row;
        let (start, end) = (at(rows.start), at(rows.end));
        self.blocks[start..end].fill(Block {
            inverse_depth: [0.0; LANES],
            color: background.channels().map(|channel| [channel as f32; LANES]),
        });
    }

    /// The pixels `columns` of row `y`, where they are nearer than what was drawn there before.
    #[inline]
    pub(super) fn fill_span<S: Shade>(
        &mut self,
        y: u32,
        columns: Range<u32>,
        inverse_depth: &Plane<f64>,
        shade: &mut S,
    ) {
        if columns.is_empty() {
            return;
        }
        let (first, last) = (
            columns.start as usize / LANES,
            (columns.end as usize - 1) / LANES,
        );
        // Offsets count from the span's first pixel: what is linear over a narrow triangle may be large beside it.
        let lead = (columns.start as usize % LANES) as f32;
        let length = columns.len() as f32;
        let (x, y_4) = (f64::from(columns.start) + 0.5, f64::from(y) + 0.5);
        shade.span(x, y_4);
        let depth = inverse_depth.at(x, y_4) as f32;
        let depth_step = inverse_depth.dx as f32;
        let row = y as usize * self.blocks_a_row;
        for (number, block) in self.blocks[row + first..=row + last].iter_mut().enumerate() {
            let ahead = (number * LANES) as f32 - lead;
            let offset = OFFSETS.map(|lane| ahead + lane);
            let near: Lanes = std::array::from_fn(|i| depth + depth_step * offset[i]);
            let nearer: [u32; LANES] =
                std::array::from_fn(|i| bits(near[i] > block.inverse_depth[i]));
            let is_inner = ahead >= 0.0 && ahead + LANES as f32 <= length;
            if is_inner && nearer.iter().fold(u32::MAX, |all, lane| all & lane) == u32::MAX {
                block.inverse_depth = near;
                shade.colors(&offset, &mut block.color);
                continue;
            }
            let drawn: [u32; LANES] = std::array::from_fn(|i| {
                nearer[i] & bits(offset[i] >= 0.0) & bits(offset[i] < length)
            });
            if drawn.iter().fold(0, |any, lane| any | lane) != 0 {
                let mut color = [[0.0; LANES]; 3];
                shade.colors(&offset, &mut color);
                pick(&drawn, &near, &mut block.inverse_depth);
                for (channel, new) in block.color.iter_mut().zip(&color) {
                    pick(&drawn, new, channel);
                }
            }
        }
    }
}

/// All bits of a lane, or none.
#[inline(always)]
fn bits(truth: bool) -> u32 {
    u32::from(truth).wrapping_neg()
}

/// Puts `new` in the place of `old` where `drawn` has its bits: by logic, for a branch would stop the lanes.
#[inline(always)]
fn pick(drawn: &[u32; LANES], new: &Lanes, old: &mut Lanes) {
    *old = std::array::from_fn(|i| {
        f32::from_bits((new[i].to_bits() & drawn[i]) | (old[i].to_bits() & !drawn[i]))
    });
}
