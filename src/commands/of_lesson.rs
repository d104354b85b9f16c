//! What commands share that draw the steps of a lesson.

use super::arguments::{
    LimitArguments, languages, method, method_names, parse_range, parse_whole, theme_names,
};
use super::failure::Failure;
use super::files::{self, Document};
use super::notes;
use super::output;
use super::progress::{Progress, named};
use crate::export::{ExportedLesson, Making, TakeAway};
use crate::language::Language;
use crate::lesson::OpenLesson;
use crate::panels::Panel;
use crate::picture::Theme;
use clap::Args;
use std::num::NonZeroUsize;
use std::ops::Range;
use std::path::Path;
use std::thread::available_parallelism;

/// Which lesson, in which language, and which of its steps.
#[derive(Args)]
pub struct LessonArguments {
    /// The id of a lesson, or a lesson file; or a scene file, which is walked through as in the window
    #[arg(value_name = "LESSON_OR_SCENE")]
    lesson: String,
    /// How to draw a scene; a lesson has its own method
    #[arg(long, value_name = "METHOD", value_parser = method_names())]
    method: Option<String>,
    /// Of all words and numbers
    #[arg(long, value_name = "LANGUAGE", default_value = "en", value_parser = languages())]
    language: Language,
    #[command(flatten)]
    limits: LimitArguments,
    #[command(flatten)]
    pub steps: StepsArguments,
}

/// The most steps that one document holds: of pictures of a megabyte each it takes 500.
const MOST_PAGES: usize = 500;

impl LessonArguments {
    /// The lesson, run.
    pub fn open(&self) -> Result<OpenLesson, Failure> {
        let limits = self.limits.into();
        let method = self.method.as_deref().map(method).transpose()?;
        let lesson = match (files::lesson_or_scene(&self.lesson, &limits)?, method) {
            (Document::Lesson(lesson), None) => *lesson,
            (Document::Lesson(_), Some(_)) => {
                let why = "is a lesson, which has its own method; --method is for scenes";
                return Err(files::wrong(&self.lesson, &why));
            }
            (Document::Scene(scene), method) => {
                let walk = files::walk(*scene, &self.lesson)?;
                method.map_or(walk.clone(), |method| walk.by_method(method))
            }
        };
        let open = named("running the lesson", || lesson.open())
            .map_err(|error| files::wrong(&self.lesson, &error))?;
        notes::print(&self.lesson, &open.setup.notes(open.lesson.method));
        Ok(open)
    }

    /// The lesson with what these panels show, rendered on all cores.
    pub fn show(&self, open: OpenLesson, panels: &[Panel]) -> ExportedLesson {
        let threads = available_parallelism().unwrap_or(NonZeroUsize::MIN);
        let rendering = Progress::new("rendering");
        ExportedLesson::new(open, panels, self.language, threads, &|done, all| {
            rendering.show(done, all)
        })
    }

    /// Writes what `make` makes of the lesson and the steps.
    pub fn write_document(
        &self,
        what: TakeAway,
        out: &Path,
        make: impl FnOnce(ExportedLesson, Vec<usize>) -> Making<'static>,
    ) -> Result<(), Failure> {
        output::check_ending("--out", out, what.endings())?;
        output::check_output(out)?;
        let open = self.open()?;
        let steps = self.steps.of(&open)?;
        if steps.len() > MOST_PAGES {
            return Err(Failure::Wrong(format!(
                "{} steps are too many for one file; it holds at most {MOST_PAGES} (--steps, --step)",
                steps.len()
            )));
        }
        let panels = open.lesson.panels.clone();
        let shown = self.show(open, &panels).asking();
        output::write_made(out, "drawing", make(shown, steps))
    }
}

/// Which steps.
#[derive(Args)]
#[group(multiple = false)]
pub struct StepsArguments {
    /// Steps, counted from 0; A is included, B is not
    #[arg(long, value_name = "A..B", allow_hyphen_values = true, value_parser = parse_range)]
    pub steps: Option<Range<usize>>,
    /// One step, counted from 0; may be given several times
    #[arg(long, value_name = "N", allow_hyphen_values = true, value_parser = parse_whole::<usize>)]
    step: Vec<usize>,
    /// The steps at which the lesson says something (this is so unless others are given)
    #[arg(long)]
    narrated: bool,
}

impl StepsArguments {
    /// Ascending, each once.
    pub fn of(&self, open: &OpenLesson) -> Result<Vec<usize>, Failure> {
        let count = open.run.walk().len();
        let within = |option: String, end: usize| match end > count {
            true => Err(Failure::Wrong(format!(
                "{option}: the lesson has {count} steps"
            ))),
            false => Ok(()),
        };
        if let Some(range) = &self.steps {
            let option = format!("--steps {}..{}", range.start, range.end);
            within(option, range.end)?;
            return Ok(range.clone().collect());
        }
        if self.step.is_empty() {
            return Ok(open.narrated.iter().map(|narrated| narrated.step).collect());
        }
        for &step in &self.step {
            within(format!("--step {step}"), step.saturating_add(1))?;
        }
        let mut steps = self.step.clone();
        steps.sort_unstable();
        steps.dedup();
        Ok(steps)
    }
}

/// In which colours.
#[derive(Args)]
pub struct ThemeArgument {
    /// The colours; `projector` is larger, too
    #[arg(long, value_name = "THEME", default_value = "light", value_parser = theme_names())]
    theme: String,
}

impl ThemeArgument {
    pub fn theme(&self) -> Theme {
        // Checked when it was read.
        Theme::from_name(&self.theme).unwrap_or_default()
    }
}
