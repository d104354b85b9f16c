//! The program, run as a user runs it.

#[path = "../common/broken.rs"]
mod broken;
mod broken_files;
mod command_line;
mod compare;
mod compare_room;
mod follow;
#[cfg(unix)]
mod interrupted;
mod json_schema;
mod killed;
mod markup;
mod meshes;
#[cfg(target_os = "linux")]
mod no_room;
mod notes;
mod radiosity;
mod rays;
mod same_files;
mod schemas;
mod stress;
mod study;
mod tables;
mod take_away;

use broken::{GOOD, POT};
use std::fs;
use std::path::Path;
use std::process::{Command, Output};

/// The program in `folder`, with arguments that are apart by spaces, and with no display.
fn command(folder: &Path, arguments: &str) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_lightwalk"));
    command.current_dir(folder).args(arguments.split(' '));
    for display in ["DISPLAY", "WAYLAND_DISPLAY", "WAYLAND_SOCKET"] {
        command.env_remove(display);
    }
    command
}

fn lightwalk(folder: &Path, arguments: &str) -> Output {
    command(folder, arguments).output().unwrap()
}

/// A run that must succeed.
fn succeeded(folder: &Path, arguments: &str) -> Output {
    let output = lightwalk(folder, arguments);
    let message = text(&output.stderr);
    assert_eq!(output.status.code(), Some(0), "{arguments}: {message}");
    output
}

/// The message of a run that refused its file or arguments.
fn refused(output: &Output, case: &str) -> String {
    let message = text(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{case}: {message}");
    assert!(!message.contains("panicked"), "{case}: {message}");
    message
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

/// The names of the files in a folder, sorted.
fn files(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).unwrap();
    let mut names: Vec<String> = entries
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    names
}

/// A folder with the unbroken scene and its mesh.
fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::create_dir(folder.path().join("meshes")).unwrap();
    fs::write(folder.path().join("meshes/pot.obj"), POT).unwrap();
    fs::write(folder.path().join("scene.json"), GOOD).unwrap();
    folder
}
