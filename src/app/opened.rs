//! Files that were opened in the window: dropped on it or named on the command line. When one is saved again, it is read again, and
//! so is a folder of lessons.

use super::session::{Choice, FolderOfLessons, Session, is_progress};
use super::strings;
use crate::color::StoredImage;
use crate::language::Message;
use crate::lesson::Lesson;
use crate::scene::document::Problem;
use std::path::{Path, PathBuf};
use std::time::SystemTime;
use web_time::Duration;

/// Reads a text, which may not be saved yet, as what is shown of it; other files are found from the path of its own.
pub type ReadDocument = fn(&Path, &[u8]) -> Result<Lesson, Vec<Problem>>;

/// What reads files. Errors: what is wrong with them, one problem a line.
#[derive(Clone, Copy)]
pub struct Readers {
    /// Reads a lesson, or a scene or mesh as one.
    pub document: fn(&Path) -> Result<Lesson, String>,
    pub folder: fn(&Path) -> Result<FolderOfLessons, String>,
    /// The text of a scene or lesson file.
    pub text: fn(&Path) -> Result<String, String>,
    /// A scene as a walk.
    pub scene: ReadDocument,
    pub lesson: ReadDocument,
    /// Writes a file, whole or not at all.
    pub write: fn(&Path, &[u8]) -> Result<(), String>,
    pub picture: fn(&Path) -> Result<StoredImage, String>,
    /// Asks for a file or folder, and waits for it. None where none is chosen; on a page, where what is chosen arrives like what is dropped.
    /// Errors: why nobody can be asked.
    pub choose: fn(Choice) -> Result<Option<PathBuf>, Message>,
}

/// How often it is looked whether something was saved.
pub(super) const LOOK: Duration = Duration::from_millis(500);

/// When a file was saved; none where it is gone.
type Saved = Option<SystemTime>;

/// The file that is shown, the picture that it is compared with, and the folder whose lessons are listed, each as it was when it was
/// read.
pub(super) struct Opened {
    readers: Readers,
    file: Option<(PathBuf, Saved)>,
    picture: Option<(PathBuf, Saved)>,
    folder: Option<(PathBuf, Vec<(PathBuf, Saved)>)>,
}

impl Opened {
    /// The lessons of the folder were read already.
    pub fn new(readers: Readers, folder: Option<PathBuf>) -> Self {
        let folder = folder.map(|path| {
            let files = files(&path);
            (path, files)
        });
        Opened {
            readers,
            file: None,
            picture: None,
            folder,
        }
    }

    pub fn readers(&self) -> Readers {
        self.readers
    }

    pub fn has_file(&self) -> bool {
        self.file.is_some() || self.picture.is_some() || self.folder.is_some()
    }

    /// Opens a file in place of what is shown, a folder in place of the one that is listed, or a picture beside what is shown; progress is
    /// merged with that here, and what is returned tells of it. Errors: what is wrong with it; nothing has changed then.
    pub fn open(&mut self, session: &mut Session, path: &Path) -> Result<Option<String>, String> {
        if path.is_dir() {
            let files = files(path);
            session.show_folder((self.readers.folder)(path)?);
            session.look.home = true;
            self.folder = Some((path.to_owned(), files));
            return Ok(None);
        }
        if is_picture(path) {
            self.picture = Some((path.to_owned(), saved(path)));
            return self.compare(session, path).map(|()| None);
        }
        if let Some(text) = (self.readers.text)(path)
            .ok()
            .filter(|text| is_progress(text))
        {
            let loaded = session.load_progress(&text);
            return loaded
                .map(Some)
                .map_err(|why| format!("{}: {why}", path.display()));
        }
        let saved = saved(path);
        let lesson = (self.readers.document)(path)?;
        session.open_document(lesson, Some(path.to_owned()))?;
        self.file = Some((path.to_owned(), saved));
        Ok(None)
    }

    fn compare(&self, session: &mut Session, path: &Path) -> Result<(), String> {
        let image = (self.readers.picture)(path)?;
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        let compared = session.compare_with(name.into_owned(), image);
        compared.map_err(|why| why.in_language(session.look.language).to_owned())
    }

    /// Reads again what was saved since: the file that is shown and the picture beside it; on the page of lessons, the folder. None where
    /// nothing new is shown; else what to say of it, or what is wrong with it: the last that was right stays.
    pub fn look(&mut self, session: &mut Session) -> Option<Result<Message, String>> {
        if session.look.home {
            return self.look_into_folder(session).err().map(Err);
        }
        match self.look_at_file(session) {
            None => self.look_at_picture(session),
            looked => looked,
        }
    }

    fn look_at_picture(&mut self, session: &mut Session) -> Option<Result<Message, String>> {
        session.against()?;
        let (path, known) = self.picture.as_mut()?;
        let now = saved(path);
        if now.is_none() || now == *known {
            return None;
        }
        *known = now;
        let path = path.clone();
        let compared = self.compare(session, &path);
        Some(compared.map(|()| strings::PICTURE_READ_AGAIN))
    }

    fn look_at_file(&mut self, session: &mut Session) -> Option<Result<Message, String>> {
        // What is edited is looked after there.
        let path = session.file.clone().filter(|_| !session.is_edited())?;
        let known = match &self.file {
            Some((of, known)) if *of == path => *known,
            // It was opened from the list.
            _ => self
                .saved_when_listed(&path)
                .unwrap_or_else(|| saved(&path)),
        };
        let now = saved(&path);
        // A file that is being written anew may be gone for a moment.
        let is_new = now.is_some() && now != known;
        let read = is_new.then(|| (self.readers.document)(&path));
        self.file = Some((path, now.or(known)));
        let shown = read?.and_then(|lesson| session.reload(lesson));
        Some(shown.map(|()| strings::READ_AGAIN))
    }

    fn look_into_folder(&mut self, session: &mut Session) -> Result<(), String> {
        let Some((path, known)) = &mut self.folder else {
            return Ok(());
        };
        let now = files(path);
        if now != *known {
            *known = now;
            session.show_folder((self.readers.folder)(path)?);
        }
        Ok(())
    }

    fn saved_when_listed(&self, file: &Path) -> Option<Saved> {
        let (_, files) = self.folder.as_ref()?;
        let found = files.iter().find(|(path, _)| path == file);
        found.map(|(_, saved)| *saved)
    }
}

fn is_picture(path: &Path) -> bool {
    let extension = path
        .extension()
        .map(|extension| extension.to_ascii_lowercase());
    extension.is_some_and(|extension| {
        ["png", "ppm", "pfm"]
            .iter()
            .any(|known| extension == *known)
    })
}

fn saved(path: &Path) -> Saved {
    std::fs::metadata(path)
        .and_then(|file| file.modified())
        .ok()
}

/// What is in a folder, by name.
fn files(folder: &Path) -> Vec<(PathBuf, Saved)> {
    let entries = std::fs::read_dir(folder).into_iter().flatten().flatten();
    let mut files: Vec<_> = entries
        .map(|entry| (entry.path(), saved(&entry.path())))
        .collect();
    files.sort();
    files
}
