//! Progress saved as one file and loaded elsewhere.

use super::*;
use crate::app::opened::{Opened, Readers};
use crate::app::session::Progress;
use std::cell::RefCell;
use std::path::{Path, PathBuf};

thread_local! {
    static WRITTEN: RefCell<Vec<(PathBuf, Vec<u8>)>> = const { RefCell::new(Vec::new()) };
    static DISK: RefCell<String> = const { RefCell::new(String::new()) };
}

const SCENE: &str = r#"{ "schema": 1,
    "camera": { "eye": [0, 0, 6], "target": [0, 0, 0], "up": [0, 1, 0], "fov_x_degrees": 40 },
    "materials": { "m": { "diffuse": [1, 0, 0] } },
    "objects": [{ "name": "ball", "material": "m", "sphere": { "center": [0, 0, 0], "radius": 1 } }],
    "lights": [{ "point": { "position": [0, 9, 9] } }] }"#;

fn readers() -> Readers {
    Readers {
        document: |_| Err("no scene and no lesson".into()),
        folder: |_| Err("no folder".into()),
        picture: |_| Err("no picture".into()),
        text: |_| Ok(DISK.with_borrow(Clone::clone)),
        scene: |_, _| Err(Vec::new()),
        lesson: |_, _| Err(Vec::new()),
        choose: |_| Ok(None),
        write: |path, bytes| {
            WRITTEN.with_borrow_mut(|written| written.push((path.to_owned(), bytes.to_vec())));
            Ok(())
        },
    }
}

fn session() -> Session {
    Session::new(builtin("gouraud-triangle").unwrap().read().unwrap()).unwrap()
}

/// Opens the file as if it had been dropped.
fn load(session: &mut Session, text: &str) -> Result<Option<String>, String> {
    DISK.set(text.to_owned());
    Opened::new(readers(), None).open(session, Path::new("lightwalk-progress.json"))
}

fn saved(session: &mut Session) -> String {
    String::from_utf8(session.progress_file().unwrap()).unwrap()
}

/// What is kept of a lesson: how many explanations were reached, and how questions stand.
fn progress(reached: usize, answers: &[(usize, Standing)]) -> serde_json::Value {
    serde_json::json!({
        "place": [reached.checked_sub(1), 2],
        "reached": reached,
        "answers": answers.iter().copied().collect::<std::collections::BTreeMap<_, _>>(),
        "guesses": answers.iter().map(|(index, _)| (*index, [Guess::Choice(reached)])).collect::<std::collections::BTreeMap<_, _>>(),
    })
}

fn file(lessons: serde_json::Value) -> String {
    let file = serde_json::json!({ "schema": 1, "lessons": lessons, "scenes": {} }).to_string();
    file.replacen('{', "{\"lightwalk\": \"progress\", ", 1)
}

fn of(session: &mut Session, id: &str) -> Progress {
    session.keep().lessons[id].clone()
}

#[test]
fn what_is_saved_here_is_found_there() {
    let mut here = session();
    for _ in 0..5 {
        if here.question_at(here.step()) {
            here.update(Command::Skip).unwrap();
        }
        here.update(Command::NextNarrated).unwrap();
    }
    let (step, kept) = (here.step(), here.keep());
    let mut there = session();
    there.update(Command::Speak(Language::Indonesian)).unwrap();
    let said = load(&mut there, &saved(&mut here)).unwrap().unwrap();
    assert!(said.contains("Pelajaran: 1"), "{said}");
    assert_eq!(there.step(), step);
    assert!(!kept.lessons["gouraud-triangle"].answers.is_empty());
    assert_eq!(there.keep().lessons, kept.lessons);
    // Language, theme and text size belong to the computer.
    assert_eq!(there.look.language, Language::Indonesian);
}

#[test]
fn the_further_progress_of_a_lesson_stays_and_answers_of_the_other_are_added() {
    use Standing::{Right, Skipped, Wrong};
    let mut session = session();
    load(
        &mut session,
        &file(serde_json::json!({
            "shadows": progress(5, &[(1, Wrong), (3, Right)]),
            "reflection": progress(5, &[(1, Wrong)]),
            "distance": progress(4, &[(2, Skipped)]),
        })),
    )
    .unwrap();
    load(
        &mut session,
        &file(serde_json::json!({
            "shadows": progress(3, &[(1, Right), (2, Right)]),
            "reflection": progress(9, &[(1, Right), (7, Wrong)]),
            "distance": progress(4, &[(2, Right)]),
            "somebodys-own": progress(1, &[]),
        })),
    )
    .unwrap();
    let mut expect = |id: &str, reached: usize, answers: &[(usize, Standing)]| {
        let found = of(&mut session, id);
        assert_eq!(found.reached, reached, "{id}");
        assert_eq!(found.answers, answers.iter().copied().collect(), "{id}");
        let guesses = serde_json::to_value(&found).unwrap()["guesses"].clone();
        assert_eq!(guesses.as_object().unwrap().len(), answers.len(), "{id}");
    };
    expect("shadows", 5, &[(1, Wrong), (2, Right), (3, Right)]);
    expect("reflection", 9, &[(1, Right), (7, Wrong)]);
    expect("distance", 4, &[(2, Skipped)]);
    expect("somebodys-own", 1, &[]);
}

#[test]
fn a_damaged_or_foreign_file_is_refused_and_nothing_is_lost() {
    let mut session = session();
    session.update(Command::NextNarrated).unwrap();
    let right = file(serde_json::json!({ "shadows": progress(5, &[]) }));
    let before = session.keep();
    let cut = &right[..right.len() - 9];
    let wrong_scene = right.replace("\"scenes\":{}", "\"scenes\":{\"a.json\":\"AAAA\"}");
    for (text, said) in [
        (cut, "damaged"),
        (&right.replace("\"reached\":5", "\"reached\":-5"), "damaged"),
        (&right.replace("\"lessons\"", "\"lesson\""), "damaged"),
        (&wrong_scene, "a.json"),
        (
            &right.replace("\"schema\":1", "\"schema\":2"),
            "another version",
        ),
        (
            &right.replace("\"progress\"", "\"presets\""),
            "another version",
        ),
        ("{ \"lightwalk\": 1 }", "damaged"),
        ("[1, 2]", "no scene and no lesson"),
        ("", "no scene and no lesson"),
    ] {
        assert_ne!(text, right);
        let refused = load(&mut session, text).unwrap_err();
        assert!(refused.contains(said), "{text}: {refused}");
        assert_eq!(session.keep(), before, "{text}");
    }
    load(&mut session, &right).unwrap();
    assert_eq!(of(&mut session, "shadows").reached, 5);
}

#[test]
fn own_scenes_are_kept_saved_and_walked_through_elsewhere() {
    let walk =
        |text: &str| Lesson::of_scene_text("ball.json", text.as_bytes(), &mut |_| unreachable!());
    let mut here = session();
    let path = Some("scenes/ball.json".into());
    here.open_document(walk(SCENE).unwrap(), path.clone())
        .unwrap();
    let text = saved(&mut here);
    let mut there = session();
    let other = SCENE.replace("40 }", "50 }");
    there.open_document(walk(&other).unwrap(), path).unwrap();
    for _ in 0..2 {
        load(&mut there, &text).unwrap();
        assert_eq!(
            there.own_scenes().collect::<Vec<_>>(),
            ["ball.json", "ball.json (2)"]
        );
    }
    there
        .update(Command::OpenOwn("ball.json (2)".into()))
        .unwrap();
    assert_eq!(there.lesson().packed, here.lesson().packed);
    there
        .update(Command::ForgetOwn("ball.json (2)".into()))
        .unwrap();
    assert_eq!(there.own_scenes().collect::<Vec<_>>(), ["ball.json"]);
}

#[test]
fn the_menu_saves_progress_and_asks_for_what_is_to_be_loaded() {
    let mut screen = triangle([]);
    let readers = Readers {
        choose: |_| Err(strings::MENU),
        ..readers()
    };
    screen.harness.state_mut().1.opened = Some(Opened::new(readers, None));
    for (entry, said) in [
        (strings::SAVE_PROGRESS, "lightwalk-progress.json"),
        (
            strings::LOAD_PROGRESS,
            strings::MENU.text(Language::English),
        ),
    ] {
        screen.click(strings::MENU.text(Language::English));
        screen.click(entry.text(Language::English));
        while screen.harness.state().1.choosing.is_some() {
            screen.harness.step();
        }
        let notice = screen.harness.state().1.notice.clone().unwrap();
        assert!(notice.contains(said), "{notice}");
    }
    let (_, bytes) = WRITTEN.with_borrow_mut(Vec::pop).unwrap();
    let text = String::from_utf8(bytes).unwrap();
    assert!(load(screen.session_mut(), &text).is_ok());
}

#[test]
fn own_scenes_stand_on_the_page_of_all_lessons() {
    let mut screen = triangle([]);
    let walk = Lesson::of_scene_text("ball.json", SCENE.as_bytes(), &mut |_| unreachable!());
    let session = screen.session_mut();
    session
        .open_document(walk.unwrap(), Some("ball.json".into()))
        .unwrap();
    session.keep();
    session.update(Command::Open("distance".into())).unwrap();
    session.update(Command::Home).unwrap();
    screen.harness.run();
    screen.keep("own-scenes");
    screen.click("ball.json");
    assert!(screen.session().lesson().is_free_walk());
}
