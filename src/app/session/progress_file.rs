//! Progress as one file, to be taken to another computer or browser: how far the lessons have come, and the scenes of one's own.
//!
//! Loading it merges, and takes nothing away. Of a lesson the progress stays that has reached more explanations, the one here where both
//! have reached as many, with its place; answers to questions that only the other one has are added. A scene whose name is taken by
//! another one gets a number.

use super::{Progress, Session};
use crate::app::strings;
use crate::lesson::Lesson;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// The file as it is written. What it is stands at its beginning.
#[derive(Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
struct Contents {
    lightwalk: String,
    schema: u32,
    /// By the lessons' ids.
    lessons: BTreeMap<String, Progress>,
    /// Packed as in an address, by their names.
    scenes: BTreeMap<String, String>,
}

const KIND: &str = "progress";
const SCHEMA: u32 = 1;

/// Whether a text begins as such a file does, be it whole or not.
pub fn is_progress(text: &str) -> bool {
    let text = text.trim_start_matches('\u{feff}').trim_start();
    let inside = text.strip_prefix('{').map(str::trim_start);
    inside.is_some_and(|inside| inside.starts_with("\"lightwalk\""))
}

impl Session {
    /// All progress, as a file has it.
    pub fn progress_file(&mut self) -> Result<Vec<u8>, serde_json::Error> {
        self.note_progress();
        self.note_scene();
        serde_json::to_vec_pretty(&Contents {
            lightwalk: KIND.into(),
            schema: SCHEMA,
            lessons: self.progress.clone(),
            scenes: self.scenes.clone(),
        })
    }

    /// Merges the progress of a file with that here, and returns what to say of it. Errors: what is wrong with the file; nothing has
    /// changed then.
    pub fn load_progress(&mut self, text: &str) -> Result<String, String> {
        let language = self.look.language;
        let damaged = |why: String| strings::PROGRESS_DAMAGED.format(language, &[("why", &why)]);
        let text = text.trim_start_matches('\u{feff}');
        let found: Contents =
            serde_json::from_str(text).map_err(|error| damaged(error.to_string()))?;
        if found.lightwalk != KIND || found.schema != SCHEMA {
            return Err(self.localize(strings::PROGRESS_FOREIGN).to_owned());
        }
        for (name, packed) in &found.scenes {
            Lesson::of_packed_scene(name, packed)
                .map_err(|why| damaged(format!("{name}: {why}")))?;
        }
        self.note_progress();
        self.note_scene();
        let counts = [found.lessons.len(), found.scenes.len()].map(|count| count.to_string());
        for (id, there) in found.lessons {
            let here = self.progress.remove(&id).unwrap_or_default();
            self.progress.insert(id, merged(here, there));
        }
        for (name, packed) in found.scenes {
            let is_free = |name: &String| match self.scenes.get(name) {
                Some(taken) => *taken == packed,
                None => true,
            };
            let mut names = (2..).map(|number| format!("{name} ({number})"));
            let free = match is_free(&name) {
                true => Some(name),
                false => names.find(is_free),
            };
            self.scenes.extend(free.map(|name| (name, packed)));
        }
        self.resume();
        let counted = [("lessons", counts[0].as_str()), ("scenes", &counts[1])];
        Ok(strings::PROGRESS_LOADED.format(language, &counted))
    }

    /// The names of the scenes of one's own that were walked through.
    pub fn own_scenes(&self) -> impl Iterator<Item = &str> {
        self.scenes.keys().map(String::as_str)
    }

    /// Walks through a scene that was kept.
    pub(super) fn open_own_scene(&mut self, name: &str) -> Result<(), String> {
        let packed = self.scenes.get(name).cloned().unwrap_or_default();
        self.open_document(Lesson::of_packed_scene(name, &packed)?, None)
    }

    /// Keeps the scene that is walked through, where it is from a file, and whole in itself and short enough for an address.
    pub(super) fn note_scene(&mut self) {
        let lesson = &self.open.lesson;
        let is_shown = lesson.is_free_walk() && !self.is_on_page();
        let packed = lesson.packed.as_ref().filter(|_| is_shown);
        if let (Some(packed), Some(file)) = (packed, &self.file) {
            let name = file.file_name().unwrap_or_default().to_string_lossy();
            self.scenes.insert(name.into_owned(), packed.to_string());
        }
    }
}

fn merged(here: Progress, there: Progress) -> Progress {
    let (mut further, other) = match there.reached > here.reached {
        true => (there, here),
        false => (here, there),
    };
    for (index, standing) in other.answers {
        if further.answers.contains_key(&index) {
            continue;
        }
        further.answers.insert(index, standing);
        if let Some(guesses) = other.guesses.get(&index) {
            further.guesses.insert(index, guesses.clone());
        }
    }
    further
}
