//! The lessons of a folder, for the window.

use super::failure::Failure;
use super::files::{self, Document, wrong};
use crate::app::{FolderOfLessons, LessonFromFile};
use crate::lesson::{Lesson, builtin};
use crate::scene::Limits;
use std::collections::HashMap;
use std::fs;
use std::path::{Path, PathBuf};

/// Reads the lessons of a folder, by the names of their files; those in its folders are not looked for. What is wrong with a lesson
/// stands in its place.
///
/// Errors: why the folder cannot be read.
pub fn read(folder: &Path) -> Result<FolderOfLessons, Failure> {
    let unread = |error: std::io::Error| wrong(&folder.display(), &files::reason(&error));
    let entries = fs::read_dir(folder).map_err(unread)?;
    let mut paths = Vec::new();
    for entry in entries {
        let path = entry.map_err(unread)?.path();
        if path
            .extension()
            .is_some_and(|extension| extension == "json")
        {
            paths.push(path);
        }
    }
    paths.sort();
    let mut taken: HashMap<String, PathBuf> = HashMap::new();
    let lessons = paths.into_iter().filter_map(|path| {
        let lesson = match files::document(&path, &Limits::default()) {
            Ok(Document::Scene(_)) => return None,
            Ok(Document::Lesson(lesson)) => Ok(*lesson),
            Err(_) if files::is_scene(&path) => return None,
            Err(failure) => Err(failure.to_string()),
        };
        let lesson = lesson.and_then(|lesson| with_own_id(lesson, &path, &mut taken));
        Some(LessonFromFile { path, lesson })
    });
    Ok(FolderOfLessons {
        name: name(folder),
        lessons: lessons.collect(),
    })
}

/// The lesson, if no other has its id: progress and links go by ids.
fn with_own_id(
    lesson: Lesson,
    path: &Path,
    taken: &mut HashMap<String, PathBuf>,
) -> Result<Lesson, String> {
    let refused = |by: &str| {
        let error = format!(
            "id: found {:?}, which is the id of {by}; choose another",
            lesson.id
        );
        Err(wrong(&path.display(), &error).to_string())
    };
    if builtin(&lesson.id).is_some() {
        return refused("a lesson of the program");
    }
    if let Some(other) = taken.get(&lesson.id) {
        return refused(&other.display().to_string());
    }
    taken.insert(lesson.id.clone(), path.to_owned());
    Ok(lesson)
}

/// What the folder is called, also where its path is `.`.
fn name(folder: &Path) -> String {
    let path = folder.canonicalize().unwrap_or_else(|_| folder.to_owned());
    let name = path.file_name().unwrap_or(path.as_os_str());
    name.to_string_lossy().into_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    const TRIANGLE: &str = include_str!("../../lessons/04-gouraud-triangle.json");

    #[test]
    fn every_lesson_of_a_folder_is_there_also_with_errors_and_no_scene_is() {
        let folder = tempfile::tempdir().unwrap();
        let own = TRIANGLE.replacen("\"gouraud-triangle\"", "\"own\"", 1);
        let scene = r#"{ "schema": 1, "materials": {}, "objects": [], "lights": [] }"#;
        for (name, text) in [
            ("a.json", &own[..]),
            ("b.json", &own),
            ("c.json", TRIANGLE),
            ("d.json", &own.replacen("\"steps\"", "\"stpes\"", 1)),
            ("e.json", &own[..own.len() / 2]),
            ("f.json", scene),
            ("g.json", &scene.replace("objects", "objcts")),
            ("notes.txt", "no lesson"),
        ] {
            fs::write(folder.path().join(name), text).unwrap();
        }
        let read = read(folder.path()).unwrap();
        assert_eq!(
            read.name,
            folder.path().file_name().unwrap().to_string_lossy()
        );
        let found: Vec<(String, String)> = read
            .lessons
            .into_iter()
            .map(|LessonFromFile { path, lesson }| {
                let name = path.file_name().unwrap().to_string_lossy().into_owned();
                (name, lesson.map_or_else(|error| error, |lesson| lesson.id))
            })
            .collect();
        let expected = [
            ("a.json", "own"),
            ("b.json", "id: found \"own\", which is the id of"),
            ("c.json", "which is the id of a lesson of the program"),
            ("d.json", "did you mean steps?"),
            ("e.json", "the file ends here"),
        ];
        assert_eq!(found.len(), expected.len(), "{found:?}");
        for ((name, said), (expected, part)) in found.iter().zip(expected) {
            assert!(name == expected && said.contains(part), "{name}: {said}");
        }
    }
}
