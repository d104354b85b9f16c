//! The rays of the pixel in a view, with their letters.

use super::super::names;
use super::draw::Layout;
use crate::algorithms::ray_tree::RayKind;
use crate::algorithms::visible::Intersection;
use crate::picture::{Ink, Stroke, Style, Tag};
use crate::replay::rays::RayState;
use glam::Vec2;

/// Opacity of rays that are many and matter less.
const FAINT: f32 = 0.2;

/// A ray as it was drawn.
struct Drawn {
    from: Vec2,
    to: Vec2,
    letters: &'static str,
}

impl Drawn {
    fn middle(&self) -> Vec2 {
        self.from.lerp(self.to, 0.5)
    }
}

fn color(kind: RayKind) -> Ink {
    match kind {
        RayKind::Primary => Ink::Text,
        RayKind::Reflected => Ink::Series(0),
        RayKind::Transmitted => Ink::Series(2),
        RayKind::TotalInternalReflection => Ink::Series(3),
    }
}

impl Layout<'_> {
    pub fn rays(&mut self) {
        let current = self.state.current;
        let mut drawn = Vec::new();
        for (index, ray) in self.state.rays.iter().enumerate() {
            if !self.is_near(index) {
                self.faint(ray);
            }
        }
        for (index, ray) in self.state.rays.iter().enumerate() {
            if current != Some(index) && self.is_near(index) {
                drawn.extend(self.ray(ray, false));
            }
        }
        let current = self.state.ray().and_then(|ray| self.ray(ray, true));
        self.letters(current, &drawn);
        for (index, ray) in self.state.rays.iter().enumerate() {
            if !self.is_near(index) {
                continue;
            }
            let Some(surface) = ray.surface else { continue };
            let at = self.view.place(surface.position);
            if self.view.shows(at, 4.0) {
                let edge = Ink::Text.stroke(1.25);
                self.picture
                    .circle(at, 2.5, Ink::Surface.fill().outlined(edge));
            }
        }
    }

    /// Whether a ray is drawn in full: all rays while there are few, later those from which the current ray comes.
    fn is_near(&self, index: usize) -> bool {
        self.way.as_ref().is_none_or(|way| way.contains(&index))
    }

    /// Of many rays those that matter less.
    fn faint(&mut self, ray: &RayState) {
        let far = self.view.beyond(ray.ray.direction);
        let length = match ray.met {
            Some(Intersection::Object(hit)) => hit.t,
            Some(Intersection::Light { t, .. }) => t,
            Some(Intersection::Nothing) | None => far,
        };
        if let Some([from, to]) = self.view.line(ray.ray.origin, ray.ray.at(length)) {
            let stroke = color(ray.kind).stroke(1.0).opacity(FAINT);
            self.picture.tagged(Tag::Scope(ray.step), |picture| {
                picture.line(from, to, stroke);
            });
        }
    }

    fn ray(&mut self, ray: &RayState, current: bool) -> Option<Drawn> {
        let stroke = color(ray.kind).stroke(2.0);
        let stroke = match ray.kind {
            RayKind::TotalInternalReflection => stroke.dashed(),
            _ => stroke,
        };
        let stroke = match (current, ray.returned) {
            (true, _) => Stroke {
                ink: Ink::This,
                width: 3.0,
                ..stroke
            },
            (false, Some(_)) => stroke.opacity(0.65),
            (false, None) => stroke,
        };
        let far = self.view.beyond(ray.ray.direction);
        let (end, ends) = match ray.met {
            Some(Intersection::Object(hit)) => (ray.ray.at(hit.t), true),
            Some(Intersection::Light { t, .. }) => (ray.ray.at(t), true),
            Some(Intersection::Nothing) | None => (ray.ray.at(far), false),
        };
        let [from, to] = self.view.line(ray.ray.origin, end)?;
        // A ray that is still looking for what it meets.
        let stroke = if ends || ray.met.is_some() {
            stroke
        } else {
            stroke.dotted()
        };
        self.picture.tagged(Tag::Scope(ray.step), |picture| {
            picture.arrow(from, to, stroke);
        });
        self.labels.avoid_stroke(from, to, stroke.width);
        let (_, letters) = names::ray_kind(ray.kind.name(), self.input.language);
        Some(Drawn { from, to, letters })
    }

    /// The letters of the rays, that of the current ray first. Rays side by side, as between two mirrors, share theirs.
    fn letters(&mut self, current: Option<Drawn>, others: &[Drawn]) {
        let mut lettered: Vec<&Drawn> = Vec::new();
        for ray in current.iter().chain(others) {
            let is_current = lettered.is_empty() && current.is_some();
            let shared = |other: &&Drawn| {
                other.letters == ray.letters
                    && other.middle().distance(ray.middle()) < 3.0 * self.text
            };
            let too_short = ray.from.distance(ray.to) <= 22.0;
            if !is_current && (too_short || lettered.iter().any(shared)) {
                continue;
            }
            let ink = if is_current { Ink::This } else { Ink::Text };
            let style = Style::LabelBold.size(self.text).ink(ink);
            let aside = (ray.to - ray.from).perp();
            let aside = if aside.y > 0.0 { -aside } else { aside };
            let at = (ray.middle(), 2.0);
            self.labels.put(self.picture, at, aside, ray.letters, style);
            lettered.push(ray);
        }
    }
}
