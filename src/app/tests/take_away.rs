//! Files that are taken away of a lesson.

use super::*;
use crate::app::opened::{Opened, Readers};
use crate::app::session::TakeAway;
use std::path::PathBuf;
use std::sync::Mutex;

static WRITTEN: Mutex<Vec<(PathBuf, Vec<u8>)>> = Mutex::new(Vec::new());

const READERS: Readers = Readers {
    document: |_| Err("no document".into()),
    folder: |_| Err("no folder".into()),
    picture: |_| Err("no picture".into()),
    text: |_| Err("no text".into()),
    scene: |_, _| Err(Vec::new()),
    lesson: |_, _| Err(Vec::new()),
    write: |path, bytes| {
        let mut written = WRITTEN.lock().unwrap();
        written.push((path.to_owned(), bytes.to_vec()));
        Ok(())
    },
    choose: |_| Ok(None),
};

#[test]
fn a_handout_slides_and_a_picture_are_saved_and_reported() {
    let mut screen = triangle([Command::Speak(Language::Indonesian)]);
    screen.harness.state_mut().1.opened = Some(Opened::new(READERS, None));
    for (what, name, within) in [
        (
            TakeAway::Handout,
            "gouraud-triangle-handout-id.html",
            "<html lang=\"id\">",
        ),
        (
            TakeAway::Deck,
            "gouraud-triangle-slides-id.html",
            "<section",
        ),
        (TakeAway::Picture, "gouraud-triangle-image-0.png", "PNG"),
    ] {
        screen
            .session_mut()
            .update(Command::TakeAway(what))
            .unwrap();
        while WRITTEN.lock().unwrap().is_empty() {
            screen.harness.step();
            std::thread::yield_now();
        }
        let (path, bytes) = WRITTEN.lock().unwrap().pop().unwrap();
        assert!(path.ends_with(name), "{path:?}");
        assert!(String::from_utf8_lossy(&bytes).contains(within), "{what:?}");
        let notice = screen.harness.state().1.notice.clone().unwrap();
        assert!(notice.contains(name), "{notice}");
    }
}
