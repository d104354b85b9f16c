//! Curves that are distinguished by colour, dash and mark, and the legend that says which is which.

use crate::picture::{Ink, Picture, Rect, Stroke, Style};
use glam::Vec2;

/// The accent's neighbour and the yellow, which is the palest, last.
const INKS: [u8; 8] = [0, 1, 2, 3, 4, 7, 5, 6];
const MARKS: [Mark; 5] = [
    Mark::Disc,
    Mark::Square,
    Mark::Triangle,
    Mark::Diamond,
    Mark::Funnel,
];

/// How one of several curves looks.
#[derive(Clone, Copy, Debug)]
pub struct Series {
    pub ink: Ink,
    pub stroke: Stroke,
    pub mark: Mark,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mark {
    Disc,
    Square,
    Triangle,
    Diamond,
    Funnel,
}

impl Series {
    /// The n-th curve.
    pub fn of(n: usize) -> Self {
        let ink = Ink::Series(INKS[n % INKS.len()]);
        let stroke = ink.stroke(1.75);
        Series {
            ink,
            stroke: match n % 3 {
                0 => stroke,
                1 => stroke.dashed(),
                _ => stroke.dotted(),
            },
            mark: MARKS[n % MARKS.len()],
        }
    }
}

impl Mark {
    /// About a point, `r` its radius.
    pub fn draw(self, picture: &mut Picture, at: Vec2, r: f32, ink: Ink) {
        let mut corners = |corners: &[[f32; 2]]| {
            let corners = corners.iter().map(|&corner| at + r * Vec2::from(corner));
            picture.polygon(corners, ink);
        };
        match self {
            Mark::Disc => drop(picture.circle(at, r, ink)),
            Mark::Square => drop(picture.rect(Rect::between(at - 0.85 * r, at + 0.85 * r), ink)),
            Mark::Triangle => corners(&[[0.0, -1.2], [1.1, 0.8], [-1.1, 0.8]]),
            Mark::Diamond => corners(&[[0.0, -1.25], [1.25, 0.0], [0.0, 1.25], [-1.25, 0.0]]),
            Mark::Funnel => corners(&[[0.0, 1.2], [1.1, -0.8], [-1.1, -0.8]]),
        }
    }
}

/// Height of a row of a legend, and its sample of a line.
pub const LEGEND_ROW: f32 = 16.0;
const SAMPLE: f32 = 20.0;
/// From the beginning of an entry to its name.
pub const LEGEND_SAMPLE: f32 = SAMPLE + 4.0;
const TEXT: f32 = 11.0;

/// Names with their lines, from the row's beginning on; what does not fit stands in rows below it that begin at `left`. Returns where
/// they end.
pub fn legend<'a>(
    picture: &mut Picture,
    entries: impl IntoIterator<Item = (Stroke, &'a str)>,
    row: Rect,
    left: f32,
) -> f32 {
    let style = Style::Body.size(TEXT);
    let (mut x, mut y) = (row.x, row.y);
    for (stroke, name) in entries {
        let width = LEGEND_SAMPLE + style.width(name);
        if x + width > row.right() && x > left {
            (x, y) = (left, y + LEGEND_ROW);
        }
        let middle = y + 0.5 * LEGEND_ROW;
        picture.line((x, middle), (x + SAMPLE, middle), stroke);
        let text = Rect::new(x + LEGEND_SAMPLE, y, row.right() - x, LEGEND_ROW);
        picture.text_in(text, name, style);
        x += width + 8.0;
    }
    y + LEGEND_ROW
}
