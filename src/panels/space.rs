//! The scene in space, from wherever the viewer likes: surfaces with hidden parts hidden, eye, image plane and lights; the rays
//! of the pixel, the vectors at a point, the current polygon, or the exchange between two patches.

mod ball;
mod camera;
mod choice;
mod edges;
mod exchange;
mod extent;
mod fan;
mod lights;
mod orbit;
mod rays;
mod sketch;
mod surfaces;
mod vectors;

pub use choice::{Pixels, RayChoice, SpaceView};
pub use orbit::{Orbit, Preset};

use super::message::{NO_STEPS, message};
use super::names;
use super::values::step_as_sentence;
use super::vectors::met::SurfaceInSight;
use super::{PanelInput, Properties};
use crate::algorithms::enclosure::Enclosure;
use crate::algorithms::visible::Intersection;
use crate::figure::{Depths, Labels, Solids, Space};
use crate::language::{Language, Message};
use crate::picture::{Ink, Picture, Rect};
use crate::replay::rays::State;
use crate::scene::Shape;
use glam::{DVec3, Vec2};
use orbit::Frame;
use sketch::Sketch;
use std::sync::Arc;

const RAYS: Message = Message("space-rays");
const NO_PIXEL: Message = Message("space-no-pixel");

pub const PANEL: Properties = Properties::titled(Message("app-space"));

/// How far around the camera's target objects are shown, in distances from eye to target.
const REACH: f64 = 1.2;
/// How far planes are drawn, in sizes of the scene.
const PLANE: f64 = 0.55;
/// Of more objects, none is named.
const MOST_NAMES: usize = 12;
/// Around what is shown, in points.
const MARGIN: f32 = 16.0;

pub fn draw(input: &PanelInput, size: Vec2) -> Picture {
    if input.run.walk().is_empty() {
        return message(NO_STEPS, input.language, size);
    }
    let room = input.run.enclosure();
    let around = surroundings(input, size);
    let mut picture = around.picture;
    picture.clipped(around.of.space.area, |picture| {
        let mut sketch = Sketch {
            labels: around.labels,
            picture,
            input,
            space: around.of.space,
            depths: around.depths,
            text: text_size(size),
            extent: around.of.extent,
        };
        match room {
            Some(room) => sketch.patches(room),
            None => sketch.scene(&around.lowest),
        }
    });
    picture.alt = step_as_sentence(input);
    if let Some(state) = input.run.rays() {
        picture.alt += " ";
        picture.alt += &in_words(state, input.language);
    }
    picture
}

/// Surfaces and edges.
#[derive(Clone)]
pub struct Surroundings {
    of: SurroundingsOf,
    picture: Picture,
    depths: Arc<Depths>,
    /// They have room beside what is drawn.
    labels: Labels,
    /// Where each object is seen lowest, if it is.
    lowest: Vec<Option<Vec2>>,
}

/// What surroundings of one scene depend on.
#[derive(Clone, Copy, PartialEq)]
pub struct SurroundingsOf {
    space: Space,
    extent: f64,
    size: Vec2,
}

fn surroundings(input: &PanelInput, size: Vec2) -> Surroundings {
    let (space, extent) = space(input, size);
    let of = SurroundingsOf {
        space,
        extent,
        size,
    };
    let room = input.run.enclosure();
    // Patches change their colours from step to step.
    let reused = input.reused.filter(|_| room.is_none());
    let Some(reused) = reused else {
        return drawn_anew(input, of, room);
    };
    let mut latest = reused.surroundings.borrow_mut();
    let known = latest.take().filter(|known| known.of == of);
    latest
        .insert(known.unwrap_or_else(|| drawn_anew(input, of, room)))
        .clone()
}

fn drawn_anew(input: &PanelInput, of: SurroundingsOf, room: Option<&Enclosure>) -> Surroundings {
    let SurroundingsOf {
        space,
        extent,
        size,
    } = of;
    let area = space.area;
    let mut picture = Picture::new(size.x, size.y);
    picture.rect(area, Ink::Faint);
    let mut solids = Solids::new(area);
    match room {
        Some(room) => {
            let colors = exchange::colors(input, &space, room);
            surfaces::patches(&mut solids, &space, room, &colors);
        }
        None => {
            let (prepared, round) = (input.run.prepared(), are_balls_round(input));
            surfaces::objects(&mut solids, &space, prepared, PLANE * extent, round);
        }
    }
    let (image, depths) = solids.finish();
    picture.image(area, image);
    let depths = Arc::new(depths);
    let mut labels = Labels::new(area.grown(-3.0));
    let mut lowest = Vec::new();
    picture.clipped(area, |picture| {
        let mut sketch = Sketch {
            labels: labels.clone(),
            picture,
            input,
            space,
            depths: depths.clone(),
            text: text_size(size),
            extent,
        };
        sketch.edges();
        lowest = sketch.lowest();
        labels = sketch.labels;
    });
    Surroundings {
        of,
        picture,
        depths,
        labels,
        lowest,
    }
}

/// Of letters, in points.
fn text_size(size: Vec2) -> f32 {
    (0.03 * size.x.min(1.3 * size.y)).clamp(11.0, 16.0).round()
}

/// A ray meets a sphere itself; scan lines meet the polygons that stand in for it.
fn are_balls_round(input: &PanelInput) -> bool {
    input.run.rays().is_some()
}

/// Corners around all that is to be seen, lights aside.
fn shown(input: &PanelInput) -> Vec<DVec3> {
    match input.run.enclosure() {
        Some(room) => {
            let patches = 0..room.patches.len();
            let pieces = patches.flat_map(|patch| room.patches.pieces(patch));
            pieces.flat_map(|piece| piece.corners).copied().collect()
        }
        None => extent::objects(input.run.prepared(), REACH),
    }
}

/// The diagonal of the box around points.
fn extent_of(points: &[DVec3]) -> f64 {
    let [low, high] = extent::bounds(points.iter().copied());
    (high - low)
        .max(DVec3::ZERO)
        .length()
        .max(f64::MIN_POSITIVE)
}

/// The view that the orbit asks for, and how large what it shows is; where there is no ray to stand by, the overview.
fn space(input: &PanelInput, size: Vec2) -> (Space, f64) {
    let area = Rect::new(0.0, 0.0, size.x, size.y).grown(-2.0);
    let prepared = input.run.prepared();
    let orbit = input.space.orbit;
    let state = input.run.rays();
    let frame = match (orbit.from, state) {
        (Preset::Incidence, Some(state)) => SurfaceInSight::of(state).map(|surface| Frame {
            pivot: Some(surface.plane.point),
            ..Frame::parallel(surface.plane.along, surface.plane.normal)
        }),
        (Preset::Ray, Some(state)) => state.ray().map(|ray| {
            let (_, vertical) = orbit::axes(prepared);
            Frame::toward(-ray.ray.direction, vertical)
        }),
        _ => None,
    };
    let frame = frame.unwrap_or_else(|| Frame::of(orbit.from, prepared));
    let shown = shown(input);
    let lights = match input.run.enclosure() {
        Some(_) => Vec::new(),
        None => extent::lights(prepared),
    };
    let space = frame.looked_at(&orbit, prepared, [&shown, &lights], area.grown(-MARGIN));
    (Space { area, ..space }, extent_of(&shown))
}

/// How the panel of that size shows the world.
pub fn sight(input: &PanelInput, size: Vec2) -> Space {
    space(input, size).0
}

/// What is shown, in words.
fn in_words(state: &State, language: Language) -> String {
    let Some(ray) = state.ray() else {
        return NO_PIXEL.text(language).to_string();
    };
    let (kind, _) = names::ray_kind(ray.kind.name(), language);
    let goal = match ray.met {
        None => String::new(),
        Some(Intersection::Nothing) => " → ∞".to_string(),
        Some(Intersection::Light { light, t }) => {
            format!(
                " → {}, t {}",
                names::light(light, language),
                language.short(t, 3)
            )
        }
        Some(Intersection::Object(hit)) => format!(
            " → {}, t {}",
            names::object(&state.prepared, hit.object, language),
            language.short(hit.t, 3)
        ),
    };
    let (count, level) = (state.rays.len().to_string(), ray.level.to_string());
    let arguments = [
        ("count", &*count),
        ("kind", &kind),
        ("level", &level),
        ("goal", &goal),
    ];
    RAYS.format(language, &arguments)
}

impl Sketch<'_> {
    fn patches(&mut self, room: &Enclosure) {
        exchange::targets(self.picture, &self.space, room);
        if let Some(pair) = self.input.pair {
            self.pair(room, pair);
        }
        self.exchange(room);
    }

    fn scene(&mut self, lowest: &[Option<Vec2>]) {
        self.camera();
        if let Some(state) = vectors::shading(self.input.run) {
            self.polygon(state);
        }
        if let Some(state) = self.input.run.rays() {
            self.fan();
            self.rays(state);
        }
        self.vectors();
        self.asked();
        self.lights();
        // If only some names fit, they could give the answer away.
        if lowest.len() <= MOST_NAMES && !self.input.is_pending() {
            self.names(lowest);
        }
    }

    /// The edges of objects.
    fn edges(&mut self) {
        let prepared = self.input.run.prepared().clone();
        for (number, object) in prepared.scene.objects.iter().enumerate() {
            let (reach, round) = (PLANE * self.extent, are_balls_round(self.input));
            let edges = edges::edges(&self.space, &prepared, number, reach, round);
            let edges = edges.into_iter();
            let drawn = edges.filter_map(|[from, to]| self.line(from, to, Ink::Muted.stroke(1.0)));
            let drawn: Vec<[Vec2; 2]> = drawn.collect();
            match object.shape {
                Shape::Sphere { center, radius } => {
                    if let Some(seen) = self.space.seen(center) {
                        let radius = radius as f32 * self.space.scale() * seen.scale;
                        self.labels.avoid_disc(seen.at, radius);
                    }
                }
                _ => self.labels.avoid_outline(drawn),
            }
        }
    }

    /// Where each object is seen lowest, if it is.
    fn lowest(&self) -> Vec<Option<Vec2>> {
        let meshes = self.input.run.prepared().tessellation.meshes.iter();
        let lowest = meshes.map(|mesh| {
            let places = (0..mesh.vertex_count() as u32).map(|vertex| mesh.position(vertex));
            let seen = places.filter_map(|place| self.seen(place));
            let seen = seen.filter(|&seen| self.is_in_sight(seen));
            let lowest = seen.max_by(|a, b| a.at.y.total_cmp(&b.at.y));
            lowest.map(|seen| seen.at)
        });
        lowest.collect()
    }

    /// The names of objects under what is seen of them: last, since rays and lights matter more.
    fn names(&mut self, lowest: &[Option<Vec2>]) {
        let prepared = self.input.run.prepared().clone();
        for (object, at) in lowest.iter().enumerate() {
            if let &Some(at) = at {
                let name = names::object(&prepared, object as u32, self.input.language);
                self.name(at, 0.0, Vec2::Y, name, Ink::Muted);
            }
        }
    }
}

#[cfg(test)]
mod tests;
