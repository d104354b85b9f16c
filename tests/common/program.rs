//! The program, run as a user runs it.

use std::path::Path;
use std::process::{Command, Output};

/// Runs the program in `folder`.
pub fn lightwalk(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_lightwalk"))
        .current_dir(folder)
        .args(arguments)
        .env_remove("DISPLAY")
        .env_remove("WAYLAND_DISPLAY")
        .env_remove("WAYLAND_SOCKET")
        .output()
        .unwrap()
}

pub fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

pub fn refused(output: &Output, case: &str) -> String {
    let message = text(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{case}: {message}");
    assert!(!message.contains("panicked"), "{case}: {message}");
    message
}
