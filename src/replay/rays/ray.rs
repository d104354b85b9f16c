//! One ray of the tree at a step, and what it is being tested against.

use super::super::current::CurrentPoint;
use crate::algorithms::ray_tree::{Branch, End, RayKind};
use crate::algorithms::visible::Intersection;
use crate::color::Rgb;
use crate::scene::primitives::{Hit, Ray};
use glam::{DVec2, DVec3};
use std::sync::Arc;

/// A ray of the tree, with what it met and what came of it.
#[derive(Clone, Debug)]
pub struct RayState {
    pub kind: RayKind,
    pub level: u16,
    pub parent: Option<usize>,
    pub ray: Ray,
    /// The step that opened it.
    pub step: usize,
    /// What it met first, once the search is done.
    pub met: Option<Intersection>,
    pub surface: Option<CurrentSurface>,
    /// How its surface was lit, once that is done.
    pub lit: Option<Arc<CurrentPoint>>,
    /// Verdicts of the lights, in order, without those that the surface turns away from.
    pub shadows: Vec<Verdict>,
    /// Light that arrives from the lights, ambient light and emission.
    pub local: Option<Rgb>,
    pub refraction: Option<CurrentRefraction>,
    /// The reflected one, and the transmitted one (or the one that total internal reflection made of it).
    pub branches: [Option<CurrentBranch>; 2],
    /// The sum so far: local light and what branches brought back.
    pub sum: Option<Rgb>,
    /// What came back along it, and the step that said so.
    pub returned: Option<(Rgb, usize)>,
}

#[derive(Clone, Copy, Debug)]
pub struct CurrentSurface {
    pub object: u32,
    pub position: DVec3,
    /// N_geometric.
    pub geometric: DVec3,
    /// N, toward the incoming ray; cos θ_i; whether the ray enters.
    pub facing: Option<(DVec3, f64, bool)>,
    pub texture: Option<(DVec2, Rgb)>,
}

#[derive(Clone, Copy, Debug)]
pub struct Verdict {
    pub light: u32,
    pub blocked: bool,
    pub by: Option<Hit>,
    /// L, and the distance of the light.
    pub direction: DVec3,
    pub distance: f64,
    /// The step that closed the shadow ray.
    pub step: usize,
}

#[derive(Clone, Copy, Debug)]
pub struct CurrentRefraction {
    pub eta_i: f64,
    pub eta_r: f64,
    /// cos²θ_r; negative at total internal reflection.
    pub radicand: f64,
    pub step: usize,
}

impl CurrentRefraction {
    /// θ_r in radians; none at total internal reflection.
    pub fn theta_r(&self) -> Option<f64> {
        (self.radicand >= 0.0).then(|| self.radicand.sqrt().min(1.0).acos())
    }

    /// The angle of incidence in radians from which on nothing is transmitted; none where the ray enters a denser medium.
    pub fn critical_angle(&self) -> Option<f64> {
        (self.eta_i > self.eta_r).then(|| (self.eta_r / self.eta_i).asin())
    }
}

#[derive(Clone, Copy, Debug)]
pub struct CurrentBranch {
    /// None where the surface has no coefficient.
    pub branch: Option<Branch>,
    pub kind: RayKind,
    pub outcome: Outcome,
    /// Distance and divisor of the attenuation.
    pub attenuation: Option<(f64, f64)>,
    /// What is added, before the coefficient.
    pub carried: Option<Rgb>,
    /// The step that recorded it first.
    pub step: usize,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// Not traced yet.
    Open,
    /// Index of the ray in [`State::rays`](super::State::rays).
    Ray(usize),
    Ended(End),
}

/// The search for the nearest object so far.
#[derive(Clone, Copy, Debug)]
pub struct CurrentSearch {
    /// What was tested last: object (or light) and t.
    pub tested: Option<Tested>,
    /// The nearest so far.
    pub nearest: Option<Tested>,
}

#[derive(Clone, Copy, Debug)]
pub struct Tested {
    pub target: Target,
    /// Infinite where the ray misses.
    pub t: f64,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Target {
    Object(u32),
    Light(u32),
}

#[derive(Clone, Copy, Debug)]
pub struct CurrentShadow {
    pub light: u32,
    pub direction: DVec3,
    pub distance: f64,
    /// What was tested last, and whether it blocks.
    pub tested: Option<(u32, f64, bool)>,
    pub step: usize,
}
