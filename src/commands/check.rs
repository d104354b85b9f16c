//! `lightwalk check`: are these files right?

use super::arguments::LimitArguments;
use super::failure::Failure;
use super::files::{self, Document};
use std::io::Write;
use std::path::PathBuf;

#[derive(clap::Args)]
pub struct Arguments {
    /// Lesson and scene files
    #[arg(required = true, value_name = "FILE")]
    files: Vec<PathBuf>,
    #[command(flatten)]
    limits: LimitArguments,
}

/// Every file is checked, also after a wrong one.
pub fn run(arguments: Arguments) -> Result<(), Failure> {
    let limits = arguments.limits.into();
    let mut problems = Vec::new();
    for path in &arguments.files {
        let checked = files::document(path, &limits).and_then(|document| match document {
            Document::Scene(scene) => Ok(format!(
                "scene, {} objects, {} lights",
                scene.objects.len(),
                scene.lights.len()
            )),
            Document::Lesson(lesson) => {
                let open = lesson
                    .open()
                    .map_err(|error| files::wrong(&path.display(), &error))?;
                Ok(format!(
                    "lesson, {} steps, {} narrated",
                    open.run.walk().len(),
                    open.narrated.len()
                ))
            }
        });
        match checked {
            Ok(summary) => writeln!(std::io::stdout(), "{}: right ({summary})", path.display())?,
            Err(failure) => problems.push(failure.to_string()),
        }
    }
    if problems.is_empty() {
        Ok(())
    } else {
        Err(Failure::Wrong(problems.join("\n")))
    }
}
