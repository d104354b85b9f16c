//! The command line, one file a command. Results go to standard output or the named file, everything else to standard error.
//!
//! Exit status: 0 done; 1 the work failed; 2 a file or an argument is wrong; 130 interrupted.

mod check;
mod files;
mod form_factors;
mod frames;
mod interrupt;
mod list;
mod needs;
mod open;
mod progress;
mod radiosity;
mod render;
mod steps;
mod stress;
mod study;

use crate::algorithms::primary::Settings;
use clap::{Args, Parser, Subcommand};
use std::ffi::OsString;
use std::io::Write;
use std::num::NonZeroU32;
use std::process::ExitCode;

/// Walk through classic rendering, step by step, forward and back.
#[derive(Parser)]
#[command(name = "lightwalk", version, about)]
struct CommandLine {
    #[command(subcommand)]
    command: Option<Command>,
}

#[derive(Subcommand)]
enum Command {
    /// Opens the window, on a lesson or on a lesson file (this is also what happens without a command)
    Open(open::Arguments),
    /// Lists the lessons
    List(list::Arguments),
    /// Validates lesson and scene files
    Check(check::Arguments),
    /// Renders a scene to an image file
    Render(render::Arguments),
    /// Finds the form factors of a scene's patches
    FormFactors(form_factors::Arguments),
    /// Solves for the light that a scene's patches exchange
    Radiosity(radiosity::Arguments),
    /// Says what a scene needs, what is left out, why, and what that saves
    Needs(needs::Arguments),
    /// Prints every step of a lesson, or of a scene, as JSON lines
    Steps(steps::Arguments),
    /// Draws the panels of a lesson to PNG files, without a display
    Frames(frames::Arguments),
    /// Runs the stiff and extreme cases, each with what was expected, what came out and a verdict
    Stress(stress::Arguments),
    /// Measures error against run time, and how work grows
    Study(study::Arguments),
}

/// How large a scene may be.
#[derive(Args, Clone, Copy)]
struct LimitArguments {
    /// The most radiosity patches that a scene may ask for
    #[arg(long, value_name = "N", default_value_t = crate::scene::Limits::default().max_patches)]
    max_patches: u64,
    /// The most triangles that its meshes may have
    #[arg(long, value_name = "N", default_value_t = crate::scene::Limits::default().max_triangles)]
    max_triangles: u64,
}

/// How far the ray methods go.
#[derive(Args, Clone, Copy)]
struct RayArguments {
    /// Ray tracing shades rays up to this level; the primary ray is level 1
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = clap::value_parser!(u32).range(1..=i64::from(Settings::DEEPEST)))]
    depth: Option<u32>,
    /// A pixel is the mean of N×N rays
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = clap::value_parser!(u32).range(1..=i64::from(Settings::MOST_SAMPLES)))]
    samples: Option<u32>,
}

impl RayArguments {
    /// What was asked for, and for the rest what `unless` says.
    fn or(self, unless: Settings) -> Settings {
        Settings {
            depth: self.depth.and_then(NonZeroU32::new).unwrap_or(unless.depth),
            samples: self
                .samples
                .and_then(NonZeroU32::new)
                .unwrap_or(unless.samples),
        }
    }

    fn is_given(self) -> bool {
        self.depth.is_some() || self.samples.is_some()
    }
}

impl From<LimitArguments> for crate::scene::Limits {
    fn from(arguments: LimitArguments) -> Self {
        crate::scene::Limits {
            max_patches: arguments.max_patches,
            max_triangles: arguments.max_triangles,
        }
    }
}

/// Why a command did not do what was asked.
#[derive(Debug, thiserror::Error)]
enum Failure {
    /// A file or an argument is wrong: status 2.
    #[error("{0}")]
    Wrong(String),
    /// The work failed: status 1.
    #[error("{0}")]
    Failed(String),
    /// Nobody reads the results any more: no message.
    #[error("")]
    ReaderGone,
}

impl Failure {
    fn status(&self) -> u8 {
        match self {
            Failure::Wrong(_) => 2,
            Failure::Failed(_) | Failure::ReaderGone => 1,
        }
    }
}

/// Writing results to standard output.
impl From<std::io::Error> for Failure {
    fn from(error: std::io::Error) -> Self {
        match error.kind() {
            std::io::ErrorKind::BrokenPipe => Failure::ReaderGone,
            _ => Failure::Failed(format!("cannot write the results: {error}")),
        }
    }
}

/// A line on standard error. Where nobody can read it, the work goes on.
fn tell(line: std::fmt::Arguments) {
    let _ = writeln!(std::io::stderr(), "{line}");
}

/// Carries out a command line, the program's name first.
pub fn run(arguments: impl IntoIterator<Item = OsString>) -> ExitCode {
    let command = match CommandLine::try_parse_from(arguments) {
        Ok(CommandLine { command }) => command.unwrap_or(Command::Open(open::Arguments::default())),
        Err(error) => {
            // Help and version come this way too, with status 0. A terminal that is gone is no reason to fail again.
            let _ = error.print();
            return ExitCode::from(u8::try_from(error.exit_code()).unwrap_or(2));
        }
    };
    if !matches!(command, Command::Open(_)) {
        interrupt::watch();
    }
    let done = match command {
        Command::Open(arguments) => open::run(arguments),
        Command::List(arguments) => list::run(arguments),
        Command::Check(arguments) => check::run(arguments),
        Command::Render(arguments) => render::run(arguments),
        Command::FormFactors(arguments) => form_factors::run(arguments),
        Command::Radiosity(arguments) => radiosity::run(arguments),
        Command::Needs(arguments) => needs::run(arguments),
        Command::Steps(arguments) => steps::run(arguments),
        Command::Frames(arguments) => frames::run(arguments),
        Command::Stress(arguments) => stress::run(arguments),
        Command::Study(arguments) => study::run(arguments),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            let message = failure.to_string();
            if !message.is_empty() {
                tell(format_args!("lightwalk: {message}"));
            }
            ExitCode::from(failure.status())
        }
    }
}

/// `640x480`
fn parse_size(text: &str) -> Result<[u32; 2], String> {
    let sides = text
        .split_once(['x', 'X', '×'])
        .and_then(|(width, height)| Some([width.parse().ok()?, height.parse().ok()?]));
    let Some([width, height]) = sides else {
        return Err("a size is written as 640x480".into());
    };
    let pixels = u64::from(width) * u64::from(height);
    if width == 0
        || height == 0
        || width > crate::render::MAX_SIDE
        || height > crate::render::MAX_SIDE
        || pixels > crate::render::MAX_PIXELS
    {
        return Err(format!(
            "a picture has sides from 1 to {} and at most {} pixels",
            crate::render::MAX_SIDE,
            crate::render::MAX_PIXELS
        ));
    }
    Ok([width, height])
}

/// `3..10`: from 3 up to, but without, 10.
fn parse_range(text: &str) -> Result<std::ops::Range<usize>, String> {
    let ends = text
        .split_once("..")
        .and_then(|(start, end)| Some((start.parse().ok()?, end.parse().ok()?)));
    match ends {
        Some((start, end)) if start < end => Ok(start..end),
        Some(_) => Err("the range is empty; A..B includes A and excludes B".into()),
        None => Err("a range is written as 3..10; it counts from 0".into()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::CommandFactory;

    #[test]
    fn the_command_line_is_well_formed() {
        CommandLine::command().debug_assert();
    }

    #[test]
    fn sizes_and_ranges_are_read_strictly() {
        assert_eq!(parse_size("640x480"), Ok([640, 480]));
        for wrong in [
            "",
            "640",
            "0x5",
            "-1x5",
            "1e9x1",
            "8193x8193",
            "99999999999x1",
            "4294967295x4294967295",
        ] {
            assert!(parse_size(wrong).is_err(), "{wrong}");
        }
        assert_eq!(parse_range("0..3"), Ok(0..3));
        for wrong in ["", "3", "3..3", "4..3", "..", "a..b", "-1..2"] {
            assert!(parse_range(wrong).is_err(), "{wrong}");
        }
    }
}
