//! `compare`: form factors and radiosities of another program against ours.

use crate::{lightwalk, refused, succeeded, text};
use serde_json::Value;
use std::f64::consts::PI;
use std::fs;
use tempfile::TempDir;

/// Two rectangles that light each other, the upper one in two patches of a quarter of the lower one's area.
const SCENE: &str = r#"{ "schema": 1,
  "materials": { "lamp": { "emission": [2, 1, 0.5], "reflectance": [0.3, 0.2, 0.1] },
    "wall": { "reflectance": [0.8, 0.6, 0.4] } },
  "objects": [
    { "name": "lamp, below", "material": "lamp", "polygon": { "vertices": [[-0.5, 0, 1], [1.5, 0, 1], [1.5, 0, 0], [-0.5, 0, 0]] } },
    { "name": "wall", "material": "wall", "polygon": { "vertices": [[0, 1, 0], [1, 1, 0], [1, 1, 1], [0, 1, 1]] }, "patches": [2, 1] } ] }"#;

/// The scene, and its form factors and radiosities in all forms in which we write them.
fn folder() -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("room.json"), SCENE).unwrap();
    for end in ["csv", "json", "npy"] {
        for command in [
            "form-factors room.json --out f.",
            "radiosity room.json --out b.",
        ] {
            succeeded(folder.path(), &format!("{command}{end}"));
        }
    }
    folder
}

/// What is said of a file with these rows.
fn said(folder: &TempDir, option: &str, rows: &[Vec<f64>]) -> String {
    let lines: Vec<String> = rows
        .iter()
        .map(|row| row.iter().map(f64::to_string).collect::<Vec<_>>().join(";"))
        .collect();
    fs::write(folder.path().join("mine.csv"), lines.join("\n")).unwrap();
    let output = lightwalk(
        folder.path(),
        &format!("compare room.json {option} mine.csv"),
    );
    assert_eq!(output.status.code(), Some(1), "{}", text(&output.stderr));
    text(&output.stdout)
}

fn numbers(folder: &TempDir, name: &str, key: &str) -> Value {
    let file = fs::read(folder.path().join(name)).unwrap();
    let mut found: Value = serde_json::from_slice(&file).unwrap();
    found[key].take()
}

fn form_factors(folder: &TempDir) -> Vec<Vec<f64>> {
    serde_json::from_value(numbers(folder, "f.json", "matrix")).unwrap()
}

fn radiosities(folder: &TempDir) -> Vec<Vec<f64>> {
    let surfaces = numbers(folder, "b.json", "surfaces");
    let surfaces = surfaces.as_array().unwrap().iter();
    let patches = surfaces.flat_map(|surface| surface["patches"].as_array().unwrap());
    patches
        .map(|patch| serde_json::from_value(patch["radiosity"].clone()).unwrap())
        .collect()
}

#[test]
fn what_we_write_agrees_in_every_form() {
    let folder = folder();
    for end in ["csv", "json", "npy"] {
        for (option, starts) in [
            ("--matrix f", "3 × 3 entries: 0 differ"),
            ("--radiosity b", "3 patches: 0 differ"),
        ] {
            let command = format!("compare room.json --method radiosity {option}.{end}");
            let output = succeeded(folder.path(), &command);
            let said = text(&output.stdout);
            assert!(said.starts_with(starts), "{command}: {said}");
        }
    }
}

#[test]
fn of_a_matrix_the_first_row_that_differs_and_what_it_is_are_reported() {
    let folder = folder();
    let f = form_factors(&folder);
    let said = |rows: &[Vec<f64>]| said(&folder, "--matrix", rows);
    let mut changed = f.clone();
    changed[1][0] += 0.125;
    let both = format!("yours is {}, and the reference {}", changed[1][0], f[1][0]);
    let text = said(&changed);
    assert!(
        text.contains("first row that differs: patch 1 (\"wall\" 0,0)"),
        "{text}"
    );
    assert!(
        text.contains("from it to patch 0 (\"lamp, below\" 0,0)"),
        "{text}"
    );
    assert!(text.contains(&both), "{text}");
    assert!(
        text.contains("1 rows sum to something else: row 1 to"),
        "{text}"
    );

    let transposed: Vec<Vec<f64>> = (0..3).map(|i| (0..3).map(|j| f[j][i]).collect()).collect();
    assert!(said(&transposed).contains("it is the transposed matrix: F_ji"));
    let mean = |i: usize, j: usize| 0.5 * (f[i][j] + f[j][i]);
    let symmetric: Vec<Vec<f64>> = (0..3)
        .map(|i| (0..3).map(|j| mean(i, j)).collect())
        .collect();
    assert!(said(&symmetric).contains("yours is symmetric"));
    let scaled = |of: &dyn Fn(usize) -> f64| -> Vec<Vec<f64>> {
        let rows = f.iter().enumerate();
        rows.map(|(i, row)| row.iter().map(|f| of(i) * f).collect())
            .collect()
    };
    assert!(said(&scaled(&|_| 1.0 / PI)).contains("it is F_ij/π"));
    let rho = [0.2, 0.6, 0.6];
    assert!(said(&scaled(&|i| rho[i])).contains("it is ρ_i·F_ij"));
}

#[test]
fn of_radiosities_the_first_patch_that_differs_and_what_they_are_are_reported() {
    let folder = folder();
    let b = radiosities(&folder);
    let said = |rows: &[Vec<f64>]| said(&folder, "--radiosity", rows);
    let mut changed = b.clone();
    changed[2][1] += 0.25;
    let text = said(&changed);
    let [mine, reference] = [&changed[2], &b[2]].map(|patch| {
        let written: Vec<String> = patch.iter().map(|b| format!("{b:.6}")).collect();
        written.join(" ")
    });
    let both = format!(
        "first patch that differs: 2 (\"wall\" 1,0); yours is {mine}, and the reference {reference}"
    );
    assert!(text.contains(&both), "{text}");
    let scaled = |of: &dyn Fn(usize) -> f64| -> Vec<Vec<f64>> {
        let rows = b.iter().enumerate();
        rows.map(|(i, row)| row.iter().map(|b| of(i) * b).collect())
            .collect()
    };
    assert!(said(&scaled(&|_| 1.0 / PI)).contains("it is B/π"));
    assert!(said(&scaled(&|i| [2.0, 0.5, 0.5][i])).contains("it is A·B"));

    // B = E + F·B and B = E + ρ·Fᵀ·B, gathered until nothing changes.
    let f = form_factors(&folder);
    let (e, rho) = (
        [2.0, 1.0, 0.5],
        [[0.3, 0.2, 0.1], [0.8, 0.6, 0.4], [0.8, 0.6, 0.4]],
    );
    let solved = |factor: &dyn Fn(usize, usize, usize) -> f64| {
        let mut light = vec![vec![0.0; 3]; 3];
        for _ in 0..200 {
            let one = |i: usize, c: usize| {
                let sum: f64 = (0..3).map(|j| factor(i, j, c) * light[j][c]).sum();
                sum + if i == 0 { e[c] } else { 0.0 }
            };
            light = (0..3)
                .map(|i| (0..3).map(|c| one(i, c)).collect())
                .collect();
        }
        light
    };
    let forgotten = said(&solved(&|i, j, _| f[i][j]));
    assert!(forgotten.contains("ρ_i is missing"), "{forgotten}");
    let transposed = said(&solved(&|i, j, c| rho[i][c] * f[j][i]));
    assert!(
        transposed.contains("F_ji stands at the place of F_ij"),
        "{transposed}"
    );
}

#[test]
fn the_same_is_reported_as_json() {
    let folder = folder();
    let b = radiosities(&folder);
    let half: Vec<Vec<f64>> = b
        .iter()
        .map(|b| b.iter().map(|b| b * PI).collect())
        .collect();
    let mine = serde_json::to_vec(&half).unwrap();
    fs::write(folder.path().join("mine.json"), mine).unwrap();
    let command = "compare room.json --radiosity mine.json --json";
    let output = lightwalk(folder.path(), command);
    assert_eq!(output.status.code(), Some(1));
    let found: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!((&found["off"], &found["patches"]), (&3.into(), &3.into()));
    assert_eq!(found["looks"], "times_pi");
    assert_eq!(found["first"]["object"], "lamp, below");
    let reference: Vec<f64> = serde_json::from_value(found["first"]["reference"].clone()).unwrap();
    assert_eq!(reference, b[0]);
}

#[test]
fn what_is_no_table_of_that_size_is_refused_with_what_would_be_right() {
    let folder = folder();
    for (name, content, option, expected) in [
        (
            "a.csv",
            "1,2\n3,4\n",
            "--matrix",
            "a.csv: it has 2 rows; the scene has 3 patches",
        ),
        (
            "b.csv",
            "1,2\n3,4\n5,6",
            "--matrix",
            "b.csv: row 0 has 2 numbers; the scene has 3 patches",
        ),
        (
            "c.csv",
            "1,2,3\n1,2,x\n1,2,3",
            "--matrix",
            "c.csv: row 1: \"x\" is not a number",
        ),
        (
            "d.csv",
            "1,2,3\n1,2,3\n1,NaN,3",
            "--matrix",
            "d.csv: row 2: a number is not finite",
        ),
        (
            "e.json",
            "{\"rows\": 3}",
            "--matrix",
            "e.json: it has no \"matrix\"",
        ),
        (
            "f.csv",
            "1,2\n1,2\n1,2",
            "--radiosity",
            "row 0 has 2 numbers; allowed are 1 and 3",
        ),
        (
            "g.csv",
            "",
            "--radiosity",
            "g.csv: it has 0 rows; the scene has 3 patches",
        ),
        (
            "h.json",
            "[[1, 2, 3], [1, 2",
            "--radiosity",
            "the file ends here",
        ),
        ("i.npy", "\u{93}NUMPY", "--radiosity", "i.npy: row 0"),
    ] {
        fs::write(folder.path().join(name), content).unwrap();
        let output = lightwalk(folder.path(), &format!("compare room.json {option} {name}"));
        let message = refused(&output, name);
        assert!(message.contains(expected), "{name}: {message}");
    }
    for (command, expected) in [
        (
            "--matrix none.csv",
            "none.csv: cannot be read: no such file",
        ),
        ("--matrix f.csv --radiosity b.csv", "cannot be used with"),
        (
            "--matrix f.csv --method flat",
            "--matrix does not go with --method flat",
        ),
        (
            "--matrix f.csv --out pictures",
            "--out, which is for pictures",
        ),
        (
            "--radiosity b.csv --tolerance 2",
            "allowed are numbers from 0 to 1",
        ),
        ("--method radiosity", "--with"),
        ("--with b.csv", "--method"),
    ] {
        let output = lightwalk(folder.path(), &format!("compare room.json {command}"));
        let message = refused(&output, command);
        assert!(message.contains(expected), "{command}: {message}");
    }
}
