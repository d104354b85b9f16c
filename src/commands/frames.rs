//! `lightwalk frames`: the panels of a lesson as PNG files, without a display.

use super::arguments::{LimitArguments, parse_range, parse_size};
use super::failure::Failure;
use super::files::{self, Document};
use super::notes;
use super::progress::Progress;
use crate::algorithms::enclosure;
use crate::panels::strings::Language;
use crate::panels::{Panel, PanelInput, draw};
use crate::picture::{Theme, rasterize, to_png};
use crate::render::compare::compare;
use crate::render::{Finished, race, render, smooth_patches};
use glam::Vec2;
use std::num::NonZeroUsize;
use std::ops::Range;
use std::path::PathBuf;

#[derive(clap::Args)]
pub struct Arguments {
    /// The id of a lesson, or a lesson file
    lesson: String,
    /// Steps, counted from 0; A is included, B is not
    #[arg(long, value_name = "A..B", allow_hyphen_values = true, value_parser = parse_range, conflicts_with = "narrated")]
    steps: Option<Range<usize>>,
    /// The steps at which the lesson says something (this is so unless --steps is given)
    #[arg(long)]
    narrated: bool,
    /// One panel; all of the lesson's panels unless given
    #[arg(long, value_name = "PANEL", value_parser = panel_names())]
    panel: Option<String>,
    /// Of a picture
    #[arg(long, allow_hyphen_values = true, value_parser = parse_size, value_name = "WxH", default_value = "640x480")]
    size: [u32; 2],
    /// Where the pictures go; it is made if it does not exist
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
    #[command(flatten)]
    limits: LimitArguments,
}

fn panel_names() -> clap::builder::PossibleValuesParser {
    Panel::ALL.map(Panel::name).into()
}

pub fn run(arguments: Arguments) -> Result<(), Failure> {
    files::check_output_folder(&arguments.out)?;
    let Document::Lesson(lesson) =
        files::lesson_or_scene(&arguments.lesson, &arguments.limits.into())?
    else {
        return Err(Failure::Wrong(format!(
            "{}: is a scene; frames are drawn of a lesson",
            arguments.lesson
        )));
    };
    let mut open = lesson
        .open()
        .map_err(|error| files::wrong(&arguments.lesson, &error))?;
    notes::print(&arguments.lesson, &open.setup.notes(open.lesson.method));
    let narrated: Vec<usize> = open.narrated.iter().map(|narrated| narrated.step).collect();
    let steps: Vec<usize> = match arguments.steps {
        None => narrated.clone(),
        Some(range) => {
            let count = open.run.walk().len();
            if range.end > count {
                return Err(Failure::Wrong(format!(
                    "--steps {}..{}: the lesson has {count} steps",
                    range.start, range.end
                )));
            }
            range.collect()
        }
    };
    let panels = match arguments.panel.as_deref().and_then(Panel::called) {
        Some(panel) => vec![panel],
        None => open.lesson.panels.clone(),
    };
    let threads = std::thread::available_parallelism().unwrap_or(NonZeroUsize::MIN);
    let rendering = Progress::new("rendering");
    let picture = render(&open.setup, open.lesson.method, threads, &|done, all| {
        rendering.show(done, all)
    });
    drop(rendering);
    let mut finished = Finished::new(picture, &open.setup.prepared.scene.lights);
    if panels.contains(&Panel::Race) {
        finished.race = race(&open.setup);
    }
    let methods = open
        .lesson
        .compare
        .iter()
        .filter(|_| panels.iter().any(|panel| panel.compares()));
    finished.compared = methods
        .map(|&method| compare(&open.setup, method))
        .collect();

    std::fs::create_dir_all(&arguments.out).map_err(|error| {
        Failure::Wrong(format!(
            "--out {}: {}",
            arguments.out.display(),
            files::reason(&error)
        ))
    })?;
    let radiosity: enclosure::Settings = open.setup.settings.get();
    let progress = Progress::new("drawing");
    for (done, &step) in steps.iter().enumerate() {
        open.run.walk_mut().seek(step);
        let input = PanelInput {
            narrated: &narrated,
            smooth: radiosity.smooth.then_some(smooth_patches),
            ..PanelInput::of(&open.run, &finished, open.lesson.focus, Language::English)
        };
        let [width, height] = arguments.size.map(|side| side as f32);
        for &panel in &panels {
            let picture = draw(panel, &input, Vec2::new(width, height));
            let pixmap = rasterize(&picture, Theme::Light, 1.0)
                .map_err(|error| Failure::Wrong(format!("--size: {error}")))?;
            let path = arguments
                .out
                .join(format!("step-{step:06}-{}.png", panel.name()));
            files::write_whole(&path, |writer| writer.write_all(&to_png(&pixmap)))?;
        }
        progress.show(done + 1, steps.len());
    }
    Ok(())
}
