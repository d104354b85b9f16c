//! The lessons that come with the program: `build.rs` lists the files of `lessons/`, which are embedded in the binary.

use super::{Lesson, LessonError};
use crate::scene::Limits;

/// A lesson of the program's own.
#[derive(Clone, Copy, Debug)]
pub struct Builtin {
    pub id: &'static str,
    json: &'static str,
}

macro_rules! lessons {
    ($($_name:ident $id:literal $path:literal,)*) => {
        /// In the order of their numbers.
        const BUILTINS: &[Builtin] = &[$(Builtin { id: $id, json: include_str!($path) }),*];
    };
}
include!(concat!(env!("OUT_DIR"), "/lessons.rs"));

/// The meshes and scenes that they may name, by path relative to them.
const FILES: &[(&str, &[u8])] = include!(concat!(env!("OUT_DIR"), "/lesson_files.rs"));

/// All of them, in the order of their numbers.
pub fn builtins() -> &'static [Builtin] {
    BUILTINS
}

/// The lesson of this id.
pub fn builtin(id: &str) -> Option<Builtin> {
    BUILTINS.iter().copied().find(|lesson| lesson.id == id)
}

impl Builtin {
    /// Errors: none for a lesson that passed the tests.
    pub fn read(self) -> Result<Lesson, LessonError> {
        Lesson::read(self.json.as_bytes(), &Limits::default(), &mut |path| {
            let file = FILES.iter().find(|(name, _)| *name == path);
            file.map(|(_, bytes)| bytes.to_vec())
                .ok_or_else(|| format!("{path} is not among the files of the program"))
        })
    }
}
