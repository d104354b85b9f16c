//! Changing parameters: the focus is recorded again, and the whole picture rendered again.

use super::{Refused, Session};
use crate::app::strings;
use crate::language::Message;
use crate::lesson::{Change, NotAllowed, Parameter};
use crate::scene::Scene;
use std::sync::Arc;

impl Session {
    /// Whether a parameter has another value than the lesson gives it.
    pub fn is_changed(&self) -> bool {
        let lesson = &self.open.lesson;
        let (now, opened) = (&self.open.setup.prepared.scene, &lesson.scene);
        let mut parameters = lesson.parameters.iter();
        parameters.any(|parameter| parameter.value(now) != parameter.value(opened))
    }

    /// Whether the narration is gone because of that: an event that it needs does not happen any more.
    pub fn is_silent(&self) -> bool {
        self.follows_lesson() && self.narrated.is_empty()
    }

    /// Why a parameter cannot be changed, if it cannot.
    pub(super) fn cannot_change(&self, parameter: Parameter) -> Option<Message> {
        let may = self.open.lesson.parameters.contains(&parameter);
        (!may).then_some(strings::STAYS)
    }

    pub(super) fn change(&mut self, change: Change) -> Result<(), Refused> {
        if let Some(strings) = self.cannot_change(change.parameter()) {
            return Err(strings.into());
        }
        if change.parameter().value(&self.open.setup.prepared.scene) == Some(change) {
            return Ok(());
        }
        let mut scene = self.open.setup.prepared.scene.clone();
        let made = change.make(&mut scene, &self.open.lesson.scene);
        made.map_err(|why| match why {
            NotAllowed::TooFar => strings::TOO_FAR,
            NotAllowed::NoView => strings::NO_VIEW,
            NotAllowed::OutOfRange => strings::OUT_OF_RANGE,
        })?;
        self.show_scene(scene);
        Ok(())
    }

    pub(super) fn reset(&mut self) {
        self.show_scene(self.open.lesson.scene.clone());
    }

    /// Shows another scene. Where only its lights differ, what was prepared of the rest stays.
    fn show_scene(&mut self, scene: Scene) {
        let old = &self.open.setup;
        let lit = Scene {
            lights: scene.lights.clone(),
            ..old.prepared.scene.clone()
        };
        let setup = if lit == scene {
            Some(old.with_lights(scene.lights))
        } else {
            self.open.lesson.setup(scene)
        };
        // A lesson that was opened has a camera.
        let Some(setup) = setup.map(Arc::new) else {
            return;
        };
        self.preview
            .restart(setup.clone(), super::methods(&self.open));
        self.open.setup = setup;
        self.record_again();
    }
}

#[cfg(test)]
mod tests;
