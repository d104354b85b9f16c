//! `lightwalk frames`: the panels of a lesson as PNG or SVG files, without a display.

use super::arguments::{panel_names, parse_scale, parse_size};
use super::failure::Failure;
use super::files;
use super::of_lesson::{LessonArguments, ThemeArgument};
use super::output;
use super::progress::Progress;
use crate::export;
use crate::panels::Panel;
use crate::picture::raster_size;
use glam::Vec2;
use std::path::PathBuf;

#[derive(clap::Args)]
pub struct Arguments {
    #[command(flatten)]
    lesson: LessonArguments,
    /// One panel; all of the lesson's panels unless given
    #[arg(long, value_name = "PANEL", value_parser = panel_names())]
    panel: Option<String>,
    /// Of a picture
    #[arg(long, allow_hyphen_values = true, value_parser = parse_size, value_name = "WxH", default_value = "640x480")]
    size: [u32; 2],
    #[command(flatten)]
    theme: ThemeArgument,
    /// SVG files in place of PNG files
    #[arg(long, conflicts_with = "scale")]
    svg: bool,
    /// Of a PNG: pixels to a point, from 1 to 4
    #[arg(long, value_name = "S", allow_negative_numbers = true, value_parser = parse_scale, default_value = "1")]
    scale: f32,
    /// Where the pictures go; it is made if it does not exist
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
}

pub fn run(arguments: Arguments) -> Result<(), Failure> {
    output::check_output_folder(&arguments.out)?;
    let theme = arguments.theme.theme();
    let size = Vec2::from(arguments.size.map(|side| side as f32)) / theme.text_scale();
    let scale = arguments.scale * theme.text_scale();
    raster_size(size, scale).map_err(|error| Failure::Wrong(format!("--size: {error}")))?;
    let open = arguments.lesson.open()?;
    let steps = arguments.lesson.steps.of(&open)?;
    let panels = match arguments.panel.as_deref().and_then(Panel::called) {
        Some(panel) => vec![panel],
        None => open.lesson.panels.clone(),
    };
    let mut shown = arguments.lesson.show(open, &panels);

    std::fs::create_dir_all(&arguments.out).map_err(|error| {
        Failure::Wrong(format!(
            "--out {}: {}",
            arguments.out.display(),
            files::reason(&error)
        ))
    })?;
    let progress = Progress::new("drawing");
    for (done, &step) in steps.iter().enumerate() {
        for &panel in &panels {
            let picture = shown.draw(panel, step, size);
            let title = panel.title().text(shown.language);
            let ending = if arguments.svg { "svg" } else { "png" };
            let made = export::panel(&picture, title, theme, ending, scale)?;
            let name = format!("step-{step:06}-{}.{ending}", panel.name());
            let path = arguments.out.join(name);
            output::write_whole(&path, |out| made.write_all(out, &|_, _| ()))?;
        }
        progress.show(done + 1, steps.len());
    }
    Ok(())
}
