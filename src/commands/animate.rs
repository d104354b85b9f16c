//! `lightwalk animate`: steps of a lesson as an animated picture.

use super::arguments::{panel_names, parse_number, parse_size};
use super::failure::Failure;
use super::of_lesson::{LessonArguments, ThemeArgument};
use super::output;
use super::progress::Progress;
use crate::color::{Animation, AnimationFormat};
use crate::export::{ExportedLesson, SMALLEST_CARD, card, reading_seconds};
use crate::lesson::OpenLesson;
use crate::panels::Panel;
use crate::picture::{raster_size, rasterize, to_rgb8};
use crate::replay::{Query, query};
use glam::Vec2;
use std::io;
use std::path::{Path, PathBuf};

/// Of all frames together: 3700 frames of 960×600.
const MAX_PIXELS: u64 = 1 << 31;
/// Frames a second where nothing is read.
const FPS: f64 = 5.0;
/// How long the last frame is shown at least, in seconds, before the first comes again.
const LAST: f64 = 2.0;

#[derive(clap::Args)]
pub struct Arguments {
    #[command(flatten)]
    lesson: LessonArguments,
    /// Only steps that are like this, written as a lesson's `at`: `Iteration` shows radiosity converging
    #[arg(long, value_name = "QUERY", conflicts_with_all = ["step", "narrated"])]
    at: Option<Query>,
    /// The panel; unless given, the one that is explained, or the lesson's first
    #[arg(long, value_name = "PANEL", value_parser = panel_names())]
    panel: Option<String>,
    #[arg(long, allow_hyphen_values = true, value_parser = parse_size, value_name = "WxH", default_value = "960x600")]
    size: [u32; 2],
    /// Frames a second, from 0.1 to 50; unless given, explanations stay as long as reading takes, and there are 5 of other steps
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = parse_fps)]
    fps: Option<f64>,
    #[command(flatten)]
    theme: ThemeArgument,
    /// FILE.png (APNG) or FILE.gif
    #[arg(long, value_name = "FILE")]
    out: PathBuf,
}

fn parse_fps(text: &str) -> Result<f64, String> {
    let fps = parse_number(text)
        .ok()
        .filter(|fps| (0.1..=50.0).contains(fps));
    fps.ok_or_else(|| "allowed are numbers from 0.1 to 50".into())
}

impl Arguments {
    /// Whether frames have the words of their steps.
    fn explains(&self) -> bool {
        self.at.is_none() && self.lesson.steps.steps.is_none()
    }

    fn steps(&self, open: &OpenLesson) -> Result<Vec<usize>, Failure> {
        let Some(at) = &self.at else {
            return self.lesson.steps.of(open);
        };
        let walk = open.run.walk();
        let range = match &self.lesson.steps.steps {
            Some(_) => {
                let steps = self.lesson.steps.of(open)?;
                steps[0]..steps[steps.len() - 1] + 1
            }
            None => 0..walk.len(),
        };
        let steps: Vec<usize> = query::matches(walk, at, range).collect();
        match steps.is_empty() {
            false => Ok(steps),
            true => {
                let kinds = query::kinds(walk).into_iter().map(|(kind, _)| kind);
                let kinds = kinds.collect::<Vec<_>>().join(", ");
                Err(Failure::Wrong(format!(
                    "--at \"{at}\": no step is like this; the run has steps of the kinds {kinds}"
                )))
            }
        }
    }
}

pub fn run(arguments: Arguments) -> Result<(), Failure> {
    let format = format(&arguments.out)?;
    output::check_output(&arguments.out)?;
    let theme = arguments.theme.theme();
    let scale = theme.text_scale();
    let [width, height] = arguments.size;
    let size = Vec2::new(width as f32, height as f32) / scale;
    let named =
        |why: &dyn std::fmt::Display| Failure::Wrong(format!("--size {width}x{height}: {why}"));
    raster_size(size, scale).map_err(|error| named(&error))?;
    let least = SMALLEST_CARD.map(|side| (side as f32 * scale) as u32);
    if arguments.explains() && (width < least[0] || height < least[1]) {
        let [width, height] = least;
        return Err(named(&format!(
            "an explanation has no room there; the least is {width}x{height}"
        )));
    }
    let open = arguments.lesson.open()?;
    let steps = arguments.steps(&open)?;
    let most = MAX_PIXELS / (u64::from(width) * u64::from(height));
    if steps.len() as u64 > most {
        return Err(named(&format!(
            "{} frames are too many; of this size there may be {most}",
            steps.len()
        )));
    }
    let chosen = arguments.panel.as_deref().and_then(Panel::called);
    let panels = match chosen {
        Some(panel) => vec![panel],
        None => open.lesson.panels.clone(),
    };
    let mut shown = arguments.lesson.show(open, &panels);
    let progress = Progress::new("drawing");
    output::write_whole(&arguments.out, |out| {
        let size_in_pixels = arguments.size;
        let count = steps.len() as u32;
        let mut animation = Animation::new(format, size_in_pixels, count, out)?;
        for (done, &step) in steps.iter().enumerate() {
            let place = [done, steps.len()];
            let (picture, seconds) = frame(&mut shown, &arguments, chosen, step, place, size);
            let pixmap = rasterize(&picture, theme, scale).map_err(io::Error::other)?;
            animation.frame(to_rgb8(&pixmap), seconds)?;
            progress.show(done + 1, steps.len());
        }
        animation.finish()
    })
}

/// The picture of a step, and how long it is shown.
fn frame(
    shown: &mut ExportedLesson,
    arguments: &Arguments,
    chosen: Option<Panel>,
    step: usize,
    place: [usize; 2],
    size: Vec2,
) -> (crate::picture::Picture, f64) {
    let mut page = shown.page(step);
    let (picture, seconds) = match arguments.explains() {
        true => {
            page.panel = chosen.unwrap_or(page.panel);
            (card(shown, &page, place, size), reading_seconds(&page))
        }
        false => {
            let panel = chosen.unwrap_or(shown.open.lesson.panels[0]);
            (shown.draw(panel, step, size), 1.0 / FPS)
        }
    };
    let seconds = arguments.fps.map_or(seconds, |fps| 1.0 / fps);
    match place[0] + 1 == place[1] {
        true => (picture, seconds.max(LAST)),
        false => (picture, seconds),
    }
}

fn format(out: &Path) -> Result<AnimationFormat, Failure> {
    output::check_ending("--out", out, &["png", "gif"])?;
    Ok(
        match out.extension().is_some_and(|ending| ending == "gif") {
            true => AnimationFormat::Gif,
            false => AnimationFormat::Png,
        },
    )
}
