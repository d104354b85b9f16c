//! Ctrl-C: a file that is half written goes, and the program ends with status 130.

use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

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

/// Runs `write` while the file of this path counts as unfinished, and then `finish`, which puts it in its place. An
/// interruption finds it either unfinished or done.
pub fn guard<T, R, E>(
    path: &Path,
    write: impl FnOnce() -> Result<T, E>,
    finish: impl FnOnce(T) -> Result<R, E>,
) -> Result<R, E> {
    *unfinished() = Some(path.to_owned());
    let written = write();
    let mut unfinished = unfinished();
    *unfinished = None;
    finish(written?)
}
