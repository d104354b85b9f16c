//! Whether a JSON file is meant as a lesson or as a scene.

use super::lesson_schema;
use crate::scene::scene_schema;
use serde::de::IgnoredAny;
use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::LazyLock;

/// What has the key `steps`, or more of the keys that only lessons have than of those that only scenes have, is a lesson: so a
/// misspelt key makes no scene of one.
pub fn is_lesson(bytes: &[u8]) -> bool {
    let keys = match serde_json::from_slice::<BTreeMap<String, IgnoredAny>>(bytes) {
        Ok(outermost) => outermost.into_keys().collect(),
        Err(_) => named(&String::from_utf8_lossy(bytes)),
    };
    let only = |own: &LazyLock<BTreeSet<String>>, other: &LazyLock<BTreeSet<String>>| {
        let is_own = |key: &&String| own.contains(*key) && !other.contains(*key);
        keys.iter().filter(is_own).count()
    };
    let is_rather_a_lesson = || only(&OF_LESSONS, &OF_SCENES) > only(&OF_SCENES, &OF_LESSONS);
    keys.iter().any(|key| key == "steps") || is_rather_a_lesson()
}

/// The keys of the outermost object.
static OF_LESSONS: LazyLock<BTreeSet<String>> = LazyLock::new(|| keys(&lesson_schema()));
static OF_SCENES: LazyLock<BTreeSet<String>> = LazyLock::new(|| keys(&scene_schema()));

fn keys(schema: &Value) -> BTreeSet<String> {
    let properties = schema["properties"].as_object().into_iter().flatten();
    properties.map(|(key, _)| key.clone()).collect()
}

/// The keys of broken JSON, as far as they can be told: what stands in quotes before a colon.
fn named(text: &str) -> Vec<String> {
    let pieces: Vec<&str> = text.split('"').collect();
    let keys = pieces
        .windows(2)
        .filter(|pair| pair[1].trim_start().starts_with(':'));
    keys.map(|pair| pair[0].to_owned()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_lesson_with_a_misspelt_key_or_broken_syntax_is_a_lesson() {
        for (text, lesson) in [
            (
                r#"{ "schema": 1, "id": "x", "title": {}, "stpes": [] }"#,
                true,
            ),
            (r#"{ "schema": 1, "steps": [] }"#, true),
            (
                r#"{ "schema": 1, "id": "x", "title": {}, "method": "flat", "scene": { "objects": [] "#,
                true,
            ),
            (
                r#"{ "schema": 1, "objects": [], "materials": {}, "lights": [] }"#,
                false,
            ),
            (r#"{ "schema": 1, "objcts": [], "materials": {} }"#, false),
            (r#"{ "schema": 1, "objects": [ { "name": "steps" "#, false),
            ("", false),
        ] {
            assert_eq!(is_lesson(text.as_bytes()), lesson, "{text}");
        }
    }
}
