//! The user's own picture beside ours, in its drawer.

use super::*;
use crate::app::opened::{Opened, Readers};
use crate::color::{png_rgb8, read_image};
use std::fs;
use std::path::Path;
use std::time::{Duration, SystemTime};

const READERS: Readers = Readers {
    document: |_| Err("no document".into()),
    folder: |_| Err("no folder".into()),
    picture: |path| read_image(&fs::read(path).unwrap()),
    text: |_| Err("no text".into()),
    scene: |_, _| Err(Vec::new()),
    lesson: |_, _| Err(Vec::new()),
    write: |_, _| Err("nothing is written".into()),
    choose: |_| Ok(None),
};

/// A lesson that asks nothing.
fn lesson(commands: impl IntoIterator<Item = Command>) -> Screen {
    let commands = [Command::Questions].into_iter().chain(commands);
    triangle(commands)
}

/// The finished picture as a PNG, saved so many seconds from now; its rows from the last to the first where it is `flipped`.
fn save(screen: &Screen, path: &Path, flipped: bool, later: u64) {
    let frame = &screen.session().panel_input().finished.picture;
    let mut rows: Vec<&[crate::color::Rgb]> = frame.color.chunks(frame.width as usize).collect();
    if flipped {
        rows.reverse();
    }
    let bytes: Vec<u8> = rows.concat().iter().flat_map(|c| c.to_srgb8()).collect();
    fs::write(path, png_rgb8(frame.width, rows.len() as u32, &bytes)).unwrap();
    let file = fs::File::options().write(true).open(path).unwrap();
    file.set_modified(SystemTime::now() + Duration::from_secs(later))
        .unwrap();
}

/// With a picture of the lesson upside down opened in it, and compared.
fn upside_down(commands: impl IntoIterator<Item = Command>) -> (tempfile::TempDir, Screen) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("mine.png");
    let mut screen = lesson(commands);
    save(&screen, &path, true, 0);
    let mut opened = Opened::new(READERS, None);
    opened.open(screen.session_mut(), &path).unwrap();
    screen.session_mut().wait_for_comparison();
    screen.harness.state_mut().1.opened = Some(opened);
    screen.harness.run_steps(4);
    (folder, screen)
}

#[test]
fn the_drawer_names_the_mistake_and_a_click_on_a_pixel_walks_it() {
    for language in Language::ALL {
        let (_folder, mut screen) = upside_down([Command::Speak(language)]);
        let name = crate::methods::Mistake::FlipY.in_words(language);
        let shown = screen.harness.query_all_by_label_contains(&name);
        assert_eq!(shown.count(), 1, "{name}");
        for title in [
            strings::COMPARE_MINE,
            strings::COMPARE_REFERENCE,
            strings::COMPARE_DIFFERENCE,
        ] {
            screen.picture(title.text(language));
        }
        screen.keep(&format!("against-{}", language.code()));
        let title = strings::COMPARE_REFERENCE.text(language);
        let place = screen.picture(title);
        screen.click_at(place.center());
        let [width, height] = screen.session().lesson().size;
        let Focus::Pixel { x, y } = screen.session().focus() else {
            panic!("a pixel");
        };
        assert!(
            x.abs_diff(width / 2) <= 2 && y.abs_diff(height / 2) <= 2,
            "({x}, {y})"
        );
    }
}

#[test]
fn a_picture_that_is_saved_again_is_compared_again() {
    let (folder, mut screen) = upside_down([]);
    save(&screen, &folder.path().join("mine.png"), false, 5);
    screen.harness.run_steps(2);
    let notice = screen.harness.state().1.notice.clone();
    let language = Language::English;
    assert_eq!(
        notice.as_deref(),
        Some(strings::PICTURE_READ_AGAIN.text(language))
    );
    screen.session_mut().wait_for_comparison();
    screen.harness.run_steps(2);
    let equal = strings::COMPARE_EQUAL.text(language);
    assert_eq!(screen.harness.query_all_by_label_contains(equal).count(), 1);
}

#[test]
fn nothing_of_ours_is_shown_while_a_question_waits() {
    let (_folder, mut screen) = upside_down([]);
    screen.session_mut().update(Command::Questions).unwrap();
    while !screen.session().panel_input().is_pending() {
        let next = screen.session_mut().update(Command::NextNarrated);
        next.expect("a question ahead");
    }
    screen.harness.run_steps(3);
    let language = Language::English;
    let title = strings::COMPARE_REFERENCE.text(language);
    assert!(screen.harness.query_all_by_label(title).next().is_none());
    screen
        .harness
        .get_by_label(strings::AFTER_YOUR_ANSWER.text(language));
}
