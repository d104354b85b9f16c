//! `compare`: pictures of another program against ours.

use crate::{files, lightwalk, refused, succeeded, text};
use serde_json::Value;
use std::fs;
use tempfile::TempDir;

/// A glass ball before a wall, with this η.
fn scene(ior: f64) -> String {
    format!(
        r#"{{ "schema": 1, "background": [0.2, 0.3, 0.5],
  "camera": {{ "eye": [0, 1, 5], "target": [0, 0.5, 0], "up": [0, 1, 0], "fov_x_degrees": 40 }},
  "materials": {{ "glass": {{ "diffuse": [0.1, 0.1, 0.1], "transmission": 0.9, "ior": {ior} }},
    "floor": {{ "diffuse": [0.6, 0.5, 0.4] }} }},
  "objects": [ {{ "name": "ball", "material": "glass", "sphere": {{ "center": [0, 0.8, 0], "radius": 0.8 }} }},
    {{ "name": "floor", "material": "floor", "plane": {{ "point": [0, 0, 0], "normal": [0, 1, 0] }} }} ],
  "lights": [ {{ "point": {{ "position": [2, 4, 3], "color": [1, 1, 1] }} }} ] }}"#
    )
}

/// The scene, a right picture and one with η inverted.
fn folder() -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    for (name, ior) in [("right", 1.5), ("wrong", 1.0 / 1.5)] {
        fs::write(folder.path().join(format!("{name}.json")), scene(ior)).unwrap();
        let render =
            format!("render {name}.json --method ray-tracing --size 40x30 --out {name}.png");
        succeeded(folder.path(), &render);
    }
    folder
}

const COMPARE: &str = "compare right.json --method ray-tracing --with";

#[test]
fn a_right_picture_agrees_and_a_wrong_one_is_explained() {
    let folder = folder();
    let output = succeeded(folder.path(), &format!("{COMPARE} right.png --json"));
    let json: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(
        (json["off"].as_u64(), json["pixels"].as_u64()),
        (Some(0), Some(1200))
    );
    assert_eq!(json["size"], serde_json::json!([40, 30]));
    assert_eq!(
        (&json["encoding"], &json["mistakes"]),
        (&"srgb".into(), &serde_json::json!([]))
    );

    let output = lightwalk(
        folder.path(),
        &format!("{COMPARE} wrong.png --json --out found"),
    );
    assert_eq!(output.status.code(), Some(1));
    let json: Value = serde_json::from_slice(&output.stdout).unwrap();
    let first = &json["mistakes"][0];
    assert_eq!(first["name"], "eta_inverted");
    assert_eq!(
        (&first["explains"], &first["of"]),
        (&json["off"], &json["off"])
    );
    assert_eq!(json["worst"].as_array().unwrap().len(), 5);
    assert_eq!(
        files(&folder.path().join("found")),
        ["difference.png", "reference.png"]
    );

    let output = lightwalk(folder.path(), &format!("{COMPARE} wrong.png"));
    let said = text(&output.stdout);
    assert!(
        said.contains("eta_inverted: ours with η taken for 1/η explains"),
        "{said}"
    );
    assert!(said.contains("lightwalk steps right.json --method ray-tracing --size 40x30 --pixel"));
}

#[test]
fn of_a_folder_the_newest_picture_is_taken() {
    let folder = folder();
    let pictures = folder.path().join("mine");
    fs::create_dir(&pictures).unwrap();
    let message = refused(
        &lightwalk(folder.path(), &format!("{COMPARE} mine")),
        "no picture",
    );
    assert!(
        message.contains("mine: no picture is in this folder"),
        "{message}"
    );
    let old = fs::File::create(pictures.join("old.png")).unwrap();
    old.set_modified(std::time::UNIX_EPOCH).unwrap();
    fs::copy(folder.path().join("right.png"), pictures.join("a.png")).unwrap();
    fs::write(pictures.join("notes.txt"), "newer, but no picture").unwrap();
    succeeded(folder.path(), &format!("{COMPARE} mine"));
}

#[test]
fn what_is_no_picture_is_refused() {
    let folder = folder();
    let picture = fs::read(folder.path().join("right.png")).unwrap();
    for (name, bytes) in [
        ("text.png", &b"not a picture"[..]),
        ("half.png", &picture[..picture.len() / 2]),
        ("empty.ppm", b""),
        ("short.ppm", b"P6 4 4 255\n\x01\x02"),
        ("huge.pfm", b"PF\n99999999 99999999\n-1\n"),
    ] {
        fs::write(folder.path().join(name), bytes).unwrap();
        let output = lightwalk(folder.path(), &format!("{COMPARE} {name}"));
        assert!(refused(&output, name).contains(name));
    }
    let tolerance = lightwalk(
        folder.path(),
        &format!("{COMPARE} right.png --tolerance -1"),
    );
    assert!(refused(&tolerance, "a negative tolerance").contains("--tolerance"));
}

#[test]
fn help_and_the_readme_list_every_mistake() {
    let readme = fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/README.md")).unwrap();
    let help = succeeded(std::path::Path::new("."), "help compare").stdout;
    let help = text(&help);
    let (_, list) = help.split_once("Mistakes that are tried:\n").unwrap();
    let lines: Vec<&str> = list.lines().collect();
    assert!(lines.len() > 30, "{help}");
    for line in lines {
        let (name, words) = line.trim().split_once("  ").unwrap();
        let row = format!("| `{name}` | {} |", words.trim());
        assert!(readme.contains(&row), "{row}");
    }
}
