//! A lesson that is written in the window alone: begun from a scene, saved, checked, read again and walked through.

mod by_hand;

use super::*;
use crate::app::author_strings as words;
use crate::app::opened::{Opened, Readers};
use crate::language::Message;
use crate::lesson::Change;
use crate::replay::query::kinds;
use crate::scene::document::Problem;
use crate::scene::edit::Edit;
use crate::scene::{Limits, Movable, View};
use std::fs;
use std::path::Path;

/// A mirror ball and a wall behind it, under a lamp.
const SCENE: &str = r#"{ "schema": 1, "background": [0.25, 0.3, 0.5], "ambient": [1, 1, 1],
  "camera": { "eye": [0, 1, 5], "target": [0, 0, 0], "up": [0, 1, 0], "fov_x_degrees": 40 },
  "materials": {
    "mirror": { "ambient": [0.1, 0.1, 0.1], "diffuse": [0.3, 0.3, 0.3], "specular": 0.5, "shininess": 40, "reflection": 0.5 },
    "clay": { "ambient": [0.1, 0.05, 0.05], "diffuse": [0.6, 0.3, 0.2] } },
  "objects": [
    { "name": "ball", "material": "mirror", "sphere": { "center": [0, 0, 0], "radius": 1 } },
    { "name": "floor", "material": "clay", "plane": { "point": [0, -1, 0], "normal": [0, 1, 0] } } ],
  "lights": [ { "point": { "position": [4, 6, 5] } } ] }
"#;

fn lesson(path: &Path, text: &[u8]) -> Result<Lesson, Vec<Problem>> {
    let folder = path.parent().unwrap();
    let mut read = |name: &str| fs::read(folder.join(name)).map_err(|error| error.to_string());
    Lesson::read(text, &Limits::default(), &mut read).map_err(|error| error.problems)
}

fn document(path: &Path) -> Result<Lesson, String> {
    let text = fs::read(path).map_err(|error| error.to_string())?;
    if String::from_utf8_lossy(&text).contains("\"steps\"") {
        return lesson(path, &text).map_err(|problems| format!("{problems:?}"));
    }
    let scene = crate::scene::read(&text, &Limits::default(), &mut |_| Err("none".into()));
    let scene = scene.map_err(|error| error.to_string())?;
    let [width, height] = Lesson::SIZE_OF_A_WALK;
    let view = View::new(&scene.camera.unwrap(), width, height);
    let prepared = crate::algorithms::prepared_scene::PreparedScene::new(scene, view);
    Ok(Lesson::of_scene("mirror.json", prepared))
}

const READERS: Readers = Readers {
    document,
    folder: |_| Err("no folder".into()),
    picture: |_| Err("no picture".into()),
    text: |path| fs::read_to_string(path).map_err(|error| error.to_string()),
    scene: |_, _| Err(Vec::new()),
    lesson,
    write: |path, bytes| fs::write(path, bytes).map_err(|error| error.to_string()),
    choose: |_| Ok(None),
};

/// The window on a file of a folder.
fn opened(folder: &Path, file: &str, language: Language) -> Screen {
    let mut screen = triangle([Command::Speak(language)]);
    let mut opened = Opened::new(READERS, None);
    let path = folder.join(file);
    opened.open(screen.session_mut(), &path).unwrap();
    screen.harness.state_mut().1.opened = Some(opened);
    screen.rest();
    screen
}

/// A folder with the scene, which is walked through.
fn walk(language: Language) -> (tempfile::TempDir, Screen) {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("mirror.json"), SCENE).unwrap();
    let screen = opened(folder.path(), "mirror.json", language);
    (folder, screen)
}

/// The first steps of ten kinds of events.
fn ten_steps(session: &Session) -> Vec<usize> {
    let walk = session.walk();
    let first = |kind: &str| (0..walk.len()).find(|&step| walk.kind(step) == kind);
    let mut steps: Vec<usize> = kinds(walk)
        .iter()
        .filter_map(|(kind, _)| first(kind))
        .collect();
    steps.truncate(10);
    steps
}

const EN: Language = Language::English;
const ID: Language = Language::Indonesian;

/// Begins a lesson at the first of ten steps, and pins the others, each with words of its own.
fn with_ten_explanations(screen: &mut Screen) -> Vec<usize> {
    let language = screen.session().look.language;
    let steps = ten_steps(screen.session());
    screen.walk_to(steps[0]);
    screen.act(words::WRITE);
    screen.keep(&format!("author-begin-{}", language.code()));
    screen.act(words::BEGIN);
    assert_eq!(screen.problems(), "");
    for (index, &step) in steps.iter().enumerate() {
        if index > 0 {
            screen.walk_to(step);
            screen.act(words::PIN);
        } else {
            screen.pick_row_of(0);
        }
        screen.write(
            words::SAY,
            EN,
            &format!("What happens here is number {index}."),
        );
        screen.write(
            words::SAY,
            ID,
            &format!("Yang terjadi di sini nomor {index}."),
        );
        screen.write(words::TITLE, language, &format!("Step {index}"));
        assert_eq!(screen.problems(), "");
    }
    let explained_at: Vec<usize> = screen
        .session()
        .explained()
        .iter()
        .map(|said| said.step)
        .collect();
    assert_eq!(explained_at, steps);
    steps
}

#[test]
fn a_lesson_of_ten_explanations_is_written_saved_read_again_and_walked() {
    let (folder, mut screen) = walk(EN);
    let steps = with_ten_explanations(&mut screen);
    screen.keep("author-explanation");

    // The third explanation asks about a number that the run records later.
    let number = |session: &Session, step| {
        !crate::lesson::draft::numbers(&session.walk().own_fields(step)).is_empty()
    };
    let answers = (steps[2] + 1..).find(|&step| number(screen.session(), step));
    screen.pick_row_of(2);
    assert_eq!(screen.session().step(), steps[2]);
    screen.walk_to(answers.unwrap());
    screen.act(words::ASK_HERE);
    screen.write(words::ASK, EN, "How large will it be?");
    screen.write(words::WHY, EN, "The run says so.");
    assert_eq!(screen.problems(), "");
    screen.keep("author-question");
    let asked = screen.session().explained()[2].question.as_ref();
    let asked = asked.expect("a question");
    assert_eq!(asked.step, answers.unwrap());
    assert!(matches!(asked.answer, Answer::Number { .. }));

    // The lesson as a whole.
    screen.act(words::WHOLE);
    screen.write(words::TITLE, EN, "One ray and its mirror");
    screen.write(words::TITLE, ID, "Satu sinar dan cerminnya");
    screen.write(words::SUMMARY, EN, "What one ray meets.");
    screen.act(words::ONE_MORE);
    let light = words::LIGHT.format(EN, &[("of", "0")]);
    screen.harness.get_by_label(&light).click();
    screen.rest();
    assert_eq!(screen.session().lesson().parameters.len(), 1);
    screen.keep("author-whole");

    screen.act(strings::SCENE_SAVE);
    let path = folder.path().join("mirror-lesson.json");
    let saved = fs::read_to_string(&path).unwrap();
    assert_eq!(saved, screen.text_of_lesson());
    // As `lightwalk check` does.
    let read = lesson(&path, saved.as_bytes()).unwrap();
    read.check_parameters().unwrap();
    let missing: Vec<&str> = read
        .missing
        .iter()
        .map(|note| note.place.as_str())
        .collect();
    assert!(missing.contains(&"summary") && missing.contains(&"steps[2].question.ask"));
    assert!(!missing.contains(&"title") && !missing.contains(&"steps[2].say"));
    let open = read.open().unwrap();
    assert_eq!((open.narrated.len(), open.lesson.questions()), (10, 1));

    // Walked from its first explanation to its last by the key that goes on.
    let mut screen = opened(folder.path(), "mirror-lesson.json", EN);
    for (index, &step) in steps.iter().enumerate() {
        assert_eq!(screen.session().step(), step);
        let said = screen.session().narration_here().unwrap().text(EN);
        assert_eq!(said, format!("What happens here is number {index}."));
        if index == 2 {
            screen.session_mut().update(Command::Skip).unwrap();
        }
        screen.press(Modifiers::NONE, Key::N);
    }
}

#[test]
fn explanations_are_moved_exchanged_and_deleted_and_each_change_is_undone() {
    let (_folder, mut screen) = walk(EN);
    let steps = with_ten_explanations(&mut screen);
    let explained_at = |screen: &Screen| -> Vec<usize> {
        screen
            .session()
            .explained()
            .iter()
            .map(|said| said.step)
            .collect()
    };
    let ten = screen.text_of_lesson();

    // The run does not go in the other order: nothing changes, and it is said why.
    screen.pick_row_of(3);
    screen.act(words::EARLIER);
    let notice = screen.harness.state().1.notice.clone().unwrap_or_default();
    let order = words::ORDER.format(EN, &[("why", "")]);
    assert!(notice.starts_with(order.trim_end()), "{notice}");
    assert_eq!(screen.text_of_lesson(), ten);

    // To a step behind the fifth one.
    let free = (steps[4] + 1..steps[5]).next();
    if let Some(free) = free {
        screen.walk_to(free);
        screen.act(words::MOVE);
        assert_eq!(explained_at(&screen)[4], free);
        assert_eq!(
            screen.session().explained()[4].text(EN),
            "What happens here is number 3."
        );
        screen.act(strings::UNDO);
        assert_eq!(screen.text_of_lesson(), ten);
    }

    screen.pick_row_of(0);
    screen.act(words::DELETE);
    assert_eq!(explained_at(&screen), steps[1..]);
    screen.act(strings::UNDO);
    assert_eq!(
        (explained_at(&screen), screen.text_of_lesson()),
        (steps, ten)
    );
}

/// Where a lamp is moved, some steps do not happen: the others stay what they are, and nothing is moved or deleted by this run.
#[test]
fn in_a_run_with_other_values_explanations_stay_what_they_are() {
    let (_folder, mut screen) = walk(EN);
    with_ten_explanations(&mut screen);
    let (session, window) = screen.harness.state_mut();
    let parameters = serde_json::json!([{ "object": "ball" }]);
    let edit = Edit::Insert(String::new(), "parameters".into(), parameters);
    window.author.documents.only().edit(&[edit], session);
    screen.rest();
    assert_eq!(screen.problems(), "");
    let text = screen.text_of_lesson();
    let away = Change::Place {
        of: Movable::Object(0),
        position: glam::DVec3::new(0.0, 20.0, 0.0),
    };
    screen.session_mut().update(Command::Change(away)).unwrap();
    screen.rest();
    let happen: Vec<usize> = screen
        .session()
        .explained()
        .iter()
        .map(|said| said.index)
        .collect();
    assert!(happen.len() < 10, "{happen:?}");
    for index in happen {
        screen.pick_row_of(index);
        let said = screen.session().narration_here().unwrap().text(EN);
        assert_eq!(said, format!("What happens here is number {index}."));
    }
    screen.pick_row_of(9);
    for name in [words::DELETE, words::EARLIER, words::MOVE] {
        screen.act(name);
    }
    assert_eq!(screen.text_of_lesson(), text);
}

#[test]
fn a_step_is_pinned_once_in_the_lessons_part_and_with_its_own_values() {
    let (_folder, mut screen) = walk(ID);
    screen.act(words::WRITE);
    screen.act(words::BEGIN);
    let refused = |screen: &Screen, why: Message| {
        assert!(
            screen.harness.query_by_label(why.text(ID)).is_some(),
            "{}",
            why.text(ID)
        );
    };
    refused(&screen, words::EXPLAINED_HERE);
    screen.keep("author-indonesian");
    screen
        .session_mut()
        .update(Command::Focus(Focus::Pixel { x: 3, y: 3 }))
        .unwrap();
    screen.rest();
    refused(&screen, words::OTHER_PART);
    let before = screen.session().lesson().focus;
    screen.act(words::WHOLE);
    screen.act(words::TAKE_PART);
    assert_ne!(screen.session().lesson().focus, before);
}

#[test]
fn nothing_is_saved_over_a_file_that_changed_or_was_there_before() {
    let (folder, mut screen) = walk(EN);
    let path = folder.path().join("mirror-lesson.json");
    screen.act(words::WRITE);
    fs::write(&path, "theirs").unwrap();
    screen.act(words::BEGIN);
    let notice = screen.harness.state().1.notice.clone();
    assert_eq!(notice.as_deref(), Some(words::FILE_EXISTS.text(EN)));
    screen.type_over(words::FILE.text(EN), "other.json");
    screen.act(words::BEGIN);
    let other = folder.path().join("other.json");
    fs::write(&other, "theirs").unwrap();
    screen.act(strings::SCENE_SAVE);
    assert_eq!(fs::read_to_string(&other).unwrap(), "theirs");
    screen.act(strings::SCENE_SAVE_MINE);
    assert_eq!(fs::read_to_string(&other).unwrap(), screen.text_of_lesson());
    assert_eq!(fs::read_to_string(&path).unwrap(), "theirs");
}

#[test]
fn a_lesson_that_is_not_saved_yet_is_found_again() {
    let (folder, mut screen) = walk(EN);
    screen.act(words::WRITE);
    screen.act(words::BEGIN);
    let text = screen.text_of_lesson();
    let scene = document(&folder.path().join("mirror.json")).unwrap();
    let file = folder.path().join("mirror.json");
    screen
        .session_mut()
        .open_document(scene, Some(file))
        .unwrap();
    screen.rest();
    let on = words::GO_ON.format(EN, &[("file", "mirror-lesson.json")]);
    screen.click_there(&on);
    assert_eq!(screen.text_of_lesson(), text);
    assert!(!screen.session().lesson().is_free_walk());
}

#[test]
fn a_lesson_of_the_program_is_copied_and_one_with_other_files_is_not() {
    let folder = tempfile::tempdir().unwrap();
    let mut screen = screen("shadows", [1280, 800], 1.0, []);
    let explanations = screen.session().explained().len();
    screen.harness.state_mut().1.opened = Some(Opened::new(READERS, None));
    screen.session_mut().update(Command::Author).unwrap();
    screen.rest();
    let path = folder.path().join("own.json");
    let text = screen.session().lesson().copied("own", 3).unwrap();
    let copy = lesson(&path, text.as_bytes()).unwrap();
    assert_eq!((copy.id.as_str(), copy.number), ("own", 3));
    assert_eq!(copy.open().unwrap().narrated.len(), explanations);
    for id in ["gouraud-teapot", "cornell-box"] {
        let mut session = Session::new(builtin(id).unwrap().read().unwrap()).unwrap();
        assert_eq!(
            session.update(Command::Author),
            Err(words::WITH_FILES.into()),
            "{id}"
        );
    }
}
