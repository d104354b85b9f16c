//! Closing the window over changes that are not saved.

use super::scene_page::{page, with};
use super::*;
use crate::app::strings;
use crate::language::Message;
use crate::scene::edit::Edit;
use egui::{ViewportCommand, ViewportEvent, ViewportId};
use std::fs;

/// Asks the window to close; whether it goes on.
fn stays(screen: &mut Screen) -> bool {
    let window = &mut screen.harness.input_mut().viewports;
    let window = window.get_mut(&ViewportId::ROOT).expect("a window");
    window.events.push(ViewportEvent::Close);
    screen.harness.step();
    let stays = commands(screen).contains(&ViewportCommand::CancelClose);
    let window = &mut screen.harness.input_mut().viewports;
    window.get_mut(&ViewportId::ROOT).unwrap().events.clear();
    stays
}

fn commands(screen: &Screen) -> &[ViewportCommand] {
    let window = &screen.harness.output().viewport_output[&ViewportId::ROOT];
    &window.commands
}

fn has(screen: &Screen, message: Message) -> bool {
    let language = screen.session().look.language;
    let found = screen.harness.query_by_label(message.text(language));
    found.is_some()
}

fn press(screen: &mut Screen, message: Message) -> bool {
    let language = screen.session().look.language;
    screen.harness.get_by_label(message.text(language)).click();
    let mut closes = false;
    for _ in 0..3 {
        screen.harness.step();
        closes |= commands(screen).contains(&ViewportCommand::Close);
    }
    closes
}

fn change(screen: &mut Screen) {
    with(screen, |document, session| {
        let background = serde_json::json!([0.5, 0.5, 0.5]);
        document.edit(&[Edit::Set("background".into(), background)], session);
    });
}

#[test]
fn a_window_closes_over_unsaved_changes_only_when_that_is_wanted() {
    for language in Language::ALL {
        let (folder, mut screen) = page(language);
        let saved = || fs::read_to_string(folder.path().join("own.json")).unwrap();
        let before = saved();
        assert!(!stays(&mut screen), "nothing was changed");
        change(&mut screen);
        assert!(stays(&mut screen));
        screen.harness.run_steps(2);
        screen.keep(&format!("unsaved-{}", language.code()));
        assert!(!press(&mut screen, strings::STAY) && !has(&screen, strings::UNSAVED));
        assert_eq!(saved(), before);

        assert!(stays(&mut screen));
        screen.harness.run_steps(2);
        assert!(press(&mut screen, strings::CLOSE_UNSAVED));
        assert!(!stays(&mut screen), "that was wanted");
        assert_eq!(saved(), before);
    }
}

#[test]
fn what_is_saved_on_closing_is_not_saved_over_what_others_wrote() {
    let (folder, mut screen) = page(Language::English);
    let path = folder.path().join("own.json");
    change(&mut screen);
    let theirs = fs::read_to_string(&path).unwrap().replace("0.25", "0.75");
    fs::write(&path, &theirs).unwrap();
    assert!(stays(&mut screen));
    screen.harness.run_steps(2);
    assert!(!press(&mut screen, strings::SAVE_AND_CLOSE));
    assert_eq!(fs::read_to_string(&path).unwrap(), theirs);
    let message = screen.harness.state().1.notice.clone().unwrap();
    assert!(message.contains("own.json"), "{message}");

    let (folder, mut screen) = page(Language::English);
    change(&mut screen);
    assert!(stays(&mut screen));
    screen.harness.run_steps(2);
    assert!(press(&mut screen, strings::SAVE_AND_CLOSE));
    let saved = fs::read_to_string(folder.path().join("own.json")).unwrap();
    assert!(
        saved.contains("0.5, 0.5, 0.5") || saved.contains("[0.5,0.5,0.5]"),
        "{saved}"
    );
}
