//! The list of lessons, how far each one has come, and the way from one to the next.

use super::{Command, Progress, Refused, Session, Standing};
use crate::app::strings;
use crate::language::{Language, Message};
use crate::lesson::{Chapter, Lesson, builtins};
use crate::picture::plain;
use std::path::Path;
use std::sync::OnceLock;

/// A lesson in the list of lessons. Texts are by language.
#[derive(Clone, Debug)]
pub struct Listed {
    pub id: String,
    pub chapter: Option<Chapter>,
    /// With its number.
    pub title: [String; 2],
    pub summary: [String; 2],
    pub explanations: usize,
    pub questions: usize,
    /// The lesson cannot be opened; the summary says why.
    pub has_errors: bool,
    /// All that the lesson says, in small letters.
    words: [String; 2],
}

impl Listed {
    pub(super) fn new(id: &str, lesson: &Lesson) -> Self {
        Listed {
            id: id.to_owned(),
            chapter: lesson.chapter,
            title: Language::ALL.map(|language| {
                let title = plain(lesson.title.in_language(language));
                format!("{} · {title}", lesson.number)
            }),
            summary: Language::ALL.map(|language| lesson.summary.in_language(language).to_owned()),
            explanations: lesson.explanations(),
            questions: lesson.questions(),
            has_errors: false,
            words: Language::ALL.map(|language| {
                let texts: Vec<&str> = lesson.texts(language).collect();
                texts.join("\n").to_lowercase()
            }),
        }
    }

    /// A lesson file that is wrong, under its name.
    pub(super) fn with_errors(path: &Path, error: &str) -> Self {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        // The name stands above.
        let before = format!("{}: ", path.display());
        let error = error.replace(&before, "");
        Listed {
            id: name.to_string(),
            chapter: None,
            title: Language::ALL.map(|_| name.to_string()),
            words: Language::ALL.map(|_| format!("{name}\n{error}").to_lowercase()),
            summary: Language::ALL.map(|_| error.clone()),
            explanations: 0,
            questions: 0,
            has_errors: true,
        }
    }

    /// Whether the lesson says all the words of a search, in this language.
    pub fn says(&self, search: &str, language: Language) -> bool {
        let said = &self.words[language as usize];
        let mut words = search.split_whitespace();
        words.all(|word| said.contains(&word.to_lowercase()))
    }
}

/// The program's own lessons, in the order of their numbers.
pub fn listed() -> &'static [Listed] {
    static LISTED: OnceLock<Vec<Listed>> = OnceLock::new();
    LISTED.get_or_init(|| {
        let lessons = builtins().iter().filter_map(|builtin| {
            let lesson = builtin.read().ok()?;
            Some(Listed::new(builtin.id, &lesson))
        });
        lessons.collect()
    })
}

/// Which lesson beside this one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Neighbour {
    Next,
    Previous,
}

impl Session {
    /// How far a lesson has come; none for one that was never opened.
    pub fn progress_in(&self, id: &str) -> Option<&Progress> {
        self.progress.get(id)
    }

    /// The lesson before or after this one, in the folder where it is of one; those with errors are passed over. Errors: why there
    /// is none.
    pub(super) fn neighbour(&self, which: Neighbour) -> Result<&Listed, Message> {
        let id = &self.lesson().id;
        let own = self.own_lesson(id).and(self.own_lessons());
        let list = own.map_or(listed(), |(_, own)| own).iter();
        let list: Vec<&Listed> = list.filter(|listed| !listed.has_errors).collect();
        let here = list.iter().position(|listed| listed.id == *id);
        let here = here.ok_or(strings::NOT_IN_THE_LIST)?;
        let (there, none) = match which {
            Neighbour::Next => (here.checked_add(1), strings::NO_NEXT_LESSON),
            Neighbour::Previous => (here.checked_sub(1), strings::NO_PREVIOUS_LESSON),
        };
        let there = there.and_then(|there| list.get(there));
        there.copied().ok_or(none)
    }

    pub fn next_lesson(&self) -> Option<&Listed> {
        self.neighbour(Neighbour::Next).ok()
    }

    pub(super) fn open_neighbour(&mut self, which: Neighbour) -> Result<(), Refused> {
        let id = self.neighbour(which)?.id.clone();
        self.update(Command::Open(id))
    }

    pub(super) fn toggle_home(&mut self) {
        self.note_progress();
        self.play = None;
        self.studying.is_open = false;
        self.look.sheet = None;
        self.look.editing = false;
        self.look.mistakes = false;
        self.look.home = !self.look.home;
    }
}

impl Progress {
    /// How many questions were answered right.
    pub fn right(&self) -> usize {
        let right = self
            .answers
            .values()
            .filter(|&&standing| standing == Standing::Right);
        right.count()
    }
}
