//! `lightwalk open`: the window.

use super::failure::Failure;

#[derive(clap::Args, Default)]
pub struct Arguments {
    /// The id of a lesson, or a lesson, scene or mesh file; the page of all lessons unless given
    lesson: Option<String>,
    /// The step to open it at, counted from 0; where it was left unless given
    #[arg(long, value_name = "N", requires = "lesson")]
    step: Option<usize>,
}

#[cfg(feature = "gui")]
pub fn run(arguments: Arguments) -> Result<(), Failure> {
    use super::files;
    use crate::lesson::builtin;
    use std::path::{Path, PathBuf};
    let path = arguments.lesson.as_ref();
    let path = path
        .filter(|name| builtin(name).is_none())
        .map(PathBuf::from);
    let lesson = match arguments.lesson {
        None => None,
        Some(name) => {
            let lesson = files::to_walk(&name)?;
            // A lesson that does not resolve is a wrong file, whether or not there is a display.
            lesson
                .clone()
                .open()
                .map_err(|error| files::wrong(&name, &error))?;
            Some(lesson)
        }
    };
    let read = |path: &Path| {
        let lesson = files::to_walk(&path.to_string_lossy());
        lesson.map_err(|failure| failure.to_string())
    };
    crate::app::open(lesson, arguments.step, (read, path)).map_err(Failure::Failed)
}

#[cfg(not(feature = "gui"))]
pub fn run(_: Arguments) -> Result<(), Failure> {
    Err(Failure::Failed(
        "this build has no window (feature `gui`); `lightwalk list` and `lightwalk frames LESSON --out DIR` work without one".into(),
    ))
}
