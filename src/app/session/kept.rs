//! What outlives the program: the look, and how far each lesson has come. The window writes it to a file.

use super::{Session, Standing, TEXT_SIZES};
use crate::language::Language;
use crate::lesson::{Guess, Lesson};
use crate::picture::Theme;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// What is kept of a session. Words that this program does not know are passed over, as if nothing had been kept.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize)]
#[serde(default)]
pub struct Kept {
    /// By its code; none before one was ever chosen.
    pub language: Option<String>,
    theme: Option<String>,
    /// In percent of the normal size.
    text_size: Option<u32>,
    /// The lesson that was open, by its id.
    pub lesson: Option<String>,
    /// By the lessons' ids.
    pub lessons: BTreeMap<String, Progress>,
    /// Scenes of one's own, by the names of their files.
    scenes: BTreeMap<String, String>,
}

/// How far a lesson has come.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize)]
#[serde(default)]
pub struct Progress {
    pub(super) place: Place,
    /// How many explanations were reached.
    pub reached: usize,
    /// How the questions stand that were answered or skipped, by the index of the explanation that asks.
    pub answers: BTreeMap<usize, Standing>,
    /// What was answered, one try after the other.
    pub(super) guesses: BTreeMap<usize, Vec<Guess>>,
}

/// The index of the last explanation at or before a step, none before the first one; and how many steps lie between. So a place
/// stays where it is when the program records more events.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize)]
pub(super) struct Place(pub Option<usize>, pub usize);

impl Place {
    /// `narrated` has the steps of the explanations, ascending.
    pub fn of(step: usize, narrated: &[usize]) -> Self {
        let explanation = narrated
            .partition_point(|&said| said <= step)
            .checked_sub(1);
        let from = explanation.map_or(0, |index| narrated[index]);
        Place(explanation, step - from)
    }

    /// The step that is meant: before the next explanation, and not behind the last step.
    pub fn step(self, narrated: &[usize], last: usize) -> usize {
        let Place(explanation, offset) = self;
        let explanation = explanation.map(|index| index.min(narrated.len().saturating_sub(1)));
        let from = explanation.and_then(|index| narrated.get(index));
        let next = narrated.get(explanation.map_or(0, |index| index + 1));
        let from = from.copied().unwrap_or(0);
        let end = next.map_or(last, |next| next.saturating_sub(1));
        from.saturating_add(offset).min(end.max(from))
    }
}

impl Session {
    /// What to keep of this session, with its latest step and answers.
    pub fn keep(&mut self) -> Kept {
        self.note_progress();
        self.note_scene();
        let theme = match self.look.presenting {
            true => self.look.before_presenting,
            false => self.look.theme,
        };
        Kept {
            language: Some(self.look.language.code().to_owned()),
            theme: Some(theme.name().to_owned()),
            text_size: Some(percent(self.look.text)),
            lesson: self.kept_lesson.clone(),
            lessons: self.progress.clone(),
            scenes: self.scenes.clone(),
        }
    }

    /// Takes what was kept, and goes to where this lesson was left.
    pub fn restore(&mut self, kept: Kept) {
        let look = &mut self.look;
        let language = kept.language.as_deref().and_then(Language::of_tag);
        look.language = language.unwrap_or(look.language);
        let theme = kept.theme.as_deref().and_then(Theme::from_name);
        look.theme = theme.unwrap_or(look.theme);
        if let Some(size) = kept.text_size {
            let sizes = 0..TEXT_SIZES.len();
            let nearest = sizes.min_by_key(|&index| percent(index).abs_diff(size));
            look.text = nearest.unwrap_or(look.text);
        }
        self.progress = kept.lessons;
        self.scenes = kept.scenes;
        self.kept_lesson = kept.lesson;
        self.resume();
    }

    /// Goes to where this lesson was left, with its answers.
    pub(super) fn resume(&mut self) {
        let Some(progress) = self.progress.get(&self.open.lesson.id) else {
            return;
        };
        let step = progress.place.step(&self.narrated, self.last_step());
        for said in &self.open.narrated {
            let index = said.index;
            let Some(question) = &said.question else {
                continue;
            };
            if let Some(&standing) = progress.answers.get(&index) {
                self.standings[index] = standing;
            }
            let mut guesses = progress.guesses.get(&index).cloned().unwrap_or_default();
            guesses.retain(|guess| question.answer.judge(guess).is_ok());
            if !guesses.is_empty() {
                self.guesses.insert(index, guesses);
            }
        }
        self.seek(step);
    }

    /// Brings the progress in this lesson up to date. It stays as it was where something that the lesson explains does not happen after a
    /// change, and where the page of all lessons is shown instead of the lesson.
    pub(super) fn note_progress(&mut self) {
        if self.look.home || self.look.mistakes {
            return;
        }
        let lesson = &self.open.lesson;
        let narrated: Vec<usize> = self.open.narrated.iter().map(|said| said.step).collect();
        if lesson.number == Lesson::UNNUMBERED || narrated.len() < lesson.explanations() {
            return;
        }
        let place = Place::of(self.lesson_step(), &narrated);
        let reached = place.0.map_or(0, |explanation| explanation + 1);
        let answers = self.standings.iter().copied().enumerate();
        let answers = answers.filter(|(_, standing)| *standing != Standing::Open);
        self.kept_lesson = Some(lesson.id.clone());
        let progress = self.progress.entry(lesson.id.clone()).or_default();
        *progress = Progress {
            place,
            reached: reached.max(progress.reached).min(narrated.len()),
            answers: answers.collect(),
            guesses: self.guesses.clone(),
        };
    }

    /// Forgets the progress in this lesson.
    pub(super) fn forget_lesson(&mut self) {
        self.progress.remove(&self.open.lesson.id);
    }

    /// Forgets the progress in all lessons; this one starts again.
    pub(super) fn forget(&mut self) {
        self.look.sheet = None;
        self.progress.clear();
        self.standings.fill(Standing::Open);
        self.guesses.clear();
        self.play = None;
        match self.follows_lesson() {
            true => self.seek(0),
            false => self.left_at = 0,
        }
    }
}

fn percent(size: usize) -> u32 {
    (100.0 * TEXT_SIZES[size]).round() as u32
}
