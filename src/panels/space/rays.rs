//! The rays of the pixel among the objects, as arrows with their letters; shadow rays, and where rays meet surfaces.

use super::super::names;
use super::sketch::Sketch;
use crate::algorithms::ray_tree::RayKind;
use crate::algorithms::visible::Intersection;
use crate::figure::cross;
use crate::picture::{Ink, Stroke, Tag};
use crate::replay::rays::{RayState, State};
use glam::{DVec3, Vec2};

/// Beyond so many rays, those from which the current ray does not come are drawn faintly and without letters.
const MOST_RAYS: usize = 24;
const FAINT: f32 = 0.25;
/// Rays shorter than this have no letter, in points.
const SHORT: f32 = 22.0;

impl Sketch<'_> {
    pub fn rays(&mut self, state: &State) {
        self.shadow_rays(state);
        let way: Vec<usize> = state.way().collect();
        let is_near = |index: usize| state.rays.len() <= MOST_RAYS || way.contains(&index);
        let mut middles: Vec<(Vec2, &str)> = Vec::new();
        let choice = self.input.space.rays;
        let is_shown = |ray: &RayState| choice.shows(ray.kind, ray.level);
        for (index, ray) in state.rays.iter().enumerate() {
            if !is_shown(ray) {
                continue;
            }
            let is_current = state.current == Some(index);
            let stroke = match (is_current, is_near(index)) {
                (true, _) => stroke(ray, Ink::This, 3.0),
                (false, true) => stroke(ray, color(ray.kind), 2.0),
                (false, false) => stroke(ray, color(ray.kind), 1.0).opacity(FAINT),
            };
            let end = self.end(ray);
            let drawn = self.arrow(Tag::Scope(ray.step), ray.ray.origin, end, stroke);
            let Some([from, to]) = drawn.filter(|_| is_near(index)) else {
                continue;
            };
            let (_, letters) = names::ray_kind(ray.kind.name(), self.input.language);
            let middle = from.lerp(to, 0.5);
            // Rays side by side, as between two mirrors, share their letter.
            let is_shared = middles.iter().any(|&(other, known)| {
                known == letters && other.distance(middle) < 3.0 * self.text
            });
            if is_current || !is_shared && from.distance(to) > SHORT {
                let aside = (to - from).perp();
                let aside = if aside.y > 0.0 { -aside } else { aside };
                let ink = if is_current { Ink::This } else { Ink::Text };
                self.name(middle, 2.0, aside, letters, ink);
                middles.push((middle, letters));
            }
        }
        for (index, ray) in state.rays.iter().enumerate() {
            if let Some(surface) = ray.surface.filter(|_| is_near(index) && is_shown(ray)) {
                let edge = Ink::Text.stroke(1.25);
                self.disc(surface.position, 2.5, Ink::Surface.fill().outlined(edge));
            }
        }
        self.tested(state);
    }

    /// Where the ray ends, or a place far beyond what is shown.
    fn end(&self, ray: &RayState) -> DVec3 {
        let length = match ray.met {
            Some(Intersection::Object(hit)) => hit.t,
            Some(Intersection::Light { t, .. }) => t,
            Some(Intersection::Nothing) | None => self.beyond(),
        };
        ray.ray.at(length)
    }

    /// What the search has found so far: the object tested last, and the nearest.
    fn tested(&mut self, state: &State) {
        let (Some(search), Some(ray)) = (state.search, state.ray()) else {
            return;
        };
        for (tested, ink) in [(search.tested, Ink::Surface), (search.nearest, Ink::This)] {
            if let Some(tested) = tested.filter(|tested| tested.t.is_finite()) {
                let paint = ink.fill().outlined(Ink::This.stroke(2.0));
                self.disc(ray.ray.at(tested.t), 4.5, paint);
            }
        }
    }

    /// From the current surface to the lights: clear, or crossed out where something blocks.
    fn shadow_rays(&mut self, state: &State) {
        let Some(ray) = state.ray() else { return };
        let Some(surface) = ray.surface else { return };
        let start = surface.position;
        let beyond = self.beyond();
        for verdict in &ray.shadows {
            let end = start + verdict.distance.min(beyond) * verdict.direction;
            let ink = if verdict.blocked {
                Ink::Muted
            } else {
                Ink::Good
            };
            let stroke = ink.stroke(1.5).dashed();
            self.arrow(Tag::Step(verdict.step), start, end, stroke);
            if let Some(hit) = verdict.by {
                self.cross(start + hit.t * verdict.direction);
            }
        }
        if let Some(shadow) = &state.shadow {
            let end = start + shadow.distance.min(beyond) * shadow.direction;
            let stroke = Ink::This.stroke(2.0).dashed();
            self.arrow(Tag::Scope(shadow.step), start, end, stroke);
            if let Some((_, t, true)) = shadow.tested {
                self.cross(start + t * shadow.direction);
            }
        }
    }

    fn cross(&mut self, at: DVec3) {
        if let Some(seen) = self.seen(at) {
            cross(self.picture, seen.at, 5.0, 2.5);
        }
    }
}

/// Total internal reflection is dashed, a ray that is still looking for what it meets dotted.
fn stroke(ray: &RayState, ink: Ink, width: f32) -> Stroke {
    let stroke = ink.stroke(width);
    match (ray.met, ray.kind) {
        (None, _) => stroke.dotted(),
        (_, RayKind::TotalInternalReflection) => stroke.dashed(),
        _ => stroke,
    }
}

pub(super) fn color(kind: RayKind) -> Ink {
    match kind {
        RayKind::Primary => Ink::Text,
        RayKind::Reflected => Ink::Series(0),
        RayKind::Transmitted => Ink::Series(2),
        RayKind::TotalInternalReflection => Ink::Series(3),
    }
}
