//! The rays of the pixel among the objects of the scene, in parallel projection from the side and, where there is room, from
//! above: both along the same horizontal axis, the one in which the camera looks.
//!
//! The views do not change from step to step, nor from pixel to pixel.

mod draw;
mod grip;
mod lights;
mod outline;
mod paths;
mod view;

pub use grip::{Grip, grip};

use super::message::{NO_RAYS, NO_STEPS, message};
use super::names;
use super::values::step_as_sentence;
use super::{PanelInput, Properties};
use crate::algorithms::visible::Intersection;
use crate::language::{Language, Message};
use crate::picture::{Picture, Rect};
use crate::replay::rays::State;
use glam::Vec2;
use view::View;

const SIDE: Message = Message("rays-side");
const ABOVE: Message = Message("rays-above");
const RAYS: Message = Message("rays-rays");
const NO_PIXEL: Message = Message("rays-no-pixel");

pub const PANEL: Properties = Properties::titled(Message("app-rays"));

pub fn draw(input: &PanelInput, size: Vec2) -> Picture {
    if input.run.walk().is_empty() {
        return message(NO_STEPS, input.language, size);
    }
    let Some(state) = input.run.rays() else {
        return message(NO_RAYS, input.language, size);
    };
    let mut picture = Picture::new(size.x, size.y);
    for (view, title) in views(state, size) {
        draw::draw(
            &mut picture,
            input,
            state,
            &view,
            title.text(input.language),
        );
    }
    picture.alt = format!(
        "{} {}",
        step_as_sentence(input),
        in_words(state, input.language)
    );
    picture
}

/// Side view and view from above beside or below each other; the side view alone where there is no room for both.
fn views(state: &State, size: Vec2) -> Vec<(View, Message)> {
    let whole = Rect::new(0.0, 0.0, size.x, size.y).grown(-4.0);
    let halves = if size.x >= 480.0 && size.x > 1.3 * size.y {
        let width = 0.5 * whole.width - 4.0;
        let left = Rect { width, ..whole };
        Some([left, left.shifted(Vec2::new(width + 8.0, 0.0))])
    } else if size.y >= 400.0 {
        let height = 0.5 * whole.height - 4.0;
        let upper = Rect { height, ..whole };
        Some([upper, upper.shifted(Vec2::new(0.0, height + 8.0))])
    } else {
        None
    };
    match halves {
        Some([side, above]) => vec![
            (View::from_side(&state.prepared, side), SIDE),
            (View::from_above(&state.prepared, above), ABOVE),
        ],
        None => vec![(View::from_side(&state.prepared, whole), SIDE)],
    }
}

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

#[cfg(test)]
mod tests;
