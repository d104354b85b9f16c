//! What panels made for one picture and can use in the next, since it is the same at every step. A picture is the same with and
//! without.

use crate::panels::list::image::SoFar;
use crate::panels::list::space::Surroundings;
use std::cell::{Cell, RefCell};

/// Of one run and its finished pictures.
#[derive(Default)]
pub struct Reused {
    version: Cell<[u64; 2]>,
    pub(in crate::panels) surroundings: RefCell<Option<Surroundings>>,
    pub(in crate::panels) so_far: RefCell<Option<SoFar>>,
}

impl Reused {
    /// What is used again of that recording and those pictures, both by their numbers; what belongs to others is forgotten.
    pub fn of(&self, recording: u64, pictures: u64) -> &Self {
        if self.version.replace([recording, pictures]) != [recording, pictures] {
            self.surroundings.take();
            self.so_far.take();
        }
        self
    }
}
