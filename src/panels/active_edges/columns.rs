//! Which columns the table of edges has, and where they stand.

use super::{MARGIN, Row, SIZE, SWATCH};
use crate::picture::{Style, measure};

/// Between two columns.
const GAP: f32 = 14.0;

/// A column, from the most to the least important.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) enum Column {
    Edge,
    X,
    Value,
    To,
    From,
    Step,
    Slope,
}

/// In which order they stand.
pub(super) const ORDER: [Column; 7] = [
    Column::Edge,
    Column::From,
    Column::To,
    Column::X,
    Column::Value,
    Column::Step,
    Column::Slope,
];
/// In which order they go where the panel is narrow.
const DROPPED: [Column; 5] = [
    Column::Slope,
    Column::Step,
    Column::From,
    Column::To,
    Column::Value,
];

/// The columns for which there is room, each with its right edge and its width.
pub(super) fn columns(titles: &[String; 7], rows: &[Row], room: f32) -> Vec<(Column, f32, f32)> {
    let width = |column: Column| {
        let at = place(column);
        let title = measure(&titles[at], Style::Label, 12.0);
        let cells = rows.iter().map(|row| match &row.cells[at] {
            words if words.contains(char::is_alphabetic) => measure(words, Style::Body, 12.0),
            number => measure(number, Style::MonoBold, SIZE),
        });
        let swatch = if column == Column::Value { SWATCH } else { 0.0 };
        cells.fold(title, f32::max) + swatch
    };
    let mut columns = ORDER.to_vec();
    columns.retain(|&column| !titles[place(column)].is_empty());
    let total = |columns: &[Column]| {
        columns.iter().map(|&column| width(column)).sum::<f32>()
            + GAP * (columns.len() as f32 - 1.0)
    };
    for dropped in DROPPED {
        if total(&columns) <= room {
            break;
        }
        columns.retain(|&column| column != dropped);
    }
    // What is left over widens the gaps, up to what is still read as one row.
    let spare = (room - total(&columns)) / columns.len() as f32;
    let gap = GAP + spare.clamp(0.0, 48.0);
    let mut right = MARGIN - gap;
    columns
        .into_iter()
        .map(|column| {
            let width = width(column);
            right += gap + width;
            (column, right, width)
        })
        .collect()
}

pub(super) fn place(column: Column) -> usize {
    ORDER.iter().position(|&known| known == column).unwrap_or(0)
}
