//! `lightwalk study`. Only studies of a second, since most are meant for a release build.

use crate::{files, lightwalk, refused, succeeded, text};
use serde_json::Value;
use std::fs;

#[test]
fn a_study_leaves_its_four_files_and_a_summary_and_nothing_else() {
    let folder = tempfile::tempdir().unwrap();
    succeeded(folder.path(), "study precision --quick --out new/found");
    let found = folder.path().join("new/found");
    let names = [
        "precision.csv",
        "precision.json",
        "precision.png",
        "precision.svg",
        "summary.md",
    ];
    assert_eq!(files(&found), names);

    let json: Value =
        serde_json::from_slice(&fs::read(found.join("precision.json")).unwrap()).unwrap();
    assert!(json["machine"]["cores"].as_u64() >= Some(1));
    assert_eq!(json["settings"]["quick"], true);
    let curves = json["parts"][0]["curves"].as_array().unwrap();
    let points = |curve: &Value| curve["points"].as_array().unwrap().len();
    let settings: usize = curves.iter().map(points).sum();
    let csv = fs::read_to_string(found.join("precision.csv")).unwrap();
    assert_eq!(csv.lines().count(), 1 + settings);
    assert!(
        fs::read(found.join("precision.png"))
            .unwrap()
            .starts_with(b"\x89PNG")
    );
    let svg = fs::read_to_string(found.join("precision.svg")).unwrap();
    assert!(svg.starts_with("<svg") && svg.trim_end().ends_with("</svg>"));
    let summary = fs::read_to_string(found.join("summary.md")).unwrap();
    assert!(summary.contains("precision.png"), "{summary}");
}

#[test]
fn far_away_the_stable_roots_in_f32_are_more_exact_than_the_plain_ones() {
    let folder = tempfile::tempdir().unwrap();
    succeeded(folder.path(), "study precision --quick --out found");
    let json: Value =
        serde_json::from_slice(&fs::read(folder.path().join("found/precision.json")).unwrap())
            .unwrap();
    let curves = json["parts"][0]["curves"].as_array().unwrap();
    // At a distance of 10⁴
    let error = |curve: &Value| curve["points"][3]["error"]["rms"].as_f64().unwrap();
    let [plain, stable, plain64] = [0, 1, 2].map(|i| error(&curves[i]));
    assert!(stable < 0.01 && plain > 10.0 * stable, "{plain} {stable}");
    assert!(plain64 < 1e-6, "{plain64}");
}

#[test]
fn what_is_no_study_is_refused_with_the_names_of_those_there_are() {
    let folder = tempfile::tempdir().unwrap();
    let output = lightwalk(folder.path(), "study shadeing --out found");
    let message = refused(&output, "an unknown name");
    for name in ["shading", "ray-depth", "growth"] {
        assert!(message.contains(name), "{message}");
    }
    fs::write(folder.path().join("file"), "").unwrap();
    for out in ["file", "file/below"] {
        let study = format!("study precision --out {out}");
        refused(&lightwalk(folder.path(), &study), out);
    }
    assert_eq!(files(folder.path()), ["file"]);
}

#[test]
fn a_study_that_says_nothing_about_the_scene_says_so() {
    let folder = tempfile::tempdir().unwrap();
    let scene = r#"{ "schema": 1, "materials": { "m": {} },
        "camera": { "eye": [0, 0, -5], "target": [0, 0, 0], "up": [0, 1, 0], "fov_x_degrees": 40 },
        "objects": [{ "name": "wall", "material": "m", "polygon": { "vertices": [[0, 0, 0], [1, 0, 0], [1, 1, 0]] } }] }"#;
    fs::write(folder.path().join("wall.json"), scene).unwrap();
    let study = "study shading ray-depth solvers precision --quick --scene wall.json --out found";
    let message = text(&succeeded(folder.path(), study).stderr);
    assert_eq!(files(&folder.path().join("found")), ["summary.md"]);
    let summary = fs::read_to_string(folder.path().join("found/summary.md")).unwrap();
    for why in [
        "no sphere",
        "reflects or transmits",
        "emits light",
        "whatever the scene",
    ] {
        assert!(
            message.contains(why) && summary.contains(why),
            "{why}: {message}"
        );
    }
}
