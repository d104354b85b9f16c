//! A full disk, a folder that may not be written in, a reader who leaves: the exit status says so, a message says what and where, and no
//! part of a file stays.

use crate::radiosity::furnace;
use crate::{files, folder, text};
use std::fs;
use std::path::Path;
use std::process::{Command, Output};

/// What writes a file of more than 8 KiB, or several.
const WRITERS: [(&str, &str); 8] = [
    (
        "render scene.json --method flat --size 200x200 --out out.pfm",
        "out.pfm",
    ),
    (
        "steps scene.json --method gouraud --size 40x30 --out out.jsonl",
        "out.jsonl",
    ),
    (
        "steps scene.json --method gouraud --size 40x30 --out out.csv",
        "out.csv",
    ),
    (
        "frames gouraud-triangle --narrated --size 640x480 --out .",
        ".png",
    ),
    (
        "animate gouraud-triangle --size 480x360 --out out.png",
        "out.png",
    ),
    (
        "animate gouraud-triangle --size 480x360 --out out.gif",
        "out.gif",
    ),
    ("handout gouraud-triangle --out out.html", "out.html"),
    ("deck gouraud-triangle --out out.html", "out.html"),
];

/// Runs a line of the shell, in which `lightwalk` is the program.
fn shell(folder: &Path, line: &str) -> Output {
    let program = format!(
        "lightwalk() {{ '{}' \"$@\"; }}; {line}",
        env!("CARGO_BIN_EXE_lightwalk")
    );
    let mut shell = Command::new("sh");
    shell.current_dir(folder).args(["-c", &program]);
    shell.output().unwrap()
}

/// The message of a run that failed with this status.
fn failed(output: &Output, status: i32, case: &str) -> String {
    let message = text(&output.stderr);
    assert_eq!(output.status.code(), Some(status), "{case}: {message}");
    assert!(
        !message.contains("panicked") && !message.contains("os error"),
        "{case}: {message}"
    );
    message
}

/// A disk that takes 8 KiB of a file and no more.
#[test]
fn a_full_disk_leaves_no_part_of_a_file() {
    for (line, name) in WRITERS {
        let folder = folder();
        let output = shell(
            folder.path(),
            &format!("trap '' XFSZ; ulimit -f 16; lightwalk {line}"),
        );
        let message = failed(&output, 1, line);
        assert!(
            message.contains("lightwalk: cannot write ") && message.contains(name),
            "{line}: {message}"
        );
        let left = files(folder.path());
        assert!(
            left.iter()
                .all(|left| left == "meshes" || left == "scene.json"),
            "{line}: {left:?}"
        );
    }
}

#[test]
fn a_full_device_is_reported() {
    let folder = folder();
    for line in [
        "steps scene.json --method flat --size 9x7 --out /dev/full",
        "steps scene.json --method flat --size 9x7 > /dev/full",
        "check scene.json > /dev/full",
        "check --json scene.json > /dev/full",
        "needs scene.json --json > /dev/full",
        "schema scene > /dev/full",
        "stress refusals > /dev/full",
        "render scene.json --method flat --size 9x7 --stats --out x.png > /dev/full",
    ] {
        let message = failed(&shell(folder.path(), &format!("lightwalk {line}")), 1, line);
        let is_told = message.contains("cannot write /dev/full: ")
            || message.contains("cannot write the results: ");
        assert!(
            is_told && message.contains("no storage space"),
            "{line}: {message}"
        );
    }
}

/// The system's folder of processes takes no files, from nobody.
#[test]
fn a_folder_that_takes_no_files_is_refused_before_the_work() {
    let folder = folder();
    for (line, _) in WRITERS {
        let line = line
            .replace("out.", "/proc/out.")
            .replace("--out .", "--out /proc");
        let message = failed(
            &shell(folder.path(), &format!("lightwalk {line}")),
            2,
            &line,
        );
        assert!(message.contains("/proc"), "{line}: {message}");
    }
}

#[test]
fn a_folder_that_is_closed_is_refused_and_keeps_its_files() {
    let folder = folder();
    let closed = folder.path().join("closed");
    fs::create_dir(&closed).unwrap();
    fs::write(closed.join("out.png"), "of before").unwrap();
    let mut permissions = fs::metadata(&closed).unwrap().permissions();
    permissions.set_readonly(true);
    fs::set_permissions(&closed, permissions).unwrap();
    // Whoever may do everything writes in it all the same.
    if fs::write(closed.join("probe"), "").is_ok() {
        fs::remove_file(closed.join("probe")).unwrap();
        return;
    }
    let line = "lightwalk render scene.json --method flat --size 9x7 --out closed/out.png";
    let message = failed(&shell(folder.path(), line), 2, line);
    assert!(
        message.contains("closed/out.png: cannot be written: no permission"),
        "{message}"
    );
    assert_eq!(fs::read(closed.join("out.png")).unwrap(), b"of before");
}

/// `head` takes a line and goes.
#[test]
fn a_reader_who_leaves_ends_the_run_without_a_word() {
    let folder = folder();
    // Its form factors fill the pipe.
    let furnace = fs::read_to_string(furnace().path().join("furnace.json")).unwrap();
    let room = furnace.replace("\"patches\": 2", "\"patches\": 8");
    fs::write(folder.path().join("room.json"), room).unwrap();
    for line in [
        "steps scene.json --method gouraud --size 60x50",
        "steps scene.json --method gouraud --size 60x50 --out /dev/stdout",
        "form-factors room.json --out /dev/stdout",
    ] {
        let line =
            format!("{{ lightwalk {line} 2> said; echo $? > status; }} | head -c 9 > /dev/null");
        assert!(shell(folder.path(), &line).status.success());
        let read = |name: &str| fs::read_to_string(folder.path().join(name)).unwrap();
        let said = read("said");
        assert_eq!(read("status"), "1\n", "{line}: {said}");
        // On a slow machine its progress is shown before there is anything to read.
        let usual = ["note: ", "leaves out", "form factors: "];
        let words = said
            .lines()
            .filter(|line| !usual.iter().any(|usual| line.contains(usual)));
        assert_eq!(words.count(), 0, "{line}: {said}");
    }
}
