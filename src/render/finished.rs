//! What panels show beside the steps of a run, found once for it.

use super::compare::SideBySide;
use super::falloff::Falloff;
use super::layers::Layers;
use crate::algorithms::frame::Frame;
use crate::algorithms::radiosity::Unsolved;
use crate::algorithms::radiosity::race::Race;
use crate::scene::Light;

#[derive(Clone, Debug)]
pub struct Finished {
    /// The whole picture, rendered unrecorded.
    pub picture: Frame,
    /// The same picture by several methods, as many as are made.
    pub compared: SideBySide,
    /// All solvers on the same enclosure, once they have run.
    pub race: Option<Result<Race, Unsolved>>,
    /// What is known of its pixels beside their colours, once it was asked for and found.
    pub layers: Option<Layers>,
    /// By light.
    pub falloff: Vec<Falloff>,
}

impl Finished {
    /// Nothing compared, and no race yet.
    pub fn new(picture: Frame, lights: &[Light]) -> Self {
        Finished {
            picture,
            compared: SideBySide::default(),
            race: None,
            layers: None,
            falloff: lights.iter().map(Falloff::of).collect(),
        }
    }
}
