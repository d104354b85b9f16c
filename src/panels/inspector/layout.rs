//! How large the lines are written, in how many columns, and which of them are seen.

use super::values::{Line, heading, lines};
use crate::panels::PanelInput;
use crate::picture::{Ink, Picture, Rect, Tag};
use crate::replay::RecordedField;
use glam::Vec2;
use std::ops::Range;

pub(super) const MARGIN: f32 = 10.0;
pub(super) const GAP: f32 = 14.0;
/// Room for the title.
pub(super) const TITLE: f32 = 30.0;
const LINE_HEIGHT: f32 = 1.6;
const LARGEST: f32 = 14.0;
const SMALLEST: f32 = 11.0;
/// Decimals of vectors and colours, from the most to the least.
const DECIMALS: [usize; 4] = [4, 3, 2, 1];

pub(super) struct Layout {
    pub lines: Vec<Line>,
    pub text: f32,
    /// Of names and of values.
    widths: [f32; 2],
    /// Columns of lines beside each other: a low, wide panel has several.
    columns: usize,
    size: Vec2,
}

impl Layout {
    /// The largest text at which all lines fit; where none is small enough, the smallest, and the list can be scrolled. Fewer decimals
    /// only where the panel is too narrow for more.
    pub fn of(known: &[RecordedField], shown: usize, input: &PanelInput, size: Vec2) -> Self {
        let steps = (2.0 * (LARGEST - SMALLEST)) as usize;
        let mut layout = None;
        for decimals in DECIMALS {
            let mut one = Layout::with(lines(known, shown, input, decimals), size);
            for step in 0..=steps {
                one.set_text(LARGEST - 0.5 * step as f32);
                if one.columns > 0 && one.lines.len() <= one.capacity() {
                    return one;
                }
            }
            let is_wide = one.columns > 0;
            layout = Some(one);
            if is_wide {
                break;
            }
        }
        let mut layout = layout.expect("there is a number of decimals");
        if layout.columns == 0 {
            // Long names are shortened, and values after them.
            layout.columns = 1;
            let room = size.x - 2.0 * MARGIN - GAP;
            let [name, value] = &mut layout.widths;
            *name = name.min((room - *value).max(0.4 * room));
            *value = room - *name;
        }
        layout
    }

    /// In the largest text.
    fn with(lines: Vec<Line>, size: Vec2) -> Self {
        let mut widths = [0.0_f32; 2];
        for line in &lines {
            if let Line::Value(known) = line {
                let cells = known.cells(LARGEST, true).map(|cell| cell.width());
                widths = [widths[0].max(cells[0]), widths[1].max(cells[1])];
            }
        }
        Layout {
            lines,
            text: LARGEST,
            widths,
            columns: 0,
            size,
        }
    }

    /// Scales the columns to a size of text, and finds how many stand beside each other.
    fn set_text(&mut self, text: f32) {
        let factor = text / self.text;
        self.text = text;
        self.widths = self.widths.map(|width| factor * width);
        let column = self.widths.iter().sum::<f32>() + GAP;
        let columns = ((self.width() + 2.0 * GAP) / (column + 2.0 * GAP)) as usize;
        // No more than there are lines for, so that headings have all the width.
        self.columns = columns.min(self.lines.len().div_ceil(self.lines_a_column()));
    }

    fn width(&self) -> f32 {
        self.size.x - 2.0 * MARGIN
    }

    /// How many lines fit.
    fn capacity(&self) -> usize {
        self.columns * self.lines_a_column()
    }

    fn lines_a_column(&self) -> usize {
        ((self.size.y - TITLE - 4.0) / (LINE_HEIGHT * self.text)).max(1.0) as usize
    }

    /// The lines that are seen when so many are scrolled past, which is no more than lets the last be seen; and whether the first place
    /// and the last stand for those before and after.
    pub fn seen(&self, first: usize) -> (Range<usize>, [bool; 2]) {
        let (all, room) = (self.lines.len(), self.capacity());
        if all <= room {
            return (0..all, [false; 2]);
        }
        // One place stands for those before.
        let last_first = all + 1 - room.max(2);
        let first = first.min(last_first);
        let before = first > 0;
        let room = room - usize::from(before);
        let after = all - first > room;
        let end = first + room.saturating_sub(usize::from(after));
        (first..end.min(all), [before, after])
    }

    /// The place of the `i`-th line that is seen.
    pub fn place(&self, i: usize) -> Rect {
        let rows = self.lines_a_column();
        let height = LINE_HEIGHT * self.text;
        let column = (self.width() + 2.0 * GAP) / self.columns as f32;
        Rect::new(
            MARGIN + (i / rows) as f32 * column,
            TITLE + (i % rows) as f32 * height,
            column - 2.0 * GAP,
            height,
        )
    }

    pub fn draw(&self, picture: &mut Picture, line: &Line, place: Rect, input: &PanelInput) {
        let here = input.run.walk().position();
        match line {
            Line::Heading { step, kind } => {
                let ink = if *step == here {
                    Ink::This
                } else {
                    Ink::Linked
                };
                let heading = heading(kind, *step, input, self.text, ink);
                picture.tagged(Tag::Step(*step), |picture| {
                    heading.draw(picture, place);
                });
            }
            Line::Value(known) => {
                let [name, value] = known.cells(self.text, known.recorded.step == here);
                picture.tagged(Tag::Field(known.recorded.field.name), |picture| {
                    let width = self.widths[0];
                    name.draw(picture, Rect { width, ..place });
                    let start = place.x + width + GAP;
                    value.draw(picture, Rect::between((start, place.y), place.max()));
                });
            }
        }
    }
}
