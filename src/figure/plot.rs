//! A plot: a field between two axes with their numbers, names and grid, and the places of values in it.

use super::scale::{Scale, Tick, Unit};
use super::table::elided;
use crate::language::Language;
use crate::picture::{Ink, Picture, Rect, Stroke, Style, Text};
use glam::Vec2;

const TEXT: f32 = 11.0;
/// Height of a line of text at an axis.
pub const ROW: f32 = 16.0;
/// Between the numbers of two ticks, at least: upward from middle to middle, to the right from end to beginning.
const APART: f32 = 18.0;
const BESIDE: f32 = 8.0;

/// A scale with its name and what its numbers count.
#[derive(Clone, Debug)]
pub struct Axis {
    pub scale: Scale,
    pub name: String,
    pub unit: Unit,
    pub language: Language,
}

impl Axis {
    pub fn new(scale: Scale, name: impl Into<String>, language: Language) -> Self {
        Axis {
            scale,
            name: name.into(),
            unit: Unit::None,
            language,
        }
    }

    pub fn unit(self, unit: Unit) -> Self {
        Axis { unit, ..self }
    }

    /// What the numbers need beside an upright axis so long.
    pub fn width(&self, length: f32) -> f32 {
        let scale = self.scale.along([length, 0.0]);
        widest(&scale.ticks(APART, self.unit, self.language)) + 6.0
    }

    fn ticks(&self, apart: f32) -> Vec<Tick> {
        self.scale.ticks(apart, self.unit, self.language)
    }
}

pub struct Plot {
    /// The field, without numbers and names.
    pub place: Rect,
    pub x: Axis,
    pub y: Axis,
}

impl Plot {
    /// In `whole` there is room for the field with its numbers, the name of the upright axis above it and that of the other one
    /// below.
    pub fn new(x: Axis, y: Axis, whole: Rect) -> Self {
        let height = whole.height - 3.0 * ROW - 2.0;
        let left = y.width(height);
        let width = whole.width - left - 6.0;
        let place = Rect::new(
            whole.x + left,
            whole.y + ROW + 2.0,
            width.max(1.0),
            height.max(1.0),
        );
        Plot::in_field(x, y, place)
    }

    pub fn in_field(mut x: Axis, mut y: Axis, place: Rect) -> Self {
        x.scale = x.scale.along([place.x, place.right()]);
        y.scale = y.scale.along([place.bottom(), place.y]);
        Plot { place, x, y }
    }

    /// The place of a value; what is smaller or larger stands on the border.
    pub fn point(&self, x: f64, y: f64) -> Vec2 {
        Vec2::new(self.x.scale.clamped(x), self.y.scale.clamped(y))
    }

    /// The row above the field, right of the name of the upright axis: for a legend.
    pub fn beside_name(&self) -> Rect {
        let x = self.place.x + Style::Label.size(TEXT).width(&self.y.name) + 2.0 * BESIDE;
        Rect::between(
            (x.min(self.place.right()), self.place.y - ROW - 2.0),
            (self.place.right(), self.place.y - 2.0),
        )
    }

    pub fn draw(&self, picture: &mut Picture) {
        self.draw_field(picture);
        self.draw_below(picture);
    }

    /// Axes and grid, the numbers and the name of the upright axis.
    pub fn draw_field(&self, picture: &mut Picture) {
        let grid = Ink::Rule.stroke(1.0).opacity(0.6);
        let Rect { x, y, .. } = self.place;
        for (value, text) in self.y.ticks(APART) {
            self.level(picture, value, grid);
            let baseline = self.y.scale.at(value) + style().baseline_below_middle();
            picture.text((x - 5.0, baseline), text, style().end());
        }
        for (value, _) in self.ticks_across() {
            self.upright(picture, value, grid);
        }
        let (right, bottom) = (self.place.right(), self.place.bottom());
        picture.line((x, y), (x, bottom), Ink::Muted.stroke(1.0));
        picture.line((x, bottom), (right, bottom), Ink::Muted.stroke(1.0));
        let above = Rect::new(x, y - ROW - 2.0, self.place.width, ROW);
        elided(picture, above, &self.y.name, Style::Label.size(TEXT));
    }

    /// The numbers under the field, and below them the name of their axis.
    pub fn draw_below(&self, picture: &mut Picture) {
        let Rect { x, width, .. } = self.place;
        let bottom = self.place.bottom();
        for (value, text) in self.ticks_across() {
            let half = 0.5 * style().width(&text);
            let last = (self.place.right() - 2.0 * half).max(x);
            let left = (self.x.scale.at(value) - half).clamp(x, last);
            let row = Rect::new(left, bottom + 1.0, 2.0 * half, ROW);
            picture.text_in(row, text, style());
        }
        let below = Rect::new(x, bottom + ROW, width, ROW);
        let set = Style::Label.size(TEXT).ink(Ink::Muted).end();
        elided(picture, below, &self.x.name, set);
    }

    /// Ticks to the right, apart by their own width.
    fn ticks_across(&self) -> Vec<Tick> {
        // Those at the ends are moved inward by half their width.
        let apart = |apart| BESIDE + 1.5 * widest(&self.x.ticks(apart));
        self.x.ticks(apart(apart(APART)))
    }

    /// A line across the field: a bound.
    pub fn level(&self, picture: &mut Picture, y: f64, stroke: Stroke) {
        let at = self.y.scale.clamped(y);
        picture.line((self.place.x, at), (self.place.right(), at), stroke);
    }

    /// A line through the field from top to bottom: a cursor.
    pub fn upright(&self, picture: &mut Picture, x: f64, stroke: Stroke) {
        let at = self.x.scale.clamped(x);
        picture.line((at, self.place.y), (at, self.place.bottom()), stroke);
    }
}

fn style() -> Text {
    Style::Body.size(TEXT).ink(Ink::Muted)
}

fn widest(ticks: &[Tick]) -> f32 {
    let widths = ticks.iter().map(|(_, text)| style().width(text));
    widths.fold(0.0, f32::max)
}
