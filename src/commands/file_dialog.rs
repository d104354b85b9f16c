//! The system's dialog for files.

use crate::app::Choice;
use crate::language::Message;
use log::{LevelFilter, Log, Metadata, Record};
use rfd::FileDialog;
use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};

/// No dialog answers, or none is there.
const NO_DIALOG: Message = Message("app-no-dialog");

/// What the window opens.
const ENDINGS: [&str; 7] = ["json", "obj", "gltf", "glb", "png", "ppm", "pfm"];

/// Waits for a file or folder. None where none is chosen. Errors: no dialog can be shown.
pub fn choose(choice: Choice) -> Result<Option<PathBuf>, Message> {
    FAILED.store(false, Ordering::Relaxed);
    let dialog = FileDialog::new();
    let chosen = match choice {
        Choice::File => dialog.add_filter("Lightwalk", &ENDINGS).pick_file(),
        Choice::Folder => dialog.pick_folder(),
    };
    match FAILED.load(Ordering::Relaxed) {
        true => Err(NO_DIALOG),
        false => Ok(chosen),
    }
}

/// Whether the dialog has reported an error: it returns none then, as it does where none is chosen.
static FAILED: AtomicBool = AtomicBool::new(false);

/// Hears the errors of the dialog.
struct DialogErrors;

impl Log for DialogErrors {
    fn enabled(&self, metadata: &Metadata) -> bool {
        metadata.target().starts_with("rfd")
    }

    fn log(&self, record: &Record) {
        if self.enabled(record.metadata()) {
            FAILED.store(true, Ordering::Relaxed);
        }
    }

    fn flush(&self) {}
}

/// Begins to hear errors of dialogs.
pub fn hear_errors() {
    if log::set_logger(&DialogErrors).is_ok() {
        log::set_max_level(LevelFilter::Error);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_error_of_the_dialog_is_heard_and_that_of_others_is_not() {
        hear_errors();
        FAILED.store(false, Ordering::Relaxed);
        log::error!(target: "winit", "something else");
        assert!(!FAILED.load(Ordering::Relaxed));
        log::error!(target: "rfd::backend::xdg_desktop_portal", "no dialog");
        assert!(FAILED.load(Ordering::Relaxed));
    }
}
