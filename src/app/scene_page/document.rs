//! A scene file that is edited: its text is what counts, and the last scene that was right is what is shown.

use super::super::opened::Readers;
use super::super::session::Session;
use crate::scene::document::{Problem, one_a_line};
use crate::scene::edit::Edit;
use serde_json::Value;
use std::path::PathBuf;
use web_time::{Duration, Instant};

/// Changes of one place that follow each other faster are undone together.
const TOGETHER: Duration = Duration::from_millis(800);

/// The text of a scene file, from its first change to the last.
pub struct Document {
    path: PathBuf,
    readers: Readers,
    text: String,
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
    pub fn open(path: PathBuf, readers: Readers) -> Result<Self, String> {
        let text = (readers.text)(&path)?;
        Ok(Document {
            path,
            readers,
            value: parsed(&text).unwrap_or_default(),
            on_disk: text.clone(),
            text,
            problems: Vec::new(),
            before: Vec::new(),
            undone: Vec::new(),
            last: None,
            selected: "camera".into(),
            in_conflict: false,
        })
    }

    pub fn text(&self) -> &str {
        &self.text
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

    /// Reads the text, and shows its scene where it is right.
    pub fn show(&mut self, session: &mut Session) {
        if let Some(value) = parsed(&self.text) {
            self.value = value;
        }
        let read = (self.readers.scene)(&self.path, self.text.as_bytes());
        self.problems = match read {
            Ok(lesson) => match session.reload(lesson) {
                Ok(()) => Vec::new(),
                Err(message) => vec![Problem {
                    place: String::new(),
                    line: None,
                    column: None,
                    message,
                }],
            },
            Err(problems) => problems,
        };
    }

    /// What is wrong, one problem a line.
    pub fn in_words(&self) -> String {
        one_a_line(&self.problems)
    }

    pub fn edit(&mut self, edit: &Edit, session: &mut Session) {
        if let Some(text) = edit.of(&self.text) {
            let of = match edit {
                Edit::Set(place, _) => place.clone(),
                // Never together with another.
                _ => String::new(),
            };
            self.change(text, of, session);
        }
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
