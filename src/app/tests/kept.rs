use super::*;
use crate::app::keeper::{Keeper, State, Store};
use tempfile::TempDir;

fn kept(folder: &TempDir) -> State {
    Keeper::open(Store::in_folder(folder.path().into()))
        .1
        .expect("a file")
}

fn keeping(folder: &TempDir) -> Screen {
    let mut screen = triangle([]);
    let keeper = Keeper::open(Store::in_folder(folder.path().into())).0;
    screen.harness.state_mut().1.keeper = Some(keeper);
    screen.harness.run();
    screen
}

/// Whatever ends the program after a frame: the file has it already.
#[test]
fn every_change_is_in_the_file_at_once() {
    let folder = tempfile::tempdir().unwrap();
    let mut screen = keeping(&folder);
    for key in [Key::ArrowRight, Key::N, Key::T, Key::L, Key::N, Key::S] {
        screen.press(Modifiers::NONE, key);
        assert_eq!(
            kept(&folder).session,
            screen.session_mut().keep(),
            "{key:?}"
        );
    }
    screen.harness.hover_at(BORDER);
    screen.harness.drag_at(BORDER);
    screen.harness.run();
    screen.harness.drop_at(egui::pos2(449.0, 300.0));
    screen.harness.run();
    assert!(kept(&folder).layout.column.is_some());
}

#[test]
fn progress_is_forgotten_only_after_a_second_word() {
    let folder = tempfile::tempdir().unwrap();
    let mut screen = keeping(&folder);
    screen.press(Modifiers::NONE, Key::N);
    let step = screen.session().step();
    let text = |message: crate::language::Message| message.text(Language::English);
    for answer in [strings::KEEP_IT, strings::FORGET_IT] {
        assert_eq!(screen.session().step(), step);
        screen.click(text(strings::MENU));
        screen.click(text(strings::FORGET));
        screen.keep("forget");
        screen
            .harness
            .get_by_role_and_label(egui::Role::Button, text(answer))
            .click();
        screen.harness.run();
    }
    assert_eq!(screen.session().step(), 0);
    assert_eq!(kept(&folder).session, screen.session_mut().keep());
}

#[test]
fn what_cannot_be_kept_is_said_in_the_window() {
    let folder = tempfile::tempdir().unwrap();
    let mut screen = keeping(&folder);
    std::fs::write(folder.path().join("progress.json"), "{").unwrap();
    screen.press(Modifiers::NONE, Key::ArrowRight);
    let notice = screen.harness.state().1.notice.clone().expect("a notice");
    assert!(notice.contains("progress.damaged-1.json"), "{notice}");
    assert_eq!(kept(&folder).session, screen.session_mut().keep());
}
