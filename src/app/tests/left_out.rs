//! The view of what is left out: read, ticked, and closed.

use super::{screen, words};
use crate::app::session::Command;
use crate::panels::words::Language;
use crate::scene::{Part, Parts};
use egui::{Key, Modifiers};
use egui_kittest::kittest::Queryable;

#[test]
fn a_ticked_part_is_done_all_the_same_and_timed() {
    let commands = [Command::Questions, Command::LeftOut];
    let mut screen = screen("needs", [1280, 800], 1.0, commands);
    let steps = screen.session().walk().len();
    let text = |label: &str, screen: &super::Screen| {
        let mut found = screen.harness.query_all_by_label_contains(label);
        found.next().is_some()
    };
    assert!(text("lights[0]: 3 of 4 objects", &screen));
    assert!(!text("Highlights", &screen), "the scene has some");
    screen.keep("left-out");
    screen.click("Reflected rays");
    assert_eq!(
        screen.session().stage().anyway(),
        Parts::from(Part::ReflectedRays)
    );
    assert!(screen.session().walk().len() > steps);
    screen.session_mut().wait_for_picture();
    screen.harness.run();
    let told = [words::TIME_WITH.en, words::TIMES_NONE.en];
    assert!(told.iter().any(|label| text(label, &screen)));
    screen.keep("left-out-ticked");
    screen.click("Reflected rays");
    assert!(screen.session().stage().anyway().is_empty());
    screen.press(Modifiers::NONE, Key::Escape);
    assert!(!screen.session().look.left_out);
}

#[test]
fn the_menu_opens_it_in_both_languages() {
    for (language, name) in [
        (Language::English, words::LEFT_OUT.en),
        (Language::Indonesian, words::LEFT_OUT.id),
    ] {
        let commands = [Command::Questions, Command::Speak(language)];
        let mut screen = screen("shadows", [1280, 800], 1.0, commands);
        let menu = screen.session().say(words::MENU);
        screen.click(menu);
        screen.click(name);
        assert!(screen.session().look.left_out);
    }
}
