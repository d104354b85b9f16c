//! `lightwalk handout`: a lesson on paper.

use super::failure::Failure;
use super::of_lesson::LessonArguments;
use crate::export::{TakeAway, handout};
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
    let (out, answers) = (&arguments.out, arguments.answers);
    let write = |shown, steps| handout(shown, steps, answers);
    arguments
        .lesson
        .write_document(TakeAway::Handout, out, write)
}
