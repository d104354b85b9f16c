use super::folder::{FILE, LOCK};
use super::*;
use std::fs::{self, File};
use tempfile::TempDir;

fn folder() -> TempDir {
    tempfile::tempdir().unwrap()
}

fn open(folder: &TempDir) -> (Keeper, State) {
    let (keeper, found) = Keeper::open(Store::in_folder(folder.path().into()));
    (keeper, found.unwrap())
}

/// A state that names a language and, of each lesson, how many explanations were reached.
fn state(language: &str, lessons: &[(&str, usize)]) -> State {
    let mut state = State::default();
    state.session.language = Some(language.into());
    for (id, reached) in lessons {
        let progress = state.session.lessons.entry((*id).into()).or_default();
        progress.reached = *reached;
    }
    state
}

fn file(folder: &TempDir) -> String {
    fs::read_to_string(folder.path().join(FILE)).unwrap()
}

#[test]
fn what_is_written_is_found_again_and_written_once() {
    let folder = folder();
    let (mut keeper, found) = open(&folder);
    assert_eq!(found, State::default());
    assert_eq!(keeper.save(&found).unwrap(), Saved::Unchanged);
    let mut kept = state("id", &[("shadows", 3)]);
    kept.layout.column = Some(312.5);
    assert_eq!(keeper.save(&kept).unwrap(), Saved::Written);
    assert_eq!(open(&folder).1, kept);
    assert_eq!(keeper.save(&kept).unwrap(), Saved::Unchanged);
    // Nothing but the file and its lock is left.
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 2);
}

#[test]
fn two_windows_keep_what_the_other_one_has_changed() {
    let folder = folder();
    let (mut first, _) = open(&folder);
    first
        .save(&state("en", &[("shadows", 1), ("reflection", 1)]))
        .unwrap();
    let (mut second, _) = open(&folder);
    first
        .save(&state("en", &[("shadows", 5), ("reflection", 1)]))
        .unwrap();
    second
        .save(&state("id", &[("shadows", 1), ("reflection", 7)]))
        .unwrap();
    first
        .save(&state("en", &[("shadows", 6), ("reflection", 1)]))
        .unwrap();
    let both = state("id", &[("shadows", 6), ("reflection", 7)]);
    assert_eq!(open(&folder).1, both);
}

#[test]
fn what_a_newer_program_has_added_stays() {
    let folder = folder();
    let text = r#"{ "session": { "language": "en", "speed": 4 }, "window": [1, 2] }"#;
    fs::write(folder.path().join(FILE), text).unwrap();
    let (mut keeper, mut found) = open(&folder);
    found.session.language = Some("id".into());
    keeper.save(&found).unwrap();
    let value: Value = serde_json::from_str(&file(&folder)).unwrap();
    assert_eq!(value["session"]["language"], "id");
    assert_eq!(value["session"]["speed"], 4);
    assert_eq!(value["window"], serde_json::json!([1, 2]));
}

#[test]
fn a_damaged_file_is_set_aside() {
    for damaged in ["", "{", "[]", "{\"session\": {\"lessons\": 3}}", "\u{0}"] {
        let folder = folder();
        let path = folder.path().join(FILE);
        // One is there from an earlier time.
        let earlier = folder.path().join("progress.damaged-1.json");
        fs::write(&earlier, "earlier").unwrap();
        fs::write(&path, damaged).unwrap();
        let (mut keeper, found) = Keeper::open(Store::in_folder(folder.path().into()));
        let Err(Trouble::SetAside(aside)) = found else {
            panic!("{damaged}: {found:?}")
        };
        assert_eq!(fs::read_to_string(aside).unwrap(), damaged);
        assert_eq!(fs::read_to_string(earlier).unwrap(), "earlier");
        let kept = state("en", &[("shadows", 2)]);
        assert_eq!(keeper.save(&kept).unwrap(), Saved::Written);
        // Damaged while the window is open: what it knows is written anew.
        fs::write(&path, damaged).unwrap();
        let kept = state("en", &[("shadows", 3)]);
        let saved = keeper.save(&kept);
        assert!(matches!(saved, Err(Trouble::SetAside(_))), "{saved:?}");
        assert_eq!(keeper.save(&kept).unwrap(), Saved::Unchanged);
        assert_eq!(open(&folder).1, kept);
    }
}

#[test]
fn that_nothing_can_be_written_is_said_once() {
    let folder = folder();
    let inside = folder.path().join("a file");
    fs::write(&inside, "").unwrap();
    let (mut keeper, _) = Keeper::open(Store::in_folder(inside.join("data")));
    // Reading has failed already where the system distinguishes a file in the way from a missing one.
    keeper.complained = false;
    let failed = keeper.save(&state("en", &[("shadows", 1)]));
    assert!(matches!(failed, Err(Trouble::Failed(_))), "{failed:?}");
    for reached in 1..4 {
        let again = keeper.save(&state("en", &[("shadows", reached)]));
        assert_eq!(again.unwrap(), Saved::Unchanged);
    }
    fs::remove_file(&inside).unwrap();
    let kept = state("en", &[("shadows", 4)]);
    assert_eq!(keeper.save(&kept).unwrap(), Saved::Written);
}

#[test]
fn a_window_waits_while_another_one_writes() {
    let folder = folder();
    let (mut keeper, _) = open(&folder);
    let kept = state("en", &[("shadows", 1)]);
    let lock = File::create(folder.path().join(LOCK)).unwrap();
    lock.lock().unwrap();
    assert_eq!(keeper.save(&kept).unwrap(), Saved::Busy);
    drop(lock);
    assert_eq!(keeper.save(&kept).unwrap(), Saved::Written);
}

#[test]
fn forgetting_removes_also_what_another_window_has_written() {
    let folder = folder();
    let (mut first, _) = open(&folder);
    let (mut second, _) = open(&folder);
    second.save(&state("id", &[("shadows", 3)])).unwrap();
    first.forget();
    first.save(&state("en", &[("reflection", 1)])).unwrap();
    assert_eq!(open(&folder).1, state("en", &[("reflection", 1)]));
}
