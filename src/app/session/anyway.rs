//! What the scene does not need, done all the same: the part that is looked at is recorded again, and the picture begun anew, so that
//! one sees that nothing changes but the steps and the time.

use super::preview::Times;
use super::{Refused, Session};
use crate::app::words;
use crate::panels::words::Words;
use crate::render::left_out;
use crate::scene::{LeftOut, Part, Parts};
use std::sync::Arc;

impl Session {
    /// What the scene does not need of the lesson's method, whether it is done all the same or not.
    pub fn left_out(&self) -> Vec<LeftOut> {
        left_out(self.stage(), self.lesson().method)
    }

    /// Run times without and with what is done all the same; none before they are measured, or where nothing is.
    pub fn times(&self) -> Option<&Times> {
        self.preview.times()
    }

    /// Why a part cannot be left out or done all the same, if it cannot.
    pub(super) fn cannot_leave_out(&self, part: Part) -> Option<Words> {
        let left_out = self.left_out();
        let is_needed = left_out.iter().all(|left_out| left_out.part != part);
        is_needed.then_some(words::IS_NEEDED)
    }

    pub(super) fn do_anyway(&mut self, part: Part) -> Result<(), Refused> {
        match self.cannot_leave_out(part) {
            Some(words) => Err(words.into()),
            None => {
                self.run_doing(self.stage().anyway().toggled(part));
                Ok(())
            }
        }
    }

    pub(super) fn leave_all_out(&mut self) {
        self.run_doing(Parts::NONE);
    }

    fn run_doing(&mut self, anyway: Parts) {
        let stage = Arc::new((*self.open.stage).clone().doing(anyway));
        self.preview
            .begin_anew(stage.clone(), super::methods(&self.open));
        self.open.stage = stage;
        self.look_again();
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
        let (picture, steps) = (session.show().finished.clone(), session.walk().len());
        assert!(session.times().is_none());
        session
            .update(Command::Anyway(Part::ReflectedRays))
            .unwrap();
        session.wait_for_picture();
        assert!(session.show().finished == &picture);
        assert!(session.walk().len() > steps);
        // A machine that is busy may be too slow to time both.
        assert!(session.times().is_some());
        assert_eq!(
            session.update(Command::Share),
            Err(words::SHARE_AS_LEFT_OUT_ONLY.into())
        );

        session
            .update(Command::Anyway(Part::ReflectedRays))
            .unwrap();
        session.wait_for_picture();
        assert!(session.show().finished == &picture && session.times().is_none());
        assert_eq!(session.walk().len(), steps);
        session.update(Command::Share).unwrap();
    }

    #[test]
    fn what_is_needed_cannot_be_left_out() {
        let mut session = session("needs");
        for part in [Part::Highlights, Part::SightTests] {
            let command = Command::Anyway(part);
            assert_eq!(session.allows(&command), Err(words::IS_NEEDED.into()));
            assert_eq!(session.update(command), Err(words::IS_NEEDED.into()));
        }
        assert!(session.stage().anyway().is_empty());
    }

    #[test]
    fn reset_leaves_all_out_again() {
        let mut session = session("needs");
        let steps = session.walk().len();
        session.update(Command::Anyway(Part::ShadowRays)).unwrap();
        assert!(session.walk().len() > steps);
        session.update(Command::Reset).unwrap();
        assert!(session.stage().anyway().is_empty());
        assert_eq!(session.walk().len(), steps);
    }
}
