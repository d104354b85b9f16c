//! Moving a light by the pointer.

use super::space;
use crate::figure::Space;
use crate::panels::PanelInput;
use crate::scene::Light;
use glam::{DVec3, Vec2};

/// How near the pointer must be to a light, in points.
const REACH: f32 = 14.0;

/// A light that the pointer holds: it moves across the line of sight, as the view was when it was taken.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grip {
    /// Index of the light.
    pub light: usize,
    position: DVec3,
    space: Space,
    /// From the pointer to the middle of the light.
    offset: Vec2,
}

/// The point light at `at` in the panel of that size.
pub fn grip(input: &PanelInput, size: Vec2, at: Vec2) -> Option<Grip> {
    if input.run.enclosure().is_some() {
        return None;
    }
    let (space, _) = space(input, size);
    let lights = input.run.prepared().scene.lights.iter().enumerate();
    let grips = lights.filter_map(|(light, source)| match *source {
        Light::Point { position, .. } => Some(Grip {
            light,
            position,
            space,
            offset: space.place(position)? - at,
        }),
        Light::Directional { .. } => None,
    });
    grips
        .filter(|grip| grip.offset.length() <= REACH)
        .min_by(|a, b| a.offset.length().total_cmp(&b.offset.length()))
}

impl Grip {
    /// Where the light is once the pointer is at `at`; it stays in the view, and as far from the viewer as it was.
    pub fn position(&self, at: Vec2) -> DVec3 {
        self.space.lift(at + self.offset, self.position)
    }
}
