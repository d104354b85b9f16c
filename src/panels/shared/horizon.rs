//! What is known while a question waits: nothing ahead of its step is shown, so that the answer cannot be read anywhere.
//!
//! What is hidden is hatched, or a question mark stands in its place, so that it does not look as if it were missing.

use super::message::AFTER_YOUR_ANSWER;
use crate::algorithms::focus::{Focus, Region};
use crate::algorithms::frame::Frame;
use crate::figure::elided;
use crate::language::Language;
use crate::panels::PanelInput;
use crate::picture::{Ink, Picture, Rect, Style};
use crate::replay::Run;
use glam::DVec2;
use std::iter;
use std::ops::Range;

named! {
    /// What a question of a lesson may hide until it is answered, beside all that is ahead of its step.
    pub enum Hidden {
        /// The finished picture, and those of other methods, where the run has not drawn them.
        Picture = "picture",
    }
}

/// What stands in the place of a number that is hidden.
pub const UNKNOWN: &str = "?";

/// The greys of hatched pixels, in sRGB: they stand out from each other and from black and white.
const HATCH: [u8; 2] = [150, 176];

impl PanelInput<'_> {
    /// Whether a question waits at the step.
    pub fn is_pending(&self) -> bool {
        self.pending.is_some()
    }

    /// The last step whose values may be shown: that of the next question.
    pub fn last_known(&self) -> usize {
        match self.is_pending() {
            true => self.run.walk().position(),
            false => self.waiting.unwrap_or(usize::MAX),
        }
    }

    pub fn hides(&self, what: Hidden) -> bool {
        self.pending.is_some_and(|hidden| hidden.contains(&what))
    }

    /// The pixels of a finished picture like `frame` that are hidden, row by row: what the run is about to draw, or all that it
    /// has not drawn. None where no pixel is hidden.
    pub fn hidden_pixels(&self, frame: &Frame) -> Option<Vec<bool>> {
        if !self.is_pending() {
            return None;
        }
        let count = frame.color.len();
        let Some(canvas) = self.run.canvas() else {
            // A room is shown in its light so far, which is known.
            let is_ahead = !matches!(self.run, Run::Radiosity(..) | Run::Hierarchical(..));
            return is_ahead.then(|| vec![true; count]);
        };
        // What is drawn so far may be covered by what is nearer.
        let finished = self
            .finished
            .picture
            .color
            .iter()
            .map(Some)
            .chain(iter::repeat(None));
        let drawn = iter::zip(canvas.iter(), finished)
            .map(|(dot, finished)| dot.step.is_some() && finished == Some(&dot.color));
        let region = match self.focus {
            _ if self.hides(Hidden::Picture) => Focus::Frame.region(frame),
            Focus::Polygon(number) => self.box_of(number, frame),
            focus => focus.region(frame),
        };
        let rows = frame.rows.clone();
        let pixels = rows.flat_map(|y| (0..frame.width).map(move |x| (x, y)));
        let within = |(x, y)| region.columns.contains(&x) && region.rows.contains(&y);
        let hidden = iter::zip(pixels, drawn).map(|(at, drawn)| !drawn && within(at));
        Some(hidden.collect())
    }

    /// The pixels around a polygon of the scene.
    fn box_of(&self, polygon: usize, frame: &Frame) -> Region {
        let prepared = self.run.prepared();
        let whole = Focus::Frame.region(frame);
        let Some(polygon) = prepared.polygon(polygon) else {
            return whole;
        };
        let corners: Vec<DVec2> = polygon.corners().map(|(_, corner)| corner.screen).collect();
        let range = |whole: Range<u32>, of: fn(&DVec2) -> f64| {
            let (low, high) = corners
                .iter()
                .map(of)
                .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), at| {
                    (low.min(at), high.max(at))
                });
            // A cast from float saturates.
            let start = (low.floor() as u32).clamp(whole.start, whole.end);
            start..(high.ceil() as u32).clamp(start, whole.end)
        };
        Region {
            columns: range(whole.columns, |corner| corner.x),
            rows: range(whole.rows, |corner| corner.y),
        }
    }
}

/// The colours of a finished picture as bytes, hidden pixels hatched.
pub fn srgb_bytes(frame: &Frame, hidden: Option<&[bool]>) -> Vec<u8> {
    let colors = frame.color.iter().map(|color| color.to_srgb8());
    hatched(colors, frame.width, hidden)
}

/// Pixels of a picture so many wide as bytes, hidden ones hatched.
pub fn hatched(
    pixels: impl Iterator<Item = [u8; 3]>,
    width: u32,
    hidden: Option<&[bool]>,
) -> Vec<u8> {
    let width = width.max(1) as usize;
    let one = |(at, pixel): (usize, [u8; 3])| match hidden {
        Some(hidden) if hidden[at] => hatch(at % width, at / width),
        _ => pixel,
    };
    pixels.enumerate().flat_map(one).collect()
}

/// Diagonal stripes.
pub fn hatch(x: usize, y: usize) -> [u8; 3] {
    const STRIPE: usize = 4;
    [HATCH[(x + y) / STRIPE % 2]; 3]
}

/// Says in the middle of `place` that what is hidden there comes after the answer; where there is no room, a question mark.
pub fn after_your_answer(picture: &mut Picture, place: Rect, language: Language) {
    let style = Style::Body.size(12.0).ink(Ink::Text).middle();
    let text = AFTER_YOUR_ANSWER.text(language);
    let text = match style.width(text) + 12.0 <= place.width {
        true => text,
        false => UNKNOWN,
    };
    let width = (style.width(text) + 12.0).min(place.width);
    let height = 20.0_f32.min(place.height);
    let center = place.center();
    let label = Rect::new(
        center.x - 0.5 * width,
        center.y - 0.5 * height,
        width,
        height,
    );
    picture.rounded_rect(
        label,
        4.0,
        Ink::Surface.fill().outlined(Ink::Rule.stroke(1.0)),
    );
    elided(picture, label, text, style);
}
