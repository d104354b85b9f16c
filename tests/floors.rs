//! The floors of the crate and their order: each may use only what stands above it in this list. `lib.rs` tells what each is for.

use std::fs;
use std::path::{Path, PathBuf};

/// Floors in one row may use each other.
const FLOORS: [&[&str]; 15] = [
    &["color", "language", "numeric"],
    &["picture"],
    &["figure"],
    &["record"],
    &["scene"],
    &["algorithms"],
    &["vocabulary"],
    &["methods"],
    &["render"],
    &["replay"],
    &["panels"],
    &["lesson"],
    &["study"],
    &["app"],
    &["commands"],
];

/// What `picture` may use: it knows no algorithm.
const OF_PICTURE: [&str; 2] = ["color", "picture"];

/// What `figure` may use: values come in ready to be drawn.
const OF_FIGURE: [&str; 5] = ["color", "figure", "language", "numeric", "picture"];

fn level(floor: &str) -> Option<usize> {
    FLOORS.iter().position(|row| row.contains(&floor))
}

fn sources(folder: &Path) -> Vec<PathBuf> {
    let mut files = Vec::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            files.extend(sources(&path));
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            files.push(path);
        }
    }
    files
}

/// The first names behind `crate::`, also in `crate::{a, b::c}`.
fn floors_named(source: &str) -> Vec<String> {
    let mut named = Vec::new();
    for (at, _) in source.match_indices("crate::") {
        let rest = &source[at + "crate::".len()..];
        let name = |text: &str| {
            text.trim()
                .chars()
                .take_while(|c| c.is_alphanumeric() || *c == '_')
                .collect::<String>()
        };
        match rest.strip_prefix('{') {
            None => named.push(name(rest)),
            Some(group) => {
                // Names at the outermost level of the braces
                let mut depth = 0;
                let mut start = 0;
                for (i, c) in group.char_indices() {
                    match c {
                        '{' => depth += 1,
                        '}' if depth == 0 => {
                            named.push(name(&group[start..i]));
                            break;
                        }
                        '}' => depth -= 1,
                        ',' if depth == 0 => {
                            named.push(name(&group[start..i]));
                            start = i + 1;
                        }
                        _ => {}
                    }
                }
            }
        }
    }
    named.retain(|name| !name.is_empty());
    named
}

/// The paths in `source`, a file of `floor`, that point down the list.
fn faults(floor: &str, source: &str) -> Vec<String> {
    let own = level(floor)
        .unwrap_or_else(|| panic!("src/{floor} is no floor: add it to the list, at its place"));
    floors_named(source)
        .into_iter()
        .filter(|named| match level(named) {
            Some(_) if floor == "picture" => !OF_PICTURE.contains(&named.as_str()),
            Some(_) if floor == "figure" => !OF_FIGURE.contains(&named.as_str()),
            Some(used) => used > own,
            None => panic!("src/{floor} names crate::{named}, which is no floor"),
        })
        .collect()
}

#[test]
fn no_floor_uses_one_below_it() {
    let src = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut read = 0;
    for file in sources(&src) {
        let relative = file.strip_prefix(&src).unwrap();
        let Some(floor) = relative
            .iter()
            .next()
            .and_then(|name| name.to_str())
            .filter(|name| !name.ends_with(".rs"))
        else {
            continue;
        };
        let faults = faults(floor, &fs::read_to_string(&file).unwrap());
        assert!(
            faults.is_empty(),
            "{} uses {faults:?}, which stand below {floor}",
            relative.display()
        );
        read += 1;
    }
    assert!(read > 50, "only {read} files were read");
}

/// Whether `path` stands in the source as a whole word: `eframe::` does not stand in `wireframe::`.
fn names(source: &str, path: &str) -> bool {
    source
        .match_indices(path)
        .any(|(at, _)| !source[..at].ends_with(|c: char| c.is_alphanumeric() || c == '_'))
}

#[test]
fn only_the_shell_knows_the_window_and_touches_files() {
    let src = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    for file in sources(&src) {
        let relative = file.strip_prefix(&src).unwrap();
        let source = fs::read_to_string(&file).unwrap();
        let shell = relative.starts_with("app") || relative.starts_with("commands");
        assert!(
            shell || !names(&source, "eframe::"),
            "{} knows eframe",
            relative.display()
        );
        assert!(
            shell || !names(&source, "egui::"),
            "{} knows egui",
            relative.display()
        );
        let touches = ["std::fs", "File::open", "File::create"]
            .iter()
            .any(|path| source.contains(path));
        let test_of_files = relative.starts_with("scene") && source.contains("#[cfg(test)]");
        assert!(
            shell || test_of_files || !touches,
            "{} touches files",
            relative.display()
        );
        let clock = ["Instant::now", "SystemTime::now"]
            .iter()
            .any(|path| source.contains(path));
        assert!(
            shell || relative.starts_with("render") || relative.starts_with("study") || !clock,
            "{} reads a clock",
            relative.display()
        );
    }
}

#[test]
fn the_check_sees_what_it_should() {
    assert_eq!(
        faults("scene", "use crate::algorithms::stage;"),
        ["algorithms"]
    );
    assert_eq!(
        faults(
            "replay",
            "use crate::{color::{Rgb, pfm}, panels::Show, record};"
        ),
        ["panels"]
    );
    assert_eq!(faults("picture", "crate::scene::Mesh"), ["scene"]);
    assert_eq!(faults("figure", "crate::replay::Run"), ["replay"]);
    assert_eq!(
        faults("lesson", "crate::panels::Panel, crate::color::Rgb"),
        [""; 0]
    );
}
