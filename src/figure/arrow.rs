//! What stands at points: arrows with their names at their tips, and discs in the colour of a value.

use super::labels::Labels;
use crate::picture::{Ink, Picture, Rect, Stroke, Style, Tag};
use glam::Vec2;

/// Length and width of the head of an arrow, about.
const HEAD: f32 = 10.0;

pub struct Arrow<'a> {
    pub from: Vec2,
    pub to: Vec2,
    pub stroke: Stroke,
    pub tag: Tag,
    pub name: &'a str,
    /// Of the name, in points.
    pub size: f32,
    /// Whether this step is about it.
    pub here: bool,
}

impl Arrow<'_> {
    /// Draws the arrow and writes its name beyond the tip, where that covers no other label.
    pub fn draw(&self, picture: &mut Picture, labels: &mut Labels) {
        let Arrow { from, to, .. } = *self;
        let stroke = match self.here {
            true => Stroke {
                ink: Ink::This,
                ..self.stroke
            },
            false => self.stroke,
        };
        picture.tagged(self.tag, |picture| {
            picture.arrow(from, to, stroke);
        });
        labels.avoid_arrow(from, to, stroke.width);
        let ink = if self.here { Ink::This } else { Ink::Text };
        let set = Style::LabelBold.size(self.size).ink(ink);
        picture.tagged(self.tag, |picture| {
            labels.put(picture, (to, 2.0), to - from, self.name, set);
        });
    }
}

/// What is blocked or does not pass is crossed out.
pub fn cross(picture: &mut Picture, at: Vec2, reach: f32, width: f32) {
    for arm in [Vec2::new(reach, reach), Vec2::new(reach, -reach)] {
        picture.line(at - arm, at + arm, Ink::Bad.stroke(width));
    }
}

/// A disc in the colour of the value at a point, which no label covers.
pub fn disc(
    picture: &mut Picture,
    labels: &mut Labels,
    (at, radius): (Vec2, f32),
    fill: Ink,
    ring: Stroke,
) {
    picture.circle(at, radius, fill.fill().outlined(ring));
    labels.reserve(Rect::between(at, at).grown(radius));
}

impl Labels {
    /// No label on the shaft, nor on the wider head.
    pub fn avoid_arrow(&mut self, from: Vec2, to: Vec2, width: f32) {
        self.avoid_stroke(from, to, width + 2.0);
        let head = HEAD.min(0.4 * from.distance(to)) * (from - to).normalize_or_zero();
        self.avoid_stroke(to + head, to, HEAD);
    }
}
