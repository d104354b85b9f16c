//! How curves look, and what is written beside them.

use super::{SMALL, TEXT};
use crate::panels::labels::Labels;
use crate::picture::{Ink, Picture, Rect, Stroke, Style};
use crate::study::form::Axes;
use crate::study::harness::{Line, Part, Point};
use crate::study::report::strings;
use glam::Vec2;

/// Colour, shape of the marks and dash, so that curves are told apart without colours too.
#[derive(Clone, Copy, Debug)]
pub struct Look {
    pub ink: Ink,
    pub mark: Mark,
    pub dashed: bool,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mark {
    Disc,
    Square,
    Triangle,
    Diamond,
    Funnel,
}

/// All that can be seen on white.
const INKS: [u8; 7] = [0, 5, 2, 3, 1, 4, 7];
const MARKS: [Mark; 5] = [
    Mark::Disc,
    Mark::Square,
    Mark::Triangle,
    Mark::Diamond,
    Mark::Funnel,
];
const RADIUS: f32 = 4.0;

impl Look {
    /// Of the n-th curve.
    pub fn of(n: usize) -> Look {
        Look {
            ink: Ink::Series(INKS[n % INKS.len()]),
            mark: MARKS[n % MARKS.len()],
            dashed: n / MARKS.len() % 2 == 1,
        }
    }

    fn stroke(&self) -> Stroke {
        let stroke = self.ink.stroke(1.75);
        if self.dashed { stroke.dashed() } else { stroke }
    }

    pub(super) fn curve(&self, picture: &mut Picture, labels: &mut Labels, places: &[Vec2]) {
        for pair in places.windows(2) {
            picture.line(pair[0], pair[1], self.stroke());
            labels.avoid(pair[0], pair[1]);
        }
    }

    /// A mark, with the bar of its quartiles.
    pub(super) fn point(
        &self,
        picture: &mut Picture,
        labels: &mut Labels,
        at: Vec2,
        bar: Option<[Vec2; 2]>,
    ) {
        if let Some([from, to]) = bar {
            picture.line(from, to, self.ink.stroke(1.0));
            labels.avoid(from, to);
        }
        let r = RADIUS;
        let corner = |x: f32, y: f32| at + r * Vec2::new(x, y);
        match self.mark {
            Mark::Disc => picture.circle(at, r, self.ink),
            Mark::Square => picture.rect(Rect::between(at - 0.85 * r, at + 0.85 * r), self.ink),
            Mark::Triangle => picture.polygon(
                [corner(0.0, -1.2), corner(1.1, 0.8), corner(-1.1, 0.8)],
                self.ink,
            ),
            Mark::Diamond => picture.polygon(
                [
                    corner(0.0, -1.25),
                    corner(1.25, 0.0),
                    corner(0.0, 1.25),
                    corner(-1.25, 0.0),
                ],
                self.ink,
            ),
            Mark::Funnel => picture.polygon(
                [corner(0.0, 1.2), corner(1.1, -0.8), corner(-1.1, -0.8)],
                self.ink,
            ),
        };
        labels.reserve(Rect::between(at - r, at + r));
    }
}

/// Each curve's name with its law beside one of its ends, and what its ends are settings of.
pub(super) fn names(
    picture: &mut Picture,
    labels: &mut Labels,
    part: &Part,
    at: &dyn Fn(&Point) -> Option<Vec2>,
) {
    for line in &part.lines {
        let placed = |point: &Point| at(point);
        let Some(end) = line.points.iter().rev().find_map(placed) else {
            continue;
        };
        let name = match law(part.axes, line) {
            Some(law) => format!("{} {law}", line.name),
            None => line.name.clone(),
        };
        let toward = Vec2::new(1.0, -0.4);
        labels.put(
            picture,
            (end, 8.0),
            toward,
            &name,
            Style::LabelBold.size(TEXT),
        );
    }
    if part.axes != Axes::ErrorOverTime {
        return;
    }
    for line in &part.lines {
        let last = line.points.last().filter(|_| line.points.len() > 1);
        let ends = [line.points.first(), last];
        for (point, toward) in ends.into_iter().flatten().zip([Vec2::Y, -Vec2::Y]) {
            if let Some(place) = at(point) {
                let set = Style::Body.size(SMALL).ink(Ink::Muted);
                labels.put(picture, (place, 8.0), toward, &point.setting, set);
            }
        }
    }
}

fn law(axes: Axes, line: &Line) -> Option<String> {
    let fit = match axes {
        Axes::TimeOverSize => line.growth,
        Axes::ErrorOverTime | Axes::ErrorOverSize => line.convergence,
    };
    strings::law(&fit?)
}
