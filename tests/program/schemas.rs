//! The JSON Schemas that editors complete and underline by: of the program, and as they lie in `lessons/schema`.

use crate::broken::{BROKEN, GOOD};
use crate::broken_files::{BROKEN_LESSONS, LESSON};
use crate::json_schema::fault;
use crate::{folder, lightwalk, refused, succeeded, text};
use serde_json::Value;
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

fn lessons() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("lessons")
}

fn read(path: &Path) -> Value {
    serde_json::from_slice(&fs::read(path).unwrap()).unwrap()
}

fn schema(of: &str) -> Value {
    read(&lessons().join(format!("schema/{of}.json")))
}

#[test]
fn the_stored_schemas_are_those_of_the_program() {
    for of in ["scene", "lesson", "steps"] {
        let printed = succeeded(Path::new("."), &format!("schema {of}")).stdout;
        let stored = fs::read(lessons().join(format!("schema/{of}.json"))).unwrap();
        assert!(
            printed == stored,
            "write it anew: lightwalk schema {of} > lessons/schema/{of}.json"
        );
    }
    let message = refused(&lightwalk(Path::new("."), "schema mesh"), "mesh");
    assert!(message.contains("scene, lesson, steps"), "{message}");
}

#[test]
fn every_lesson_and_scene_of_the_repository_is_as_its_schema_says() {
    for (of, folder) in [("lesson", ""), ("scene", "scenes")] {
        let schema = schema(of);
        let entries = fs::read_dir(lessons().join(folder)).unwrap();
        let paths = entries.map(|entry| entry.unwrap().path());
        let mut checked = 0;
        for path in paths.filter(|path| path.extension().is_some_and(|json| json == "json")) {
            let found = fault(&schema, &read(&path));
            assert_eq!(found, None, "{}", path.display());
            checked += 1;
        }
        assert!(checked > 0);
    }
}

/// Where the program refuses a file for its keys, types or names, so does the schema; what is right for the program is right for it.
#[test]
fn schemas_refuse_what_the_program_refuses_for_keys_and_types() {
    const BY_KEYS_AND_TYPES: [&str; 4] =
        ["unknown key", "unknown choice", "is missing", "; expected"];
    let scenes = BROKEN.iter().map(|case| ("scene", GOOD, case));
    let lessons = BROKEN_LESSONS.iter().map(|case| ("lesson", LESSON, case));
    for of in ["scene", "lesson"] {
        let good = if of == "scene" { GOOD } else { LESSON };
        let found = fault(&schema(of), &serde_json::from_str(good).unwrap());
        assert_eq!(found, None, "{of}");
    }
    let mut refused = 0;
    for (of, good, (from, to, said)) in scenes.chain(lessons) {
        let broken: Result<Value, _> = serde_json::from_str(&good.replacen(from, to, 1));
        let says = |part: &&str| BY_KEYS_AND_TYPES.iter().any(|sign| part.contains(sign));
        let (Ok(broken), true) = (broken, said.iter().any(says)) else {
            continue;
        };
        let found = fault(&schema(of), &broken);
        assert!(found.is_some(), "{of}: {from} → {to} is taken");
        refused += 1;
    }
    assert!(refused > 20, "{refused}");
}

#[test]
fn a_file_may_say_where_its_schema_is() {
    let folder = folder();
    let named = |file: &str| file.replacen('{', "{ \"$schema\": \"schema/here.json\",", 1);
    fs::write(folder.path().join("named.json"), named(GOOD)).unwrap();
    fs::write(folder.path().join("lesson.json"), named(LESSON)).unwrap();
    succeeded(folder.path(), "check named.json lesson.json");
    for (of, file) in [("scene", GOOD), ("lesson", LESSON)] {
        let document = serde_json::from_str(&named(file)).unwrap();
        assert_eq!(fault(&schema(of), &document), None, "{of}");
        let wrong = file.replacen('{', "{ \"$schema\": 1,", 1);
        fs::write(folder.path().join("wrong.json"), &wrong).unwrap();
        let message = refused(&lightwalk(folder.path(), "check wrong.json"), of);
        assert!(
            message.contains("$schema: found 1; expected a text"),
            "{message}"
        );
        assert!(fault(&schema(of), &serde_json::from_str(&wrong).unwrap()).is_some());
    }
}

/// One step of each kind, of lessons of every family.
#[test]
fn printed_steps_are_as_their_schema_says() {
    let schema = schema("steps");
    let mut kinds = BTreeSet::new();
    for lesson in [
        "gouraud-triangle",
        "fast-phong",
        "refraction",
        "texture-transparency",
        "form-factors",
        "shooting",
    ] {
        let output = succeeded(Path::new("."), &format!("steps {lesson}"));
        for line in text(&output.stdout).lines() {
            let step: Value = serde_json::from_str(line).unwrap();
            if kinds.insert(step["kind"].to_string()) {
                assert_eq!(fault(&schema, &step), None, "{line}");
            }
        }
    }
    assert!(kinds.len() > 40, "{}", kinds.len());
    for wrong in [
        r#"{ "step": 0, "depth": 0 }"#,
        r#"{ "step": -1, "depth": 0, "kind": "Frame" }"#,
        r#"{ "step": 0, "depth": 0, "kind": "Frmae" }"#,
        r#"{ "step": 0, "depth": 0, "kind": "Frame", "heigth": 3 }"#,
        r#"{ "step": 0, "depth": 0, "kind": "Frame", "A": [1, 1] }"#,
    ] {
        let step = serde_json::from_str(wrong).unwrap();
        assert!(fault(&schema, &step).is_some(), "{wrong}");
    }
}
