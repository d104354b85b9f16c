//! `lightwalk deck`: a lesson as slides for reveal.js.

use super::failure::Failure;
use super::of_lesson::{LessonArguments, ThemeArgument};
use crate::export::{TakeAway, deck};
use std::path::PathBuf;

#[derive(clap::Args)]
pub struct Arguments {
    #[command(flatten)]
    lesson: LessonArguments,
    #[command(flatten)]
    theme: ThemeArgument,
    /// The sections, to be put between `<div class="slides">` and `</div>` of a deck
    #[arg(long, value_name = "FILE.html")]
    out: PathBuf,
}

pub fn run(arguments: Arguments) -> Result<(), Failure> {
    let theme = arguments.theme.theme();
    let write = |shown, steps| deck(shown, steps, theme);
    let lesson = arguments.lesson;
    lesson.write_document(TakeAway::Slides, &arguments.out, write)
}
