//! The scene page: tree, controls and text are one, and nothing is lost.

use super::*;
use crate::app::document::Document;
use crate::app::opened::{Opened, Readers};
use crate::scene::{Limits, View, read};
use std::fs;
use std::path::Path;

const SCENE: &str = r#"{ "schema": 1, "background": [0.25, 0.3, 0.5],
  "camera": { "eye": [0, 1, 5], "target": [0, 0, 0], "up": [0, 1, 0], "fov_x_degrees": 40.0 },
  "materials": {
    "red": { "diffuse": [0.6, 0.2, 0.2], "specular": 0.5, "shininess": 40 },
    "grey": { "diffuse": [0.5, 0.5, 0.5] } },
  "objects": [
    { "name": "ball", "material": "red", "sphere": { "center": [0, 0, 0], "radius": 1 } },
    { "name": "wall", "material": "grey", "polygon": { "vertices": [[-2, -1, -2], [2, -1, -2], [2, 2, -2]] } } ],
  "lights": [ { "point": { "position": [4, 6, 5] } } ] }
"#;

fn walk(_: &Path, text: &[u8]) -> Result<Lesson, Vec<crate::scene::document::Problem>> {
    let scene = read(text, &Limits::default(), &mut |_| Err("no file".into()));
    let scene = scene.map_err(|error| error.problems)?;
    let view = View::new(&scene.camera.unwrap(), 60, 40);
    let prepared = crate::algorithms::prepared_scene::PreparedScene::new(scene, view);
    Ok(Lesson::of_scene("own.json", prepared))
}

const READERS: Readers = Readers {
    document: |path| walk(path, &fs::read(path).unwrap()).map_err(|_| "wrong".into()),
    folder: |_| Err("no folder".into()),
    picture: |_| Err("no picture".into()),
    text: |path| fs::read_to_string(path).map_err(|error| error.to_string()),
    scene: walk,
    lesson: walk,
    write: |path, bytes| fs::write(path, bytes).map_err(|error| error.to_string()),
    choose: |_| Ok(None),
};

/// The page of a scene file.
pub(super) fn page(language: Language) -> (tempfile::TempDir, Screen) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("own.json");
    fs::write(&path, SCENE).unwrap();
    let mut screen = triangle([Command::Speak(language)]);
    let mut opened = Opened::new(READERS, None);
    opened.open(screen.session_mut(), &path).unwrap();
    screen.harness.state_mut().1.opened = Some(opened);
    screen.session_mut().update(Command::EditScene).unwrap();
    screen.harness.run_steps(3);
    (folder, screen)
}

/// Does something with the document and its session.
pub(super) fn with<T>(
    screen: &mut Screen,
    act: impl FnOnce(&mut Document, &mut Session) -> T,
) -> T {
    let (session, window) = screen.harness.state_mut();
    let done = act(window.scene_page.documents.only(), session);
    screen.harness.run_steps(3);
    done
}

fn text(screen: &mut Screen) -> String {
    with(screen, |document, _| document.text().to_owned())
}

#[test]
fn what_is_added_copied_and_deleted_stands_in_the_text_and_in_the_picture() {
    for language in Language::ALL {
        let (_folder, mut screen) = page(language);
        screen.keep(&format!("scene-page-{}", language.code()));
        let objects = |screen: &Screen| screen.session().prepared().scene.objects.len();
        screen.harness.get_by_label("ball").click();
        screen.harness.run_steps(3);
        screen.keep(&format!("scene-page-ball-{}", language.code()));
        screen
            .harness
            .get_by_label(strings::SCENE_COPY.text(language))
            .click();
        screen.harness.run_steps(3);
        assert!(text(&mut screen).contains("\"name\": \"ball-2\""));
        assert_eq!(objects(&screen), 3);
        screen.harness.get_by_label("ball-2").click();
        screen.harness.run_steps(3);
        screen
            .harness
            .get_by_label(strings::SCENE_DELETE.text(language))
            .click();
        screen.harness.run_steps(3);
        assert_eq!(text(&mut screen), SCENE);
        assert_eq!(objects(&screen), 2);
        with(&mut screen, |document, session| document.undo(session));
        assert_eq!(objects(&screen), 3);
    }
}

#[test]
fn a_control_changes_its_value_in_the_text_and_nothing_else() {
    let (_folder, mut screen) = page(Language::English);
    screen.harness.get_by_label("wall").click();
    screen.harness.run_steps(3);
    screen
        .harness
        .get_by_label("objects[1].polygon.vertices[2][1]");
    screen.harness.get_by_label("ball").click();
    screen.harness.run_steps(3);
    let radius = screen.harness.get_by_label("objects[0].sphere.radius");
    let at = radius.rect().center();
    screen.harness.drag_at(at);
    screen.harness.run_steps(2);
    screen.harness.hover_at(at + egui::vec2(30.0, 0.0));
    screen.harness.run_steps(2);
    screen.harness.drop_at(at + egui::vec2(30.0, 0.0));
    screen.harness.run_steps(3);
    let now = text(&mut screen);
    let (before, rest) = now.split_once("\"radius\": ").unwrap();
    let (value, after) = rest.split_once(' ').unwrap();
    assert!(value.parse::<f64>().unwrap() > 1.0, "{value}");
    assert_eq!(format!("{before}\"radius\": 1 {after}"), SCENE);
}

#[test]
fn a_mistake_in_the_text_is_named_with_its_place_and_the_last_right_picture_stays() {
    let (_folder, mut screen) = page(Language::English);
    for (from, to, line, said) in [
        (
            "\"radius\": 1 ",
            "\"radius\": -1 ",
            7,
            "objects[0].sphere.radius: found -1",
        ),
        (
            "\"red\", \"sphere\"",
            "\"rde\", \"sphere\"",
            7,
            "found \"rde\", which is no material",
        ),
        ("\"camera\"", "\"camrea\"", 2, "did you mean camera?"),
        ("\"lights\": [", "\"lights\": [[", 9, "found a list"),
    ] {
        let wrong = SCENE.replacen(from, to, 1);
        assert_ne!(wrong, SCENE);
        with(&mut screen, |document, session| {
            document.write(wrong, session)
        });
        let words = with(&mut screen, |document, _| document.in_words());
        assert!(words.contains(&format!("line {line}, column ")), "{words}");
        assert!(words.contains(said), "{words}");
        assert_eq!(screen.harness.query_all_by_label_contains(said).count(), 1);
        assert_eq!(screen.session().prepared().scene.objects.len(), 2);
    }
    screen.keep("scene-page-wrong");
    with(&mut screen, |document, session| {
        document.write(SCENE.into(), session)
    });
    assert!(with(&mut screen, |document, _| document
        .problems
        .is_empty()));
}

#[test]
fn nothing_is_saved_over_what_someone_else_has_written_unless_that_is_wanted() {
    let (folder, mut screen) = page(Language::English);
    let path = folder.path().join("own.json");
    let theirs = SCENE.replace("\"ball\"", "\"sun\"");
    fs::write(&path, &theirs).unwrap();
    with(&mut screen, |document, session| document.look(session));
    assert_eq!(text(&mut screen), theirs, "nothing was unsaved");
    let mine = theirs.replace("\"sun\"", "\"moon\"");
    with(&mut screen, |document, session| {
        document.write(mine.clone(), session)
    });
    fs::write(&path, SCENE).unwrap();
    assert!(!with(&mut screen, |document, _| document.save(false)).unwrap());
    assert_eq!(fs::read_to_string(&path).unwrap(), SCENE);
    screen
        .harness
        .get_by_label(strings::SCENE_CONFLICT.text(Language::English));
    screen.click_in_page(strings::SCENE_SAVE_MINE.text(Language::English));
    assert_eq!(fs::read_to_string(&path).unwrap(), mine);
    assert!(with(&mut screen, |document, _| document.is_saved()
        && !document.in_conflict));
}

impl Screen {
    /// The page looks at its file again and again: it never comes to rest.
    fn click_in_page(&mut self, label: &str) {
        self.harness.get_by_label(label).click();
        self.harness.run_steps(3);
    }
}

#[test]
fn a_lesson_is_no_scene_of_its_own() {
    let mut session = Session::new(builtin("distance").unwrap().read().unwrap()).unwrap();
    assert_eq!(
        session.update(Command::EditScene),
        Err(strings::EDIT_A_SCENE.into())
    );
}
