//! Values of the document, changed by their paths; undo; and what does not happen after a change.

use super::*;
use crate::lesson::PathValue;

/// A pane before a page: its index of refraction, its transmission and the depth of the tree can be changed by their paths.
fn pane() -> Lesson {
    let json = r#"{ "schema": 1, "id": "pane", "number": 1, "topics": [],
        "title": { "en": "T", "id": "T" }, "summary": { "en": "S", "id": "S" },
        "scene": { "schema": 1, "materials": { "chalk": { "diffuse": [1, 1, 1] }, "glass": { "transmission": 0.9, "ior": 1.5 } },
            "camera": { "eye": [0, 0, 4], "target": [0, 0, 0], "up": [0, 1, 0], "fov_x_degrees": 40 },
            "objects": [{ "name": "page", "material": "chalk", "polygon": { "vertices": [[-9, -9, 0], [9, -9, 0], [0, 9, 0]] } },
                { "name": "ball", "material": "glass", "sphere": { "center": [0, 0, 2], "radius": 0.5 } }],
            "lights": [{ "point": { "position": [0, 3, 3] } }] },
        "method": "ray-tracing", "size": [25, 19], "depth": 5, "focus": { "pixel": [12, 8] }, "panels": ["image"],
        "parameters": [
            { "number": { "path": "scene.materials.glass.ior", "name": { "en": "η", "id": "η" }, "from": 1, "to": 2.5 } },
            { "number": { "path": "depth", "name": { "en": "depth", "id": "kedalaman" }, "from": 1, "to": 8, "whole": true } },
            { "choice": { "path": "scene.materials.glass.transmission", "name": { "en": "glass", "id": "kaca" }, "options": [
                { "value": 0.9, "name": { "en": "clear", "id": "bening" } }, { "value": 0, "name": { "en": "none", "id": "tak ada" } }] } }],
        "steps": [{ "at": "Ray", "title": { "en": "Begin", "id": "Mulai" }, "say": { "en": "A", "id": "A" } },
            { "at": "Refraction", "title": { "en": "Into the glass", "id": "Ke dalam kaca" }, "say": { "en": "η is {eta_r}", "id": "η {eta_r}" },
              "otherwise": { "en": "The ray ends.", "id": "Sinar berakhir." } },
            { "at": "PixelColored", "title": { "en": "End", "id": "Akhir" }, "say": { "en": "C", "id": "C" } }] }"#;
    let read = Lesson::read(
        json.as_bytes(),
        &Default::default(),
        &mut |_| unreachable!(),
    );
    let lesson = read.unwrap();
    lesson.check_parameters().unwrap();
    lesson
}

fn by_path(parameter: usize, value: PathValue) -> Command {
    Command::Change(Change::ByPath { parameter, value })
}

#[test]
fn a_value_of_the_document_is_changed_undone_and_done_again() {
    let mut session = Session::new(pane()).unwrap();
    let ior = |session: &Session| session.prepared().scene.materials[1].ior;
    let depth = |session: &Session| {
        let settings: primary::Settings = session.setup().settings.get();
        settings.depth.get()
    };
    assert_eq!(
        session.update(Command::Undo),
        Err(strings::NOTHING_TO_UNDO.into())
    );
    session.update(by_path(0, PathValue::Number(1.7))).unwrap();
    session.update(by_path(0, PathValue::Number(2.0))).unwrap();
    session.update(by_path(1, PathValue::Number(2.0))).unwrap();
    assert_eq!((ior(&session), depth(&session)), (2.0, 2));
    session.update(Command::Undo).unwrap();
    assert_eq!((ior(&session), depth(&session)), (2.0, 5));
    session.update(Command::Undo).unwrap();
    assert_eq!(
        (ior(&session), session.is_changed()),
        (1.5, false),
        "a slider that moves is one change"
    );
    session.update(Command::Redo).unwrap();
    session.update(Command::Redo).unwrap();
    assert_eq!((ior(&session), depth(&session)), (2.0, 2));
    session.update(Command::LessonsValues).unwrap();
    assert!(!session.is_changed() && ior(&session) == 1.5 && depth(&session) == 5);
    session.update(Command::Undo).unwrap();
    assert_eq!((ior(&session), depth(&session)), (2.0, 2));
    let refused = session.update(by_path(0, PathValue::Number(9.0)));
    assert!(matches!(refused, Err(Refused::Error(_))));
    assert_eq!(ior(&session), 2.0);
}

#[test]
fn what_does_not_happen_is_reported_where_it_would_follow() {
    let mut session = Session::new(pane()).unwrap();
    assert_eq!(session.explanations(), 3);
    session.update(by_path(2, PathValue::Option(1))).unwrap();
    assert_eq!(session.explanations(), 2);
    assert!(!session.is_silent());
    let notes: Vec<_> = session.not_happening_here();
    assert_eq!(notes, [(Some("Into the glass"), Some("The ray ends."))]);
    session.update(Command::NextNarrated).unwrap();
    assert_eq!(session.walk().kind(session.step()), "PixelColored");
    assert!(session.not_happening_here().is_empty());
    session.update(by_path(2, PathValue::Option(0))).unwrap();
    assert_eq!(session.explanations(), 3);
}
