//! The matrix in as many cells as there is room for, and the scale of its colours.

use crate::figure::viridis;
use crate::panels::horizon::hatch;
use crate::picture::{Image, Rect};
use glam::Vec2;
use std::ops::Range;

/// Decades that the colours span at most: what is smaller has the colour of the smallest.
const DECADES: i32 = 6;
/// Entries along each side of a cell of many that are looked at.
const LOOKS: usize = 4;

/// A square matrix as it is drawn. Where there are more entries than points, a cell shows the largest of several.
pub struct Grid {
    pub n: usize,
    /// Cells along each side: `n`, or fewer.
    pub cells: usize,
    pub area: Rect,
    /// Row-major, one a cell.
    values: Vec<f64>,
}

impl Grid {
    /// As large as it fits into `area`, from its upper left corner.
    pub fn new(matrix: &[f64], n: usize, area: Rect) -> Self {
        let room = Vec2::new(area.width, area.height).max(Vec2::ONE);
        let cells = n.min(room.min_element() as usize);
        // Cells of whole points are equally large on every screen.
        let extent = cells as f32 * (room / cells as f32).floor();
        let mut grid = Grid {
            n,
            cells,
            area: Rect::new(area.x.floor(), area.y.floor(), extent.x, extent.y),
            values: Vec::new(),
        };
        let parts: Vec<Range<usize>> = (0..cells).map(|cell| grid.entries(cell)).collect();
        let looked = |part: &Range<usize>| part.clone().step_by(part.len().div_ceil(LOOKS).max(1));
        // Not a number where all are hidden
        let largest = |rows: &Range<usize>, columns: &Range<usize>| {
            looked(rows)
                .flat_map(|i| looked(columns).map(move |j| matrix[i * n + j]))
                .fold(f64::NAN, f64::max)
        };
        grid.values = parts
            .iter()
            .flat_map(|rows| parts.iter().map(move |columns| (rows, columns)))
            .map(|(rows, columns)| largest(rows, columns))
            .collect();
        grid
    }

    /// The entries of a cell, along one side.
    pub fn entries(&self, cell: usize) -> Range<usize> {
        cell * self.n / self.cells..(cell + 1) * self.n / self.cells
    }

    /// Points a cell.
    pub fn cell(&self) -> Vec2 {
        Vec2::new(self.area.width, self.area.height) / self.cells as f32
    }

    /// Where rows begin and end.
    pub fn rows(&self, rows: Range<usize>) -> [f32; 2] {
        self.span(rows, self.area.y, self.area.height)
    }

    /// Where columns begin and end.
    pub fn columns(&self, columns: Range<usize>) -> [f32; 2] {
        self.span(columns, self.area.x, self.area.width)
    }

    fn span(&self, entries: Range<usize>, start: f32, length: f32) -> [f32; 2] {
        [entries.start, entries.end].map(|at| start + at as f32 / self.n as f32 * length)
    }

    pub fn rect(&self, rows: Range<usize>, columns: Range<usize>) -> Rect {
        let ([top, bottom], [left, right]) = (self.rows(rows), self.columns(columns));
        Rect::between([left, top], [right, bottom])
    }

    /// Powers of ten around all values but 0.
    pub fn decades(&self) -> [i32; 2] {
        let positive = self.values.iter().filter(|&&value| value > 0.0);
        let (low, high) = positive.fold((f64::INFINITY, 0.0_f64), |(low, high), &value| {
            (low.min(value), high.max(value))
        });
        if high == 0.0 {
            return [-1, 0];
        }
        let last = high.log10().ceil() as i32;
        let first = low.log10().floor() as i32;
        [first.clamp(last - DECADES, last - 1), last]
    }

    /// Whether most of it is hidden.
    pub fn is_mostly_hidden(&self) -> bool {
        let hidden = self.values.iter().filter(|value| value.is_nan()).count();
        2 * hidden > self.values.len()
    }

    /// One pixel a cell; where it is 0, nothing, and where it is hidden, a pattern.
    pub fn image(&self) -> Image {
        let [first, last] = self.decades().map(f64::from);
        let color = |(cell, &value): (usize, &f64)| {
            if value.is_nan() {
                let [r, g, b] = hatch(4 * (cell % self.cells), 4 * (cell / self.cells));
                [r, g, b, 255]
            } else if value > 0.0 {
                let share = (value.log10() - first) / (last - first);
                let [r, g, b] = viridis(share).to_srgb8();
                [r, g, b, 255]
            } else {
                [0; 4]
            }
        };
        let bytes: Vec<u8> = self.values.iter().enumerate().flat_map(color).collect();
        Image::new(self.cells as u32, self.cells as u32, bytes)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_share_the_entries_and_none_is_left_out() {
        for (n, side) in [(7, 100.0), (100, 100.0), (250, 100.0), (1, 3.0)] {
            let matrix = vec![0.01; n * n];
            let grid = Grid::new(&matrix, n, Rect::new(0.0, 0.0, side, side));
            let parts: Vec<_> = (0..grid.cells).map(|cell| grid.entries(cell)).collect();
            assert_eq!((parts[0].start, parts[grid.cells - 1].end), (0, n));
            assert!(parts.windows(2).all(|pair| pair[0].end == pair[1].start));
            assert!(parts.iter().all(|part| !part.is_empty()));
            assert_eq!(grid.decades(), [-3, -2]);
        }
    }
}
