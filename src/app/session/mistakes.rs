//! The page of classic mistakes, and the way from there to a walk in which one is made.

use super::{Refused, Session};
use crate::app::strings;
use crate::language::Language;
use crate::lesson::Lesson;
use crate::methods::Mistake;

impl Session {
    /// Opens the page, or goes back to that of all lessons.
    pub(super) fn toggle_mistakes(&mut self) {
        self.note_progress();
        self.play = None;
        self.studying.is_open = false;
        self.look.sheet = None;
        self.look.editing = false;
        self.look.mistakes = !self.look.mistakes;
        self.look.home = !self.look.mistakes;
    }

    /// Walks through the scene that shows a mistake, with the mistake switched on.
    pub(super) fn show_mistake(&mut self, mistake: Mistake) -> Result<(), Refused> {
        let example = mistake.example(Lesson::SIZE_OF_A_WALK);
        let (setup, method) = example.ok_or(strings::NOT_FOUND)?;
        let title = Language::ALL.map(|language| mistake.title(language));
        let about = Language::ALL.map(|language| mistake.about(language));
        let lesson = Lesson::walk(title, about, &setup, method);
        self.open_document(lesson, None).map_err(Refused::Error)?;
        self.make_mistake(Some(mistake));
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Command, Drawer, Session};
    use super::*;
    use crate::lesson::builtin;

    fn session() -> Session {
        Session::new(builtin("gouraud-triangle").unwrap().read().unwrap()).unwrap()
    }

    #[test]
    fn the_page_lies_beside_that_of_all_lessons() {
        let mut session = session();
        session.look.home = true;
        session.update(Command::Mistakes).unwrap();
        assert!(session.look.mistakes && !session.look.home);
        session.update(Command::Mistakes).unwrap();
        assert!(!session.look.mistakes && session.look.home);
        session.update(Command::Mistakes).unwrap();
        session.update(Command::Home).unwrap();
        assert!(!session.look.mistakes && session.look.home);
    }

    #[test]
    fn any_mistake_can_be_walked_in_a_scene_that_shows_it() {
        let mut session = session();
        for mistake in Mistake::ALL {
            session.look.mistakes = true;
            session.update(Command::ShowMistake(mistake)).unwrap();
            assert!(!session.look.mistakes && session.lesson().is_free_walk());
            assert_eq!(session.what_if().on, Some(mistake));
            assert_eq!(session.look.drawer, Some(Drawer::WhatIf));
            assert!(mistake.concerns(session.lesson().method));
            let said = session
                .narration_here()
                .map(|said| said.text(Language::English));
            assert_eq!(said, Some(mistake.about(Language::English).as_str()));
        }
    }
}
