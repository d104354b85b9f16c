//! Ctrl-C: exit status 130, soon, and nothing left behind.

use crate::{command, files, folder};
use std::fs;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

fn start(folder: &Path, arguments: &str) -> Child {
    let mut command = command(folder, arguments);
    command
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .unwrap()
}

/// Interrupts a run that is still at work. It ends within five seconds.
pub fn interrupt(mut child: Child) {
    assert!(child.try_wait().unwrap().is_none(), "it was not long");
    let interrupted = Instant::now();
    let kill = Command::new("kill")
        .args(["-INT", &child.id().to_string()])
        .status();
    assert!(kill.unwrap().success());
    assert_eq!(child.wait().unwrap().code(), Some(130));
    assert!(interrupted.elapsed().as_secs() < 5);
}

#[test]
fn a_file_that_was_begun_is_gone() {
    let folder = folder();
    let steps = "steps scene.json --method gouraud --size 700x500 --out steps.jsonl";
    let mut child = start(folder.path(), steps);
    let begun = || {
        let files = files(folder.path());
        files.iter().any(|name| name.starts_with(".lightwalk-"))
    };
    while !begun() {
        assert!(child.try_wait().unwrap().is_none(), "it was not long");
        sleep(Duration::from_millis(10));
    }
    interrupt(child);
    assert_eq!(files(folder.path()), ["meshes", "scene.json"]);
}

#[test]
fn a_long_picture_ends_at_once() {
    let folder = folder();
    // Fifty thousand times the whole picture: longer than anybody waits.
    let wall = "v -9 -9 1\nv 9 -9 1\nv 9 9 1\nv -9 9 1\nvt 0 0\n".to_owned();
    let mesh = wall + &"f 1/1 2/1 3/1 4/1\n".repeat(50_000);
    fs::write(folder.path().join("meshes/pot.obj"), mesh).unwrap();
    let render = "render scene.json --method flat --threads 1 --out x.png";
    let child = start(folder.path(), render);
    sleep(Duration::from_secs(1));
    interrupt(child);
    assert_eq!(files(folder.path()), ["meshes", "scene.json"]);
}

#[test]
fn a_study_leaves_no_part_of_itself() {
    let folder = tempfile::tempdir().unwrap();
    let child = start(folder.path(), "study patches --out found");
    sleep(Duration::from_secs(2));
    interrupt(child);
    assert!(files(folder.path()).is_empty());
}

/// Whatever takes long, interrupted in the middle, leaves neither its results nor a part of them.
#[test]
fn all_long_work_ends_at_once() {
    let room = include_str!("../../lessons/scenes/cornell-box.json");
    for line in [
        "form-factors room.json --out x.json",
        "form-factors room.json --out x.npy",
        "radiosity room.json --solver jacobi --tolerance 1e-15 --out x.json",
        "render room.json --method radiosity --size 2000x2000 --samples 4 --threads 1 --out x.png",
        "render scene.json --method ray-tracing --size 4000x4000 --samples 8 --threads 1 --out x.png",
        "animate gouraud-teapot --steps 0..3000 --size 960x600 --out x.gif",
        "handout extremes --steps 0..400 --out x.html",
        "deck extremes --steps 0..400 --out x.html",
        "compare scene.json --method ray-tracing --with mine.ppm",
        "needs scene.json --method ray-tracing",
        "stress",
        "list",
        "steps stiff-room --out x.csv",
    ] {
        let folder = folder();
        let fine = room.replace("\"patches\": [4, 4]", "\"patches\": [24, 24]");
        fs::write(folder.path().join("room.json"), fine).unwrap();
        let (width, height) = (1200, 900);
        let mut picture = format!("P6 {width} {height} 255\n").into_bytes();
        picture.resize(picture.len() + 3 * width * height, 99);
        fs::write(folder.path().join("mine.ppm"), picture).unwrap();
        let before = files(folder.path());
        let mut child = start(folder.path(), line);
        sleep(Duration::from_millis(400));
        assert!(
            child.try_wait().unwrap().is_none(),
            "{line}: it was not long"
        );
        interrupt(child);
        assert_eq!(files(folder.path()), before, "{line}");
    }
}
