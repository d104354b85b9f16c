//! Lessons of a folder of the user's own: in the list of lessons they have a chapter for themselves.

use super::lessons::{Listed, listed};
use super::{Refused, Session};
use crate::app::strings;
use crate::lesson::{Lesson, LessonError, builtin};
use std::path::{Path, PathBuf};

/// What was read from a folder.
#[derive(Clone, Debug)]
pub struct FolderOfLessons {
    /// The heading of its chapter.
    pub name: String,
    /// In the order of the list.
    pub lessons: Vec<LessonFromFile>,
}

#[derive(Clone, Debug)]
pub struct LessonFromFile {
    pub path: PathBuf,
    /// Or what is wrong with it.
    pub lesson: Result<Lesson, String>,
}

impl FolderOfLessons {
    /// The lessons that are right, with their files.
    pub fn right(&self) -> impl Iterator<Item = (&Lesson, &Path)> {
        let lessons = self.lessons.iter();
        lessons.filter_map(|own| Some((own.lesson.as_ref().ok()?, own.path.as_path())))
    }

    /// The lesson of this id, if it is right, and its file.
    pub fn lesson(&self, id: &str) -> Option<(&Lesson, &Path)> {
        self.right().find(|(lesson, _)| lesson.id == id)
    }

    /// The first lesson that is right, and its file.
    pub fn first(&self) -> Option<(&Lesson, &Path)> {
        self.right().next()
    }
}

/// A folder, as it stands in the list of lessons.
pub(super) struct Chapter {
    folder: FolderOfLessons,
    /// One for each of its lessons.
    listed: Vec<Listed>,
}

impl Chapter {
    fn new(folder: FolderOfLessons) -> Self {
        let listed = folder.lessons.iter().map(|own| match &own.lesson {
            Ok(lesson) => Listed::new(&lesson.id, lesson),
            Err(error) => Listed::with_errors(&own.path, error),
        });
        Chapter {
            listed: listed.collect(),
            folder,
        }
    }
}

/// Every line of what is wrong with a lesson, behind the path of its file where it is from one.
fn with_path(file: Option<&Path>, error: &LessonError) -> String {
    let error = error.to_string();
    let Some(file) = file else { return error };
    let lines = error
        .lines()
        .map(|line| format!("{}: {line}", file.display()));
    lines.collect::<Vec<_>>().join("\n")
}

impl Session {
    /// Puts the lessons of a folder into the list, in place of those of another one.
    pub fn show_folder(&mut self, folder: FolderOfLessons) {
        self.own = Some(Chapter::new(folder));
    }

    /// The name of the folder, and its lessons.
    pub fn own_lessons(&self) -> Option<(&str, &[Listed])> {
        let own = self.own.as_ref()?;
        Some((&own.folder.name, &own.listed))
    }

    /// The lessons of the folder and those of the program.
    pub fn all_lessons(&self) -> impl Iterator<Item = &Listed> {
        let own = self.own_lessons().map_or(&[][..], |(_, own)| own);
        own.iter().chain(listed())
    }

    /// Of the folder.
    pub fn own_lesson(&self, id: &str) -> Option<&LessonFromFile> {
        let own = self.own.as_ref()?;
        let index = own.listed.iter().position(|listed| listed.id == id)?;
        Some(&own.folder.lessons[index])
    }

    /// Opens a lesson of the list, where it was left.
    pub(super) fn open_listed(&mut self, id: &str) -> Result<(), Refused> {
        let (lesson, file) = match self.own_lesson(id) {
            Some(own) => (
                own.lesson.clone().map_err(Refused::Error)?,
                Some(own.path.clone()),
            ),
            None => {
                let builtin = builtin(id).ok_or(strings::NO_SUCH_LESSON)?;
                let read = builtin
                    .read()
                    .map_err(|error| Refused::Error(error.to_string()))?;
                (read, None)
            }
        };
        self.open_document(lesson, file).map_err(|error| {
            self.mark(id, &error);
            Refused::Error(error)
        })
    }

    /// The lesson is wrong in a way that only its run has shown.
    fn mark(&mut self, id: &str, error: &str) {
        let Some(own) = &mut self.own else { return };
        if let Some(index) = own.listed.iter().position(|listed| listed.id == id) {
            own.folder.lessons[index].lesson = Err(error.to_owned());
            own.listed[index] = Listed::with_errors(&own.folder.lessons[index].path, error);
        }
    }

    /// Shows a lesson, from a file or of the program's own. Errors: what is wrong with it; nothing has changed then.
    pub fn open_document(&mut self, lesson: Lesson, file: Option<PathBuf>) -> Result<(), String> {
        self.replace(lesson)
            .map_err(|error| with_path(file.as_deref(), &error))?;
        self.file = file;
        self.look.home = false;
        self.look.mistakes = false;
        self.look.editing = false;
        self.studying.is_open = false;
        Ok(())
    }

    /// Shows the file again, as it was saved. Errors: what is wrong with it; nothing has changed then.
    pub fn reload(&mut self, lesson: Lesson) -> Result<(), String> {
        self.replace_document(lesson)
            .map_err(|problems| with_path(self.file.as_deref(), &LessonError { problems }))
    }
}
