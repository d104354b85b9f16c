//! Reading scenes and lessons from files.

use super::failure::{Failure, note};
use super::progress;
use crate::algorithms::prepared_scene::PreparedScene;
use crate::language::suggestion;
use crate::lesson::{Lesson, builtin, builtins, is_lesson};
use crate::methods::{Method, Settings};
use crate::scene::{self, Limits, Scene, document};
use std::fs;
use std::io::Read;
use std::path::{Path, PathBuf};

/// The largest mesh file that is read, in bytes: five million triangles take about 400 MB.
const MAX_MESH_BYTES: u64 = 1 << 30;

/// What a file holds.
pub enum Document {
    Scene(Box<Scene>),
    Lesson(Box<Lesson>),
}

/// Reads a lesson of the program's own by its id, or else a lesson or scene file by its path.
pub fn lesson_or_scene(name: &str, limits: &Limits) -> Result<Document, Failure> {
    match own_lesson(name)? {
        Some(lesson) => Ok(Document::Lesson(lesson.into())),
        None => document(Path::new(name), limits),
    }
}

/// The lesson of the program's own with that id; none where it names a file.
fn own_lesson(name: &str) -> Result<Option<Lesson>, Failure> {
    match builtin(name) {
        Some(lesson) => lesson
            .read()
            .map(Some)
            .map_err(|error| wrong(&name, &error)),
        None if is_an_id(name) => Err(no_such_lesson(name, &[])),
        None => Ok(None),
    }
}

/// Whether that is the id of a lesson, known or not, rather than the path of a file.
pub fn is_an_id(name: &str) -> bool {
    let path = Path::new(name);
    !path.exists() && path.extension().is_none()
}

/// What is said of an id that is neither the program's nor one of the user's `own` lessons.
pub fn no_such_lesson(id: &str, own: &[&str]) -> Failure {
    let ids = builtins().iter().map(|lesson| lesson.id);
    let meant = suggestion(id, ids.chain(own.iter().copied()));
    wrong(
        &id,
        &format!("there is no such lesson or file{meant}; `lightwalk list` lists the lessons"),
    )
}

/// Reads what the window can walk through: a lesson, a scene, or a mesh, which gets a camera and a light; with its path, where it is
/// no lesson of the program's own.
#[cfg(feature = "gui")]
pub fn to_walk(name: &str) -> Result<(Lesson, Option<PathBuf>), Failure> {
    if let Some(lesson) = own_lesson(name)? {
        return Ok((lesson, None));
    }
    let path = Path::new(name);
    let limit = match scene::is_mesh(name) {
        true => MAX_MESH_BYTES,
        false => document::MAX_BYTES as u64,
    };
    let bytes = read_named(path, limit)?;
    let folder = folder_of(path);
    let mut read_file = |name: &str| read_inside(&folder, name);
    let lesson = progress::named(&format!("reading {}", path.display()), || {
        Lesson::of_file(&title(path), &bytes, &mut read_file)
    });
    let lesson = lesson.map_err(|error| wrong(&path.display(), &error))?;
    Ok((lesson, Some(path.to_owned())))
}

/// A walk through a scene, which is called as its file is.
pub fn walk(scene: Scene, name: &str) -> Result<Lesson, Failure> {
    let prepared = PreparedScene::of_size(scene, Lesson::SIZE_OF_A_WALK);
    let prepared = prepared.map_err(|error| wrong(&name, &error))?;
    Ok(Lesson::of_scene(&title(Path::new(name)), prepared))
}

/// A walk through a scene whose text may not be in its file yet.
#[cfg(feature = "gui")]
pub fn edited_scene(path: &Path, text: &[u8]) -> Result<Lesson, Vec<document::Problem>> {
    let folder = folder_of(path);
    let mut read_file = |name: &str| read_inside(&folder, name);
    Lesson::of_scene_text(&title(path), text, &mut read_file)
}

fn title(path: &Path) -> String {
    let name = path.file_name().unwrap_or_default();
    name.to_string_lossy().into_owned()
}

/// A lesson whose text may not be in its file yet.
#[cfg(feature = "gui")]
pub fn edited_lesson(path: &Path, text: &[u8]) -> Result<Lesson, Vec<document::Problem>> {
    let folder = folder_of(path);
    let mut read_file = |name: &str| read_inside(&folder, name);
    let lesson = Lesson::read(text, &Limits::default(), &mut read_file);
    lesson.map_err(|error| error.problems)
}

/// Whether a file can be read and is no lesson.
#[cfg(feature = "gui")]
pub fn is_scene(path: &Path) -> bool {
    read(path, document::MAX_BYTES as u64).is_ok_and(|bytes| !is_lesson(&bytes))
}

/// Reads a lesson or scene file.
pub fn document(path: &Path, limits: &Limits) -> Result<Document, Failure> {
    let bytes = read_named(path, document::MAX_BYTES as u64)?;
    let folder = folder_of(path);
    let mut read_file = |name: &str| read_inside(&folder, name);
    let wrong = |error: &dyn std::fmt::Display| wrong(&path.display(), &error);
    progress::named(&format!("reading {}", path.display()), || {
        match is_lesson(&bytes) {
            true => match Lesson::read(&bytes, limits, &mut read_file) {
                Ok(lesson) => Ok(Document::Lesson(lesson.into())),
                Err(error) => Err(wrong(&error)),
            },
            false => match scene::read(&bytes, limits, &mut read_file) {
                Ok(scene) => Ok(Document::Scene(scene.into())),
                Err(error) => Err(wrong(&error)),
            },
        }
    })
}

/// Reads a file that somebody named.
fn read_named(path: &Path, limit: u64) -> Result<Vec<u8>, Failure> {
    read(path, limit).map_err(|reason| {
        let meant = match path.exists() {
            true => String::new(),
            false => like_it(path),
        };
        wrong(&path.display(), &format!("cannot be read: {reason}{meant}"))
    })
}

/// Reads a text, of at most as many bytes as a scene.
pub fn text(path: &Path) -> Result<String, Failure> {
    let cannot = |reason: &str| wrong(&path.display(), &format!("cannot be read: {reason}"));
    let bytes = read(path, document::MAX_BYTES as u64).map_err(|reason| cannot(&reason))?;
    String::from_utf8(bytes).map_err(|_| cannot("it is not a text in UTF-8"))
}

/// Reads the bytes of a picture or of a table of numbers.
pub fn bytes(path: &Path) -> Result<Vec<u8>, Failure> {
    read(path, MAX_MESH_BYTES)
        .map_err(|reason| wrong(&path.display(), &format!("cannot be read: {reason}")))
}

/// Reads a scene file, or the scene of a lesson file with its settings.
pub fn scene(path: &Path, limits: &Limits) -> Result<(Scene, Settings), Failure> {
    match document(path, limits)? {
        Document::Scene(scene) => Ok((*scene, Settings::default())),
        Document::Lesson(lesson) => Ok((lesson.scene, lesson.settings)),
    }
}

/// A scene in front of its own camera, in a picture of `width`×`height`. Says which objects are left out.
pub fn prepared(
    scene: Scene,
    size: [u32; 2],
    method: Method,
    name: &dyn std::fmt::Display,
) -> Result<PreparedScene, Failure> {
    let prepared = progress::named("dividing the scene into polygons", || {
        PreparedScene::of_size(scene, size)
    });
    let prepared = prepared.map_err(|error| wrong(name, &error))?;
    if method.follows_rays() {
        return Ok(prepared);
    }
    for &object in &prepared.tessellation.skipped {
        let object = &prepared.scene.objects[object].name;
        note(format_args!(
            "lightwalk: {} leaves out the infinite plane \"{object}\"",
            method.name()
        ));
    }
    Ok(prepared)
}

/// A problem with every line under the file's name.
pub fn wrong(file: &dyn std::fmt::Display, error: &dyn std::fmt::Display) -> Failure {
    let lines: Vec<String> = error
        .to_string()
        .lines()
        .map(|line| format!("{file}: {line}"))
        .collect();
    Failure::Wrong(lines.join("\n"))
}

pub fn folder_of(path: &Path) -> PathBuf {
    match path.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent.to_owned(),
        _ => PathBuf::from("."),
    }
}

/// Reads a file that must lie in `folder`, symbolic links followed; or says why it cannot be read.
fn read_inside(folder: &Path, name: &str) -> Result<Vec<u8>, String> {
    let folder = folder.canonicalize().map_err(|error| reason(&error))?;
    let path = folder
        .join(name)
        .canonicalize()
        .map_err(|error| reason(&error))?;
    if !path.starts_with(&folder) {
        return Err(
            "it leads outside the folder of the file that names it; copy it into that folder"
                .into(),
        );
    }
    read(&path, MAX_MESH_BYTES)
}

/// Reads a regular file of at most `limit` bytes; or says why it cannot be read.
fn read(path: &Path, limit: u64) -> Result<Vec<u8>, String> {
    let metadata = fs::metadata(path).map_err(|error| reason(&error))?;
    if !metadata.is_file() {
        return Err("it is not a file".into());
    }
    if metadata.len() > limit {
        return Err(format!(
            "it has {} bytes; at most {limit} are read",
            metadata.len()
        ));
    }
    // The file may have grown since.
    let mut bytes = Vec::new();
    let file = fs::File::open(path).map_err(|error| reason(&error))?;
    file.take(limit)
        .read_to_end(&mut bytes)
        .map_err(|error| reason(&error))?;
    Ok(bytes)
}

/// What may be meant by the path of a file that is not there: a lesson of the program, or a file of the folder with a name like it.
fn like_it(path: &Path) -> String {
    if path.to_str().and_then(builtin).is_some() {
        return "; it is a lesson of the program, and what is read here is a file".into();
    }
    let entries = fs::read_dir(folder_of(path))
        .into_iter()
        .flatten()
        .flatten();
    let names: Vec<String> = entries
        .filter_map(|entry| entry.file_name().into_string().ok())
        .collect();
    let ids = builtins().iter().map(|lesson| lesson.id);
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    suggestion(&name, names.iter().map(String::as_str).chain(ids))
}

pub fn reason(error: &std::io::Error) -> String {
    match error.kind() {
        std::io::ErrorKind::NotFound => "no such file".into(),
        std::io::ErrorKind::PermissionDenied => "no permission to read it".into(),
        std::io::ErrorKind::NotADirectory => "it is not a folder".into(),
        _ => error.to_string(),
    }
}

/// What the processor is called, where the system says it in the place where Linux does.
pub fn processor_name() -> Option<String> {
    let recorded = fs::read_to_string("/proc/cpuinfo").ok()?;
    let line = recorded
        .lines()
        .find(|line| line.starts_with("model name"))?;
    let (_, name) = line.split_once(':')?;
    Some(name.trim().to_string())
}
