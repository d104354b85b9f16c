//! Questions for a direction, shown by an arrow that is turned in the picture.

use super::{Refused, Session, Standing};
use crate::app::strings;
use crate::lesson::{ARROW_START, Answer, Guess};
use crate::panels::AskedArrow;

impl Session {
    /// The degrees of the arrow that the current question asks for; none where it asks for something else or has its verdict.
    pub fn arrow_asked(&self) -> Option<f64> {
        let (question, standing) = self.question()?;
        let is_arrow = matches!(question.answer, Answer::Arrow { .. });
        (is_arrow && standing == Standing::Open).then(|| self.degrees())
    }

    /// As the arrow at this step was turned; before, as it was answered.
    fn degrees(&self) -> f64 {
        let here = (self.recording, self.step());
        let turned = self.turned.filter(|(at, _)| *at == here);
        let answered = match self.guesses().last() {
            Some(&Guess::Arrow(degrees)) => degrees,
            _ => ARROW_START,
        };
        turned.map_or(answered, |(_, degrees)| degrees)
    }

    pub(super) fn turn(&mut self, degrees: f64) -> Result<(), Refused> {
        if self.arrow_asked().is_none() {
            return Err(strings::NO_QUESTION.into());
        }
        self.turned = Some(((self.recording, self.step()), degrees));
        Ok(())
    }

    /// The arrow of the question at this step, and the right one once there is a verdict.
    pub(super) fn asked_arrow(&self) -> Option<AskedArrow> {
        let (question, standing) = self.question()?;
        let Answer::Arrow {
            name,
            plane,
            direction,
            ..
        } = question.answer
        else {
            return None;
        };
        Some(AskedArrow {
            field: name,
            point: plane.point,
            own: plane.direction(self.degrees()),
            right: (standing != Standing::Open).then_some(direction),
            is_right: standing == Standing::Right,
        })
    }
}
