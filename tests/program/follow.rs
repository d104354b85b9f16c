//! `follow`: the trace of a program in Python against our steps.

use crate::{folder, lightwalk, text};
use serde_json::json;
use std::fs;
use std::process::Command;

const BALL: &str = r#"{ "schema": 1,
  "camera": { "eye": [0, 0, 4], "target": [0, 0, 0], "up": [0, 1, 0], "fov_x_degrees": 40 },
  "materials": { "clay": { "ambient": [0.1, 0.1, 0.1], "diffuse": [0.6, 0.5, 0.4] } },
  "objects": [ { "name": "ball", "material": "clay", "sphere": { "center": [0, 0, 0], "radius": 1 } } ],
  "lights": [ { "directional": { "toward": [-1, -2, -3], "color": [0.9, 0.9, 0.9] } } ] }"#;

const FOLLOW: &str =
    "follow ball.json --method ray-casting --size 64x48 --pixel 30,20 --with mine.jsonl";

/// What the Python program prints.
fn printed(arguments: &[&str]) -> Vec<u8> {
    let program = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/program/follow.py");
    let output = Command::new("python3")
        .arg(program)
        .args(arguments)
        .output();
    let output = output.expect("Python is installed");
    assert!(output.status.success(), "{}", text(&output.stderr));
    output.stdout
}

#[test]
fn a_program_in_python_is_followed_to_its_end_and_to_its_mistake() {
    let folder = folder();
    fs::write(folder.path().join("ball.json"), BALL).unwrap();
    let mine = folder.path().join("mine.jsonl");
    fs::write(&mine, printed(&["30", "20"])).unwrap();
    let output = lightwalk(folder.path(), FOLLOW);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    assert_eq!(text(&output.stdout), "6 of 6 steps agree\n");

    let marked = ["\u{feff}".as_bytes(), &printed(&["30", "20"])].concat();
    fs::write(&mine, marked).unwrap();
    assert_eq!(lightwalk(folder.path(), FOLLOW).status.code(), Some(0));

    fs::write(&mine, printed(&["30", "20", "reversed"])).unwrap();
    let output = lightwalk(folder.path(), FOLLOW);
    assert_eq!(output.status.code(), Some(1));
    let said = text(&output.stdout);
    assert!(
        said.contains("line 4, ToLight: your L is [−0.267261, "),
        "{said}"
    );
    assert!(said.contains("and the run has [0.267261, "), "{said}");
    assert!(
        said.contains("light_to_point: L from the light to the point would give yours"),
        "{said}"
    );
    let output = lightwalk(folder.path(), &format!("{FOLLOW} --json"));
    let json: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(
        (json["agree"].as_u64(), json["of"].as_u64()),
        (Some(3), Some(6))
    );
    assert_eq!(json["difference"]["field"], "L");
    let explained = json["difference"]["explained"].as_array().unwrap();
    assert!(
        explained.len() > 1 && explained[1].as_str().unwrap().contains(" = "),
        "{json}"
    );
}

#[test]
fn a_trace_that_cannot_be_read_is_reported_with_its_line() {
    let folder = folder();
    fs::write(folder.path().join("ball.json"), BALL).unwrap();
    for (trace, expected) in [
        ("", "there is no step in it"),
        (
            "{\"kind\": \"Ray\"\n",
            "line 1, column 14: the line ends here",
        ),
        ("[1]", "line 1: found a list; expected an object"),
        (
            "{\"kind\": \"Ray\", \"t\": NaN}",
            "line 1, column 22: expected a value: a number",
        ),
        (
            "{\"kind\": \"Ray\", \"u\": 1, \"u\": 2}",
            "the name \"u\" is given twice",
        ),
        (
            "{\"kind\": 3}",
            "line 1: kind is 3; it names the step by a text",
        ),
        (
            "{\"kind\": \"Diffuse\", \"I_d\": \"red\"}",
            "line 1: I_d is a word; of Diffuse it is a list of three numbers",
        ),
        ("\n{\"t\": 3}\n", "line 2: the key `kind` is missing"),
        (
            "{\"kind\": \"Ray\", \"u\": [1, 2]}",
            "line 1: u is [1,2]; allowed are",
        ),
        (
            "{\"kind\": \"Rya\"}",
            "no step of the kind \"Rya\" (did you mean Ray?); the kinds of this run are Ambient, Diffuse",
        ),
        (
            "{\"kind\": \"Ray\", \"w\": 1}",
            "Ray has no value \"w\"; its values are ",
        ),
    ] {
        fs::write(folder.path().join("mine.jsonl"), trace).unwrap();
        let output = lightwalk(folder.path(), FOLLOW);
        let said = text(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{trace}: {said}");
        assert!(
            said.contains("mine.jsonl") && said.contains(expected),
            "{said}"
        );
    }
    fs::remove_file(folder.path().join("mine.jsonl")).unwrap();
    let output = lightwalk(folder.path(), FOLLOW);
    assert_eq!(output.status.code(), Some(2));
    assert!(text(&output.stderr).contains("mine.jsonl: cannot be read"));
}

const ROOM: &str = r#"{ "schema": 1,
  "camera": { "eye": [0.5, 0.5, 3], "target": [0.5, 0.5, 0], "up": [0, 1, 0], "fov_x_degrees": 50 },
  "materials": { "lamp": { "emission": [2, 1, 0.5], "reflectance": [0.3, 0.2, 0.1], "diffuse": [0.5, 0.4, 0.3] },
    "wall": { "reflectance": [0.8, 0.6, 0.4], "diffuse": [0.3, 0.6, 0.4] } },
  "objects": [
    { "name": "lamp", "material": "lamp", "polygon": { "vertices": [[0, 0, 1], [1, 0, 1], [1, 0, 0], [0, 0, 0]] } },
    { "name": "wall", "material": "wall", "polygon": { "vertices": [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]] } } ],
  "lights": [ { "point": { "position": [0.5, 0.8, 2] } } ] }"#;

#[test]
fn a_scan_line_and_a_patch_are_followed_like_a_pixel() {
    let folder = folder();
    fs::write(folder.path().join("room.json"), ROOM).unwrap();
    for (focus, kind, field, wrong, written) in [
        (
            "--method gouraud --size 32x24 --scan-line 12",
            "PixelColored",
            "color",
            json!([7.5, 7.5, 7.5]),
            "[7.5, 7.5, 7.5]",
        ),
        (
            "--method radiosity --solver gauss-seidel --patch 1",
            "Exchanged",
            "F_ij",
            json!(7.5),
            "7.5",
        ),
    ] {
        let steps = lightwalk(folder.path(), &format!("steps room.json {focus}"));
        assert_eq!(steps.status.code(), Some(0), "{}", text(&steps.stderr));
        let mine = folder.path().join("mine.jsonl");
        fs::write(&mine, &steps.stdout).unwrap();
        let follow = format!("follow room.json {focus} --with mine.jsonl");
        let output = lightwalk(folder.path(), &follow);
        let count = text(&steps.stdout).lines().count();
        assert_eq!(
            text(&output.stdout),
            format!("{count} of {count} steps agree\n"),
            "{}",
            text(&output.stderr)
        );

        let printed = text(&steps.stdout);
        let mut lines: Vec<serde_json::Value> = printed
            .lines()
            .map(|line| serde_json::from_str(line).unwrap())
            .collect();
        let changed = lines.iter_mut().find(|line| line["kind"] == kind);
        let changed = changed.unwrap_or_else(|| panic!("{kind} in {printed}"));
        changed[field] = wrong;
        let number = changed["step"].as_u64().unwrap() + 1;
        let lines: Vec<String> = lines.iter().map(serde_json::Value::to_string).collect();
        fs::write(&mine, lines.join("\n")).unwrap();
        let output = lightwalk(folder.path(), &follow);
        assert_eq!(output.status.code(), Some(1));
        let said = text(&output.stdout);
        let first = format!("line {number}, {kind}: your {field} is {written}, and the run has ");
        assert!(said.contains(&first), "{said}");
    }
}
