//! The pixel at which methods are compared: the current one, and before there is one, that of the focus.

use super::super::PanelInput;
use crate::algorithms::focus::Focus;
use crate::algorithms::frame::Frame;
use crate::color::Rgb;
use crate::record::Value;

/// A scan line, and a pixel on it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cursor {
    pub x: Option<u32>,
    pub y: Option<u32>,
}

impl Cursor {
    pub fn of(input: &PanelInput) -> Cursor {
        let walk = input.run.walk();
        let recorded = (!walk.is_empty()).then(|| walk.fields(walk.position()));
        let whole = |name| match recorded.as_ref().and_then(|fields| fields.get(name)) {
            Some(Value::Integer(value)) => u32::try_from(value).ok(),
            _ => None,
        };
        let looked_at = match input.focus {
            Focus::Pixel { x, y } => (Some(x), Some(y)),
            Focus::ScanLine(y) => (None, Some(y)),
            _ => (None, None),
        };
        let y = whole("y").or(looked_at.1);
        Cursor {
            x: whole("x").or(looked_at.0).filter(|_| y.is_some()),
            y,
        }
    }

    /// The row of the pixel; where there is none, the middle one.
    pub fn row(&self, frame: &Frame) -> u32 {
        let rows = frame.rows.len() as u32;
        self.y.filter(|&y| y < rows).unwrap_or(rows / 2)
    }

    /// Whether its pixel is one of those marked, row by row.
    pub fn is_on(&self, frame: &Frame, marked: &[bool]) -> bool {
        match (self.x, self.y) {
            (Some(x), Some(y)) if self.value(frame).is_some() => marked[frame.index(x, y)],
            _ => false,
        }
    }

    /// The colour of a picture there.
    pub fn value(&self, frame: &Frame) -> Option<Rgb> {
        let (x, y) = (self.x?, self.y?);
        (x < frame.width && frame.rows.contains(&y)).then(|| frame.pixel(x, y))
    }
}
