//! `lightwalk handout`: a lesson on paper.

use super::failure::Failure;
use super::of_lesson::LessonArguments;
use crate::export::{Contents, handout};
use std::path::PathBuf;

#[derive(clap::Args)]
pub struct Arguments {
    #[command(flatten)]
    lesson: LessonArguments,
    /// With the answers to the questions, on a last page
    #[arg(long)]
    answers: bool,
    /// One file with all that it needs, ready to print
    #[arg(long, value_name = "FILE.html")]
    out: PathBuf,
}

pub fn run(arguments: Arguments) -> Result<(), Failure> {
    let answers = arguments.answers;
    let lesson = arguments.lesson;
    lesson.write_document(&arguments.out, |shown, steps, progress| {
        handout(shown, &Contents { steps, answers }, progress)
    })
}
