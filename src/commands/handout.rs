//! `lightwalk handout`: a lesson on paper.

use super::failure::Failure;
use super::files;
use super::of_lesson::{LessonArguments, StepsArguments};
use super::progress::Progress;
use crate::export::{Contents, handout};
use std::path::PathBuf;

#[derive(clap::Args)]
pub struct Arguments {
    #[command(flatten)]
    lesson: LessonArguments,
    #[command(flatten)]
    steps: StepsArguments,
    /// With the answers to the questions, on a last page
    #[arg(long)]
    answers: bool,
    /// One file with all that it needs, ready to print
    #[arg(long, value_name = "FILE.html")]
    out: PathBuf,
}

pub fn run(arguments: Arguments) -> Result<(), Failure> {
    files::check_ending("--out", &arguments.out, &["html"])?;
    files::check_output(&arguments.out)?;
    let open = arguments.lesson.open()?;
    let steps = arguments.steps.pages(&open)?;
    let panels = open.lesson.panels.clone();
    let mut shown = arguments.lesson.show(open, &panels).asking();
    let contents = Contents {
        steps: &steps,
        answers: arguments.answers,
    };
    let progress = Progress::new("drawing");
    let page = handout(&mut shown, &contents, &|done| {
        progress.show(done, steps.len())
    });
    files::write_whole(&arguments.out, |out| out.write_all(page.as_bytes()))
}
