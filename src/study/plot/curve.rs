//! The points of a curve, and what is written beside them.

use super::{SMALL, TEXT};
use crate::figure::{Labels, Series};
use crate::language::Language;
use crate::picture::{Ink, Picture, Rect, Style, Tag};
use crate::study::form::Axes;
use crate::study::harness::{Line, Part, Point};
use crate::study::report::strings;
use glam::Vec2;

const RADIUS: f32 = 4.0;
/// Within it the pointer is at the point.
const REACH: f32 = 10.0;

/// A mark, with the bar of its quartiles.
pub(super) fn point(
    picture: &mut Picture,
    labels: &mut Labels,
    ([curve, point], series): ([usize; 2], Series),
    at: Vec2,
    bar: Option<[Vec2; 2]>,
) {
    if let Some([from, to]) = bar {
        picture.line(from, to, series.ink.stroke(1.0));
        labels.avoid(from, to);
    }
    picture.tagged(Tag::Point { curve, point }, |picture| {
        picture.circle(at, REACH, Ink::Surface.fill().opacity(0.0));
    });
    series.mark.draw(picture, at, RADIUS, series.ink);
    labels.reserve(Rect::between(at - RADIUS, at + RADIUS));
}

/// Each curve's name with its law beside its end. Returns the curves for whose names there is no room.
pub(super) fn names(
    picture: &mut Picture,
    labels: &mut Labels,
    part: &Part,
    language: Language,
    at: &dyn Fn(&Point) -> Option<Vec2>,
) -> Vec<usize> {
    let mut nameless = Vec::new();
    for (number, line) in part.lines.iter().enumerate() {
        let Some(end) = line.points.iter().rev().find_map(at) else {
            continue;
        };
        let name = line.name.text(language);
        let name = match law(part.axes, line, language) {
            Some(law) => format!("{name} {law}"),
            None => name,
        };
        let toward = Vec2::new(1.0, -0.4);
        let set = Style::LabelBold.size(TEXT);
        if !labels.put(picture, (end, 8.0), toward, &name, set) {
            nameless.push(number);
        }
    }
    nameless
}

/// What the ends of the curves are settings of.
pub(super) fn settings(
    picture: &mut Picture,
    labels: &mut Labels,
    part: &Part,
    language: Language,
    at: &dyn Fn(&Point) -> Option<Vec2>,
) {
    let set = Style::Body.size(SMALL).ink(Ink::Muted);
    for line in &part.lines {
        let last = line.points.last().filter(|_| line.points.len() > 1);
        let ends = [line.points.first(), last];
        for (point, toward) in ends.into_iter().flatten().zip([Vec2::Y, -Vec2::Y]) {
            if let Some(place) = at(point) {
                let setting = point.setting.text(language);
                labels.put(picture, (place, 8.0), toward, &setting, set);
            }
        }
    }
}

fn law(axes: Axes, line: &Line, language: Language) -> Option<String> {
    let fit = match axes {
        Axes::TimeOverSize => line.growth,
        Axes::ErrorOverTime | Axes::ErrorOverSize => line.convergence,
    };
    strings::law(&fit?, language)
}
