//! Broken scenes and lessons: each is refused with its place and reason, and leaves no file.

use crate::broken::{BROKEN, GOOD, POT};
use crate::{folder, lightwalk, refused, succeeded};
use std::fs;

#[test]
fn every_broken_scene_is_refused_without_a_file() {
    let folder = folder();
    for (from, to, said) in BROKEN {
        let case = format!("{from} → {to}");
        fs::write(
            folder.path().join("broken.json"),
            GOOD.replacen(from, to, 1),
        )
        .unwrap();
        let message = refused(
            &lightwalk(
                folder.path(),
                "render broken.json --method gouraud --out out.png",
            ),
            &case,
        );
        assert!(
            message.starts_with("lightwalk: broken.json: "),
            "{case}: {message}"
        );
        for part in *said {
            assert!(message.contains(part), "{case}: {message} lacks {part}");
        }
        assert_eq!(
            fs::read_dir(folder.path()).unwrap().count(),
            3,
            "{case}: left a file behind"
        );
    }
}

/// A right lesson, to be broken in one place.
pub const LESSON: &str = r#"{ "schema": 1, "id": "my-lesson", "number": 1,
  "title": { "en": "A title", "id": "Judul" }, "summary": { "en": "Why", "id": "Mengapa" }, "topics": ["gouraud"],
  "scene_file": "scene.json", "names": { "pot": { "en": "the pot", "id": "panci" } }, "method": "gouraud", "size": [64, 48], "focus": { "polygon": 0 },
  "parameters": [{ "light": 0 }], "panels": ["image", "scan-line"],
  "steps": [
    { "at": { "kind": "VertexLit" }, "say": { "en": "It has {I_v:2}.", "id": "Nilainya {I_v:2}." },
      "question": { "ask": { "en": "How bright?", "id": "Seberapa terang?" }, "at": { "kind": "VertexLit" },
        "answer": { "number": { "field": "I_v.r", "tolerance": 0.01 } }, "why": { "en": "So.", "id": "Begitu." } } },
    { "at": { "kind": "EdgeTable" }, "say": { "en": "Edges", "id": "Sisi" } } ] }"#;

#[rustfmt::skip]
pub const BROKEN_LESSONS: &[(&str, &str, &[&str])] = &[
    ("\"schema\": 1,", "", &["`schema` is missing"]),
    ("\"number\": 1,", "", &["the key `number` is missing"]),
    ("\"number\": 1,", "\"number\": -1,", &["number", "line 1"]),
    ("\"number\": 1,", "\"numbr\": 1,", &["unknown key `numbr` (did you mean number?)"]),
    ("my-lesson", "My Lesson", &["id: found \"My Lesson\"", "lower-case"]),
    ("\"en\": \"A title\", \"id\": \"Judul\"", "", &["title: found no text; it needs the key `en`, `id` or both"]),
    ("Judul", "  ", &["title.id: found an empty text"]),
    ("\"id\": \"Sisi\"", "\"de\": \"Kanten\"", &["steps[1].say", "unknown key `de`"]),
    ("\"scene_file\": \"scene.json\", ", "", &["exactly one of the keys `scene`"]),
    ("scene.json", "../scene.json", &["scene_file", ".."]),
    ("scene.json", "/etc/passwd", &["scene_file"]),
    ("scene.json", "none.json", &["scene_file", "none.json"]),
    ("\"method\": \"gouraud\"", "\"method\": \"gouraud\", \"texture_mapping\": \"bent\"", &["texture_mapping: found \"bent\"; allowed are perspective, linear"]),
    ("\"pot\": {", "\"pan\": {", &["names.pan: there is no object or material of this name; allowed are ball, blue,"]),
    ("\"panci\"", "\"\"", &["names.pot.id: found an empty text"]),
    ("\"id\": \"panci\"", "\"de\": \"Topf\"", &["names.pot", "unknown key `de`"]),
    ("\"method\": \"gouraud\"", "\"method\": \"goraud\"", &["method: found \"goraud\"; allowed are wireframe, flat, gouraud"]),
    ("[64, 48]", "[0, 48]", &["size: found 0×48"]),
    ("[64, 48]", "[64000000, 48]", &["size: found 64000000×48"]),
    ("[64, 48]", "[64]", &["size", "line 3"]),
    ("{ \"polygon\": 0 }", "{ \"polygon\": 99999 }", &["focus: found 99999: there are", "polygons"]),
    ("{ \"polygon\": 0 }", "{ \"scan_line\": 48 }", &["focus: found 48: there are 48 rows, counted from 0"]),
    ("{ \"polygon\": 0 }", "{ \"circle\": 0 }", &["focus", "unknown choice `circle`"]),
    ("{ \"light\": 0 }", "{ \"light\": 1 }", &["parameters[0]: found 1, a directional light; only point"]),
    ("{ \"light\": 0 }", "{ \"light\": 0 }, { \"light\": 7 }", &["parameters[1]: found 7; the scene has 2 lights"]),
    ("{ \"light\": 0 }", "{ \"light\": 0 }, { \"light\": 0 }", &["parameters[1]: found a parameter that stands in the list already"]),
    ("{ \"light\": 0 }", "{ \"light\": -1 }", &["parameters[0].light", "line 4"]),
    ("{ \"light\": 0 }", "{ \"lamp\": 0 }", &["parameters[0]", "line 4", "unknown choice `lamp`"]),
    ("{ \"light\": 0 }", "{ \"specular\": \"glass\" }", &["parameters[0]: found \"glass\", which is no material of the scene; it has"]),
    ("{ \"light\": 0 }", "{ \"divisions\": \"glass\" }", &["parameters[0]: found \"glass\", which is no object"]),
    ("[{ \"light\": 0 }]", "null", &["parameters", "null"]),
    ("\"scan-line\"", "\"scanline\"", &["panels[1]: found \"scanline\"; allowed are active-edges"]),
    ("[\"image\", \"scan-line\"]", "[]", &["panels: found an empty list"]),
    ("\"kind\": \"EdgeTable\"", "\"kind\": \"EdgeTabel\"", &["steps[1].at: no step from", "EdgeTable"]),
    ("\"kind\": \"EdgeTable\"", "\"kind\": \"Frame\"", &["steps[1].at: no step from"]),
    ("\"kind\": \"EdgeTable\"", "\"index\": 7", &["steps[1].at", "unknown key `index`"]),
    ("It has {I_v:2}", "It has {I_w}", &["steps[0].say.en: found `{I_w}`", "recorded are"]),
    ("It has {I_v:2}", "It has {I_v", &["steps[0].say.en: found `{` without"]),
    ("\"I_v.r\"", "\"I_7\"", &["steps[0].question.answer: `I_7` is no number recorded"]),
    ("\"tolerance\": 0.01", "\"tolerance\": -1", &["steps[0].question.answer", "tolerance"]),
    ("\"tolerance\": 0.01", "\"tolerance\": 1e400", &["line", "finite"]),
    ("{ \"number\": { \"field\": \"I_v.r\", \"tolerance\": 0.01 } }", "{ \"pixel\": { \"tolerance\": 0 } }", &["does not record a pixel"]),
    ("{ \"number\": { \"field\": \"I_v.r\", \"tolerance\": 0.01 } }", "{ \"choice\": [] }", &["0 of the 0 options hold"]),
    ("\"ask\": ", "\"aks\": ", &["steps[0].question", "unknown key `aks`"]),
    ("] }", "]", &["the file ends here"]),
];

#[test]
fn every_broken_lesson_is_refused_with_its_place_and_reason() {
    let folder = folder();
    fs::write(folder.path().join("lesson.json"), LESSON).unwrap();
    succeeded(folder.path(), "check lesson.json scene.json");
    for (from, to, said) in BROKEN_LESSONS {
        let case = format!("{from} → {to}");
        assert!(LESSON.contains(from), "{case}");
        // The last of them, so that an ending can be cut off too
        let at = if *from == "] }" {
            LESSON.rfind(from)
        } else {
            LESSON.find(from)
        }
        .unwrap();
        let broken = format!("{}{to}{}", &LESSON[..at], &LESSON[at + from.len()..]);
        fs::write(folder.path().join("broken.json"), broken).unwrap();
        let message = refused(&lightwalk(folder.path(), "check broken.json"), &case);
        for part in *said {
            assert!(message.contains(part), "{case}: {message} lacks {part}");
        }
        refused(
            &lightwalk(folder.path(), "frames broken.json --out frames"),
            &case,
        );
        assert!(!folder.path().join("frames").exists(), "{case}");
    }
}

#[test]
fn the_kinds_of_steps_are_listed_once_for_all_anchors_that_are_not_found() {
    let folder = folder();
    let broken = LESSON.replace("\"VertexLit\"", "\"VertexLti\"");
    let broken = broken.replace("\"EdgeTable\"", "\"EdgeTabel\"");
    fs::write(folder.path().join("broken.json"), broken).unwrap();
    let message = refused(&lightwalk(folder.path(), "check broken.json"), "anchors");
    let count = |part: &str| message.matches(part).count();
    assert_eq!(count("at: no step from 0 on is like this"), 2, "{message}");
    assert_eq!(count("the run has steps of the kinds"), 1, "{message}");
}

#[test]
fn an_empty_object_is_reported_with_all_that_a_scene_needs() {
    let folder = folder();
    fs::write(folder.path().join("empty.json"), "{}").unwrap();
    let message = refused(&lightwalk(folder.path(), "check empty.json"), "{}");
    let all = "line 1, column 2: the keys `materials`, `objects`, `schema` are missing";
    assert!(message.contains(all), "{message}");
}

#[cfg(unix)]
#[test]
fn a_mesh_outside_the_folder_is_refused_also_behind_a_link() {
    let outside = tempfile::tempdir().unwrap();
    fs::write(outside.path().join("secret.obj"), POT).unwrap();
    let folder = folder();
    std::os::unix::fs::symlink(
        outside.path().join("secret.obj"),
        folder.path().join("meshes/link.obj"),
    )
    .unwrap();
    std::os::unix::fs::symlink(outside.path(), folder.path().join("away")).unwrap();
    std::os::unix::fs::symlink(
        folder.path().join("meshes/pot.obj"),
        folder.path().join("inside.obj"),
    )
    .unwrap();
    for (mesh, right) in [
        ("meshes/link.obj", false),
        ("away/secret.obj", false),
        ("inside.obj", true),
    ] {
        fs::write(
            folder.path().join("linked.json"),
            GOOD.replace("meshes/pot.obj", mesh),
        )
        .unwrap();
        if right {
            succeeded(folder.path(), "check linked.json");
        } else {
            let output = lightwalk(folder.path(), "check linked.json");
            assert!(refused(&output, mesh).contains("outside"));
        }
    }
}
