//! The whole trace of a tiny run, as text.

use crate::files::{golden, updating};
use std::fs;

/// A triangle in a picture of 3×3 pixels. Its numbers are sums and products of short ones: the same on every machine.
const TINY: &str = r#"{ "schema": 1, "background": [0, 0, 0],
  "camera": { "eye": [0, 0, 4], "target": [0, 0, 0], "up": [0, 1, 0], "fov_x_degrees": 90 },
  "materials": { "paper": { "diffuse": [1, 0.5, 0.25] } },
  "objects": [ { "name": "sheet", "material": "paper", "polygon": { "vertices": [[-3, 3, 0], [-3, -3, 0], [3, -3, 0]] } } ],
  "lights": [ { "directional": { "toward": [0, 0, -1] } } ] }"#;

#[test]
fn the_trace_of_a_tiny_triangle_reads_as_before() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("tiny.json"), TINY).unwrap();
    let output = std::process::Command::new(env!("CARGO_BIN_EXE_lightwalk"))
        .current_dir(folder.path())
        .args(["steps", "tiny.json", "--method", "gouraud", "--size", "3x3"])
        .output()
        .unwrap();
    assert!(
        output.status.success(),
        "{}",
        String::from_utf8_lossy(&output.stderr)
    );
    let golden = golden("traces/gouraud-3x3.jsonl");
    let trace = String::from_utf8(output.stdout).unwrap();
    if updating() {
        fs::write(&golden, &trace).unwrap();
    }
    let old = fs::read_to_string(&golden).unwrap();
    for (line, (old, new)) in old.lines().zip(trace.lines()).enumerate() {
        assert_eq!(new, old, "line {}", line + 1);
    }
    assert_eq!(trace.lines().count(), old.lines().count());
}
