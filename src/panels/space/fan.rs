//! The rays of many pixels at once, thin, with a legend of their kinds.

use super::super::names;
use super::rays::color;
use super::sketch::Sketch;
use crate::algorithms::ray_tree::RayKind;
use crate::figure::{LEGEND_ROW, legend};
use crate::picture::{Ink, Picture, Rect, Stroke, Tag};

const WIDTH: f32 = 1.0;

impl Sketch<'_> {
    pub fn fan(&mut self) {
        if self.input.is_pending() || self.input.fan.is_empty() {
            return;
        }
        let choice = self.input.space.rays;
        let beyond = self.beyond();
        for ray in self.input.fan {
            if !choice.shows(ray.kind, ray.level) {
                continue;
            }
            let end = ray.origin + ray.length.min(beyond) * ray.direction;
            let (x, y) = ray.pixel;
            let start = self.picture.items.len();
            self.line(ray.origin, end, stroke(ray.kind));
            for item in &mut self.picture.items[start..] {
                item.tag = Some(Tag::Pixel { x, y });
            }
        }
        self.legend();
    }

    fn legend(&mut self) {
        let shown = |kind: &RayKind| self.input.space.rays.shows_kind(*kind);
        let kinds = RayKind::ALL.into_iter().filter(shown);
        let entries: Vec<(Stroke, String)> = kinds
            .map(|kind| {
                let (word, letters) = names::ray_kind(kind.name(), self.input.language);
                (stroke(kind), format!("{letters} {word}"))
            })
            .collect();
        let area = self.space.area;
        let row = Rect::new(area.x + 6.0, area.y + 4.0, area.width - 12.0, LEGEND_ROW);
        let entries = entries.iter().map(|(stroke, name)| (*stroke, &**name));
        let mut rows = Picture::new(self.picture.width, self.picture.height);
        let end = legend(&mut rows, entries, row, row.x);
        let ground = Rect {
            height: end - row.y,
            ..row
        };
        self.picture
            .rounded_rect(ground, 2.0, Ink::Surface.fill().opacity(0.85));
        self.picture.items.extend(rows.items);
        self.labels.reserve(ground);
    }
}

/// Kinds are told apart by their dashes too.
fn stroke(kind: RayKind) -> Stroke {
    let stroke = color(kind).stroke(WIDTH);
    match kind {
        RayKind::Primary => stroke.opacity(0.6),
        RayKind::Reflected => stroke.dashed(),
        RayKind::Transmitted => stroke,
        RayKind::TotalInternalReflection => stroke.dotted(),
    }
}
