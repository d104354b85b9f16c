//! Notes: what a scene says without effect is said once, and changes no status.

use crate::{folder, succeeded, text};
use serde_json::Value;
use std::fs;
use tempfile::TempDir;

/// A room lit by nothing that emits, a black light, and a checker on a mesh without texture coordinates.
const WITHOUT_EFFECT: &str = r#"{ "schema": 1,
  "camera": { "eye": [0.2, 0.2, 3], "target": [0.2, 0.2, 0], "up": [0, 1, 0], "fov_x_degrees": 60 },
  "materials": { "checked": { "diffuse": [0.5, 0.5, 0.5], "texture": { "checker": { "colors": [[1, 1, 1], [0, 0, 0]] } } } },
  "objects": [
    { "name": "bare", "material": "checked", "mesh": { "file": "meshes/bare.obj" } },
    { "name": "behind", "material": "checked", "sphere": { "center": [0, 0, 9], "radius": 1 } },
    { "name": "wall", "material": "checked", "polygon": { "vertices": [[0, 0, 0], [1, 0, 0], [1, 1, 0]] }, "patches": 2 } ],
  "lights": [ { "point": { "position": [0, 0, 3], "color": [0, 0, 0] } } ] }"#;

fn noted(scene: &str) -> TempDir {
    let folder = folder();
    fs::write(folder.path().join("noted.json"), scene).unwrap();
    let bare = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    fs::write(folder.path().join("meshes/bare.obj"), bare).unwrap();
    folder
}

/// The notes of a JSON object, as `place: what`.
fn notes(recorded: &Value) -> Vec<String> {
    let notes = recorded["notes"].as_array().unwrap().iter();
    let part = |note: &Value, key: &str| note[key].as_str().unwrap().to_owned();
    let mut lines: Vec<String> = notes
        .map(|note| {
            assert!(!part(note, "why").is_empty());
            format!("{}: {}", part(note, "place"), part(note, "what"))
        })
        .collect();
    lines.sort();
    lines
}

const TEXTURE: &str = "objects[0].material: the texture of the material \"checked\"";
const BLACK: &str = "lights[0].point.color: a black light";
const POINT: &str = "lights[0]: a point light";
const BEHIND: &str = "objects[1]: the object \"behind\"";
const ROUND: &str = "objects[1]: a sphere";
const DARK: &str = "objects: no surface has an `emission` other than 0";

#[test]
fn every_command_notes_what_has_no_effect_for_it() {
    let folder = noted(WITHOUT_EFFECT);
    let json = |output: &std::process::Output| serde_json::from_slice(&output.stdout).unwrap();
    let out = || serde_json::from_slice(&fs::read(folder.path().join("out.json")).unwrap());
    let run = |arguments: &str| succeeded(folder.path(), arguments);
    let of_radiosity = [BLACK, POINT, DARK, TEXTURE];

    let check = run("check --json noted.json");
    let with_round = [BLACK, POINT, DARK, TEXTURE, ROUND];
    assert_eq!(notes(&json(&check)), with_round);
    let lines = text(&check.stderr);
    for note in with_round {
        assert_eq!(lines.matches(note).count(), 1, "{note} in {lines}");
    }

    let draw = "render noted.json --size 8x8 --out picture.png --stats --method";
    assert_eq!(
        notes(&json(&run(&format!("{draw} flat")))),
        [BLACK, TEXTURE, ROUND, BEHIND]
    );
    let stats = json(&run(&format!("{draw} radiosity")));
    assert_eq!(notes(&stats), with_round);

    run("radiosity noted.json --out out.json");
    assert_eq!(notes(&out().unwrap()), of_radiosity);
    run("form-factors noted.json --out out.json");
    assert_eq!(notes(&out().unwrap()), [BLACK, TEXTURE]);
    let needs = run("needs noted.json --json --method radiosity");
    assert_eq!(notes(&json(&needs)), with_round);
    let steps = run("steps noted.json --method flat --pixel 4,4");
    assert!(text(&steps.stderr).contains(BLACK));
}

#[test]
fn options_that_the_method_has_no_use_for_are_noted() {
    let folder = folder();
    let given = "--size 8x8 --depth 3 --samples 2 --solver direct --tolerance 1e-3";
    let draw = format!("render scene.json {given} --out picture.png --stats --method");
    let noted = |method: &str| {
        let output = succeeded(folder.path(), &format!("{draw} {method}"));
        let stats: Value = serde_json::from_slice(&output.stdout).unwrap();
        let noted = notes(&stats).into_iter();
        let options = noted.filter_map(|note| {
            let option = note
                .strip_prefix("--")?
                .strip_suffix(&format!(": given with {method}"));
            Some(option.expect("the method").to_owned())
        });
        let options: Vec<String> = options.collect();
        for option in &options {
            let said = format!("note: --{option}: given with {method}: it counts only for ");
            assert_eq!(text(&output.stderr).matches(&said).count(), 1, "{said}");
        }
        options
    };
    assert_eq!(noted("flat"), ["depth", "samples", "solver", "tolerance"]);
    assert_eq!(noted("ray-casting"), ["depth", "solver", "tolerance"]);
    assert_eq!(noted("ray-tracing"), ["solver", "tolerance"]);
    let steps = "steps scene.json --method gouraud --pixel 4,4 --size 8x8 --depth 3";
    let steps = text(&succeeded(folder.path(), steps).stderr);
    let why = "note: --depth: given with gouraud: it counts only for ray-tracing";
    assert!(steps.contains(why), "{steps}");
}

#[test]
fn check_prints_an_object_a_file_also_of_a_wrong_one() {
    let folder = folder();
    fs::write(folder.path().join("wrong.json"), "{").unwrap();
    let output = crate::lightwalk(folder.path(), "check --json scene.json wrong.json");
    assert_eq!(output.status.code(), Some(2));
    let recorded = text(&output.stdout);
    let files: Vec<Value> = recorded
        .lines()
        .map(|line| serde_json::from_str(line).unwrap())
        .collect();
    assert_eq!(files.len(), 2);
    assert_eq!(
        (&files[0]["right"], &files[0]["kind"]),
        (&true.into(), &"scene".into())
    );
    assert_eq!(files[1]["right"], false);
    assert_eq!(files[1]["problems"].as_array().unwrap().len(), 1);
}
