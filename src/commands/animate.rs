//! `lightwalk animate`: steps of a lesson as an animated picture.

use super::arguments::{panel_names, parse_number, parse_size};
use super::failure::Failure;
use super::of_lesson::{LessonArguments, ThemeArgument};
use super::output;
use crate::export::{Film, SMALLEST_CARD, TakeAway, animation};
use crate::lesson::OpenLesson;
use crate::panels::Panel;
use crate::picture::raster_size;
use crate::replay::{Query, query};
use glam::Vec2;
use std::path::PathBuf;

/// Of all frames together: 3700 frames of 960×600.
const MAX_PIXELS: u64 = 1 << 31;

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
    let out = &arguments.out;
    output::check_ending("--out", out, TakeAway::Explanations.endings())?;
    output::check_output(out)?;
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
    let film = Film {
        panel: chosen,
        size: arguments.size,
        theme,
        seconds: arguments.fps.map(|fps| 1.0 / fps),
        explains: arguments.explains(),
    };
    let shown = arguments.lesson.show(open, &panels);
    let ending = out.extension().and_then(|ending| ending.to_str());
    let film = animation(shown, steps, film, ending.unwrap_or_default())?;
    output::write_made(out, "drawing", film)
}
