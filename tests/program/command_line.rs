//! Results, messages, exit status, and where results go.

#[cfg(feature = "gui")]
use crate::broken_files::LESSON;
#[cfg(all(target_os = "linux", feature = "gui"))]
use crate::command;
use crate::{files, folder, lightwalk, refused, succeeded, text};
use serde_json::Value;
use std::fs;
use std::path::Path;

#[cfg(feature = "gui")]
#[test]
fn what_the_window_cannot_open_is_reported() {
    let folder = folder();
    fs::create_dir_all(folder.path().join("own/meshes")).unwrap();
    fs::write(folder.path().join("own/first.json"), LESSON).unwrap();
    for file in ["scene.json", "meshes/pot.obj"] {
        let own = folder.path().join("own").join(file);
        fs::copy(folder.path().join(file), own).unwrap();
    }
    for (arguments, said) in [
        ("open gouraud-tea", "did you mean gouraud-teapot?"),
        ("open my-leson --lessons own", "did you mean my-lesson?"),
        ("open meshes", "meshes: there is no lesson in this folder"),
        ("open --lessons none", "none: no such file"),
        ("open meshes --step 3", "it is a folder"),
    ] {
        let message = refused(&lightwalk(folder.path(), arguments), arguments);
        assert!(message.contains(said), "{message} lacks {said}");
    }
}

#[test]
fn wrong_arguments_say_what_is_allowed() {
    let folder = folder();
    fs::create_dir(folder.path().join("folder.png")).unwrap();
    for (arguments, said) in [
        (
            "render scene.json --method raytracing --out x.png",
            "wireframe, flat, gouraud",
        ),
        ("render scene.json --method flat", "--out"),
        (
            "render scene.json --method flat --out x.jpg",
            ".png or .pfm",
        ),
        (
            "render scene.json --method flat --out none/x.png",
            "does not exist",
        ),
        (
            "render scene.json --method flat --out folder.png",
            "is a folder",
        ),
        (
            "render scene.json --method flat --out x.png --size 0x0",
            "sides from 1",
        ),
        (
            "render scene.json --method flat --out x.png --size 99999x99999",
            "pixels",
        ),
        (
            "render scene.json --method flat --out x.png --threads 0",
            "threads",
        ),
        (
            "render scene.json --method flat --out x.png --exposure nan",
            "from -64 to 64",
        ),
        (
            "render scene.json --method flat --out x.png --max-patches 3",
            "patches",
        ),
        (
            "steps scene.json",
            "--method is missing: a scene can be drawn in several ways; allowed are wireframe, flat",
        ),
        (
            "steps scene.json --method flat --pixel 640,0",
            "640 columns",
        ),
        (
            "steps no-such-lesson",
            "no-such-lesson: there is no such lesson or file; `lightwalk list`",
        ),
        (
            "steps gouraud-triangel",
            "there is no such lesson or file (did you mean gouraud-triangle?)",
        ),
        ("frames fast-phnog --out x", "did you mean fast-phong?"),
        (
            "check scnee.json",
            "cannot be read: no such file (did you mean scene.json?)",
        ),
        (
            "render scene.jsn --method flat --out x.png",
            "did you mean scene.json?",
        ),
        (
            "render gouraud-triangel --method flat --out x.png",
            "did you mean gouraud-triangle?",
        ),
        (
            "render refraction --method flat --out x.png",
            "it is a lesson of the program, and what is read here is a file",
        ),
        (
            "open refraction --step abc",
            "allowed are whole numbers of 0 or more",
        ),
        (
            "open refraction --step -1",
            "allowed are whole numbers of 0 or more",
        ),
        (
            "steps refraction --scan-line -1",
            "allowed are whole numbers of 0 or more",
        ),
        (
            "steps refraction --patch 1.5",
            "allowed are whole numbers of 0 or more",
        ),
        (
            "steps refraction --pixel -1,2",
            "a pixel is written as 12,34; it counts from 0",
        ),
        (
            "steps refraction --iterations -1..2",
            "a range is written as 3..10",
        ),
        (
            "frames refraction --steps -1..2 --out x",
            "a range is written as 3..10",
        ),
        (
            "frames refraction --out scene.json",
            "--out scene.json: scene.json is a file; name a folder",
        ),
        (
            "frames refraction --out scene.json/x",
            "scene.json is a file; name a folder",
        ),
        (
            "render scene.json --method flat --out x.png --exposure bright",
            "allowed are numbers, such as 0.5",
        ),
        (
            "render scene.json --method flat --out x.png --exposure 1e300",
            "--exposure 1e300: allowed are numbers from -64 to 64",
        ),
        (
            "render scene.json --method flat --out x.png --depth deep",
            "allowed are whole numbers from 1 to",
        ),
        (
            "render scene.json --method flat --out x.png --max-patches -3",
            "allowed are whole numbers of 0 or more",
        ),
        (
            "radiosity scene.json --tolerance 1e300 --out x",
            "--tolerance 1e300: allowed",
        ),
        (
            "radiosity scene.json --tolerance small --out x",
            "allowed are numbers, such as 0.5",
        ),
        (
            "form-factors scene.json --out f.foo",
            "--out f.foo: the name ends in .json or .csv or .npy",
        ),
        (
            "radiosity scene.json --out b.foo",
            "--out b.foo: the name ends in .json or .csv or .npy",
        ),
        (
            "steps gouraud-triangle --out s.npy",
            "--out s.npy: the name ends in .jsonl or .csv or .json",
        ),
    ] {
        let message = refused(&lightwalk(folder.path(), arguments), arguments);
        assert!(message.contains(said), "{message} lacks {said}");
    }
    assert_eq!(files(folder.path()), ["folder.png", "meshes", "scene.json"]);
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
            let render =
                format!("render scene.json --method {method} --size 40x30 --out {name} --stats");
            let output = succeeded(folder.path(), &render);
            let stats: Value = serde_json::from_slice(&output.stdout).unwrap();
            assert!(stats["seconds"]["render"].as_f64().unwrap() > 0.0);
            assert_eq!(stats["left_out"][0]["object"], "floor");
            assert!(text(&output.stderr).contains("infinite plane \"floor\""));
        }
    }
    let pfm = fs::read(folder.path().join("x.pfm")).unwrap();
    assert!(pfm.starts_with(b"PF\n40 30\n-1.0\n"));
    assert_eq!(pfm.len(), 14 + 40 * 30 * 12);
    let png = fs::read(folder.path().join("x.png")).unwrap();
    assert!(png.starts_with(b"\x89PNG"));
}

#[test]
fn steps_are_json_lines_in_order() {
    let folder = folder();
    let steps = "steps gouraud-triangle --scan-line 15";
    let output = succeeded(folder.path(), steps);
    let lines: Vec<Value> = text(&output.stdout)
        .lines()
        .map(|line| serde_json::from_str(line).unwrap())
        .collect();
    let mut numbered = lines.iter().enumerate();
    assert!(numbered.all(|(step, line)| line["step"] == step));
    assert_eq!(lines[0]["kind"], "Frame");
    assert_eq!(lines[0]["depth"], 0);
    let mut edges = lines
        .iter()
        .filter(|line| line["kind"] == "EdgeInterpolated");
    let edge = edges.next().unwrap();
    let number = |name: &str| {
        let value = &edge[name];
        value.as_f64().or_else(|| value[0].as_f64()).unwrap()
    };
    // The slide's formula, from the line's own values
    let weight = (number("y_4") - number("y_2")) / (number("y_1") - number("y_2"));
    let expected = weight * number("I_1") + (1.0 - weight) * number("I_2");
    assert!((number("I_4") - expected).abs() < 1e-14);

    succeeded(folder.path(), &format!("{steps} --out steps.jsonl"));
    let file = fs::read(folder.path().join("steps.jsonl")).unwrap();
    assert_eq!(file, output.stdout);
}

#[test]
fn lessons_are_listed_in_the_order_of_their_files() {
    let output = succeeded(folder().path(), "list --json");
    let listed: Value = serde_json::from_slice(&output.stdout).unwrap();
    let ids = listed
        .as_array()
        .unwrap()
        .iter()
        .map(|lesson| &lesson["id"]);
    // 04-gouraud-triangle.json
    let names = files(&Path::new(env!("CARGO_MANIFEST_DIR")).join("lessons"));
    let names = names.iter().filter_map(|name| name.strip_suffix(".json"));
    assert!(ids.eq(names.map(|name| &name[3..])), "{listed}");
    assert!(listed[3]["steps"].as_u64().unwrap() > 1000);
}

#[test]
fn the_frames_of_some_steps_of_one_panel_are_drawn() {
    let folder = folder();
    let frames = "frames gouraud-triangle --steps 5..7 --panel image --size 300x200 --out frames";
    succeeded(folder.path(), frames);
    assert_eq!(
        files(&folder.path().join("frames")),
        ["step-000005-image.png", "step-000006-image.png"]
    );
}

#[test]
fn without_a_display_the_window_says_so_in_one_line() {
    let output = lightwalk(folder().path(), "open");
    let message = text(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{message}");
    assert_eq!(message.trim_end().lines().count(), 1, "{message}");
    assert!(message.contains("lightwalk frames"), "{message}");
}

#[cfg(all(target_os = "linux", feature = "gui"))]
#[test]
fn a_wayland_socket_that_was_not_inherited_is_a_display_that_did_not_answer() {
    let folder = folder();
    for number in ["987", "-1", "socket"] {
        let mut open = command(folder.path(), "open");
        let output = open.env("WAYLAND_SOCKET", number).output().unwrap();
        let message = text(&output.stderr);
        assert_eq!(output.status.code(), Some(1), "{number}: {message}");
        assert_eq!(message.trim_end().lines().count(), 1, "{message}");
        let display = format!("the Wayland display {number:?} (that of WAYLAND_SOCKET)");
        assert!(message.contains(&display), "{message}");
    }
}

/// Renamed onto its name, the file would take the place of the pipe, or of a device.
#[cfg(unix)]
#[test]
fn a_pipe_takes_the_output_and_stays_a_pipe() {
    let folder = folder();
    let pipe = folder.path().join("pipe.pfm");
    let created = std::process::Command::new("mkfifo").arg(&pipe).status();
    assert!(created.unwrap().success());
    let reader = std::thread::spawn({
        let pipe = pipe.clone();
        move || fs::read(pipe).unwrap()
    });
    let render = "render scene.json --method flat --size 40x30 --out pipe.pfm";
    succeeded(folder.path(), render);
    assert!(!fs::metadata(&pipe).unwrap().is_file());
    assert!(reader.join().unwrap().starts_with(b"PF\n40 30\n"));
}

#[cfg(target_os = "linux")]
#[test]
fn messages_that_nobody_can_read_do_not_stop_the_work() {
    let folder = folder();
    let full = fs::OpenOptions::new()
        .write(true)
        .open("/dev/full")
        .unwrap();
    let render = "render scene.json --method flat --size 20x20 --out x.png";
    let status = crate::command(folder.path(), render).stderr(full).status();
    assert_eq!(status.unwrap().code(), Some(0));
    assert!(folder.path().join("x.png").exists());
}
