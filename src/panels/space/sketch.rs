//! What is drawn among the surfaces: lines and arrows, whose hidden parts are dotted, points and names.

use crate::figure::{Depths, Labels, Seen, Space};
use crate::panels::PanelInput;
use crate::picture::{Dash, Ink, Paint, Picture, Rect, Shape, Stroke, Style, Tag};
use glam::{DVec3, Vec2};
use std::sync::Arc;

/// What lies behind a surface by less than this share of the scene's size lies on it.
const TOLERANCE: f64 = 0.008;
/// How much of a hidden line is left.
const HIDDEN: f32 = 0.4;

pub(super) struct Sketch<'a> {
    pub picture: &'a mut Picture,
    pub input: &'a PanelInput<'a>,
    pub space: Space,
    pub depths: Arc<Depths>,
    pub labels: Labels,
    /// Size of the letters, in points.
    pub text: f32,
    /// How large what is shown is, in lengths of the world.
    pub extent: f64,
}

impl Sketch<'_> {
    fn tolerance(&self) -> f32 {
        (TOLERANCE * self.extent) as f32
    }

    /// The ends of the line as they are drawn, if any of it is.
    pub fn line(&mut self, from: DVec3, to: DVec3, stroke: Stroke) -> Option<[Vec2; 2]> {
        let ends = self.space.line(from, to)?;
        for ([from, to], in_sight) in self.depths.pieces(ends, self.tolerance()) {
            self.picture.line(from, to, as_seen(stroke, in_sight));
        }
        Some(ends.map(|end| end.at))
    }

    /// As [`Sketch::line`], with a head at its end where that lies in the picture.
    pub fn arrow(&mut self, tag: Tag, from: DVec3, to: DVec3, stroke: Stroke) -> Option<[Vec2; 2]> {
        let ends = self.space.line(from, to)?;
        let pieces = self.depths.pieces(ends, self.tolerance());
        let last = pieces.len() - 1;
        self.picture.tagged(tag, |picture| {
            for (i, &([from, to], in_sight)) in pieces.iter().enumerate() {
                let stroke = as_seen(stroke, in_sight);
                if i < last {
                    picture.line(from, to, stroke);
                } else {
                    picture.arrow(from, to, stroke);
                }
            }
        });
        let [from, to] = ends.map(|end| end.at);
        self.labels.avoid_arrow(from, to, stroke.width);
        Some([from, to])
    }

    /// A closed outline, each of whose sides is a line.
    pub fn outline(&mut self, corners: &[DVec3], stroke: Stroke) {
        let next = corners.iter().cycle().skip(1);
        for (&from, &to) in corners.iter().zip(next) {
            self.line(from, to, stroke);
        }
    }

    /// A disc, faint where it is hidden; returns where it is.
    pub fn disc(&mut self, at: DVec3, radius: f32, paint: Paint) -> Option<Vec2> {
        let seen = self.seen(at)?;
        let paint = match self.is_in_sight(seen) {
            true => paint,
            false => paint.opacity(HIDDEN),
        };
        self.picture.circle(seen.at, radius, paint);
        self.labels
            .reserve(Rect::between(seen.at, seen.at).grown(radius));
        Some(seen.at)
    }

    /// Letters on a ground of their own, so that they can be read over any surface.
    pub fn name(&mut self, at: Vec2, radius: f32, toward: Vec2, text: &str, ink: Ink) {
        let style = Style::LabelBold.size(self.text).ink(ink);
        let mut label = Picture::new(self.picture.width, self.picture.height);
        self.labels
            .put(&mut label, (at, radius), toward, text, style);
        for item in &label.items {
            if let Shape::Text { .. } = item.shape {
                let ground = item.shape.bounds().grown(1.0);
                self.picture
                    .rounded_rect(ground, 2.0, Ink::Surface.fill().opacity(0.7));
            }
        }
        self.picture.items.extend(label.items);
    }

    /// A point that lies in the picture.
    pub fn seen(&self, point: DVec3) -> Option<Seen> {
        let seen = self.space.seen(point)?;
        (seen.at.is_finite() && self.space.area.contains(seen.at)).then_some(seen)
    }

    pub fn is_in_sight(&self, seen: Seen) -> bool {
        !self.depths.hides(seen.at, seen.nearness + self.tolerance())
    }

    /// A length that leads out of the picture in any direction.
    pub fn beyond(&self) -> f64 {
        let area = self.space.area;
        4.0 * f64::from(area.width + area.height) / f64::from(self.space.scale())
            + 4.0 * self.extent
    }
}

fn as_seen(stroke: Stroke, in_sight: bool) -> Stroke {
    match in_sight {
        true => stroke,
        false => Stroke {
            dash: Dash::Dotted,
            ..stroke.opacity(HIDDEN)
        },
    }
}
