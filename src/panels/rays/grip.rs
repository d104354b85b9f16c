//! Moving a light by the pointer.

use super::view::View;
use super::views;
use crate::panels::PanelInput;
use crate::scene::Light;
use glam::{DVec3, Vec2};

/// How near the pointer must be to a light, in points.
const REACH: f32 = 14.0;

/// A light that the pointer holds: it moves in the plane of the view in which it was taken.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grip {
    /// Index of the light.
    pub light: usize,
    position: DVec3,
    view: View,
    /// From the pointer to the middle of the light.
    offset: Vec2,
}

/// The point light at `at` in the rays panel of that size.
pub fn grip(input: &PanelInput, size: Vec2, at: Vec2) -> Option<Grip> {
    let state = input.run.rays()?;
    let (view, _) = views(state, size)
        .into_iter()
        .find(|(view, _)| view.area.contains(at))?;
    let lights = state.prepared.scene.lights.iter().enumerate();
    let grips = lights.filter_map(|(light, source)| match *source {
        Light::Point { position, .. } => {
            let offset = view.place(position) - at;
            Some(Grip {
                light,
                position,
                view,
                offset,
            })
        }
        Light::Directional { .. } => None,
    });
    grips
        .filter(|grip| grip.offset.length() <= REACH)
        .min_by(|a, b| a.offset.length().total_cmp(&b.offset.length()))
}

impl Grip {
    /// Where the light is once the pointer is at `at`; it stays in the view, and as far from the viewer as it was.
    pub fn position(&self, at: Vec2) -> DVec3 {
        self.view.lift(at + self.offset, self.position)
    }
}
