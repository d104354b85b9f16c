//! Predict before seeing: what follows a question stays hidden until it is answered or skipped.

use super::{Refused, Session};
use crate::app::strings;
use crate::lesson::{Answer, Guess, NoAnswer, Question};
use crate::panels::{Answered, Hidden};
use crate::picture::Tag;
use serde::{Deserialize, Serialize};

/// How a question stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Standing {
    Open,
    Right,
    Wrong,
    Skipped,
}

impl Session {
    /// How the questions stand, by their explanations.
    #[cfg(target_arch = "wasm32")]
    pub fn standings(&self) -> &[Standing] {
        &self.standings
    }

    /// The question at this step, and how it stands.
    pub fn question(&self) -> Option<(&Question, Standing)> {
        let index = self.narrated_here().filter(|_| self.asks())?;
        let said = &self.open.narrated[index];
        Some((said.question.as_ref()?, self.standings[said.index]))
    }

    /// Whether a question waits to be answered at `step`.
    pub fn question_at(&self, step: usize) -> bool {
        self.asks()
            && self.narrated.binary_search(&step).is_ok_and(|index| {
                let said = &self.open.narrated[index];
                let question = said.question.as_ref();
                self.standings[said.index] == Standing::Open
                    && question.is_some_and(|question| question.answer != Answer::Undecided)
            })
    }

    /// What the question hides that waits at this step; none where no question waits.
    pub(super) fn pending(&self) -> Option<&[Hidden]> {
        match self.question() {
            Some((question, Standing::Open)) if question.answer != Answer::Undecided => {
                Some(&question.hide)
            }
            _ => None,
        }
    }

    /// The first step from `here`, and before `target`, at which a question waits.
    pub(super) fn question_between(&self, here: usize, target: usize) -> Option<usize> {
        let first = self.narrated.partition_point(|&step| step < here);
        let ahead = self.narrated[first..]
            .iter()
            .take_while(|&&step| step < target);
        ahead.copied().find(|&step| self.question_at(step))
    }

    /// Judges a guess. After a first wrong one there is a second try, where the question has one.
    pub(super) fn answer(&mut self, guess: &Guess) -> Result<(), Refused> {
        let index = self
            .narrated_here()
            .filter(|_| self.question_at(self.step()));
        let index = index.ok_or(strings::NO_QUESTION)?;
        let said = &self.open.narrated[index];
        let (index, question) = (said.index, said.question.as_ref());
        let answer = &question.ok_or(strings::NO_QUESTION)?.answer;
        let right = answer.judge(guess).map_err(|why| match why {
            NoAnswer::NotANumber => strings::NOT_A_NUMBER,
            NoAnswer::OtherKind => strings::NO_QUESTION,
        })?;
        let guesses = self.guesses.entry(index).or_default();
        guesses.push(guess.clone());
        if right {
            self.standings[index] = Standing::Right;
        } else if guesses.len() >= answer.tries() {
            self.standings[index] = Standing::Wrong;
        }
        Ok(())
    }

    /// What was answered so far to the question at this step, the last one last.
    pub fn guesses(&self) -> &[Guess] {
        let index = self.narrated_here();
        index
            .and_then(|index| self.guesses.get(&self.open.narrated[index].index))
            .map_or(&[], |guesses| guesses)
    }

    /// The pixel, the thing or the arrow that was answered at this step, and the right one once there is a verdict.
    pub(super) fn answered(&self) -> Answered {
        let Some((question, standing)) = self.question() else {
            return Answered::default();
        };
        let right = match question.answer {
            Answer::Pixel { x, y, .. } => Some(Tag::Pixel { x, y }),
            Answer::Pick { thing, right, .. } => self.place_of(thing, right),
            _ => None,
        };
        let own = match (&question.answer, self.guesses().last()) {
            (Answer::Pixel { .. }, Some(&Guess::Pixel { x, y })) => Some(Tag::Pixel { x, y }),
            (&Answer::Pick { thing, .. }, Some(&Guess::Pick(number))) => {
                self.place_of(thing, number)
            }
            _ => None,
        };
        Answered {
            own,
            right: right.filter(|_| standing != Standing::Open),
            arrow: self.asked_arrow(),
        }
    }

    pub(super) fn skip(&mut self) -> Result<(), Refused> {
        let index = self
            .narrated_here()
            .filter(|_| self.question_at(self.step()));
        let said = &self.open.narrated[index.ok_or(strings::NO_QUESTION)?];
        self.standings[said.index] = Standing::Skipped;
        Ok(())
    }

    /// Goes to a step given from outside; the questions before it count as skipped.
    pub fn start_at(&mut self, step: usize) {
        let target = step.min(self.last_step());
        let before = self.narrated.partition_point(|&step| step < target);
        let before = before
            .checked_sub(1)
            .map_or(0, |last| self.open.narrated[last].index + 1);
        for standing in &mut self.standings[..before] {
            if *standing == Standing::Open {
                *standing = Standing::Skipped;
            }
        }
        self.seek(target);
    }

    /// Whether a click on a pixel of the image answers the current question.
    pub fn pixel_is_asked(&self) -> bool {
        matches!(
            self.question(),
            Some((
                Question {
                    answer: Answer::Pixel { .. },
                    ..
                },
                Standing::Open
            ))
        )
    }
}
