//! Lessons of one's own: of a folder on the page of all lessons, and of a file that is saved again.

use super::*;
use crate::app::opened::{Opened, Readers};
use crate::app::session::{Choice, FolderOfLessons, LessonFromFile, Refused};
use crate::language::Message;
use crate::scene::Limits;
use std::fs;
use std::path::Path;
use std::time::{Duration, SystemTime};

const TRIANGLE: &str = include_str!("../../../lessons/04-gouraud-triangle.json");

/// The triangle under another id and title.
fn lesson(id: &str) -> String {
    let text = TRIANGLE.replacen("\"gouraud-triangle\"", &format!("\"{id}\""), 1);
    let (before, title) = text.split_once("\"title\": {").expect("a title");
    let (_, after) = title.split_once('}').expect("its end");
    format!("{before}\"title\": {{ \"en\": \"Title of {id}\", \"id\": \"Judul {id}\" }}{after}")
}

fn read(path: &Path) -> Result<Lesson, String> {
    let bytes = fs::read(path).map_err(|error| error.to_string())?;
    let read = Lesson::read(&bytes, &Limits::default(), &mut |_| Err("none".into()));
    read.map_err(|error| format!("{}: {error}", path.display()))
}

fn read_folder(path: &Path) -> Result<FolderOfLessons, String> {
    let entries = fs::read_dir(path).map_err(|error| error.to_string())?;
    let mut paths: Vec<_> = entries.map(|entry| entry.unwrap().path()).collect();
    paths.sort();
    let lessons = paths.into_iter().map(|path| LessonFromFile {
        lesson: read(&path),
        path,
    });
    Ok(FolderOfLessons {
        name: "My chapter".into(),
        lessons: lessons.collect(),
    })
}

const READERS: Readers = Readers {
    document: read,
    folder: read_folder,
    picture: |_| Err("no picture".into()),
    text: |_| Err("no text".into()),
    scene: |_, _| Err(Vec::new()),
    lesson: |_, _| Err(Vec::new()),
    write: |_, _| Err("nothing is written".into()),
    choose: |_| Ok(None),
};

/// Writes a file as if it had been saved so many seconds later.
fn save(path: &Path, text: &str, later: u64) {
    fs::write(path, text).unwrap();
    let file = fs::File::options().write(true).open(path).unwrap();
    file.set_modified(SystemTime::now() + Duration::from_secs(later))
        .unwrap();
}

/// Two right lessons and one with an error between them, and the window on the page of all lessons.
fn own_lessons(size: [u32; 2]) -> (tempfile::TempDir, Screen) {
    let folder = tempfile::tempdir().unwrap();
    save(&folder.path().join("1.json"), &lesson("own-first"), 0);
    save(
        &folder.path().join("2.json"),
        &lesson("own-wrong").replacen("\"number\"", "\"numbr\"", 1),
        0,
    );
    save(&folder.path().join("3.json"), &lesson("own-last"), 0);
    let mut screen = screen("gouraud-triangle", size, 1.0, []);
    let mut opened = Opened::new(READERS, None);
    opened.open(screen.session_mut(), folder.path()).unwrap();
    screen.harness.state_mut().1.opened = Some(opened);
    screen.harness.run_steps(6);
    (folder, screen)
}

fn notice(screen: &Screen) -> &str {
    screen
        .harness
        .state()
        .1
        .notice
        .as_deref()
        .unwrap_or_default()
}

#[test]
fn lessons_of_a_folder_have_a_chapter_also_those_with_errors() {
    let (folder, mut screen) = own_lessons([1280, 800]);
    screen.harness.get_by_label("My chapter");
    screen.keep("home-own");
    let wrong = screen.harness.get_by_label("2.json");
    let description = wrong.accesskit_node().description().expect("words");
    assert!(description.contains("line 5, column 9"), "{description}");
    assert!(
        description.contains("did you mean number?"),
        "{description}"
    );
    let path = folder.path().join("2.json").display().to_string();
    assert!(!description.contains(&path), "{description}");

    screen.click("2.json");
    assert!(screen.session().look.home);
    assert!(
        notice(&screen).starts_with(&format!("{path}: line ")),
        "{}",
        notice(&screen)
    );

    let card = "4 · Title of own-first";
    screen.click(card);
    let session = screen.session_mut();
    assert_eq!(session.lesson().id, "own-first");
    session.update(Command::Share).unwrap();
    let command = session.shared.take().unwrap();
    let first = folder.path().join("1.json").display().to_string();
    assert_eq!(
        command,
        format!("lightwalk open {first} --step {}", session.step())
    );
}

/// What the system's dialog gives.
#[test]
fn a_file_that_is_chosen_is_opened_and_where_nobody_can_be_asked_that_is_said() {
    let (_folder, mut screen) = own_lessons([1280, 800]);
    let answer = |screen: &mut Screen, choose| {
        let readers = Readers { choose, ..READERS };
        screen.harness.state_mut().1.opened = Some(Opened::new(readers, None));
        screen.harness.state_mut().1.notice = None;
        screen.click("Open a file…");
        for _ in 0..1000 {
            screen.harness.step();
            if screen.harness.state().1.choosing.is_none() {
                break;
            }
            std::thread::yield_now();
        }
    };
    let path = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/lessons/04-gouraud-triangle.json"
    );
    let before = screen.session().recording();
    answer(&mut screen, |_| Ok(None));
    assert_eq!(screen.session().recording(), before);
    assert_eq!(notice(&screen), "");
    answer(&mut screen, |_| Err(Message("app-no-dialog")));
    assert!(notice(&screen).contains("lightwalk open FILE"));
    answer(&mut screen, |choice| {
        assert_eq!(choice, Choice::File);
        let path = concat!(
            env!("CARGO_MANIFEST_DIR"),
            "/lessons/04-gouraud-triangle.json"
        );
        Ok(Some(path.into()))
    });
    assert_eq!(screen.session().file.as_deref(), Some(Path::new(path)));
    assert!(!screen.session().look.home);
}

/// The one with an error lies between.
#[test]
fn one_lesson_of_the_folder_leads_to_the_next() {
    let (_folder, mut screen) = own_lessons([1280, 800]);
    let session = screen.session_mut();
    session.update(Command::Open("own-first".into())).unwrap();
    assert_eq!(
        session.allows(&Command::PreviousLesson),
        Err(strings::NO_PREVIOUS_LESSON.into())
    );
    session.update(Command::NextLesson).unwrap();
    assert_eq!(session.lesson().id, "own-last");
    assert_eq!(
        session.allows(&Command::NextLesson),
        Err(strings::NO_NEXT_LESSON.into())
    );
    session
        .update(Command::Open("gouraud-triangle".into()))
        .unwrap();
    session.update(Command::NextLesson).unwrap();
    assert_eq!(
        (session.lesson().id.as_str(), &session.file),
        ("gouraud-teapot", &None)
    );
}

#[test]
fn an_anchor_that_its_run_lacks_is_reported_on_the_card_too() {
    let (folder, mut screen) = own_lessons([1280, 800]);
    let (before, after) = TRIANGLE.rsplit_once("\"at\": \"").expect("an anchor");
    let lost = format!("{before}\"at\": \"Lost{after}").replacen("gouraud-triangle", "own-lost", 1);
    save(&folder.path().join("4.json"), &lost, 5);
    screen.harness.run_steps(3);
    let refused = screen
        .session_mut()
        .update(Command::Open("own-lost".into()));
    let Err(Refused::Error(error)) = refused else {
        panic!("{refused:?}");
    };
    assert!(
        error.contains("4.json: line ") && error.contains(": steps[") && error.contains("no step"),
        "{error}"
    );
    screen.harness.run_steps(3);
    screen.harness.get_by_label("4.json");
}

#[test]
fn what_is_saved_in_the_folder_stands_on_the_page() {
    let (folder, mut screen) = own_lessons([1280, 800]);
    save(&folder.path().join("2.json"), &lesson("own-mended"), 5);
    screen.harness.run_steps(3);
    screen.harness.get_by_label("4 · Title of own-mended");
    assert!(screen.harness.query_by_label("2.json").is_none());
}

/// The folder, with its first lesson opened.
fn first_opened() -> (tempfile::TempDir, Screen) {
    let (folder, mut screen) = own_lessons([1280, 800]);
    screen
        .session_mut()
        .update(Command::Open("own-first".into()))
        .unwrap();
    screen.harness.run_steps(3);
    (folder, screen)
}

#[test]
fn a_mistake_in_a_saved_file_is_reported_with_line_column_and_path_and_the_last_right_one_stays() {
    let (folder, mut screen) = first_opened();
    let path = folder.path().join("1.json");
    let right = lesson("own-first");
    let lost = right.replacen("\"at\": \"", "\"at\": \"Lost", 1);
    for (later, text, said) in [
        (
            5,
            right.replacen("\"focus\"", "\"focsu\"", 1),
            "unknown key `focsu` (did you mean focus?)",
        ),
        (10, lost, "steps[0].at: no step"),
    ] {
        save(&path, &text, later);
        screen.harness.run_steps(3);
        let message = notice(&screen);
        assert!(
            message.starts_with(&path.display().to_string()),
            "{message}"
        );
        assert!(message.contains(said), "{message}");
        let is_placed = message.contains(": line ") && message.contains(", column ");
        assert!(is_placed, "{message}");
        assert_eq!(screen.session().lesson().id, "own-first");
    }
    save(&path, &right.replacen("Title of", "New title of", 1), 15);
    screen.harness.run_steps(3);
    assert_eq!(notice(&screen), strings::READ_AGAIN.text(Language::English));
    assert!(screen.session().title().contains("New title of own-first"));
}

/// It was opened first, then left for a lesson of the program.
#[test]
fn a_file_that_is_not_shown_any_more_is_not_read_again() {
    let (folder, mut screen) = first_opened();
    screen
        .session_mut()
        .update(Command::Open("distance".into()))
        .unwrap();
    save(&folder.path().join("1.json"), &lesson("own-first"), 5);
    screen.harness.run_steps(3);
    assert_eq!(screen.session().lesson().id, "distance");
}
