//! The surface in sight, its plane of incidence, and the media on both sides.

use super::super::names;
use super::arrows::V_LENGTH;
use super::plane::Tip;
use crate::language::{Language, Message};
use crate::replay::VectorPlane;
use crate::replay::rays::{CurrentSurface, RayState, State, Verdict};
use crate::replay::shading::{CurrentLight, CurrentPoint};
use crate::scene::Movable;
use glam::{DVec3, Vec2};

const AIR: Message = Message("vectors-air");

/// The surface that the current ray met, or, while it has met none yet, the surface that it leaves.
pub struct SurfaceInSight<'a> {
    pub state: &'a State,
    pub ray: &'a RayState,
    pub surface: CurrentSurface,
    /// Of the ray in [`State::rays`].
    index: usize,
    /// The plane of incidence.
    pub plane: VectorPlane,
}

impl<'a> SurfaceInSight<'a> {
    pub fn of(state: &'a State) -> Option<Self> {
        let mut index = state.current?;
        loop {
            let ray = state.rays.get(index)?;
            let Some(surface) = ray.surface else {
                index = ray.parent?;
                continue;
            };
            let u = ray.ray.direction;
            return Some(SurfaceInSight {
                state,
                ray,
                surface,
                index,
                plane: VectorPlane::new(surface.position, surface.geometric, u),
            });
        }
    }

    /// What can be moved: the lights so far, and the eye where the ray comes from it.
    pub fn tips(&self) -> Vec<Tip> {
        let eye = self.state.prepared.view.eye;
        // At the start of u, and at the tip of V.
        let lengths = [1.0, V_LENGTH].into_iter();
        let primary = lengths.filter(|_| self.ray.parent.is_none());
        let primary = primary.map(|length| Tip {
            held: Movable::Eye,
            distance: eye.distance(self.surface.position),
            direction: -self.ray.ray.direction,
            length,
        });
        let lights = self.lit().map_or(&[][..], |lit| &lit.lights);
        let lights = lights
            .iter()
            .filter(|light| light.distance.is_finite())
            .filter_map(|light| {
                let (direction, _) = light.to_light?;
                Some(Tip {
                    held: Movable::Light(light.light as usize),
                    distance: light.distance,
                    direction,
                    length: 1.0,
                })
            });
        lights.chain(primary).collect()
    }

    /// A vector in the plane of incidence, y down.
    pub fn project(&self, vector: DVec3) -> Vec2 {
        self.plane.project(vector)
    }

    /// How far a unit vector leans out of the plane of incidence, in degrees.
    pub fn lean(&self, vector: DVec3) -> f64 {
        vector
            .dot(self.plane.across())
            .clamp(-1.0, 1.0)
            .abs()
            .asin()
            .to_degrees()
    }

    /// How the surface was lit so far.
    pub fn lit(&self) -> Option<&CurrentPoint> {
        let current = self.state.current == Some(self.index);
        let current = self.state.point.as_ref().filter(|_| current);
        current.or(self.ray.lit.as_deref())
    }

    /// The current light, while the surface is being lit.
    pub fn current_light(&self) -> Option<&CurrentLight> {
        let lit = self.lit()?;
        lit.lights.last().filter(|_| lit.intensity.is_none())
    }

    pub fn verdict(&self, light: u32) -> Option<&Verdict> {
        self.ray
            .shadows
            .iter()
            .find(|verdict| verdict.light == light)
    }

    pub fn name(&self, language: Language) -> &str {
        names::object(&self.state.prepared, self.surface.object, language)
    }

    /// Whether light passes the surface at all.
    pub fn is_transparent(&self) -> bool {
        self.state.transmits(self.surface.object)
    }

    /// Whether the ray comes from outside, or to the front.
    pub fn comes_from_above(&self) -> bool {
        self.ray.ray.direction.dot(self.surface.geometric) < 0.0
    }

    /// What lies above and below the surface: names, and η where it is known.
    pub fn media(&self, language: Language) -> [String; 2] {
        let named = |object: Option<&u32>| match object {
            Some(&object) => names::object(&self.state.prepared, object, language).to_string(),
            None => AIR.text(language).to_string(),
        };
        let around = self.state.media_around(self.index);
        let object = self.surface.object;
        if !self.state.transmits(object) {
            return [named(around.last()), named(Some(&object))];
        }
        let mut outside = around.clone();
        if let Some(at) = outside.iter().rposition(|&inner| inner == object) {
            outside.remove(at);
        }
        let [above, below] = [named(outside.last()), named(Some(&object))];
        match &self.ray.refraction {
            Some(refraction) => {
                let (incoming, beyond) = (refraction.eta_i, refraction.eta_r);
                let (up, down) = if self.comes_from_above() {
                    (incoming, beyond)
                } else {
                    (beyond, incoming)
                };
                let [up, down] = [up, down].map(|eta| language.number(eta));
                [format!("{above}  η {up}"), format!("{below}  η {down}")]
            }
            None => [above, below],
        }
    }
}
