//! Predict before seeing: what follows a question stays hidden until it is answered or skipped.

use super::{Guess, Refused, Session, Standing};
use crate::app::strings;
use crate::lesson::{Answer, Question};
use crate::panels::Hidden;

impl Session {
    /// The question at this step, and how it stands.
    pub fn question(&self) -> Option<(&Question, Standing)> {
        let index = self.narrated_here().filter(|_| self.look.questions)?;
        let question = self.open.narrated[index].question.as_ref()?;
        Some((question, self.standings[index]))
    }

    /// Whether a question waits to be answered at `step`.
    pub fn question_at(&self, step: usize) -> bool {
        self.look.questions
            && self.narrated.binary_search(&step).is_ok_and(|index| {
                self.standings[index] == Standing::Open
                    && self.open.narrated[index].question.is_some()
            })
    }

    /// What the question hides that waits at this step; none where no question waits.
    pub(super) fn pending(&self) -> Option<&[Hidden]> {
        match self.question() {
            Some((question, Standing::Open)) => Some(&question.hide),
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

    pub(super) fn answer(&mut self, guess: &Guess) -> Result<(), Refused> {
        let index = self
            .narrated_here()
            .filter(|_| self.question_at(self.step()));
        let index = index.ok_or(strings::NO_QUESTION)?;
        let question = self.open.narrated[index].question.as_ref();
        let right = match (question.map(|question| &question.answer), guess) {
            (Some(Answer::Number { value, tolerance }), Guess::Number(text)) => {
                let number = read_number(text).ok_or(strings::NOT_A_NUMBER)?;
                (number - value).abs() <= *tolerance
            }
            (Some(Answer::Choice { right, .. }), Guess::Choice(choice)) => choice == right,
            (Some(Answer::Pixel { x, y, tolerance }), Guess::Pixel { x: at_x, y: at_y }) => {
                x.abs_diff(*at_x) <= *tolerance && y.abs_diff(*at_y) <= *tolerance
            }
            _ => return Err(strings::NO_QUESTION.into()),
        };
        self.standings[index] = if right {
            Standing::Right
        } else {
            Standing::Wrong
        };
        Ok(())
    }

    pub(super) fn skip(&mut self) -> Result<(), Refused> {
        let index = self
            .narrated_here()
            .filter(|_| self.question_at(self.step()));
        self.standings[index.ok_or(strings::NO_QUESTION)?] = Standing::Skipped;
        Ok(())
    }

    /// Goes to a step given from outside; the questions before it count as skipped.
    pub fn start_at(&mut self, step: usize) {
        let target = step.min(self.last_step());
        let before = self.narrated.partition_point(|&step| step < target);
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

/// A number as an answer is typed: with a decimal point, or a comma as Indonesian writes it.
pub fn read_number(text: &str) -> Option<f64> {
    let number: f64 = text
        .trim()
        .replace(',', ".")
        .replace('−', "-")
        .parse()
        .ok()?;
    number.is_finite().then_some(number)
}
