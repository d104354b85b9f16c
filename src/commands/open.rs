//! `lightwalk open`: the window.

use super::arguments::parse_whole;
use super::failure::Failure;
use std::path::PathBuf;

#[derive(clap::Args, Default)]
pub struct Arguments {
    /// The id of a lesson, a lesson, scene or mesh file, a folder of lessons, the address of a step on the web page, or `mistakes` for the
    /// page of classic mistakes; the page of all lessons unless given
    lesson: Option<String>,
    /// A folder of lessons of your own, which stand on the page of all lessons too
    #[arg(long, value_name = "DIR")]
    lessons: Option<PathBuf>,
    /// The step to open it at, counted from 0; where it was left unless given
    #[arg(long, value_name = "N", requires = "lesson", allow_hyphen_values = true, value_parser = parse_whole::<usize>)]
    step: Option<usize>,
}

/// Opens the page of classic mistakes.
#[cfg(feature = "gui")]
const MISTAKES: &str = "mistakes";

#[cfg(feature = "gui")]
pub fn run(arguments: Arguments) -> Result<(), Failure> {
    use super::{file_dialog, files, lesson_folder, output};
    use crate::app::{self, FolderOfLessons, NotOpened, Readers, Start};
    use crate::color::{StoredImage, read_image};
    use crate::lesson::{Lesson, Link, builtin};
    use std::path::Path;

    let Arguments {
        mut lesson,
        mut lessons,
        step,
    } = arguments;
    // A file may have such a name.
    let page = lesson.take_if(|name| name == MISTAKES && !Path::new(name).exists());
    if page.is_some() && step.is_some() {
        let message = "it is the page of classic mistakes; `--step` is for a lesson";
        return Err(files::wrong(&MISTAKES, &message));
    }
    let link = lesson.take_if(|name| name.contains('#') && !Path::new(name).exists());
    let address = link.clone().unwrap_or_default();
    let link = match &link {
        None => page.map(|_| Link {
            mistakes: true,
            ..Link::default()
        }),
        Some(address) => {
            let (_, place) = address.split_once('#').unwrap_or_default();
            let link = Link::parse(place).map_err(|why| files::wrong(address, &why))?;
            lesson = link.lesson.clone();
            Some(link)
        }
    };
    if let Some(folder) = lesson.take_if(|name| Path::new(name).is_dir())
        && (lessons.replace(folder.clone().into()).is_some() || step.is_some())
    {
        let message = "it is a folder; `--lessons` and `--step` are for a lesson beside it";
        return Err(files::wrong(&folder, &message));
    }
    let folder = match lessons {
        None => None,
        Some(path) => {
            let folder = lesson_folder::read(&path)?;
            if folder.lessons.is_empty() {
                return Err(files::wrong(
                    &path.display(),
                    &"there is no lesson in this folder",
                ));
            }
            Some((path, folder))
        }
    };
    let lesson = match lesson {
        None => None,
        Some(name) => {
            let own = folder.as_ref().and_then(|(_, folder)| folder.lesson(&name));
            let (lesson, path) = match own {
                Some((lesson, path)) => (lesson.clone(), Some(path.to_owned())),
                None if builtin(&name).is_none() && files::is_an_id(&name) => {
                    let own = folder.iter().flat_map(|(_, folder)| folder.right());
                    let ids: Vec<&str> = own.map(|(lesson, _)| &*lesson.id).collect();
                    return Err(files::no_such_lesson(&name, &ids));
                }
                None => files::to_walk(&name)?,
            };
            // A lesson that does not resolve is a wrong file, whether or not there is a display.
            lesson
                .clone()
                .open()
                .map_err(|error| files::wrong(&name, &error))?;
            Some((lesson, path))
        }
    };
    fn document(path: &Path) -> Result<Lesson, String> {
        let read = files::to_walk(&path.to_string_lossy());
        read.map(|(lesson, _)| lesson)
            .map_err(|failure| failure.to_string())
    }
    fn folder_of_lessons(path: &Path) -> Result<FolderOfLessons, String> {
        lesson_folder::read(path).map_err(|failure| failure.to_string())
    }
    fn picture(path: &Path) -> Result<StoredImage, String> {
        let bytes = files::bytes(path).map_err(|failure| failure.to_string())?;
        read_image(&bytes).map_err(|error| files::wrong(&path.display(), &error).to_string())
    }
    let start = Start {
        lesson,
        step,
        link,
        folder,
        readers: Readers {
            choose: file_dialog::choose,
            document,
            folder: folder_of_lessons,
            picture,
            text: |path| files::text(path).map_err(|failure| failure.to_string()),
            scene: files::edited_scene,
            lesson: files::edited_lesson,
            write: |path, bytes| {
                let written = output::write_whole(path, |writer| writer.write_all(bytes));
                written.map_err(|failure| failure.to_string())
            },
        },
    };
    file_dialog::hear_errors();
    app::open(start).map_err(|why| match why {
        NotOpened::Link(why) => files::wrong(&address, &why),
        NotOpened::Window(why) => Failure::Failed(why),
    })
}

#[cfg(not(feature = "gui"))]
pub fn run(_: Arguments) -> Result<(), Failure> {
    Err(Failure::Failed(
        "this build has no window (feature `gui`); `lightwalk list` and `lightwalk frames LESSON --out DIR` work without one".into(),
    ))
}
