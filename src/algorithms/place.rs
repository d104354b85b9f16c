//! A place where a ray meets a surface, with the surfaces that touch it there, and how the next ray starts.

use super::surface::SurfaceInteraction;
use super::visible::{self, Blocker};
use crate::record::Recorder;
use crate::scene::Scene;
use crate::scene::primitives::{Between, Hit, Ray, leaving};
use glam::DVec3;

/// Where a ray meets a surface.
pub struct Place<'a> {
    pub hit: Hit,
    pub interaction: SurfaceInteraction<'a>,
    /// Where other surfaces touch this one.
    pub between: Option<Between<'a>>,
}

/// A ray, and the surfaces that it meets at once, where it starts between some that touch.
#[derive(Clone, Copy)]
pub struct Start<'a> {
    pub ray: Ray,
    pub between: Option<Between<'a>>,
}

impl<'a> Place<'a> {
    /// The ray that leaves in `direction` (unit), through the surface or back to where the last ray came from.
    pub fn leaving(&self, direction: DVec3, through: bool) -> Start<'a> {
        let between = self.between.and_then(|between| between.leaving(through));
        let ray = match between {
            Some(_) => Ray {
                origin: self.interaction.surface.position,
                direction,
            },
            None => self.past_all(direction),
        };
        Start { ray, between }
    }

    /// The ray that leaves in `direction`, past all surfaces here.
    pub fn past_all(&self, direction: DVec3) -> Ray {
        let surface = &self.interaction.surface;
        match self.between {
            Some(between) => leaving(&between.last(surface), direction),
            None => leaving(surface, direction),
        }
    }
}

impl Start<'_> {
    /// A surface at the place of the start that casts a shadow on the one that the ray leaves.
    pub fn blocker<E: From<visible::Event>>(
        &self,
        scene: &Scene,
        recorder: &mut impl Recorder<E>,
    ) -> Option<Blocker> {
        let casts_shadow = |hit: &Hit| scene.objects[hit.object as usize].casts_shadow;
        let hit = self.between?.ahead().find(casts_shadow)?;
        recorder.step(|| visible::Event::between(hit.object as usize, Some(hit), 0.0, true).into());
        Some(Blocker { hit: Some(hit) })
    }
}
