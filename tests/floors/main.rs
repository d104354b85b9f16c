//! The floors of the crate and their order: each may use only what stands above it in this list. `lib.rs` says what each is for.

mod circles;

use std::fs;
use std::path::{Path, PathBuf};

/// Floors in one row may use each other.
const FLOORS: [&[&str]; 16] = [
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
    &["export"],
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

/// All paths behind `crate::`, also those in braces, without `crate`.
fn paths(source: &str) -> Vec<String> {
    let mut paths = Vec::new();
    for (at, _) in source.match_indices("crate::") {
        tree(&source[at + "crate::".len()..], "", &mut paths);
    }
    paths
}

/// Adds the paths of a tree of imports, as far as it goes, and returns what stands behind it.
fn tree<'a>(source: &'a str, above: &str, paths: &mut Vec<String>) -> &'a str {
    let source = source.trim_start();
    if let Some(mut rest) = source.strip_prefix('{') {
        loop {
            rest = rest.trim_start_matches(|c: char| c.is_whitespace() || c == ',');
            if rest.is_empty() || rest.starts_with('}') {
                return rest.strip_prefix('}').unwrap_or(rest);
            }
            rest = tree(rest, above, paths);
        }
    }
    let end = source.find(|c: char| !(c.is_alphanumeric() || c == '_' || c == '*'));
    if end == Some(0) {
        return source.split_at(source.ceil_char_boundary(1)).1;
    }
    let (name, rest) = source.split_at(end.unwrap_or(source.len()));
    let path = match name {
        "self" => above.trim_end_matches("::").to_owned(),
        name => format!("{above}{name}"),
    };
    match rest.strip_prefix("::") {
        Some(rest) => tree(rest, &format!("{path}::"), paths),
        None => {
            paths.push(path);
            rest
        }
    }
}

/// The paths in `source`, a file of `floor`, that point down the list.
fn faults(floor: &str, source: &str) -> Vec<String> {
    let own = level(floor)
        .unwrap_or_else(|| panic!("src/{floor} is no floor: add it to the list, at its place"));
    let floors = paths(source).into_iter();
    floors
        .map(|path| path.split("::").next().unwrap_or_default().to_owned())
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

/// What drawing may name of the floors that compute: events and other values that come in with the panels' input.
const DRAWN: [&str; 26] = [
    "algorithms::enclosure::CHANNELS",
    "algorithms::enclosure::Enclosure",
    "algorithms::focus::Focus",
    "algorithms::focus::Region",
    "algorithms::frame::Frame",
    "algorithms::prepared_scene::PreparedScene",
    "algorithms::radiosity::race::Lap",
    "algorithms::radiosity::race::Race",
    "algorithms::radiosity::race::Racer",
    "algorithms::radiosity::Solver",
    "algorithms::radiosity::SolverEvent",
    "algorithms::radiosity::Unsolved",
    "algorithms::ray_tree::End",
    "algorithms::ray_tree::RayKind",
    "algorithms::visible::Intersection",
    "algorithms::wireframe::Event",
    "methods::Method",
    "render::compare::Compared",
    "render::compare::Difference",
    "render::compare::SideBySide",
    "render::falloff::Falloff",
    "render::falloff::Sample",
    "render::DrawPatches",
    "render::Finished",
    "render::Layer",
    "render::Layers",
];

/// Calls on those values that would compute.
const COMPUTING: [&str; 10] = [
    "Falloff::of(",
    "prepared.enclosure(",
    ".form_factors(",
    ".lighting(",
    ".matrix_or(",
    ".light_or(",
    ".needs(",
    ".primitives(",
    ".race(",
    ".solve(",
];

/// What in `source`, a file of `panels`, is more than layout.
fn computed(source: &str) -> Vec<String> {
    // Tests stand at the end of a file.
    let source = source
        .split("#[cfg(test)]\nmod tests {")
        .next()
        .unwrap_or_default();
    let computes = |path: &String| {
        let floor = path.split("::").next().unwrap_or_default();
        ["algorithms", "methods", "numeric", "render"].contains(&floor)
            && !DRAWN.contains(&path.as_str())
    };
    let calls = COMPUTING.iter().filter(|call| source.contains(**call));
    let paths = paths(source).into_iter().filter(computes);
    paths.chain(calls.map(|call| (*call).to_owned())).collect()
}

#[test]
fn drawing_calls_no_algorithm() {
    let panels = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/panels");
    let mut read = 0;
    for file in sources(&panels) {
        let relative = file.strip_prefix(&panels).unwrap();
        if relative.starts_with("shared/fixtures")
            || relative.starts_with("shared/fixture.rs")
            || relative.starts_with("shared/fixtures.rs")
            || relative.ends_with("tests.rs")
        {
            continue;
        }
        let computed = computed(&fs::read_to_string(&file).unwrap());
        assert!(
            computed.is_empty(),
            "panels/{} computes: {computed:?}. Let it come in with the state of the run or with `PanelInput`",
            relative.display()
        );
        read += 1;
    }
    assert!(read > 50, "only {read} files were read");
}

#[test]
fn the_check_of_drawing_sees_what_it_should() {
    assert_eq!(
        computed(
            "use crate::algorithms::{focus::Focus, illumination::{attenuation, slide_factor}};"
        ),
        [
            "algorithms::illumination::attenuation",
            "algorithms::illumination::slide_factor"
        ]
    );
    assert_eq!(
        computed("crate::numeric::perceived(&row)"),
        ["numeric::perceived"]
    );
    assert_eq!(
        computed("use crate::algorithms::radiosity::{self, Solver};"),
        ["algorithms::radiosity"]
    );
    assert_eq!(
        computed("let room = prepared.enclosure();"),
        ["prepared.enclosure("]
    );
    assert_eq!(
        computed("use crate::{picture, render::compare::{Compared, Difference}};"),
        [""; 0]
    );
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
