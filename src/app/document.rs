//! Scene and lesson files that are edited: the text of a file is what counts, and the last that was right is what is shown.

use super::opened::{ReadDocument, Readers};
use super::session::Session;
use crate::scene::document::{Problem, one_a_line};
use crate::scene::edit::Edit;
use serde_json::Value;
use std::collections::HashMap;
use std::path::{Path, PathBuf};
use web_time::{Duration, Instant};

/// Changes of one place that follow each other faster are undone together.
const TOGETHER: Duration = Duration::from_millis(800);

/// How often it is looked whether someone else has changed a file.
pub const LOOK: Duration = Duration::from_millis(500);

/// The text of a file, from its first change to the last.
pub struct Document {
    path: PathBuf,
    readers: Readers,
    /// What the text is read as.
    read: ReadDocument,
    text: String,
    /// The last text that was right.
    right: String,
    /// The file as it was read or saved last.
    on_disk: String,
    /// What the text means as JSON; the last that could be read.
    pub value: Value,
    /// What is wrong with the text.
    pub problems: Vec<Problem>,
    before: Vec<String>,
    undone: Vec<String>,
    /// What was changed last, and when.
    last: Option<(String, Instant)>,
    /// The path of what is looked at.
    pub selected: String,
    /// Whether the file was changed by someone else, so that saving would undo that.
    pub in_conflict: bool,
}

fn parsed(text: &str) -> Option<Value> {
    serde_json::from_str(text.trim_start_matches('\u{feff}')).ok()
}

impl Document {
    /// Errors: why the file cannot be read.
    pub fn open(path: PathBuf, readers: Readers, read: ReadDocument) -> Result<Self, String> {
        let text = (readers.text)(&path)?;
        let on_disk = text.clone();
        Ok(Document {
            on_disk,
            ..Document::new(path, readers, read, text)
        })
    }

    /// One whose file is not there yet.
    pub fn new(path: PathBuf, readers: Readers, read: ReadDocument, text: String) -> Self {
        Document {
            path,
            readers,
            read,
            value: parsed(&text).unwrap_or_default(),
            on_disk: String::new(),
            right: text.clone(),
            text,
            problems: Vec::new(),
            before: Vec::new(),
            undone: Vec::new(),
            last: None,
            selected: String::new(),
            in_conflict: false,
        }
    }

    pub fn path(&self) -> &Path {
        &self.path
    }

    pub fn text(&self) -> &str {
        &self.text
    }

    pub fn right(&self) -> &str {
        &self.right
    }

    pub fn is_saved(&self) -> bool {
        self.text == self.on_disk
    }

    pub fn can_undo(&self) -> bool {
        !self.before.is_empty()
    }

    pub fn can_redo(&self) -> bool {
        !self.undone.is_empty()
    }

    /// Reads the text, and shows it where it is right.
    pub fn show(&mut self, session: &mut Session) {
        if let Some(value) = parsed(&self.text) {
            self.value = value;
        }
        let read = (self.read)(&self.path, self.text.as_bytes());
        self.problems = match read {
            Ok(lesson) => session.replace_document(lesson).err().unwrap_or_default(),
            Err(problems) => problems,
        };
        if self.problems.is_empty() {
            self.right.clone_from(&self.text);
        }
    }

    /// What is wrong, one problem a line.
    pub fn in_words(&self) -> String {
        one_a_line(&self.problems)
    }

    /// Makes changes one after the other, as one.
    pub fn edit(&mut self, edits: &[Edit], session: &mut Session) {
        let text = edits
            .iter()
            .try_fold(self.text.clone(), |text, edit| edit.of(&text));
        if let Some(text) = text {
            let of = match edits {
                [Edit::Set(place, _)] => place.clone(),
                // Never together with another.
                _ => String::new(),
            };
            self.change(text, of, session);
        }
    }

    /// Makes changes that are to leave the text right. Errors: what would be wrong; nothing has changed then.
    pub fn try_to_edit(&mut self, edits: &[Edit], session: &mut Session) -> Result<(), String> {
        let (before, undone) = (self.text.clone(), self.undone.clone());
        self.last = None;
        self.edit(edits, session);
        if self.problems.is_empty() {
            return Ok(());
        }
        let wrong = self.in_words();
        if self.text != before {
            self.undo(session);
            self.undone = undone;
        }
        Err(wrong)
    }

    pub fn write(&mut self, text: String, session: &mut Session) {
        self.change(text, "text".into(), session);
    }

    fn change(&mut self, text: String, of: String, session: &mut Session) {
        if text == self.text {
            return;
        }
        let now = Instant::now();
        let goes_on = self.last.as_ref().is_some_and(|(last, when)| {
            !of.is_empty() && *last == of && now.duration_since(*when) < TOGETHER
        });
        let before = std::mem::replace(&mut self.text, text);
        if !goes_on {
            self.before.push(before);
        }
        self.undone.clear();
        self.last = Some((of, now));
        self.show(session);
    }

    pub fn undo(&mut self, session: &mut Session) {
        if let Some(before) = self.before.pop() {
            self.undone.push(std::mem::replace(&mut self.text, before));
            self.last = None;
            self.show(session);
        }
    }

    pub fn redo(&mut self, session: &mut Session) {
        if let Some(next) = self.undone.pop() {
            self.before.push(std::mem::replace(&mut self.text, next));
            self.last = None;
            self.show(session);
        }
    }

    /// Looks whether someone else has changed the file: where nothing is unsaved, their text is shown.
    pub fn look(&mut self, session: &mut Session) {
        let Ok(there) = (self.readers.text)(&self.path) else {
            return;
        };
        if there == self.on_disk {
            return;
        }
        match self.is_saved() {
            true => self.take_theirs(session),
            false => self.in_conflict = there != self.text,
        }
    }

    /// Puts the file as it is now in place of the text, which can be undone.
    pub fn take_theirs(&mut self, session: &mut Session) {
        if let Ok(there) = (self.readers.text)(&self.path) {
            self.on_disk = there.clone();
            self.in_conflict = false;
            self.change(there, String::new(), session);
        }
    }

    /// Saves the text, whole or not at all; not over what someone else has written since, unless that is wanted. Whether it was saved.
    /// Errors: why it cannot be written.
    pub fn save(&mut self, over_theirs: bool) -> Result<bool, String> {
        let there = (self.readers.text)(&self.path);
        if !over_theirs && there.is_ok_and(|there| there != self.on_disk) {
            self.in_conflict = true;
            return Ok(false);
        }
        (self.readers.write)(&self.path, self.text.as_bytes())?;
        self.on_disk = self.text.clone();
        self.in_conflict = false;
        Ok(true)
    }
}

/// The files that are edited, each with what is not saved yet.
#[derive(Default)]
pub struct Documents {
    all: HashMap<PathBuf, Document>,
    /// The one that was shown last.
    shown: Option<PathBuf>,
    looked: Option<Instant>,
}

impl Documents {
    pub fn has(&self, path: &Path) -> bool {
        self.all.contains_key(path)
    }

    pub fn insert(&mut self, document: Document) {
        self.all.insert(document.path.clone(), document);
    }

    /// The document of a file, shown in the session when it was not shown before; now and then it is looked whether someone else has
    /// changed the file.
    pub fn show(&mut self, path: &Path, session: &mut Session) -> Option<&mut Document> {
        let document = self.all.get_mut(path)?;
        let now = Instant::now();
        if self.shown.as_deref() != Some(path) {
            self.shown = Some(path.to_owned());
            document.show(session);
        } else if self
            .looked
            .is_none_or(|when| now.duration_since(when) >= LOOK)
        {
            self.looked = Some(now);
            document.look(session);
        }
        Some(document)
    }

    /// Those with changes that are not saved, by their paths.
    pub fn unsaved(&self) -> Vec<&Document> {
        let all = self.all.values();
        let mut unsaved: Vec<&Document> = all.filter(|document| !document.is_saved()).collect();
        unsaved.sort_by(|a, b| a.path.cmp(&b.path));
        unsaved
    }

    pub fn unsaved_mut(&mut self) -> impl Iterator<Item = &mut Document> {
        let all = self.all.values_mut();
        all.filter(|document| !document.is_saved())
    }

    /// Nothing of them is shown any more.
    pub fn close(&mut self) {
        self.shown = None;
    }

    /// Takes the last change of the file that is shown back, or makes it again.
    pub fn go_back(&mut self, session: &mut Session, again: bool) {
        let path = session.file.clone();
        let document = path.and_then(|path| self.all.get_mut(&path));
        match document {
            Some(document) if again => document.redo(session),
            Some(document) => document.undo(session),
            None => {}
        }
    }

    #[cfg(test)]
    pub fn only(&mut self) -> &mut Document {
        self.all.values_mut().next().expect("a document")
    }
}
