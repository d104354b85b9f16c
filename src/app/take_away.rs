//! What one takes away of a lesson, as a file: a page saves it as a download, the window in the folder where it was started.

use super::background::Work;
use super::opened::Readers;
use super::session::{Session, TakeAway};
use crate::export::{Contents, ExportedLesson, deck, handout};
use crate::language::Language;
use crate::lesson::Lesson;
use crate::panels::{Panel, draw};
use crate::picture::{rasterize, to_png};
use glam::Vec2;
use std::num::NonZeroUsize;
use std::path::PathBuf;

/// Points of a picture, and pixels of each.
const PICTURE: Vec2 = Vec2::new(960.0, 600.0);
const SCALE: f32 = 2.0;

/// A file, before it is written: its name, and what is in it. An error says why there is none.
pub type NewFile = Result<(String, Vec<u8>), String>;

/// Begins to make it. A page does so between two frames.
pub fn begin(session: &Session, what: TakeAway) -> Work<NewFile> {
    let lesson = session.lesson().clone();
    let look = session.look;
    match what {
        TakeAway::Picture => {
            let made = picture(session);
            Work::begin("picture", move |worker| worker.send(made))
        }
        TakeAway::Handout => Work::begin("handout", move |worker| {
            worker.send(document(
                lesson,
                look.language,
                "handout",
                |shown, steps| {
                    let contents = Contents {
                        steps,
                        answers: true,
                    };
                    handout(shown, &contents, &|_| ())
                },
            ));
        }),
        TakeAway::Deck => Work::begin("slides", move |worker| {
            worker.send(document(lesson, look.language, "slides", |shown, steps| {
                deck(shown, steps, look.theme, &|_| ())
            }));
        }),
    }
}

/// The key panel at this step.
fn picture(session: &Session) -> NewFile {
    let panel = session.key_panel().unwrap_or(Panel::Image);
    let drawn = draw(panel, &session.panel_input(), PICTURE);
    let pixels = rasterize(&drawn, session.look.theme, SCALE).map_err(|error| error.to_string())?;
    let (id, step) = (&session.lesson().id, session.step());
    Ok((format!("{id}-{}-{step}.png", panel.name()), to_png(&pixels)))
}

/// The explanations of a lesson, put down by `write`.
fn document(
    lesson: Lesson,
    language: Language,
    kind: &str,
    write: impl FnOnce(&mut ExportedLesson, &[usize]) -> String,
) -> NewFile {
    let open = lesson.open().map_err(|error| error.to_string())?;
    let panels = open.lesson.panels.clone();
    let name = format!("{}-{kind}-{}.html", open.lesson.id, language.code());
    // Another thread renders what the window shows.
    let mut shown =
        ExportedLesson::new(open, &panels, language, NonZeroUsize::MIN, &|_, _| ()).asking();
    let steps = shown.narrated().to_vec();
    Ok((name, write(&mut shown, &steps).into_bytes()))
}

/// Writes it beside what is there. Returns the name under which it was saved.
pub fn save(made: NewFile, readers: Readers) -> Result<String, String> {
    let (name, bytes) = made?;
    let path = free(&name);
    (readers.write)(&path, &bytes)?;
    Ok(path.display().to_string())
}

/// A path in the folder where the program was started that nothing has yet: numbered, where the name is taken.
fn free(name: &str) -> PathBuf {
    let folder = std::env::current_dir().unwrap_or_default();
    let (stem, ending) = name.rsplit_once('.').unwrap_or((name, ""));
    let numbered = |number: usize| folder.join(format!("{stem}-{number}.{ending}"));
    let first = folder.join(name);
    match first.exists() {
        false => first,
        true => {
            let mut others = (2..).map(numbered);
            others.find(|path| !path.exists()).unwrap_or(first)
        }
    }
}
