//! The program as a user runs it: results, messages, exit status, and files that appear whole or not at all.

#[path = "common/broken.rs"]
mod broken;
#[path = "common/program.rs"]
mod program;

use broken::{BROKEN, GOOD, POT};
use program::{lightwalk, refused, text};
use std::fs;
use std::process::{Command, Output};

/// A folder with the unbroken scene and its mesh.
fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::create_dir(folder.path().join("meshes")).unwrap();
    fs::write(folder.path().join("meshes/pot.obj"), POT).unwrap();
    fs::write(folder.path().join("scene.json"), GOOD).unwrap();
    folder
}

#[test]
fn every_broken_scene_is_refused_without_a_file() {
    let folder = folder();
    for (from, to, said) in BROKEN {
        let case = format!("{from} → {to}");
        fs::write(
            folder.path().join("broken.json"),
            GOOD.replacen(from, to, 1),
        )
        .unwrap();
        let message = refused(
            &lightwalk(
                folder.path(),
                &[
                    "render",
                    "broken.json",
                    "--method",
                    "gouraud",
                    "--out",
                    "out.png",
                ],
            ),
            &case,
        );
        assert!(
            message.starts_with("lightwalk: broken.json: "),
            "{case}: {message}"
        );
        for part in *said {
            assert!(message.contains(part), "{case}: {message} lacks {part}");
        }
        assert_eq!(
            fs::read_dir(folder.path()).unwrap().count(),
            3,
            "{case}: left a file behind"
        );
    }
}

/// A right lesson, to be broken in one place.
const LESSON: &str = r#"{ "schema": 1, "id": "my-lesson", "number": 1,
  "title": { "en": "A title", "id": "Judul" }, "summary": { "en": "Why", "id": "Mengapa" }, "topics": ["gouraud"],
  "scene_file": "scene.json", "method": "gouraud", "size": [64, 48], "focus": { "polygon": 0 },
  "parameters": [{ "light": 0 }], "panels": ["image", "scan-line"],
  "steps": [
    { "at": { "kind": "VertexLit" }, "say": { "en": "It has {I_v:2}.", "id": "Nilainya {I_v:2}." },
      "question": { "ask": { "en": "How bright?", "id": "Seberapa terang?" }, "at": { "kind": "VertexLit" },
        "answer": { "number": { "field": "I_v.r", "tolerance": 0.01 } }, "why": { "en": "So.", "id": "Begitu." } } },
    { "at": { "kind": "EdgeTable" }, "say": { "en": "Edges", "id": "Sisi" } } ] }"#;

#[rustfmt::skip]
const BROKEN_LESSONS: &[(&str, &str, &[&str])] = &[
    ("\"schema\": 1,", "", &["`schema` is missing"]),
    ("\"number\": 1,", "", &["missing field `number`"]),
    ("\"number\": 1,", "\"number\": -1,", &["number", "line 1"]),
    ("\"number\": 1,", "\"numbr\": 1,", &["unknown field `numbr`"]),
    ("my-lesson", "My Lesson", &["id: found \"My Lesson\"", "lower-case"]),
    ("\"en\": \"A title\", ", "", &["title", "missing field `en`"]),
    ("Judul", "  ", &["title.id: found an empty text"]),
    ("\"id\": \"Sisi\"", "\"de\": \"Kanten\"", &["steps[1].say", "unknown field `de`"]),
    ("\"scene_file\": \"scene.json\", ", "", &["exactly one of the keys `scene`"]),
    ("scene.json", "../scene.json", &["scene_file", ".."]),
    ("scene.json", "/etc/passwd", &["scene_file"]),
    ("scene.json", "none.json", &["scene_file", "none.json"]),
    ("\"method\": \"gouraud\"", "\"method\": \"gouraud\", \"texture_mapping\": \"bent\"", &["texture_mapping: found \"bent\"; allowed are perspective, linear"]),
    ("\"method\": \"gouraud\"", "\"method\": \"goraud\"", &["method: found \"goraud\"; allowed are wireframe, flat, gouraud"]),
    ("[64, 48]", "[0, 48]", &["size: found 0×48"]),
    ("[64, 48]", "[64000000, 48]", &["size: found 64000000×48"]),
    ("[64, 48]", "[64]", &["size", "line 3"]),
    ("{ \"polygon\": 0 }", "{ \"polygon\": 99999 }", &["focus: found 99999: there are", "polygons"]),
    ("{ \"polygon\": 0 }", "{ \"scan_line\": 48 }", &["focus: found 48: there are 48 rows, counted from 0"]),
    ("{ \"polygon\": 0 }", "{ \"circle\": 0 }", &["focus", "unknown variant `circle`"]),
    ("{ \"light\": 0 }", "{ \"light\": 1 }", &["parameters[0]: found 1, a directional light; only point"]),
    ("{ \"light\": 0 }", "{ \"light\": 0 }, { \"light\": 7 }", &["parameters[1]: found 7; the scene has 2 lights"]),
    ("{ \"light\": 0 }", "{ \"light\": 0 }, { \"light\": 0 }", &["parameters[1]: found a parameter that stands in the list already"]),
    ("{ \"light\": 0 }", "{ \"light\": -1 }", &["parameters[0].light", "line 4"]),
    ("{ \"light\": 0 }", "{ \"lamp\": 0 }", &["parameters[0]", "line 4", "unknown variant `lamp`"]),
    ("{ \"light\": 0 }", "{ \"specular\": \"glass\" }", &["parameters[0]: found \"glass\", which is no material of the scene; it has"]),
    ("{ \"light\": 0 }", "{ \"divisions\": \"glass\" }", &["parameters[0]: found \"glass\", which is no object"]),
    ("[{ \"light\": 0 }]", "null", &["parameters", "null"]),
    ("\"scan-line\"", "\"scanline\"", &["panels[1]: found \"scanline\"; allowed are image"]),
    ("[\"image\", \"scan-line\"]", "[]", &["panels: found an empty list"]),
    ("\"kind\": \"EdgeTable\"", "\"kind\": \"EdgeTabel\"", &["steps[1].at: no step from", "EdgeTable"]),
    ("\"kind\": \"EdgeTable\"", "\"kind\": \"Frame\"", &["steps[1].at: no step from"]),
    ("\"kind\": \"EdgeTable\"", "\"index\": 7", &["steps[1].at", "unknown field `index`"]),
    ("It has {I_v:2}", "It has {I_w}", &["steps[0].say.en: found `{I_w}`", "told are"]),
    ("It has {I_v:2}", "It has {I_v", &["steps[0].say.en: found `{` without"]),
    ("\"I_v.r\"", "\"I_7\"", &["steps[0].question.answer: `I_7` is no number told"]),
    ("\"tolerance\": 0.01", "\"tolerance\": -1", &["steps[0].question.answer", "tolerance"]),
    ("\"tolerance\": 0.01", "\"tolerance\": 1e400", &["line", "finite"]),
    ("{ \"number\": { \"field\": \"I_v.r\", \"tolerance\": 0.01 } }", "{ \"pixel\": { \"tolerance\": 0 } }", &["does not tell a pixel"]),
    ("{ \"number\": { \"field\": \"I_v.r\", \"tolerance\": 0.01 } }", "{ \"choice\": [] }", &["0 of the 0 options hold"]),
    ("\"ask\": ", "\"aks\": ", &["steps[0].question", "unknown field `aks`"]),
    ("] }", "]", &["the file ends here"]),
];

#[test]
fn every_broken_lesson_is_refused_with_its_place_and_reason() {
    let folder = folder();
    fs::write(folder.path().join("lesson.json"), LESSON).unwrap();
    let right = lightwalk(folder.path(), &["check", "lesson.json", "scene.json"]);
    assert_eq!(right.status.code(), Some(0), "{}", text(&right.stderr));
    for (from, to, said) in BROKEN_LESSONS {
        let case = format!("{from} → {to}");
        assert!(LESSON.contains(from), "{case}");
        // The last of them, so that an ending can be cut off too
        let at = if *from == "] }" {
            LESSON.rfind(from)
        } else {
            LESSON.find(from)
        }
        .unwrap();
        let broken = format!("{}{to}{}", &LESSON[..at], &LESSON[at + from.len()..]);
        fs::write(folder.path().join("broken.json"), broken).unwrap();
        let message = refused(&lightwalk(folder.path(), &["check", "broken.json"]), &case);
        for part in *said {
            assert!(message.contains(part), "{case}: {message} lacks {part}");
        }
        refused(
            &lightwalk(folder.path(), &["frames", "broken.json", "--out", "frames"]),
            &case,
        );
        assert!(!folder.path().join("frames").exists(), "{case}");
    }
}

#[test]
fn wrong_arguments_say_what_is_allowed() {
    let folder = folder();
    fs::create_dir(folder.path().join("folder.png")).unwrap();
    let render = |arguments: &[&str]| {
        lightwalk(
            folder.path(),
            &[&["render", "scene.json"], arguments].concat(),
        )
    };
    let cases: [(Output, &str); 14] = [
        (
            render(&["--method", "raytracing", "--out", "x.png"]),
            "wireframe, flat, gouraud",
        ),
        (render(&["--method", "flat"]), "--out"),
        (
            render(&["--method", "flat", "--out", "x.jpg"]),
            ".png or .pfm",
        ),
        (
            render(&["--method", "flat", "--out", "none/x.png"]),
            "does not exist",
        ),
        (
            render(&["--method", "flat", "--out", "folder.png"]),
            "is a folder",
        ),
        (
            render(&["--method", "flat", "--out", "x.png", "--size", "0x0"]),
            "sides from 1",
        ),
        (
            render(&[
                "--method",
                "flat",
                "--out",
                "x.png",
                "--size",
                "99999x99999",
            ]),
            "pixels",
        ),
        (
            render(&["--method", "flat", "--out", "x.png", "--threads", "0"]),
            "threads",
        ),
        (
            render(&["--method", "flat", "--out", "x.png", "--exposure", "nan"]),
            "from -64 to 64",
        ),
        (
            render(&["--method", "flat", "--out", "x.png", "--max-patches", "3"]),
            "patches",
        ),
        (
            lightwalk(folder.path(), &["steps", "scene.json"]),
            "--method",
        ),
        (
            lightwalk(
                folder.path(),
                &[
                    "steps",
                    "scene.json",
                    "--method",
                    "flat",
                    "--pixel",
                    "640,0",
                ],
            ),
            "640 columns",
        ),
        (
            lightwalk(folder.path(), &["steps", "no-such-lesson"]),
            "no-such-lesson",
        ),
        (
            lightwalk(folder.path(), &["frames", "scene.json", "--out", "x"]),
            "is a scene",
        ),
    ];
    for (output, said) in cases {
        let message = refused(&output, said);
        assert!(message.contains(said), "{message} lacks {said}");
    }
    assert!(!folder.path().join("x.png").exists() && !folder.path().join("x").exists());
}

#[cfg(unix)]
#[test]
fn a_mesh_outside_the_folder_is_refused_also_behind_a_link() {
    let outside = tempfile::tempdir().unwrap();
    fs::write(outside.path().join("secret.obj"), POT).unwrap();
    let folder = folder();
    std::os::unix::fs::symlink(
        outside.path().join("secret.obj"),
        folder.path().join("meshes/link.obj"),
    )
    .unwrap();
    std::os::unix::fs::symlink(outside.path(), folder.path().join("away")).unwrap();
    std::os::unix::fs::symlink(
        folder.path().join("meshes/pot.obj"),
        folder.path().join("inside.obj"),
    )
    .unwrap();
    for (mesh, right) in [
        ("meshes/link.obj", false),
        ("away/secret.obj", false),
        ("inside.obj", true),
    ] {
        fs::write(
            folder.path().join("linked.json"),
            GOOD.replace("meshes/pot.obj", mesh),
        )
        .unwrap();
        let output = lightwalk(folder.path(), &["check", "linked.json"]);
        if right {
            assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
        } else {
            assert!(refused(&output, mesh).contains("outside"));
        }
    }
}

/// Renamed onto its name, the file would take the place of the pipe, or of a device.
#[cfg(unix)]
#[test]
fn a_pipe_takes_the_output_and_stays_a_pipe() {
    let folder = folder();
    let pipe = folder.path().join("pipe.pfm");
    let made = std::process::Command::new("mkfifo").arg(&pipe).status();
    assert!(made.unwrap().success());
    let reader = std::thread::spawn({
        let pipe = pipe.clone();
        move || fs::read(pipe).unwrap()
    });
    let arguments = [
        "render",
        "scene.json",
        "--method",
        "flat",
        "--size",
        "40x30",
    ];
    let output = lightwalk(
        folder.path(),
        &[&arguments[..], &["--out", "pipe.pfm"]].concat(),
    );
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    assert!(!fs::metadata(&pipe).unwrap().is_file());
    assert!(reader.join().unwrap().starts_with(b"PF\n40 30\n"));
}

#[test]
fn pictures_come_in_both_formats() {
    let folder = folder();
    for method in [
        "wireframe",
        "flat",
        "gouraud",
        "phong",
        "fast-phong",
        "exact",
    ] {
        for name in ["x.png", "x.pfm"] {
            let arguments = [
                "render",
                "scene.json",
                "--method",
                method,
                "--size",
                "40x30",
                "--out",
                name,
                "--stats",
            ];
            let output = lightwalk(folder.path(), &arguments);
            assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
            let stats: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
            assert!(stats["seconds"]["render"].as_f64().unwrap() > 0.0);
            assert_eq!(stats["left_out"][0]["object"], "floor");
            assert!(text(&output.stderr).contains("infinite plane \"floor\""));
        }
    }
    let pfm = fs::read(folder.path().join("x.pfm")).unwrap();
    assert!(pfm.starts_with(b"PF\n40 30\n-1.0\n"));
    assert_eq!(pfm.len(), 14 + 40 * 30 * 12);
    assert!(
        fs::read(folder.path().join("x.png"))
            .unwrap()
            .starts_with(b"\x89PNG")
    );
}

#[test]
fn steps_are_json_lines_in_order() {
    let folder = folder();
    let output = lightwalk(
        folder.path(),
        &["steps", "gouraud-triangle", "--scan-line", "15"],
    );
    let lines: Vec<serde_json::Value> = text(&output.stdout)
        .lines()
        .map(|line| serde_json::from_str(line).unwrap())
        .collect();
    assert!(
        lines
            .iter()
            .enumerate()
            .all(|(step, line)| line["step"] == step)
    );
    assert_eq!(lines[0]["kind"], "Frame");
    assert_eq!(lines[0]["depth"], 0);
    let edge = lines
        .iter()
        .find(|line| line["kind"] == "EdgeInterpolated")
        .unwrap();
    let number = |name: &str| {
        edge[name]
            .as_f64()
            .or_else(|| edge[name][0].as_f64())
            .unwrap()
    };
    // The slide's formula, from the line's own values
    let weight = (number("y_4") - number("y_2")) / (number("y_1") - number("y_2"));
    assert!(
        (number("I_4") - (weight * number("I_1") + (1.0 - weight) * number("I_2"))).abs() < 1e-14
    );
    let file = lightwalk(
        folder.path(),
        &[
            "steps",
            "gouraud-triangle",
            "--scan-line",
            "15",
            "--out",
            "steps.jsonl",
        ],
    );
    assert_eq!(file.status.code(), Some(0));
    assert_eq!(
        fs::read(folder.path().join("steps.jsonl")).unwrap(),
        output.stdout
    );
}

#[test]
fn lessons_are_listed_and_their_frames_drawn() {
    let folder = folder();
    let listed: serde_json::Value =
        serde_json::from_slice(&lightwalk(folder.path(), &["list", "--json"]).stdout).unwrap();
    let ids: Vec<&str> = listed
        .as_array()
        .unwrap()
        .iter()
        .map(|lesson| lesson["id"].as_str().unwrap())
        .collect();
    let expected = [
        "illumination-model",
        "distance",
        "flat-shading",
        "gouraud-triangle",
        "gouraud-teapot",
        "mach-bands",
        "incremental-drift",
        "phong-highlight",
        "fast-phong",
        "side-by-side",
        "ray-casting",
        "shadows",
        "reflection",
        "refraction",
        "ray-tree",
        "depth-attenuation",
        "texture-transparency",
        "form-factors",
        "assumptions",
        "linear-system",
        "gathering",
        "shooting",
        "color-bleeding",
        "cornell-box",
        "stiff-room",
        "error-against-time",
        "needs",
        "extremes",
    ];
    assert_eq!(ids, expected);
    assert!(listed[3]["steps"].as_u64().unwrap() > 1000);
    let output = lightwalk(
        folder.path(),
        &[
            "frames",
            "gouraud-triangle",
            "--steps",
            "5..7",
            "--panel",
            "image",
            "--size",
            "300x200",
            "--out",
            "frames",
        ],
    );
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let mut names: Vec<_> = fs::read_dir(folder.path().join("frames"))
        .unwrap()
        .map(|entry| entry.unwrap().file_name())
        .collect();
    names.sort();
    assert_eq!(names, ["step-000005-image.png", "step-000006-image.png"]);
}

#[test]
fn without_a_display_the_window_says_so_in_one_line() {
    let output = lightwalk(folder().path(), &["open"]);
    let message = text(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{message}");
    assert_eq!(message.trim_end().lines().count(), 1, "{message}");
    assert!(message.contains("lightwalk frames"), "{message}");
}

#[cfg(unix)]
#[test]
fn an_interruption_leaves_no_file_and_says_130() {
    let folder = folder();
    let mut running = Command::new(env!("CARGO_BIN_EXE_lightwalk"))
        .current_dir(folder.path())
        .args([
            "steps",
            "scene.json",
            "--method",
            "gouraud",
            "--size",
            "700x500",
            "--out",
            "steps.jsonl",
        ])
        .stderr(std::process::Stdio::null())
        .spawn()
        .unwrap();
    // Until the file is begun
    let unfinished = || {
        fs::read_dir(folder.path()).unwrap().any(|entry| {
            entry
                .unwrap()
                .file_name()
                .to_string_lossy()
                .starts_with(".lightwalk-")
        })
    };
    while !unfinished() {
        assert!(
            running.try_wait().unwrap().is_none(),
            "it ended before it could be interrupted"
        );
        std::thread::sleep(std::time::Duration::from_millis(10));
    }
    let kill = Command::new("kill")
        .args(["-INT", &running.id().to_string()])
        .status()
        .unwrap();
    assert!(kill.success());
    assert_eq!(running.wait().unwrap().code(), Some(130));
    assert!(!unfinished());
    assert!(!folder.path().join("steps.jsonl").exists());
}

#[cfg(unix)]
#[test]
fn a_long_render_is_interrupted_at_once() {
    let folder = folder();
    // Fifty thousand times the whole picture: longer than anybody waits.
    let wall = "v -9 -9 1\nv 9 -9 1\nv 9 9 1\nv -9 9 1\nvt 0 0\n".to_owned();
    let mesh = wall + &"f 1/1 2/1 3/1 4/1\n".repeat(50_000);
    fs::write(folder.path().join("meshes/pot.obj"), mesh).unwrap();
    let mut running = Command::new(env!("CARGO_BIN_EXE_lightwalk"))
        .current_dir(folder.path())
        .args(["render", "scene.json", "--method", "flat", "--threads", "1"])
        .args(["--out", "x.png"])
        .stderr(std::process::Stdio::null())
        .spawn()
        .unwrap();
    std::thread::sleep(std::time::Duration::from_secs(1));
    assert!(running.try_wait().unwrap().is_none(), "it was not long");
    let interrupted = std::time::Instant::now();
    let kill = Command::new("kill")
        .args(["-INT", &running.id().to_string()])
        .status()
        .unwrap();
    assert!(kill.success());
    assert_eq!(running.wait().unwrap().code(), Some(130));
    assert!(interrupted.elapsed().as_secs() < 5);
    // The scene and the folder of its mesh, and nothing begun.
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 2);
}

#[cfg(target_os = "linux")]
#[test]
fn messages_that_nobody_can_read_do_not_stop_the_work() {
    let folder = folder();
    let full = fs::OpenOptions::new()
        .write(true)
        .open("/dev/full")
        .unwrap();
    let status = Command::new(env!("CARGO_BIN_EXE_lightwalk"))
        .current_dir(folder.path())
        .args([
            "render",
            "scene.json",
            "--method",
            "flat",
            "--size",
            "20x20",
            "--out",
            "x.png",
        ])
        .stderr(full)
        .status()
        .unwrap();
    assert_eq!(status.code(), Some(0));
    assert!(folder.path().join("x.png").exists());
}
