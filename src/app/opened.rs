//! A file that was opened in the window: dropped on it or named on the command line. When it is saved again, it is read again.

use super::session::Session;
use crate::lesson::Lesson;
use std::path::{Path, PathBuf};
use std::time::SystemTime;
use web_time::Duration;

/// Reads a lesson, or a scene or mesh as one. Errors: what is wrong with the file.
pub type ReadDocument = fn(&Path) -> Result<Lesson, String>;

/// How often it is looked whether the file was saved.
pub(super) const LOOK: Duration = Duration::from_millis(500);

/// What reads files, and the file that is shown.
pub(super) struct Opened {
    read: ReadDocument,
    file: Option<(PathBuf, Option<SystemTime>)>,
}

impl Opened {
    pub fn new(read: ReadDocument, path: Option<PathBuf>) -> Self {
        let file = path.map(|path| {
            let saved = saved(&path);
            (path, saved)
        });
        Opened { read, file }
    }

    pub fn has_file(&self) -> bool {
        self.file.is_some()
    }

    /// Opens a file in place of what is shown. Errors: what is wrong with it; nothing has changed then.
    pub fn open(&mut self, session: &mut Session, path: &Path) -> Result<(), String> {
        let saved = saved(path);
        let lesson = (self.read)(path)?;
        session
            .open_document(lesson)
            .map_err(|error| error.to_string())?;
        self.file = Some((path.to_owned(), saved));
        Ok(())
    }

    /// Reads the file again if it was saved since. None where there is nothing new; else what is wrong with it: then the last that was
    /// right stays.
    pub fn look(&mut self, session: &mut Session) -> Option<Result<(), String>> {
        let (path, known) = self.file.as_mut()?;
        let now = saved(path);
        // A file that is being written anew may be gone for a moment.
        if now.is_none() || now == *known {
            return None;
        }
        *known = now;
        let read = (self.read)(path);
        Some(read.and_then(|lesson| session.reload(lesson).map_err(|error| error.to_string())))
    }
}

fn saved(path: &Path) -> Option<SystemTime> {
    std::fs::metadata(path)
        .and_then(|file| file.modified())
        .ok()
}
