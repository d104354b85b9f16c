//! The catalogues of text: complete in every language, used, and the only place of text on screen.

use lightwalk::vocabulary::FAMILIES;
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

fn is_key(text: &str) -> bool {
    !text.is_empty()
        && text
            .bytes()
            .all(|byte| byte.is_ascii_lowercase() || byte.is_ascii_digit() || byte == b'-')
}

/// A name of the program as the catalogues write it: `EdgeInterpolated` as `edge-interpolated`.
fn hyphenated(name: &str) -> String {
    let mut key = String::new();
    for c in name.chars() {
        let follows_small = key.ends_with(|c: char| c.is_ascii_lowercase() || c.is_ascii_digit());
        if c.is_ascii_uppercase() && follows_small || !c.is_ascii_alphanumeric() {
            key.push('-');
        }
        key.extend(c.is_ascii_alphanumeric().then(|| c.to_ascii_lowercase()));
    }
    key
}

/// Every text in quotes in `src` that could be a key: lower-case words with hyphens between them; and the keys in braces, as
/// pseudocode has them.
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
            if text.contains('-') && is_key(text) {
                *quoted.entry(text.to_string()).or_insert(false) |= named;
            }
            for space in [
                "mistake",
                "mistake-about",
                "mistake-group",
                "kind",
                "method",
                "object",
                "operations",
                "quantity",
                "racer",
                "value",
            ] {
                let key = format!("{space}-{}", hyphenated(text));
                quoted.entry(key).or_insert(false);
            }
            let braced = text.split('{').skip(1);
            for key in braced.filter_map(|rest| Some(rest.split_once('}')?.0)) {
                if is_key(key) {
                    *quoted.entry(key.to_string()).or_insert(false) |= key.contains('-');
                }
            }
        }
    }
    quoted
}

/// The messages in which a value of some kind of event is explained.
fn meanings(messages: &BTreeMap<String, String>) -> BTreeSet<String> {
    let values = FAMILIES.into_iter().flatten().flat_map(|kind| {
        let names = kind.quantities.iter().map(|quantity| quantity.name);
        names.map(|name| (format!("meaning-{name}"), kind.name))
    });
    let keys = values.map(|(general, kind)| {
        let own = format!("{general}-of-{kind}");
        if messages.contains_key(&own) {
            own
        } else {
            general
        }
    });
    keys.collect()
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

/// Sentences of steps and notes are set as mathematics, which lowers one letter unless there are braces.
#[test]
fn an_index_of_several_letters_stands_in_braces() {
    for (name, source) in CATALOGUES {
        for (key, message) in messages(name, source) {
            if !key.starts_with("event-") && !key.starts_with("note-") {
                continue;
            }
            // Arguments have names of their own.
            let literals = message
                .split('{')
                .map(|part| part.split_once('}').map_or(part, |(_, literals)| literals));
            for part in literals {
                let indices = part.split('_').skip(1);
                for index in indices {
                    let letters = index.chars().take_while(|c| c.is_alphabetic()).count();
                    assert!(letters < 2, "{name}, {key}: _{index}");
                }
            }
        }
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
    let meanings = meanings(&messages);
    let unused: Vec<&String> = messages
        .keys()
        .filter(|key| !quoted.contains_key(*key) && !meanings.contains(*key))
        .collect();
    assert!(unused.is_empty(), "no code names {unused:?}");
}

/// Names of widgets for egui, which nobody reads.
const UNSEEN: [&str; 9] = [
    "column border",
    "key sheet",
    "left out",
    "on front",
    "own error",
    "row end",
    "the end of a row has another width",
    "the words of this step take another height",
    "time line",
];

/// What stands in quotes in code that is no test, with comments and messages of broken invariants left out.
fn literals(source: &str) -> Vec<&str> {
    let code = source.split("#[cfg(test)]\nmod tests").next().unwrap();
    let mut literals = Vec::new();
    for line in code.lines().map(|line| line.split("//").next().unwrap()) {
        let mut rest = line;
        while let Some(at) = rest.find('"') {
            let is_invariant = ["expect(", "panic!(", "assert!(", "unreachable!("]
                .iter()
                .any(|call| rest[..at].ends_with(call));
            rest = &rest[at + 1..];
            let end = rest.find('"').unwrap_or(rest.len());
            if !is_invariant {
                literals.push(&rest[..end]);
            }
            rest = rest.get(end + 1..).unwrap_or_default();
        }
    }
    literals
}

/// Whether a text has two words of a language beside each other; what stands in braces is none.
fn is_prose(text: &str) -> bool {
    let mut without_braces = String::new();
    let mut depth = 0;
    for c in text.chars() {
        depth += i32::from(c == '{');
        if depth == 0 {
            without_braces.push(c);
        }
        depth -= i32::from(c == '}');
    }
    let is_word = |word: &str| {
        let word = word.trim_matches(|c: char| !c.is_alphabetic());
        word.len() > 1 && word.chars().all(|c| c.is_ascii_lowercase())
    };
    let words: Vec<bool> = without_braces.split_whitespace().map(is_word).collect();
    words.windows(2).any(|pair| pair == [true, true])
}

/// A command line is the same in every language.
fn is_command(text: &str) -> bool {
    text.starts_with("lightwalk ")
}

/// The files of panels and window whose text people read in their language, by name.
fn shown_sources() -> Vec<(String, String)> {
    let mut files = Vec::new();
    for folder in ["src/panels", "src/app"] {
        sources(
            &Path::new(env!("CARGO_MANIFEST_DIR")).join(folder),
            &mut files,
        );
    }
    // Without a window nobody has chosen a language.
    let others = [
        "/tests",
        "fixture",
        "painter",
        "main_window",
        "eframe_app",
        "app/page",
        "sample",
    ];
    let names = files.iter().map(|file| file.to_string_lossy().into_owned());
    names
        .filter(|name| !others.iter().any(|other| name.contains(other)))
        .map(|name| (name.clone(), fs::read_to_string(name).unwrap()))
        .collect()
}

#[test]
fn panels_and_window_have_no_text_outside_of_the_catalogues() {
    assert!(is_prose("{count} more of them") && !is_prose("cos θ_i {angle}"));
    for (name, source) in shown_sources() {
        for text in literals(&source) {
            assert!(
                !is_prose(text) || UNSEEN.contains(&text) || is_command(text),
                "{name}: `{text}` is in no catalogue"
            );
        }
    }
}

/// What stands between the parentheses of each `format!`.
fn formatted(source: &str) -> impl Iterator<Item = &str> {
    source.split("format!(").skip(1).map(|rest| {
        let mut depth = 1;
        let end = rest.find(|c: char| {
            depth += i32::from(c == '(') - i32::from(c == ')');
            depth == 0
        });
        &rest[..end.unwrap_or(rest.len())]
    })
}

/// Whether the text of a message is put beside something else: there a translator could not change the order of the words.
fn joins_a_message(formatted: &str) -> bool {
    let mut parts = formatted.splitn(3, '"').skip(1);
    let (Some(literal), Some(values)) = (parts.next(), parts.next()) else {
        return false;
    };
    let texts = [".text(", "localize(", "strings("];
    literal.matches('{').count() > 1 && texts.iter().any(|text| values.contains(text))
}

#[test]
fn messages_are_whole_with_their_arguments_in_them() {
    assert!(joins_a_message("\"{} {count}\", RAYS.text(language)"));
    assert!(!joins_a_message("\"{} ▾\", RAYS.text(language)"));
    let mut joined = Vec::new();
    for (name, source) in shown_sources() {
        let found = formatted(&source).filter(|formatted| joins_a_message(formatted));
        joined.extend(found.map(|formatted| format!("{name}: format!({formatted})")));
    }
    assert_eq!(joined, Vec::<String>::new(), "no whole messages");
}
