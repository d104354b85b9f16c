//! What the scene does not need, done all the same: the part that is looked at is recorded again, and the picture begun anew, so that
//! one sees that nothing changes but the steps and the time.

use super::preview::Times;
use super::{Refused, Session};
use crate::app::strings;
use crate::language::Message;
use crate::scene::{LeftOut, Part, Parts};
use std::sync::Arc;

impl Session {
    /// What the lesson's method does not need for the scene, forced or not.
    pub fn skipped(&self) -> Vec<LeftOut> {
        self.setup().skipped(self.lesson().method)
    }

    /// Run times without and with what is forced; none before they are measured, or where nothing is forced.
    pub fn times(&self) -> Option<&Times> {
        self.preview.times()
    }

    /// Why a part cannot be skipped or forced, if it cannot.
    pub(super) fn cannot_leave_out(&self, part: Part) -> Option<Message> {
        let skipped = self.skipped();
        let is_needed = skipped.iter().all(|skipped| skipped.part != part);
        is_needed.then_some(strings::IS_NEEDED)
    }

    pub(super) fn force(&mut self, part: Part) -> Result<(), Refused> {
        match self.cannot_leave_out(part) {
            Some(strings) => Err(strings.into()),
            None => {
                self.run_with_forced(self.setup().forced().toggled(part));
                Ok(())
            }
        }
    }

    pub(super) fn leave_all_out(&mut self) {
        self.run_with_forced(Parts::NONE);
    }

    fn run_with_forced(&mut self, forced: Parts) {
        let setup = Arc::new(self.open.setup.with_forced(forced));
        self.preview
            .restart(setup.clone(), super::methods(&self.open));
        self.open.setup = setup;
        self.record_again();
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Command, Session};
    use super::*;
    use crate::lesson::builtin;

    fn session(id: &str) -> Session {
        let mut session = Session::new(builtin(id).unwrap().read().unwrap()).unwrap();
        session.update(Command::Questions).unwrap();
        session.wait_for_picture();
        session
    }

    #[test]
    fn a_part_done_all_the_same_changes_steps_and_time_and_no_bit_of_the_picture() {
        let mut session = session("needs");
        let (picture, steps) = (
            session.panel_input().finished.picture.clone(),
            session.walk().len(),
        );
        assert!(session.times().is_none());
        session.update(Command::Force(Part::ReflectedRays)).unwrap();
        session.wait_for_picture();
        assert!(session.panel_input().finished.picture == picture);
        assert!(session.walk().len() > steps);
        // A machine that is busy may be too slow to time both.
        assert!(session.times().is_some());
        assert_eq!(
            session.update(Command::Share),
            Err(strings::SHARE_AS_LEFT_OUT_ONLY.into())
        );

        session.update(Command::Force(Part::ReflectedRays)).unwrap();
        session.wait_for_picture();
        assert!(session.panel_input().finished.picture == picture && session.times().is_none());
        assert_eq!(session.walk().len(), steps);
        session.update(Command::Share).unwrap();
    }

    #[test]
    fn what_is_needed_cannot_be_left_out() {
        let mut session = session("needs");
        for part in [Part::Highlights, Part::SightTests] {
            let command = Command::Force(part);
            assert_eq!(session.allows(&command), Err(strings::IS_NEEDED.into()));
            assert_eq!(session.update(command), Err(strings::IS_NEEDED.into()));
        }
        assert!(session.setup().forced().is_empty());
    }

    #[test]
    fn reset_leaves_all_out_again() {
        let mut session = session("needs");
        let steps = session.walk().len();
        session.update(Command::Force(Part::ShadowRays)).unwrap();
        assert!(session.walk().len() > steps);
        session.update(Command::Reset).unwrap();
        assert!(session.setup().forced().is_empty());
        assert_eq!(session.walk().len(), steps);
    }
}
