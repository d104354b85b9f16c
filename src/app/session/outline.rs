//! Where one is in the lesson: its explanations in their order, and how their questions stand.

use super::{Refused, Session, Sheet, Standing};
use crate::app::strings;

/// An explanation in the outline.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Entry {
    pub step: usize,
    /// None while a question waits before it, so that it does not give away the answer.
    pub title: Option<String>,
    /// How its question stands, where it asks one.
    pub standing: Option<Standing>,
}

impl Session {
    /// The step in the lesson's own run, also while another part is looked at.
    pub(super) fn lesson_step(&self) -> usize {
        match self.follows_lesson() {
            true => self.step(),
            false => self.left_at,
        }
    }

    /// The index of the explanation at this step, or else of the last one before it. None before the first, and in another part.
    pub fn explanation(&self) -> Option<usize> {
        let reached = self.narrated.partition_point(|&step| step <= self.step());
        reached.checked_sub(1)
    }

    /// How many explanations the lesson has.
    pub fn explanations(&self) -> usize {
        self.open.narrated.len()
    }

    /// The lesson's explanations.
    pub fn outline(&self) -> Vec<Entry> {
        let here = self.lesson_step();
        let language = self.look.language;
        let entries = self.open.narrated.iter().map(|said| {
            let title = said.title.as_ref().map(|title| title.in_language(language));
            let hidden = said.step > here && self.waits_at(here);
            let asks = said.question.is_some() && self.asks();
            Entry {
                step: said.step,
                title: (!hidden).then(|| title.unwrap_or(said.text(language)).to_owned()),
                standing: asks.then(|| self.standings[said.index]),
            }
        });
        entries.collect()
    }

    /// Whether a question waits at a step of the lesson's own run.
    fn waits_at(&self, step: usize) -> bool {
        let narrated = &self.open.narrated;
        let at = narrated.binary_search_by_key(&step, |said| said.step);
        self.asks()
            && at.is_ok_and(|index| {
                let said = &narrated[index];
                said.question.is_some() && self.standings[said.index] == Standing::Open
            })
    }

    /// Whether the lesson explains nothing after this step.
    pub fn is_last_explanation(&self) -> bool {
        self.narrated
            .last()
            .is_some_and(|&last| last <= self.step())
    }

    /// Ends the lesson: shows what was learned.
    pub(super) fn finish(&mut self) -> Result<(), Refused> {
        if self.question_at(self.step()) {
            return Err(strings::ANSWER_FIRST.into());
        }
        self.play = None;
        self.look.sheet = Some(Sheet::Finished);
        Ok(())
    }

    pub(super) fn toggle_sheet(&mut self, sheet: Sheet) {
        self.play = None;
        self.look.sheet = Some(sheet).filter(|_| self.look.sheet != Some(sheet));
    }
}
