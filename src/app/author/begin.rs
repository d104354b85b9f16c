//! Where a lesson begins: from a scene that is walked through, with the step that is shown as its first explanation, or as a copy of
//! another lesson.

use super::super::document::Document;
use super::super::opened::Readers;
use super::super::session::Session;
use super::super::{prose, style};
use super::form::{button, named};
use super::strings;
use crate::lesson::anchor;
use crate::lesson::draft::{self, Draft};
use crate::picture::Ink;
use egui::{TextEdit, Ui};
use std::path::{Path, PathBuf};

/// What the file is to be called.
#[derive(Default)]
pub struct Begin {
    /// As it was typed, for what.
    name: Option<(String, String)>,
}

impl Begin {
    /// Asks for the name of the file; returns the lesson once it begins. Errors: why that cannot be its name.
    pub fn show(
        &mut self,
        session: &Session,
        readers: Readers,
        unsaved: &[&Document],
        ui: &mut Ui,
    ) -> Result<Option<Document>, String> {
        let language = session.look.language;
        let folder = folder(session);
        let of = stem(session);
        let is_taken = |name: &str| {
            let path = folder.join(name);
            path.exists() || unsaved.iter().any(|document| document.path() == path)
        };
        if self.name.as_ref().is_none_or(|(known, _)| *known != of) {
            self.name = Some((of.clone(), free_name(&of, is_taken)));
        }
        let name = self.name.as_mut().map(|(_, name)| name);
        let Some(name) = name else { return Ok(None) };
        let what = match session.lesson().is_free_walk() {
            true => strings::FROM_A_WALK,
            false => strings::FROM_A_LESSON,
        };
        ui.label(prose::prose(
            session,
            session.localize(what),
            14.0,
            Ink::Text,
        ));
        ui.label(style::strong(session.localize(strings::FILE), 13.0));
        let edit = TextEdit::singleline(name).desired_width(f32::INFINITY);
        let response = ui.add(edit);
        named(&response, session.localize(strings::FILE), name);
        let shown = folder.display().to_string();
        let inside = strings::IN_FOLDER.format(language, &[("folder", &shown)]);
        ui.label(prose::prose(session, &inside, 12.5, Ink::Muted));
        // Its selector is found in this run, and its scene is that of the file.
        let otherwise = session.runs_otherwise().map(|why| session.localize(why));
        if !button(session, strings::BEGIN, otherwise, ui) {
            return Ok(None);
        }
        let Some(id) = id_of(name) else {
            return Err(session.localize(strings::FILE_NAME).to_owned());
        };
        let path = folder.join(&*name);
        if is_taken(name) {
            return Err(session.localize(strings::FILE_EXISTS).to_owned());
        }
        let number = session.own_lessons().map_or(0, |(_, own)| own.len()) as u32 + 1;
        let text = match session.lesson().is_free_walk() {
            true => new_lesson(session, &id, number),
            false => session.lesson().copied(&id, number).unwrap_or_default(),
        };
        Ok(Some(Document::new(path, readers, readers.lesson, text)))
    }
}

/// Where the file will lie: beside the scene, or where the program was started.
fn folder(session: &Session) -> PathBuf {
    let file = session.file.as_deref().and_then(Path::parent);
    let named = file.filter(|folder| !folder.as_os_str().is_empty());
    named.unwrap_or(Path::new(".")).to_owned()
}

/// Of the scene's file, or the lesson's id.
fn stem(session: &Session) -> String {
    let stem = session.file.as_deref().and_then(Path::file_stem);
    match stem {
        Some(stem) => stem.to_string_lossy().into_owned(),
        None => session.lesson().id.clone(),
    }
}

fn free_name(of: &str, is_taken: impl Fn(&str) -> bool) -> String {
    let names = (1..).map(|number| match number {
        1 => format!("{of}-lesson.json"),
        _ => format!("{of}-lesson-{number}.json"),
    });
    names
        .take(1000)
        .find(|name| !is_taken(name))
        .unwrap_or_default()
}

/// The id of a lesson in a file of that name; none where no lesson's file is called so.
fn id_of(name: &str) -> Option<String> {
    let stem = name.strip_suffix(".json")?;
    let has_folder = stem.contains(['/', '\\', ':']) || stem.starts_with('.');
    let plain = |c: char| match c.to_ascii_lowercase() {
        c if c.is_ascii_lowercase() || c.is_ascii_digit() => c,
        _ => '-',
    };
    let id: String = stem.chars().map(plain).collect();
    let id = id.trim_matches('-').to_owned();
    (!has_folder && !id.is_empty()).then_some(id)
}

/// A lesson of one explanation, at the step that is shown.
fn new_lesson(session: &Session, id: &str, number: u32) -> String {
    let language = session.look.language;
    let file = session.file.as_deref().and_then(Path::file_name);
    let scene_file = file.unwrap_or_default().to_string_lossy();
    let walk = session.lesson();
    let scene = stem(session);
    let name = [("scene", scene.as_str())];
    let at = anchor::selector(session.walk(), session.step());
    let [title, say] = session.step_for_a_lesson(session.step(), language);
    let first = walk.panels.first().copied();
    let key = session.key_panel().filter(|&key| Some(key) != first);
    let draft = Draft {
        id,
        number,
        language,
        title: &strings::NEW_TITLE.format(language, &name),
        summary: &strings::NEW_SUMMARY.format(language, &name),
        scene_file: &scene_file,
        walk,
        focus: session.focus(),
        step: draft::step(&at, language, &title, &say, key),
    };
    draft.text()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_id_of_a_lesson_is_made_of_its_files_name() {
        for (name, id) in [
            ("mirrors.json", Some("mirrors")),
            ("Two Mirrors.json", Some("two-mirrors")),
            ("mirrors", None),
            (".json", None),
            ("../mirrors.json", None),
            ("a/b.json", None),
        ] {
            assert_eq!(id_of(name).as_deref(), id, "{name}");
        }
    }
}
