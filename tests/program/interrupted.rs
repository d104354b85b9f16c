//! Ctrl-C: exit status 130, soon, and nothing left behind.

use crate::{command, files, folder};
use std::fs;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

fn start(folder: &Path, arguments: &str) -> Child {
    let mut command = command(folder, arguments);
    command.stderr(Stdio::null()).spawn().unwrap()
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
