//! The command line, one file a command. Results go to standard output or the named file, everything else to standard error.
//!
//! Exit status: 0 done; 1 the work failed; 2 a file or an argument is wrong; 130 interrupted.

mod accuracy;
mod animate;
mod arguments;
mod check;
mod compare;
mod compare_room;
mod deck;
mod failure;
#[cfg(feature = "gui")]
mod file_dialog;
mod files;
mod follow;
mod form_factors;
mod frames;
mod handout;
mod hierarchy;
mod interrupt;
#[cfg(feature = "gui")]
mod lesson_folder;
mod list;
mod matrix_difference;
mod needs;
mod notes;
mod of_lesson;
mod open;
mod output;
mod progress;
mod radiosity;
mod render;
mod schema;
mod steps;
mod stress;
mod study;

use clap::{Parser, Subcommand};
use failure::note;
use std::ffi::OsString;
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
    /// Opens the window, on a lesson, a file or a folder of lessons (this is also what happens without a command)
    Open(open::Arguments),
    /// Lists the lessons
    List(list::Arguments),
    /// Validates lesson and scene files
    Check(check::Arguments),
    /// Renders a scene to an image file
    Render(render::Arguments),
    /// Compares a picture, form factors or radiosities of your own program with ours, and names what explains the difference
    Compare(compare::Arguments),
    /// Holds the trace of your own program against the steps of ours, up to the first that differs
    Follow(follow::Arguments),
    /// Finds the form factors of a scene's patches
    FormFactors(form_factors::Arguments),
    /// Solves for the light that a scene's patches exchange
    Radiosity(radiosity::Arguments),
    /// Says what a scene needs, what is left out, why, and what that saves
    Needs(needs::Arguments),
    /// Prints every step of a lesson, or of a scene, as JSON lines or as a table
    Steps(steps::Arguments),
    /// Prints the JSON Schema of scene files, of lesson files, or of printed steps, for editors and other programs
    Schema(schema::Arguments),
    /// Draws the panels of a lesson to PNG or SVG files, without a display
    Frames(frames::Arguments),
    /// Writes a lesson as one HTML file that prints: explanations, pictures, formulas, and questions with room for the answer
    Handout(handout::Arguments),
    /// Writes a lesson as an animated PNG or GIF
    Animate(animate::Arguments),
    /// Writes a lesson as HTML sections, one a slide, for a deck of reveal.js
    Deck(deck::Arguments),
    /// Runs the stiff and extreme cases, each with what was expected, what came out and a verdict
    Stress(stress::Arguments),
    /// Measures error against run time, and how work grows
    Study(study::Arguments),
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
        Command::Compare(arguments) => compare::run(arguments),
        Command::Follow(arguments) => follow::run(arguments),
        Command::FormFactors(arguments) => form_factors::run(arguments),
        Command::Radiosity(arguments) => radiosity::run(arguments),
        Command::Needs(arguments) => needs::run(arguments),
        Command::Steps(arguments) => steps::run(arguments),
        Command::Schema(arguments) => schema::run(arguments),
        Command::Frames(arguments) => frames::run(arguments),
        Command::Handout(arguments) => handout::run(arguments),
        Command::Animate(arguments) => animate::run(arguments),
        Command::Deck(arguments) => deck::run(arguments),
        Command::Stress(arguments) => stress::run(arguments),
        Command::Study(arguments) => study::run(arguments),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            let message = failure.to_string();
            if !message.is_empty() {
                note(format_args!("lightwalk: {message}"));
            }
            ExitCode::from(failure.status())
        }
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
}
