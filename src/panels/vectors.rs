//! The vectors where a ray meets a surface, in the plane of incidence: the plane of the incoming ray u and the normal; of methods
//! that convert polygons, those at the point that is lit.
//!
//! Outside (or the front) is up, inside (or the back) is down, and u goes from left to right. What leans out of the plane, as
//! directions to lights do, is drawn as its shadow in it: shortened.

mod angles;
mod arrows;
mod asked;
pub(super) mod met;
mod plane;
pub(super) mod point;

pub use plane::PlaneGrip;

use super::message::{NO_STEPS, centered, message};
use super::names;
use super::values::step_as_sentence;
use super::{PanelInput, Properties};
use crate::algorithms::visible::Intersection;
use crate::language::{Language, Message};
use crate::picture::{Picture, Rect};
use crate::replay::rays::State;
use crate::scene::Scene;
use angles::Angles;
use glam::Vec2;
use met::SurfaceInSight;
use plane::{Plane, Tip};

const NOT_YET: Message = Message("vectors-not-yet");
const NORMAL_NEXT: Message = Message("vectors-normal-next");
const NO_POINT: Message = Message("vectors-no-point");
const NO_SURFACE: Message = Message("vectors-no-surface");

pub const PANEL: Properties = Properties::titled(Message("app-vectors"));

pub fn draw(input: &PanelInput, size: Vec2) -> Picture {
    if input.run.walk().is_empty() {
        return message(NO_STEPS, input.language, size);
    }
    let Some(state) = input.run.rays() else {
        return at_point(input, size);
    };
    let Some(surface) = SurfaceInSight::of(state) else {
        return centered(&no_surface(state, input.language), size);
    };
    let walk = input.run.walk();
    let kind = walk.kind(walk.position());
    let text = (1.4 * small(size)).min(24.0).round();
    let angles = Angles::of(&surface, input.language);

    let mut picture = Picture::new(size.x, size.y);
    let layout = Layout::of(size, &state.prepared.scene, text);
    let drawing = layout.drawing;
    arrows::draw(&mut picture, &surface, input, text, drawing);
    angles.draw(
        &mut picture,
        kind,
        small(size),
        layout.table,
        layout.columns,
    );
    picture.alt = format!("{} {}", step_as_sentence(input), angles.in_words());
    picture
}

/// The vectors at a point of a polygon.
fn at_point(input: &PanelInput, size: Vec2) -> Picture {
    let (Some(prepared), Some(point)) = input.run.lit() else {
        return message(NO_POINT, input.language, size);
    };
    let mut picture = Picture::new(size.x, size.y);
    let angles = point::draw(&mut picture, point, prepared.view.eye, input, size);
    picture.alt = format!("{} {angles}.", step_as_sentence(input));
    picture
}

/// The vector toward a light or the eye whose tip is at `at` in the panel of that size.
pub fn grip(input: &PanelInput, size: Vec2, at: Vec2) -> Option<PlaneGrip> {
    let (plane, tips) = plane_and_tips(input, size)?;
    plane.grip(&tips, at)
}

/// By how many degrees an arrow that points to `at` is turned clockwise from the normal, in the panel of that size.
pub fn degrees_toward(input: &PanelInput, size: Vec2, at: Vec2) -> Option<f64> {
    let (plane, _) = plane_and_tips(input, size)?;
    Some(plane.degrees_toward(at))
}

/// The plane as it is drawn in the panel of that size, and the vectors in it that can be moved.
fn plane_and_tips(input: &PanelInput, size: Vec2) -> Option<(Plane, Vec<Tip>)> {
    let Some(state) = input.run.rays() else {
        let (Some(prepared), Some(point)) = input.run.lit() else {
            return None;
        };
        let eye = prepared.view.eye;
        return Some((point::plane(point, eye, size), point::tips(point, eye)));
    };
    let surface = SurfaceInSight::of(state)?;
    let text = (1.4 * small(size)).min(24.0).round();
    let drawing = Layout::of(size, &state.prepared.scene, text).drawing;
    Some((arrows::plane(&surface, text, drawing), surface.tips()))
}

/// Why the current ray has no surface in sight.
fn no_surface(state: &State, language: Language) -> String {
    match state.ray().and_then(|ray| ray.met) {
        None => NOT_YET.text(language).to_owned(),
        Some(Intersection::Object(hit)) => {
            let object = names::object(&state.prepared, hit.object, language);
            let t = language.number(hit.t);
            NORMAL_NEXT.format(language, &[("object", object), ("t", &t)])
        }
        Some(_) => NO_SURFACE.text(language).to_owned(),
    }
}

/// Size of the text of the list.
fn small(size: Vec2) -> f32 {
    (0.033 * size.x.min(1.4 * size.y)).clamp(11.0, 16.0).round()
}

/// Length of the arrows below which the table gives way to them.
const SHORTEST: f32 = 24.0;

/// Where the vectors are drawn, and where the angles stand.
struct Layout {
    drawing: Rect,
    table: Rect,
    /// Of the table: all rows below each other, or those of the lights beside those of the ray.
    columns: usize,
}

impl Layout {
    /// Of the places for the table, the one that leaves the longest arrows. It depends on no step, so that nothing jumps.
    fn of(size: Vec2, scene: &Scene, text: f32) -> Self {
        let whole = Rect::new(0.0, 0.0, size.x, size.y).grown(-6.0);
        let small = small(size);
        let below = |columns| Layout::below(whole, columns, angles::height(scene, small, columns));
        let mut layouts = vec![Layout::beside(whole, small), below(1)];
        if whole.width >= 2.0 * angles::COLUMN * small {
            layouts.push(below(2));
        }
        // Where there are transparent surfaces, these need the most room.
        let clear = angles::transmits(scene);
        let unit = |layout: &Layout| arrows::unit(layout.drawing, text, clear);
        let longest = layouts
            .into_iter()
            .max_by(|a, b| unit(a).total_cmp(&unit(b)));
        let drawing_alone = Layout::below(whole, 1, 0.0);
        longest
            .filter(|layout| unit(layout) >= SHORTEST)
            .unwrap_or(drawing_alone)
    }

    fn beside(whole: Rect, text: f32) -> Self {
        let width = (20.0 * text).min(0.5 * whole.width);
        Layout {
            drawing: Rect {
                width: whole.width - width - 8.0,
                ..whole
            },
            table: Rect::new(whole.right() - width, whole.y, width, whole.height),
            columns: 1,
        }
    }

    fn below(whole: Rect, columns: usize, height: f32) -> Self {
        let height = height.min(0.45 * whole.height);
        Layout {
            drawing: Rect {
                height: whole.height - height - 6.0,
                ..whole
            },
            table: Rect::new(whole.x, whole.bottom() - height, whole.width, height),
            columns,
        }
    }
}

#[cfg(test)]
mod tests;
