//! `lightwalk open`: the window.

use super::failure::Failure;

#[derive(clap::Args, Default)]
pub struct Arguments {
    /// The id of a lesson, or a lesson file; the page of all lessons unless given
    lesson: Option<String>,
    /// The step to open it at, counted from 0; where it was left unless given
    #[arg(long, value_name = "N", requires = "lesson")]
    step: Option<usize>,
}

#[cfg(feature = "gui")]
pub fn run(arguments: Arguments) -> Result<(), Failure> {
    use super::files::{self, Document};
    use crate::scene::Limits;
    let lesson = match arguments.lesson {
        None => None,
        Some(name) => match files::lesson_or_scene(&name, &Limits::default())? {
            Document::Lesson(lesson) => {
                // A lesson that does not resolve is a wrong file, whether or not there is a display.
                lesson
                    .clone()
                    .open()
                    .map_err(|error| files::wrong(&name, &error))?;
                Some(*lesson)
            }
            Document::Scene(_) => {
                return Err(Failure::Wrong(format!(
                    "{name}: is a scene; the window opens lessons"
                )));
            }
        },
    };
    crate::app::open(lesson, arguments.step).map_err(Failure::Failed)
}

#[cfg(not(feature = "gui"))]
pub fn run(_: Arguments) -> Result<(), Failure> {
    Err(Failure::Failed(
        "this build has no window (feature `gui`); `lightwalk list` and `lightwalk frames LESSON --out DIR` work without one".into(),
    ))
}
