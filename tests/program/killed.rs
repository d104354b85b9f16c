//! Killed at any moment, with no chance to clean up: what stands under the name of a result is whole, and what was there before is
//! whole too.

use crate::{command, folder, succeeded};
use lightwalk::numeric::Random;
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::Instant;

/// Of each command.
const MOMENTS: u64 = 4;

/// What writes files, each into `out` and under names that begin so.
const COMMANDS: [&str; 9] = [
    "render scene.json --method ray-tracing --size 320x240 --threads 1 --out out.png",
    "render scene.json --method gouraud --size 900x700 --threads 1 --out out.pfm",
    "steps scene.json --method gouraud --size 90x70 --out out.jsonl",
    "steps scene.json --method ray-casting --size 20x15 --out out.csv",
    "frames gouraud-triangle --narrated --size 300x200 --out out",
    "animate gouraud-triangle --size 480x360 --out out.png",
    "handout gouraud-triangle --out out.html",
    "deck gouraud-triangle --out out.html",
    "compare scene.json --method flat --with before.png --out out",
];

/// The files whose names begin with `out`, and those in the folder `out`.
fn results(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let mut found = BTreeMap::new();
    for place in [folder.to_owned(), folder.join("out")] {
        for entry in fs::read_dir(&place).into_iter().flatten().flatten() {
            let name = entry.file_name().into_string().unwrap();
            let is_result = name.starts_with("out") || place.ends_with("out");
            if is_result && entry.path().is_file() && !name.starts_with(".lightwalk-") {
                found.insert(name, fs::read(entry.path()).unwrap());
            }
        }
    }
    found
}

fn kill(mut child: Child) {
    // It may have come to its end.
    let _ = child.kill();
    child.wait().unwrap();
}

fn start(mut command: Command) -> Child {
    command
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .unwrap()
}

#[test]
fn no_file_is_half_written() {
    let random = &mut Random(20);
    for line in COMMANDS {
        let folder = folder();
        let picture = "render scene.json --method wireframe --size 300x200 --out before.png";
        succeeded(folder.path(), picture);
        let begun = Instant::now();
        start(command(folder.path(), line)).wait().unwrap();
        let whole_time = begun.elapsed();
        let whole = results(folder.path());
        assert!(!whole.is_empty(), "{line}: nothing is written");
        for moment in 0..MOMENTS {
            // Over the results of before, or where there are none
            if moment % 2 == 0 {
                whole.keys().for_each(|name| {
                    let _ = fs::remove_file(folder.path().join(name));
                });
                let _ = fs::remove_dir_all(folder.path().join("out"));
            }
            let child = start(command(folder.path(), line));
            let share = 0.5 + 0.5 * random.number();
            sleep(whole_time.mul_f64(share.max(0.05)));
            kill(child);
            for (name, bytes) in results(folder.path()) {
                assert!(
                    whole.get(&name) == Some(&bytes),
                    "{line}: {name} is another after {share:.2} of the time"
                );
            }
        }
    }
}

/// Files that say how long the work took are not the same twice.
#[test]
fn no_measurement_is_half_written() {
    let random = &mut Random(21);
    for line in [
        "form-factors scene.json --out out.json",
        "radiosity scene.json --out out.json --matrix out.csv",
        "study interpolation --quick --out out",
    ] {
        let folder = room();
        let begun = Instant::now();
        succeeded(folder.path(), line);
        let whole_time = begun.elapsed();
        for (name, bytes) in results(folder.path()) {
            assert!(is_whole(&name, &bytes), "{line}: {name}");
        }
        for _ in 0..MOMENTS {
            let child = start(command(folder.path(), line));
            let share = 0.5 + 0.5 * random.number();
            sleep(whole_time.mul_f64(share.max(0.05)));
            kill(child);
            for (name, bytes) in results(folder.path()) {
                assert!(
                    is_whole(&name, &bytes),
                    "{line}: {name} after {share:.2} of the time"
                );
            }
        }
    }
}

/// Whether a file has its end.
fn is_whole(name: &str, bytes: &[u8]) -> bool {
    let (_, ending) = name.rsplit_once('.').unwrap();
    match ending {
        "json" => serde_json::from_slice::<serde_json::Value>(bytes).is_ok(),
        "png" => bytes.ends_with(b"IEND\xaeB`\x82"),
        "svg" => bytes.ends_with(b"</svg>\n"),
        _ => bytes.ends_with(b"\n"),
    }
}

/// Of some hundred patches.
fn room() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let scene = include_str!("../../lessons/scenes/cornell-box.json");
    fs::write(folder.path().join("scene.json"), scene).unwrap();
    folder
}
