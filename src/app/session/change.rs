//! Changing parameters: the focus is recorded again, and the whole picture rendered again.

use super::{Refused, Session};
use crate::app::strings;
use crate::language::Message;
use crate::lesson::{Change, NotAllowed, Parameter};
use crate::methods::{Settings, Setup};
use crate::scene::{Movable, NoRoom, Scene};
use std::sync::Arc;

/// What has other values than the lesson gives it, and what it was before.
#[derive(Default)]
pub(super) struct Changes {
    /// At most one a parameter.
    now: Vec<Change>,
    before: Vec<Vec<Change>>,
    /// What was undone, the next one last.
    undone: Vec<Vec<Change>>,
    /// The parameter that is being moved: until another one is, that is one change.
    moving: Option<Parameter>,
}

impl Changes {
    pub fn now(&self) -> &[Change] {
        &self.now
    }

    /// The changes once another is made. One to the lesson's own value is none.
    fn with(&self, change: Change, own: Option<Change>) -> Vec<Change> {
        let parameter = change.parameter();
        let others = self.now.iter().copied();
        let mut changes: Vec<Change> = others.filter(|old| old.parameter() != parameter).collect();
        if own != Some(change) {
            changes.push(change);
        }
        changes
    }
}

impl Session {
    /// Whether a parameter has another value than the lesson gives it.
    pub fn is_changed(&self) -> bool {
        !self.changes.now.is_empty()
    }

    /// The value of a parameter.
    pub fn value(&self, parameter: Parameter) -> Option<Change> {
        self.open.lesson.value(parameter, &self.changes.now)
    }

    /// What may be put elsewhere.
    pub fn movable(&self) -> impl Iterator<Item = Movable> {
        let all = Movable::all(&self.open.setup.prepared.scene);
        all.filter(|&of| self.may_move(of))
    }

    pub fn may_move(&self, of: Movable) -> bool {
        self.open.lesson.may_change(Parameter::Place(of))
    }

    /// What the explanation here was followed by, or preceded, and does not happen with the values chosen.
    pub fn not_happening_here(&self) -> Vec<(Option<&str>, Option<&str>)> {
        let said = self.narration_here().into_iter();
        said.flat_map(|said| said.not_happening(self.look.language))
            .collect()
    }

    /// Whether the narration is gone because of that: an event that it needs does not happen any more.
    pub fn is_silent(&self) -> bool {
        self.follows_lesson() && self.narrated.is_empty()
    }

    /// Why a parameter cannot be changed, if it cannot.
    pub(super) fn cannot_change(&self, parameter: Parameter) -> Option<Message> {
        let may = self.open.lesson.may_change(parameter);
        (!may).then_some(strings::STAYS)
    }

    pub(super) fn change(&mut self, change: Change) -> Result<(), Refused> {
        if let Some(strings) = self.cannot_change(change.parameter()) {
            return Err(strings.into());
        }
        let parameter = change.parameter();
        if self.value(parameter) == Some(change) {
            return Ok(());
        }
        let own = self.open.lesson.value(parameter, &[]);
        let now = self.changes.with(change, own);
        let before = self.changes.now.clone();
        self.show_changes(now)?;
        if self.changes.moving != Some(parameter) {
            self.changes.before.push(before);
        }
        self.changes.moving = Some(parameter);
        self.changes.undone.clear();
        Ok(())
    }

    /// Why there is nothing to undo or to do again, if there is not.
    pub(super) fn cannot_undo(&self) -> Option<Message> {
        let nothing = self.changes.before.is_empty();
        nothing.then_some(strings::NOTHING_TO_UNDO)
    }

    pub(super) fn cannot_redo(&self) -> Option<Message> {
        let nothing = self.changes.undone.is_empty();
        nothing.then_some(strings::NOTHING_TO_REDO)
    }

    pub(super) fn undo(&mut self) -> Result<(), Refused> {
        let before = self.changes.before.pop().ok_or(strings::NOTHING_TO_UNDO)?;
        let now = self.changes.now.clone();
        self.show_changes(before)?;
        self.changes.undone.push(now);
        self.changes.moving = None;
        Ok(())
    }

    pub(super) fn redo(&mut self) -> Result<(), Refused> {
        let next = self.changes.undone.pop().ok_or(strings::NOTHING_TO_REDO)?;
        let now = self.changes.now.clone();
        self.show_changes(next)?;
        self.changes.before.push(now);
        self.changes.moving = None;
        Ok(())
    }

    /// The lesson's own values, which can be undone.
    pub(super) fn reset(&mut self) {
        let before = std::mem::take(&mut self.changes.now);
        // The lesson was opened with them.
        if self.show_changes(Vec::new()).is_ok() {
            self.changes.before.push(before);
        }
        self.changes.undone.clear();
        self.changes.moving = None;
    }

    /// Shows the lesson with these changes in place of those before. Errors: why they cannot be had; nothing has changed then.
    pub(super) fn show_changes(&mut self, changes: Vec<Change>) -> Result<(), Refused> {
        let changed = self.open.lesson.changed(&changes);
        let (scene, settings) = changed.map_err(|why| match why {
            NotAllowed::NoRoom(NoRoom::TooFar) => strings::TOO_FAR.into(),
            NotAllowed::NoRoom(NoRoom::NoView) => strings::NO_VIEW.into(),
            NotAllowed::OutOfRange => strings::OUT_OF_RANGE.into(),
            NotAllowed::NoRoom(NoRoom::Refused(why)) | NotAllowed::Refused(why) => {
                Refused::Error(why)
            }
        })?;
        let by_path = |changes: &[Change]| {
            let all = changes.iter().copied();
            all.filter(|change| matches!(change, Change::ByPath { .. }))
                .collect::<Vec<_>>()
        };
        let same_settings = by_path(&changes) == by_path(&self.changes.now);
        let setup = self.setup_of(scene, settings, same_settings)?;
        self.preview
            .restart(setup.clone(), super::methods(&self.open));
        self.open.setup = setup;
        self.changes.now = changes;
        self.record_again();
        self.compare_again();
        self.what_if.restart();
        Ok(())
    }

    /// Another scene, prepared. Where only its lights differ, what was prepared of the rest stays. Errors: what is looked at is not there.
    fn setup_of(
        &self,
        scene: Scene,
        settings: Settings,
        same_settings: bool,
    ) -> Result<Arc<Setup>, Refused> {
        let old = &self.open.setup;
        let lit = Scene {
            lights: scene.lights.clone(),
            ..old.prepared.scene.clone()
        };
        if lit == scene && same_settings {
            return Ok(Arc::new(old.with_lights(scene.lights)));
        }
        let lesson = &self.open.lesson;
        let setup = lesson.setup(scene, settings).ok_or(strings::NO_VIEW)?;
        let wrong = |why: String| Refused::Error(why);
        setup
            .check_for(lesson.method)
            .map_err(|error| wrong(error.to_string()))?;
        setup
            .check(self.focus)
            .map_err(|error| wrong(error.to_string()))?;
        Ok(Arc::new(setup))
    }
}

#[cfg(test)]
mod tests;
