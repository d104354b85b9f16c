//! What whoever writes a lesson needs of the session: where one may begin, and what the lesson says where.

use super::{Drawer, Session};
use crate::algorithms::focus::Focus;
use crate::app::author_strings as strings;
use crate::language::{Language, Message};
use crate::lesson::{Lesson, Narrated};
use crate::panels::{kind_name, said_with_names};
use std::path::PathBuf;

impl Session {
    /// Whether questions are asked: not of whoever writes them.
    pub(super) fn asks(&self) -> bool {
        self.look.questions && !self.is_written()
    }

    /// Whether the lesson is being written, not only about to begin.
    pub fn is_written(&self) -> bool {
        let is_own = self.file.is_some() && !self.lesson().is_free_walk();
        self.look.drawer == Some(Drawer::Author) && is_own
    }

    /// Why no lesson can be written from here, if none can.
    pub(super) fn cannot_write(&self) -> Option<Message> {
        let is_json = |file: &PathBuf| file.extension().is_some_and(|end| end == "json");
        let lesson = self.lesson();
        match &self.file {
            Some(file) if is_json(file) => None,
            None if lesson.copied("copy", 1).is_some() => None,
            None if !lesson.is_free_walk() => Some(strings::WITH_FILES),
            _ => Some(strings::NO_SCENE_FILE),
        }
    }

    /// Shows a lesson that begins, whose file is not there yet, at its first explanation. Errors: what is wrong with it.
    pub fn open_to_write(&mut self, lesson: Lesson, file: PathBuf) -> Result<(), String> {
        let (key, drawer) = (self.key_panel(), self.look.drawer);
        self.open_document(lesson, Some(file))?;
        self.look.drawer = drawer;
        self.chosen = key;
        Ok(())
    }

    /// The lesson's explanations in the order of their steps.
    pub fn explained(&self) -> &[Narrated] {
        &self.open.narrated
    }

    /// The explanation of that index in the lesson's file; none where its step does not happen.
    pub fn explained_at(&self, index: usize) -> Option<&Narrated> {
        self.explained().iter().find(|said| said.index == index)
    }

    /// Why steps of this run are not those of the file, if they are not.
    pub fn runs_otherwise(&self) -> Option<Message> {
        let otherwise = self.is_changed() || !self.setup().forced().is_empty();
        otherwise.then_some(strings::CHANGED)
    }

    /// Why the step cannot become one of the lesson's, if it cannot.
    pub fn cannot_explain_here(&self) -> Option<Message> {
        if let Some(why) = self.runs_otherwise() {
            return Some(why);
        }
        if !self.follows_lesson() {
            return Some(strings::OTHER_PART);
        }
        self.narration_here().map(|_| strings::EXPLAINED_HERE)
    }

    /// What the step is called, and what it does, as the text of a lesson says it.
    pub fn step_for_a_lesson(&self, step: usize, language: Language) -> [String; 2] {
        let run = &self.open.run;
        let name = kind_name(run.walk().kind(step), language);
        let said = said_with_names(run, step, language);
        let said = if said.is_empty() {
            format!("{name}.")
        } else {
            said
        };
        [name, said]
    }

    /// The part of the run that is shown, in words.
    pub fn focus_in_words(&self, focus: Focus) -> String {
        crate::panels::strings::focus(focus, self.look.language)
    }
}
