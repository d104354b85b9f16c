//! What is wrong with a lesson.

use crate::scene::SceneError;
use crate::scene::document::{self, Problem};
use crate::scene::locate::locate;

/// What is wrong with a lesson. Displayed as one problem a line.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{}", document::one_a_line(.problems))]
pub struct LessonError {
    /// One or more.
    pub problems: Vec<Problem>,
}

impl From<Problem> for LessonError {
    fn from(problem: Problem) -> Self {
        LessonError {
            problems: vec![problem],
        }
    }
}

impl From<SceneError> for LessonError {
    fn from(SceneError { problems }: SceneError) -> Self {
        LessonError { problems }
    }
}

impl LessonError {
    /// With line and column of what is wrong in the text of the lesson.
    pub(super) fn located(mut self, text: &[u8]) -> Self {
        locate(text, &mut self.problems);
        self
    }
}

pub(super) fn problem(place: impl Into<String>, message: impl Into<String>) -> Problem {
    Problem {
        place: place.into(),
        line: None,
        column: None,
        message: message.into(),
    }
}
