//! The catalogues of text: complete in every language, and used.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

const CATALOGUES: [(&str, &str); 2] = [
    ("en.ftl", include_str!("../src/language/en.ftl")),
    ("id.ftl", include_str!("../src/language/id.ftl")),
];

/// Each key with its message: a message is the line of its key and the indented ones under it.
fn messages(name: &str, source: &str) -> BTreeMap<String, String> {
    let mut messages = BTreeMap::new();
    let mut last = None;
    for line in source.lines().filter(|line| !line.starts_with('#')) {
        if line.starts_with(' ') {
            let message: Option<&mut String> = last.as_ref().and_then(|key| messages.get_mut(key));
            message
                .unwrap_or_else(|| panic!("{name}: `{line}` belongs to no key"))
                .push_str(line);
        } else if !line.is_empty() {
            let (key, text) = line
                .split_once(" =")
                .unwrap_or_else(|| panic!("{name}: `{line}` is no message"));
            let before = messages.insert(key.to_string(), text.trim().to_string());
            assert!(before.is_none(), "{name} has `{key}` twice");
            last = Some(key.to_string());
        }
    }
    messages
}

/// The names after `$`.
fn arguments(message: &str) -> BTreeSet<String> {
    let names = message.split('$').skip(1);
    names
        .map(|rest| {
            let end = rest.find(|c: char| !(c.is_alphanumeric() || c == '-' || c == '_'));
            rest[..end.unwrap_or(rest.len())].to_string()
        })
        .collect()
}

fn sources(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            sources(&path, found);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            found.push(path);
        }
    }
}

/// Every text in quotes in `src` that could be a key: lower-case words with hyphens between them.
fn quoted() -> BTreeMap<String, bool> {
    let mut files = Vec::new();
    sources(
        &Path::new(env!("CARGO_MANIFEST_DIR")).join("src"),
        &mut files,
    );
    let mut quoted = BTreeMap::new();
    for file in files {
        let source = fs::read_to_string(file).unwrap();
        let mut rest = source.as_str();
        while let Some(at) = rest.find('"') {
            let named = rest[..at].trim_end().ends_with("Message(");
            rest = &rest[at + 1..];
            let end = rest.find('"').unwrap_or(rest.len());
            let text = &rest[..end];
            let is_key = text.contains('-')
                && text
                    .bytes()
                    .all(|byte| byte.is_ascii_lowercase() || byte.is_ascii_digit() || byte == b'-');
            if is_key {
                *quoted.entry(text.to_string()).or_insert(false) |= named;
            }
        }
    }
    quoted
}

#[test]
fn every_message_is_there_in_every_language_with_the_same_arguments() {
    let [english, others @ ..] = CATALOGUES.map(|(name, source)| (name, messages(name, source)));
    assert!(english.1.len() > 200, "{} messages", english.1.len());
    for (name, other) in others {
        for (key, message) in &english.1 {
            let translated = other
                .get(key)
                .unwrap_or_else(|| panic!("{name} lacks `{key}`"));
            assert_eq!(
                arguments(message),
                arguments(translated),
                "arguments of `{key}` in {name}"
            );
            assert!(
                !message.is_empty() && !translated.is_empty(),
                "`{key}` says nothing"
            );
        }
        let more: Vec<&String> = other
            .keys()
            .filter(|key| !english.1.contains_key(*key))
            .collect();
        assert!(more.is_empty(), "{name} alone has {more:?}");
    }
}

#[test]
fn every_key_in_the_code_is_in_the_catalogue_and_every_message_is_used() {
    let (name, source) = CATALOGUES[0];
    let messages = messages(name, source);
    let quoted = quoted();
    for (key, _) in quoted.iter().filter(|(_, named)| **named) {
        assert!(messages.contains_key(key), "{name} lacks `{key}`");
    }
    let unused: Vec<&String> = messages
        .keys()
        .filter(|key| !quoted.contains_key(*key))
        .collect();
    assert!(unused.is_empty(), "no code names {unused:?}");
}
