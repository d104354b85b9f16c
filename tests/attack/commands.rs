//! Every command but `open` and `study`, with random scenes and arguments, in one process: what it prints and writes is looked at after
//! each.
//!
//! The process is this one once more, whose output goes to files that it reads itself.

use crate::command_lines::case;
use crate::kit::{Driver, Outcome, is_clear, not_finite};
use crate::line::Case;
use crate::written::check_file;
use lightwalk::commands::run;
use std::ffi::OsString;
use std::fs::{self, File};
use std::io::{Read, Seek, SeekFrom, Write, stderr, stdout};
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};

/// Where the process finds its folder.
const FOLDER: &str = "ATTACK_FOLDER";

/// What has been written to a file since it was last asked.
struct Tail {
    path: PathBuf,
    read: u64,
}

impl Tail {
    fn take(&mut self) -> String {
        let mut file = File::open(&self.path).expect("the output of this process");
        let mut bytes = Vec::new();
        file.seek(SeekFrom::Start(self.read)).expect("it is a file");
        file.read_to_end(&mut bytes).expect("it can be read");
        self.read += bytes.len() as u64;
        String::from_utf8_lossy(&bytes).into_owned()
    }
}

/// What is in the folder of a case after its run, but for what was put there.
fn written(folder: &Path, case: &Case) -> Vec<PathBuf> {
    let mut found = Vec::new();
    let mut folders = vec![folder.to_owned()];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder)
            .expect("the folder of a case")
            .flatten()
        {
            match entry.path() {
                path if path.is_dir() => folders.push(path),
                path => found.push(path),
            }
        }
    }
    found.retain(|path| !case.files.keys().any(|name| path == &folder.join(name)));
    found
}

fn attempt(text: &str) -> Result<Outcome, String> {
    let folder = PathBuf::from(std::env::var_os(FOLDER).ok_or("the process has a folder")?);
    let [mut said, mut errors] = ["stdout", "stderr"].map(|name| {
        let path = folder.join(name);
        let read = path.metadata().map_or(0, |file| file.len());
        Tail { path, read }
    });
    let place = folder.join("case");
    let _ = fs::remove_dir_all(&place);
    fs::create_dir(&place).map_err(|error| error.to_string())?;
    let case: Case = serde_json::from_str(text).map_err(|error| error.to_string())?;
    for (name, bytes) in &case.files {
        fs::write(place.join(name), bytes).map_err(|error| error.to_string())?;
    }
    fs::write(folder.join("arguments"), case.arguments.join(" "))
        .map_err(|error| error.to_string())?;

    let arguments = std::iter::once("lightwalk").chain(case.arguments.iter().map(String::as_str));
    let code = run(arguments.map(OsString::from));
    let flushed = stdout().flush().and_then(|()| stderr().flush());
    flushed.map_err(|error| error.to_string())?;
    let (said, errors) = (said.take(), errors.take());
    check(&case, &place, code, &said, &errors).map_err(|why| {
        format!("{why}\n{code:?}\n--- standard error\n{errors}--- standard output\n{said:.2000}")
    })
}

fn check(
    case: &Case,
    place: &Path,
    code: ExitCode,
    said: &str,
    errors: &str,
) -> Result<Outcome, String> {
    if errors.contains("panicked") {
        return Err("a thread panics".into());
    }
    let written = written(place, case);
    let named = written
        .iter()
        .find(|path| path.to_string_lossy().contains(".lightwalk-"));
    if let Some(path) = named {
        return Err(format!("{} is left behind", path.display()));
    }
    if code != ExitCode::SUCCESS {
        if !written.is_empty() && !case.arguments.iter().any(|argument| argument == "compare") {
            return Err(format!("{written:?} are written by a run that failed"));
        }
        is_clear(errors)?;
        return names_its_place(case, errors, code).map(|()| Outcome::Refused);
    }
    if let Some(place) = not_finite(said) {
        return Err(format!("a number that is not finite is printed: {place}"));
    }
    for path in &written {
        check_file(path).map_err(|why| format!("{}: {why}", path.display()))?;
    }
    Ok(Outcome::Done)
}

/// A message says which file or option is wrong; of work that failed, what failed.
fn names_its_place(case: &Case, errors: &str, code: ExitCode) -> Result<(), String> {
    let named = |place: &str| errors.contains(place);
    let file = case.files.keys().any(|name| named(name));
    let known = file
        || named("--")
        || named("<")
        || case
            .arguments
            .iter()
            .any(|argument| argument.len() > 2 && named(argument));
    match (code == ExitCode::from(1), code == ExitCode::from(2)) {
        (true, _) if named("lightwalk: ") => Ok(()),
        (_, true) if known => Ok(()),
        _ => Err("the message names no place".into()),
    }
}

const DRIVER: Driver = Driver {
    kind: "commands",
    cases: 600,
    done_percent: 12,
    make: case,
    attempt,
};

/// What [`every_command_is_right_or_refuses`] runs.
#[test]
#[ignore = "a part of another test"]
fn in_one_process() {
    if std::env::var_os(FOLDER).is_some() {
        DRIVER.attack();
    }
}

#[test]
fn every_command_is_right_or_refuses() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = |name: &str| File::create(folder.path().join(name)).expect("a file in it");
    let this = std::env::current_exe().expect("this program");
    let status = Command::new(this)
        .args([
            "--exact",
            "commands::in_one_process",
            "--ignored",
            "--nocapture",
        ])
        .env(FOLDER, folder.path())
        .current_dir(folder.path())
        .stdout(file("stdout"))
        .stderr(file("stderr"))
        .status()
        .expect("it starts");
    let read = |name: &str| fs::read_to_string(folder.path().join(name)).unwrap_or_default();
    let [said, errors] = ["stdout", "stderr"].map(read);
    let counts = said.lines().filter(|line| line.starts_with(DRIVER.kind));
    counts.for_each(|line| println!("{line}"));
    let last = read("arguments");
    let from = errors.len().saturating_sub(20_000);
    let from = (from..=errors.len())
        .find(|&at| errors.is_char_boundary(at))
        .unwrap_or(0);
    assert!(
        status.success(),
        "{status}; the last was lightwalk {last}\n{}",
        &errors[from..]
    );
}
