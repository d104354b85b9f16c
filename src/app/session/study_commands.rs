//! What a session does with studies.

use super::Session;
use super::command::{PointAt, Refused, StudyCommand};
use super::study::{Studying, name_of_point};
use crate::app::strings;
use crate::language::{Language, Message};
use crate::lesson::Lesson;
use crate::study::families;

impl Session {
    pub fn studying(&self) -> &Studying {
        &self.studying
    }

    #[cfg(test)]
    pub fn studying_mut(&mut self) -> &mut Studying {
        &mut self.studying
    }

    /// Takes what the study that is measured has found.
    pub fn take_findings(&mut self) {
        self.studying.take();
    }

    pub(super) fn study(&mut self, command: StudyCommand) -> Result<(), Refused> {
        let studying = &mut self.studying;
        match command {
            StudyCommand::View => {
                studying.is_open = !studying.is_open;
                self.look.home = false;
                self.look.mistakes = false;
                self.look.editing = false;
                self.play = None;
            }
            StudyCommand::Choose(index) if index < families::ALL.len() => studying.chosen = index,
            StudyCommand::Choose(_) => return Err(strings::NO_SUCH_STUDY.into()),
            StudyCommand::Quick => studying.quick = !studying.quick,
            StudyCommand::Part(part) => studying.part = part,
            StudyCommand::Measure => return studying.begin(),
            StudyCommand::Cancel => return studying.cancel(),
            StudyCommand::Pick(at) => return self.pick(at),
        }
        Ok(())
    }

    /// Why a command about studies cannot act, if it cannot.
    pub(super) fn cannot_study(&self, command: StudyCommand) -> Option<Message> {
        let measures = self.studying.percent().is_some();
        match command {
            StudyCommand::Measure => measures.then_some(strings::STILL_MEASURING),
            StudyCommand::Cancel => (!measures).then_some(strings::NOTHING_IS_MEASURED),
            StudyCommand::Pick(at) if self.studying.point(at).is_none() => {
                Some(strings::NO_SUCH_POINT)
            }
            _ => None,
        }
    }

    fn pick(&mut self, at: PointAt) -> Result<(), Refused> {
        let found = self.studying.point(at);
        let (_, line, point) = found.ok_or(strings::NO_SUCH_POINT)?;
        let lesson = point.drawn.as_ref().map(|drawn| {
            let title = Language::ALL.map(|language| name_of_point(line, point, language));
            let say = strings::said_of_a_point(point);
            Lesson::of_picture(title, say, &drawn.setup, drawn.method)
        });
        self.studying.picked = Some(at);
        if let Some(lesson) = lesson {
            self.replace(lesson)
                .map_err(|error| Refused::Error(error.to_string()))?;
            self.file = None;
            self.studying.is_open = false;
        }
        Ok(())
    }
}
