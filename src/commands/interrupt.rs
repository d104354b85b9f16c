//! Ctrl-C: a file that is half written goes, and the program ends with status 130.

use std::path::PathBuf;
use std::sync::{Mutex, MutexGuard, PoisonError};
use tempfile::NamedTempFile;

/// The file that is being written under a temporary name.
static UNFINISHED: Mutex<Option<PathBuf>> = Mutex::new(None);

fn unfinished() -> MutexGuard<'static, Option<PathBuf>> {
    // The path inside is whole whatever happened to the thread that held the lock.
    UNFINISHED.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Takes Ctrl-C from now on. Where the system does not let it, Ctrl-C ends the program as it ends any other.
pub fn watch() {
    let _ = ctrlc::set_handler(|| {
        if let Some(path) = unfinished().take() {
            let _ = std::fs::remove_file(path);
        }
        std::process::exit(130);
    });
}

/// Makes a file and runs `write` on it, while it counts as unfinished, and then `finish`, which puts it in its place. An interruption
/// finds it not begun, unfinished or done.
pub fn guard<T, R, E>(
    make: impl FnOnce() -> Result<NamedTempFile, E>,
    write: impl FnOnce(NamedTempFile) -> Result<T, E>,
    finish: impl FnOnce(T) -> Result<R, E>,
) -> Result<R, E> {
    let made = {
        let mut unfinished = unfinished();
        let made = make()?;
        *unfinished = Some(made.path().to_owned());
        made
    };
    let written = write(made);
    let mut unfinished = unfinished();
    *unfinished = None;
    finish(written?)
}

/// Does what no interruption comes into.
pub fn whole<T>(work: impl FnOnce() -> T) -> T {
    let _unfinished = unfinished();
    work()
}
