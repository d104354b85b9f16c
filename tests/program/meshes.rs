//! Mesh files as people have them.

use crate::{lightwalk, succeeded, text};
use std::fs;
use tempfile::TempDir;

const SCENE: &str = r#"{ "schema": 1, "background": [0.2, 0.3, 0.5],
  "camera": { "eye": [2.5, 2, 4], "target": [0, 0, 0], "up": [0, 1, 0], "fov_x_degrees": 45 },
  "materials": { "m": { "ambient": [0.1, 0.1, 0.1], "diffuse": [0.6, 0.5, 0.4] } },
  "objects": [{ "name": "o", "material": "m", "mesh": { "file": "mesh.obj" } }],
  "lights": [{ "point": { "position": [3, 5, 6] } }] }"#;

const TRIANGLE: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

fn folder_with(mesh: &[u8]) -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("scene.json"), SCENE).unwrap();
    fs::write(folder.path().join("mesh.obj"), mesh).unwrap();
    folder
}

#[test]
fn what_a_mesh_file_says_without_effect_is_noted_with_its_count() {
    let mesh = format!("{TRIANGLE}usemtl red\nf 1 2 3\nf 1 2\nf 2 3\n");
    let folder = folder_with(mesh.as_bytes());
    let output = succeeded(
        folder.path(),
        "render scene.json --method flat --size 16x12 --out a.png",
    );
    let notes = text(&output.stderr);
    for note in [
        "objects[0].mesh.file: 2 faces of fewer than three corners, the first in line 6",
        "objects[0].mesh.file: 1 line of materials",
    ] {
        assert!(notes.contains(note), "{notes}");
    }
}

#[test]
fn a_file_of_another_kind_is_called_by_its_name() {
    let page = folder_with(b"<!DOCTYPE html>\n<html><body>404</body></html>\n");
    let output = lightwalk(page.path(), "check scene.json");
    assert_eq!(output.status.code(), Some(2));
    let message = text(&output.stderr);
    assert!(
        message.contains("in \"mesh.obj\": found a web page (HTML)"),
        "{message}"
    );

    let folder = folder_with(TRIANGLE.as_bytes());
    let output = lightwalk(folder.path(), "render mesh.obj --method flat --out a.png");
    assert_eq!(output.status.code(), Some(2));
    let message = text(&output.stderr);
    assert!(
        message.contains("mesh.obj: found a Wavefront OBJ file"),
        "{message}"
    );
}
