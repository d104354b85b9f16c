//! What is shown, as files are made of it.

use super::{Choice, Refused, Session};
use crate::algorithms::focus::Focus;
use crate::export::{ExportedLesson, SIZE, TakeAway, Wish};
use crate::language::{Language, Message};
use crate::lesson::{Lesson, OpenLesson};
use crate::methods::Setup;
use crate::panels::{Panel, draw};
use crate::picture::Picture;
use crate::record::RecordingLimit;
use crate::render::Finished;
use crate::replay::Run;
use glam::Vec2;
use std::sync::Arc;

/// The lesson or walk with the values that were chosen, not run yet, and what is wanted of it.
pub struct Source {
    lesson: Lesson,
    setup: Arc<Setup>,
    focus: Focus,
    finished: Finished,
    language: Language,
    wish: Wish,
}

/// What the window is to save, open or copy.
#[derive(Default)]
pub struct Wanted {
    /// Files of what is shown, with the endings of their names.
    pub files: Vec<(TakeAway, &'static str)>,
    /// Whether all progress is to be saved as a file.
    pub progress: bool,
    /// What the user is to be asked for.
    pub choice: Option<Choice>,
    /// Whether the key panel is to be copied.
    pub copy: bool,
}

impl Source {
    /// Runs it again, away from the window.
    pub fn run(self) -> (ExportedLesson, Wish) {
        let (setup, lesson, focus) = (self.setup, self.lesson, self.focus);
        let limit = RecordingLimit::default();
        let run = Run::record(setup.clone(), lesson.method, focus, limit);
        let is_own = focus == lesson.focus;
        // Where what is explained does not happen after a change, nothing is.
        let narrated = is_own.then(|| lesson.narrate(&run).unwrap_or_default());
        let open = OpenLesson {
            narrated: narrated.unwrap_or_default(),
            lesson,
            setup,
            run,
        };
        let shown = ExportedLesson::of(open, focus, self.finished, self.language);
        (shown, self.wish)
    }
}

impl Session {
    /// What a file is made of, once the whole picture is there.
    pub fn source(&self, what: TakeAway) -> Source {
        let (panel, seen) = self.seen();
        let wish = Wish {
            steps: self.chosen_steps(),
            panel,
            seen,
            theme: self.look.theme,
        };
        Source {
            lesson: self.lesson().clone(),
            setup: self.open.setup.clone(),
            focus: what.focus(self.lesson().focus, self.focus, &wish),
            finished: self.preview.finished().clone(),
            language: self.look.language,
            wish,
        }
    }

    /// The key panel as it is looked at, in the size of pictures that are taken away.
    pub fn seen(&self) -> (Panel, Picture) {
        let panel = self.key_panel().unwrap_or(Panel::Image);
        let size = Vec2::from(SIZE.map(|side| side as f32));
        (panel, draw(panel, &self.panel_input(), size))
    }

    /// The steps with a breakpoint; without any, in a scene of one's own, the one that is shown. A lesson has its explanations.
    fn chosen_steps(&self) -> Option<Vec<usize>> {
        match self.breakpoints() {
            [] if self.lesson().is_free_walk() => Some(vec![self.step()]),
            [] => None,
            steps => Some(steps.to_vec()),
        }
    }

    /// What a file that is taken away is called.
    pub fn file_name(&self, what: TakeAway, ending: &str) -> String {
        let stem = self.file.as_ref().and_then(|file| file.file_stem());
        let of = match stem {
            Some(stem) => stem.to_string_lossy().into_owned(),
            None => self.lesson().id.clone(),
        };
        let name = what.name();
        match what {
            TakeAway::Panel => {
                let panel = self.key_panel().unwrap_or(Panel::Image).name();
                format!("{of}-{panel}-{}.{ending}", self.step())
            }
            _ if what.has_words() => {
                let language = self.look.language.code();
                format!("{of}-{name}-{language}.{ending}")
            }
            _ => format!("{of}-{name}.{ending}"),
        }
    }

    pub(super) fn take_away(
        &mut self,
        what: TakeAway,
        ending: &'static str,
    ) -> Result<(), Refused> {
        if let Some(why) = self.cannot_take(what) {
            return Err(why.into());
        }
        self.wanted.files.push((what, ending));
        Ok(())
    }

    /// Why there is no such file of what is shown, if there is none.
    pub(super) fn cannot_take(&self, what: TakeAway) -> Option<Message> {
        what.is_missing(self.lesson().method)
    }
}
