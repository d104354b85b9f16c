//! The commands that exchange light between patches.

use crate::{lightwalk, refused, succeeded, text};
use serde_json::Value;
use std::fs;

/// A closed unit cube of 2×2 patches a wall, which all emit 1 and reflect half: B = 2 everywhere.
pub fn furnace() -> tempfile::TempDir {
    let corners = |bits: [usize; 4]| -> Vec<[f64; 3]> {
        let corner = |bits: usize| [0, 1, 2].map(|axis| f64::from((bits >> axis & 1) as u32));
        bits.into_iter().map(corner).collect()
    };
    let walls = [
        [0, 1, 3, 2],
        [5, 4, 6, 7],
        [4, 0, 2, 6],
        [1, 5, 7, 3],
        [4, 5, 1, 0],
        [2, 3, 7, 6],
    ];
    let objects: Vec<String> = (0..6)
        .map(|wall| {
            let vertices = corners(walls[wall]);
            format!(r#"{{ "name": "wall {wall}", "material": "glow", "polygon": {{ "vertices": {vertices:?} }}, "patches": 2 }}"#)
        })
        .collect();
    let scene = format!(
        r#"{{ "schema": 1, "materials": {{ "glow": {{ "emission": [1, 1, 1], "reflectance": [0.5, 0.5, 0.5] }} }},
            "camera": {{ "eye": [0.5, 0.5, 0.5], "target": [0.5, 0.5, 0], "up": [0, 1, 0], "fov_x_degrees": 60 }},
            "objects": [{}] }}"#,
        objects.join(", ")
    );
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("furnace.json"), scene).unwrap();
    folder
}

/// What a command wrote to `out.json`.
fn written(folder: &tempfile::TempDir, arguments: &str) -> Value {
    succeeded(folder.path(), &format!("{arguments} --out out.json"));
    serde_json::from_slice(&fs::read(folder.path().join("out.json")).unwrap()).unwrap()
}

fn numbers(value: &Value) -> Vec<f64> {
    let list = value.as_array().unwrap().iter();
    list.map(|number| number.as_f64().unwrap()).collect()
}

#[test]
fn form_factors_of_a_closed_cube_sum_to_1_by_every_exact_method() {
    let folder = furnace();
    for method in ["auto", "element-to-polygon", "contour"] {
        let found = written(
            &folder,
            &format!("form-factors furnace.json --method {method}"),
        );
        assert_eq!(found["method"], method);
        assert!(found["seconds"].as_f64().unwrap() >= 0.0);
        let patches = found["patches"].as_array().unwrap();
        assert_eq!(patches.len(), 24);
        assert_eq!(patches[5]["object"], "wall 1");
        assert_eq!((&patches[5]["i"], &patches[5]["j"]), (&1.into(), &0.into()));
        assert_eq!(patches[5]["area"], 0.25);
        for row in found["matrix"].as_array().unwrap() {
            let sum: f64 = numbers(row).iter().sum();
            assert!((sum - 1.0).abs() < 1e-3, "{method}: {sum}");
        }
        assert!(found["closure_defect"].as_f64().unwrap() < 1e-3);
    }
}

#[test]
fn a_matrix_of_another_program_is_held_against_ours() {
    let folder = furnace();
    let found = written(&folder, "form-factors furnace.json");
    let rows: Vec<Vec<f64>> = found["matrix"]
        .as_array()
        .unwrap()
        .iter()
        .map(numbers)
        .collect();
    let write = |scale: f64, changed: f64| {
        let mut rows = rows.clone();
        rows[3][7] += changed;
        let line = |row: &Vec<f64>| {
            let words: Vec<String> = row.iter().map(|f| (f * scale).to_string()).collect();
            words.join(",")
        };
        let lines: Vec<String> = rows.iter().map(line).collect();
        fs::write(folder.path().join("mine.csv"), lines.join("\n")).unwrap();
    };
    let compare = || lightwalk(folder.path(), "form-factors furnace.json --with mine.csv");
    write(1.0, 0.0);
    let output = compare();
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    assert!(text(&output.stdout).starts_with("24 × 24 entries: 0 differ by more than 0.0001"));

    write(1.0, 0.01);
    let output = compare();
    assert_eq!(output.status.code(), Some(1));
    let said = text(&output.stdout);
    assert!(
        said.contains("first row that differs: patch 3 (\"wall 0\" 1,1); from it to patch 7"),
        "{said}"
    );
    assert!(
        said.contains("1 rows sum to something else: row 3 to 1.01"),
        "{said}"
    );

    write(1.0 / std::f64::consts::PI, 0.0);
    assert!(text(&compare().stdout).contains("it is F_ij/π"));

    fs::write(folder.path().join("mine.csv"), "1,2\n3,4\n").unwrap();
    let message = refused(&compare(), "two rows");
    assert!(
        message.contains("mine.csv: it has 2 rows; the scene has 24 patches"),
        "{message}"
    );
    let neither = lightwalk(folder.path(), "form-factors furnace.json");
    assert!(refused(&neither, "neither --out nor --with").contains("--out"));
}

#[test]
fn every_solver_finds_the_light_of_a_furnace() {
    let folder = furnace();
    for solver in [
        "auto",
        "jacobi",
        "gauss-seidel",
        "over-relaxation",
        "shooting",
        "overshooting",
        "chebyshev",
        "conjugate-gradients",
        "direct",
    ] {
        let found = written(
            &folder,
            &format!("radiosity furnace.json --solver {solver}"),
        );
        assert_eq!(found["solver"], solver);
        for residual in numbers(&found["residual"]) {
            assert!((0.0..=1e-6).contains(&residual));
        }
        let surfaces = found["surfaces"].as_array().unwrap();
        assert_eq!(surfaces[3]["object"], "wall 3");
        assert_eq!(surfaces[3]["grid"], serde_json::json!([2, 2]));
        for patch in surfaces
            .iter()
            .flat_map(|surface| surface["patches"].as_array().unwrap())
        {
            for b in numbers(&patch["radiosity"]) {
                assert!((b - 2.0).abs() < 1e-5, "{solver}: {b}");
            }
        }
    }
    let shot = written(
        &folder,
        "radiosity furnace.json --solver shooting --max-memory 0",
    );
    assert!(
        (shot["surfaces"][0]["patches"][0]["radiosity"][1]
            .as_f64()
            .unwrap()
            - 2.0)
            .abs()
            < 1e-5
    );
}

#[test]
fn a_picture_shows_b_itself_constant_or_smooth() {
    let folder = furnace();
    for smooth in ["", " --smooth"] {
        let render = "render furnace.json --method radiosity --size 8x6 --out a.pfm --stats";
        let output = succeeded(folder.path(), &format!("{render}{smooth}"));
        let stats: Value = serde_json::from_slice(&output.stdout).unwrap();
        assert!(stats["seconds"]["solve"].as_f64().unwrap() > 0.0);
        let pfm = fs::read(folder.path().join("a.pfm")).unwrap();
        let samples = pfm[pfm.len() - 8 * 6 * 3 * 4..].chunks(4);
        for sample in samples {
            let b = f32::from_le_bytes(sample.try_into().unwrap());
            assert!((b - 2.0).abs() < 1e-5, "{b}");
        }
    }
}

#[test]
fn steps_are_of_iterations_a_patch_or_one_form_factor() {
    let folder = furnace();
    let kinds = |focus: &str| -> Vec<String> {
        let steps = format!("steps furnace.json --method radiosity --solver jacobi {focus}");
        let recorded = text(&succeeded(folder.path(), &steps).stdout);
        let kind = |line: &str| -> String {
            let step: Value = serde_json::from_str(line).unwrap();
            step["kind"].as_str().unwrap().to_owned()
        };
        recorded.lines().map(kind).collect()
    };
    let count = |kinds: &[String], kind: &str| kinds.iter().filter(|found| *found == kind).count();
    // A furnace of ρ = 1/2: B = E leaves the residual 1/2, each iteration half of it, and 2⁻²⁰ < 10⁻⁶.
    let all = kinds("--tolerance 1e-6");
    assert_eq!(count(&all, "IterationDone"), 19);
    assert_eq!(count(&all, "Exchanged"), 19 * 24 * 24);
    let some = kinds("--iterations 1..3");
    assert_eq!(count(&some, "IterationDone"), 2);
    assert_eq!(count(&some, "Exchanged"), 2 * 24 * 24);
    assert_eq!(count(&kinds("--patch 3"), "Exchanged"), 19 * 24);
    let form_factor = kinds("--form-factor 0,4");
    assert_eq!(
        (&*form_factor[0], &*form_factor[form_factor.len() - 1]),
        ("Reference", "FormFactorFound")
    );
}

#[test]
fn a_tolerance_that_rounding_keeps_from_being_met_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let room = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/lessons/scenes/closed-room.json"
    );
    let output = lightwalk(
        folder.path(),
        &format!("radiosity {room} --tolerance 1e-30 --out out.json"),
    );
    let message = text(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{message}");
    assert!(
        message.contains("the residual no longer falls"),
        "{message}"
    );
    assert!(!folder.path().join("out.json").exists());
}

#[test]
fn what_cannot_be_solved_is_said_and_leaves_no_file() {
    let folder = furnace();
    let scene = fs::read_to_string(folder.path().join("furnace.json")).unwrap();
    let write = |name: &str, from: &str, to: &str| {
        assert!(scene.contains(from));
        fs::write(folder.path().join(name), scene.replacen(from, to, 1)).unwrap();
    };
    write("endless.json", "[0.5, 0.5, 0.5] }", "[1, 1, 1] }");
    write(
        "plane.json",
        "\"objects\": [",
        "\"objects\": [{ \"name\": \"sea\", \"material\": \"glow\", \"plane\": { \"point\": [0, -9, 0], \"normal\": [0, 1, 0] } }, ",
    );
    for (arguments, status, part) in [
        ("radiosity endless.json", 1, "no solution exists"),
        (
            "radiosity furnace.json --solver jacobi --max-iterations 2",
            1,
            "after 2 iterations",
        ),
        ("radiosity plane.json", 2, "objects[0]"),
        ("form-factors plane.json", 2, "\"sea\""),
        ("radiosity furnace.json --max-memory 0", 2, "--max-memory"),
        (
            "radiosity furnace.json --max-patches 10",
            2,
            "--max-patches",
        ),
        ("radiosity furnace.json --tolerance 2", 2, "--tolerance"),
        (
            "radiosity furnace.json --solver magic",
            2,
            "conjugate-gradients",
        ),
        ("form-factors furnace.json --visibility maybe", 2, "none"),
    ] {
        let output = lightwalk(folder.path(), &format!("{arguments} --out out.json"));
        let message = text(&output.stderr);
        assert_eq!(output.status.code(), Some(status), "{arguments}: {message}");
        assert!(message.contains(part), "{arguments}: {message}");
        assert!(!folder.path().join("out.json").exists(), "{arguments}");
    }
    for (focus, part) in [
        ("--pixel 0,0", "goes patch by patch"),
        ("--patch 24", "there are 24 patches"),
        ("--form-factor 0,99", "24 patches"),
    ] {
        let steps = format!("steps furnace.json --method radiosity {focus}");
        let message = refused(&lightwalk(folder.path(), &steps), focus);
        assert!(message.contains(part), "{message}");
    }
}

#[test]
fn a_result_says_how_exact_it_is() {
    let folder = furnace();
    for (closure, correction) in [("auto", 1e-16..1e-6), ("off", 0.0..1e-300)] {
        let found = written(
            &folder,
            &format!("radiosity furnace.json --closure {closure}"),
        );
        let number = |value: &Value| value.as_f64().unwrap();
        let (least, largest) = (&found["rows"]["least"], &found["rows"]["largest"]);
        assert!((number(least) - 1.0).abs() < 1e-6 && (number(largest) - 1.0).abs() < 1e-6);
        assert!(number(&found["reciprocity_error"]) < 1e-14);
        assert_eq!(found["closed"], true);
        let defect = number(&found["closure_defect"]);
        assert!(defect < 1e-6);
        assert!(number(&found["form_factor_error"]) >= defect);
        let corrected = number(&found["closure_correction"]);
        assert!(correction.contains(&corrected), "{closure}: {corrected}");
        let bounds = numbers(&found["error_bound"]);
        let totals = numbers(&found["total_error"]);
        for (total, bound) in totals.iter().zip(bounds) {
            assert!(*total >= bound && *total < 1e-5, "{closure}: {total}");
        }
    }
}
