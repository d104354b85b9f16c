//! The pinned ray tree, with which those of other pixels are compared.

use super::Session;
use crate::app::strings;
use crate::language::Message;
use crate::replay::rays::State;

impl Session {
    /// The ray tree that is pinned, as it was then.
    pub fn pinned(&self) -> Option<&State> {
        self.pinned.as_ref()
    }

    /// Counts the trees that were pinned or taken away, so that pictures with another one are known to be old.
    pub fn pins(&self) -> u64 {
        self.pins
    }

    /// Why there is no tree to pin, if there is none.
    pub(super) fn cannot_pin(&self) -> Option<Message> {
        let tree = self.open.run.rays().and_then(State::ray);
        (self.pinned.is_none() && tree.is_none()).then_some(strings::NOTHING_TO_PIN)
    }

    /// Pins the tree of the step as far as it is traced, or takes the pinned one away.
    pub(super) fn toggle_pin(&mut self) {
        self.pinned = match self.pinned.take() {
            Some(_) => None,
            None => self.open.run.rays().cloned(),
        };
        self.pins += 1;
    }
}
