//! How much of the light of a pixel came from each level of its tree: the recorded sum, split by where its terms arose.

use super::{Outcome, RayState, State};
use crate::color::Rgb;

impl State {
    /// The light that the primary ray has gathered so far, or brought back; black before there is any.
    pub fn light_so_far(&self) -> Rgb {
        let primary = self.rays.get(0);
        let light = primary.and_then(|ray| ray.returned.map(|(light, _)| light).or(ray.sum));
        light.unwrap_or(Rgb::BLACK)
    }

    /// The light that has come up to the primary ray so far, by the level of the rays that met it: the first is level 1. What a
    /// ray met arrives times the coefficients on its way, and divided by the attenuations there. None of a level from which
    /// nothing has come up yet.
    pub fn light_by_level(&self) -> Vec<Option<Rgb>> {
        let mut levels: Vec<Option<Rgb>> = Vec::new();
        // What one unit of a ray's light adds to the pixel; none where it has not come all the way up. Rays stand behind their
        // parents.
        let mut factors: Vec<Option<Rgb>> = Vec::with_capacity(self.rays.len());
        for (index, ray) in self.rays.iter().enumerate() {
            let factor = match ray.parent {
                None => Some(Rgb::WHITE),
                Some(parent) => self
                    .factor_of_edge(parent, index)
                    .zip(factors[parent])
                    .map(|(edge, above)| above * edge),
            };
            factors.push(factor);
            let level = usize::from(ray.level).max(1);
            levels.resize(levels.len().max(level), None);
            if let (Some(factor), Some(light)) = (factor, ray.own_light()) {
                *levels[level - 1].get_or_insert(Rgb::BLACK) += factor * light;
            }
        }
        levels
    }

    /// By what light is multiplied between a ray and its parent; none before it is added there.
    fn factor_of_edge(&self, parent: usize, child: usize) -> Option<Rgb> {
        let branches = self.rays.get(parent)?.branches;
        let mut branches = branches.into_iter().flatten();
        let branch = branches.find(|branch| branch.outcome == Outcome::Ray(child))?;
        branch.carried?;
        let divisor = branch.attenuation.map_or(1.0, |(_, divisor)| divisor);
        Some(branch.branch?.coefficient / divisor)
    }
}

impl RayState {
    /// The light of what the ray met, without what its branches bring: the local term of a surface, else the light or background
    /// that was met.
    fn own_light(&self) -> Option<Rgb> {
        match self.surface {
            Some(_) => self.local,
            None => self.returned.map(|(light, _)| light),
        }
    }
}
