//! `lightwalk deck`: a lesson as slides for reveal.js.

use super::failure::Failure;
use super::files;
use super::of_lesson::{LessonArguments, StepsArguments, ThemeArgument};
use super::progress::Progress;
use crate::export::deck;
use std::path::PathBuf;

#[derive(clap::Args)]
pub struct Arguments {
    #[command(flatten)]
    lesson: LessonArguments,
    #[command(flatten)]
    steps: StepsArguments,
    #[command(flatten)]
    theme: ThemeArgument,
    /// The sections, to be put between `<div class="slides">` and `</div>` of a deck
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
    let theme = arguments.theme.theme();
    let progress = Progress::new("drawing");
    let show = |done| progress.show(done, steps.len());
    let slides = deck(&mut shown, &steps, theme, &show);
    files::write_whole(&arguments.out, |out| out.write_all(slides.as_bytes()))
}
