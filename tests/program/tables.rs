//! Steps, matrices and radiosities as tables for other programs.

use crate::radiosity::furnace;
use crate::{files, folder, lightwalk, refused, succeeded, text};
use serde_json::Value;
use std::fs;
use std::path::Path;

/// The shape of an `.npy` file, as it is written, and its numbers.
fn npy(path: &Path) -> (String, Vec<f64>) {
    let file = fs::read(path).unwrap();
    let length = usize::from(u16::from_le_bytes([file[8], file[9]]));
    let (header, numbers) = file[10..].split_at(length);
    let header = text(header);
    let (_, shape) = header.split_once("'shape': (").unwrap();
    let (shape, _) = shape.split_once(')').unwrap();
    let numbers = numbers.chunks_exact(8);
    let numbers = numbers.map(|bytes| f64::from_le_bytes(bytes.try_into().unwrap()));
    (shape.to_owned(), numbers.collect())
}

/// The cells of a CSV without quotation marks.
fn csv(path: &Path) -> Vec<Vec<String>> {
    let file = fs::read_to_string(path).unwrap();
    let lines = file.lines();
    lines
        .map(|line| line.split(',').map(str::to_owned).collect())
        .collect()
}

fn number(cell: &str) -> f64 {
    cell.parse().unwrap()
}

#[test]
fn steps_are_a_table_with_the_values_of_the_json_lines() {
    let folder = folder();
    let steps = "steps gouraud-triangle --scan-line 15";
    let lines = text(&succeeded(folder.path(), steps).stdout);
    succeeded(folder.path(), &format!("{steps} --out steps.csv"));
    let table = csv(&folder.path().join("steps.csv"));
    let (names, rows) = table.split_first().unwrap();
    assert_eq!(names[..3], ["step", "depth", "kind"]);
    assert_eq!(rows.len(), lines.lines().count());
    let mut compared = 0;
    for (line, row) in lines.lines().zip(rows) {
        let line: Value = serde_json::from_str(line).unwrap();
        assert_eq!(row.len(), names.len());
        for (name, cell) in names.iter().zip(row) {
            let (value, at) = match name.rsplit_once('.') {
                Some((name, "r" | "x")) => (&line[name][0], "first"),
                Some((name, "g" | "y")) => (&line[name][1], "second"),
                Some((name, "b" | "z")) => (&line[name][2], "third"),
                _ => (&line[name], "only"),
            };
            match value {
                // JSON has no infinity.
                Value::Null => assert!(cell.is_empty() || !number(cell).is_finite(), "{name}"),
                Value::Number(value) => assert_eq!(number(cell), value.as_f64().unwrap()),
                Value::String(value) => assert_eq!(cell, value),
                value => assert_eq!(*cell, value.to_string(), "{name}, {at}"),
            }
            compared += usize::from(!value.is_null());
        }
    }
    assert!(compared > 10 * rows.len());
}

#[test]
fn form_factors_are_the_same_numbers_in_every_format() {
    let folder = furnace();
    for name in ["f.json", "f.csv", "f.npy"] {
        succeeded(
            folder.path(),
            &format!("form-factors furnace.json --out {name}"),
        );
    }
    let json: Value =
        serde_json::from_slice(&fs::read(folder.path().join("f.json")).unwrap()).unwrap();
    let rows = json["matrix"].as_array().unwrap();
    let entries = rows.iter().flat_map(|row| row.as_array().unwrap());
    let expected: Vec<f64> = entries.map(|entry| entry.as_f64().unwrap()).collect();
    let table = csv(&folder.path().join("f.csv"));
    assert!(table.len() == 24 && table.iter().all(|row| row.len() == 24));
    let written: Vec<f64> = table.iter().flatten().map(|cell| number(cell)).collect();
    assert_eq!(written, expected);
    assert_eq!(
        npy(&folder.path().join("f.npy")),
        ("24, 24, ".to_owned(), expected)
    );
    succeeded(folder.path(), "form-factors furnace.json --with f.csv");
}

#[test]
fn the_system_times_its_radiosities_is_the_emission() {
    let folder = furnace();
    succeeded(
        folder.path(),
        "radiosity furnace.json --matrix k.npy --out b.npy",
    );
    succeeded(
        folder.path(),
        "radiosity furnace.json --matrix k.csv --out b.csv",
    );
    let (shape, system) = npy(&folder.path().join("k.npy"));
    assert_eq!(shape, "3, 24, 24, ");
    let (shape, light) = npy(&folder.path().join("b.npy"));
    assert_eq!(shape, "24, 3, ");
    for (number, row) in system.chunks_exact(24).enumerate() {
        let channel = number / 24;
        let emission: f64 = (0..24).map(|j| row[j] * light[3 * j + channel]).sum();
        assert!((emission - 1.0).abs() < 1e-5, "{emission}");
    }
    let rows = csv(&folder.path().join("k.csv"));
    let written: Vec<f64> = rows.iter().flatten().map(|cell| number(cell)).collect();
    assert_eq!(written, system);
    let patches = csv(&folder.path().join("b.csv"));
    assert_eq!(
        patches[0].join(","),
        "object,i,j,area,reflectance.r,reflectance.g,reflectance.b,emission.r,emission.g,emission.b,radiosity.r,radiosity.g,radiosity.b"
    );
    assert_eq!(
        patches[2][..10].join(","),
        "wall 0,1,0,0.25,0.5,0.5,0.5,1.0,1.0,1.0"
    );
    for (patch, row) in patches[1..].iter().enumerate() {
        let [first, _, last] = [10, 11, 12].map(|column| number(&row[column]));
        assert_eq!([first, last], [light[3 * patch], light[3 * patch + 2]]);
    }
}

#[test]
fn a_matrix_that_cannot_be_written_is_refused() {
    let folder = furnace();
    for (arguments, said) in [
        (
            "--matrix k.json --out b.json",
            "--matrix k.json: the name ends in .csv or .npy",
        ),
        (
            "--matrix none/k.npy --out b.json",
            "its folder does not exist",
        ),
        (
            "--matrix k.npy --max-memory 0 --solver shooting --out b.json",
            "--max-memory",
        ),
    ] {
        let arguments = format!("radiosity furnace.json {arguments}");
        let message = refused(&lightwalk(folder.path(), &arguments), &arguments);
        assert!(message.contains(said), "{message} lacks {said}");
    }
    assert_eq!(files(folder.path()), ["furnace.json"]);
}
