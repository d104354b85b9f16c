//! The view of what is left out: read, ticked, and closed.

use super::{screen, strings};
use crate::app::session::Command;
use crate::panels::strings::Language;
use crate::scene::{Part, Parts};
use egui::{Key, Modifiers};
use egui_kittest::kittest::Queryable;

#[test]
fn a_ticked_part_is_done_all_the_same_and_timed() {
    let commands = [Command::Questions, Command::Skipped];
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
        screen.session().setup().forced(),
        Parts::from(Part::ReflectedRays)
    );
    assert!(screen.session().walk().len() > steps);
    screen.session_mut().wait_for_picture();
    screen.harness.run();
    let recorded = [
        "done all the same:",
        strings::TIMES_NONE.text(Language::English),
    ];
    assert!(recorded.iter().any(|label| text(label, &screen)));
    screen.keep("left-out-ticked");
    screen.click("Reflected rays");
    assert!(screen.session().setup().forced().is_empty());
    screen.press(Modifiers::NONE, Key::Escape);
    assert!(!screen.session().look.skipped);
}

#[test]
fn the_menu_opens_it_in_both_languages() {
    for (language, name) in [
        (Language::English, strings::LEFT_OUT.text(Language::English)),
        (
            Language::Indonesian,
            strings::LEFT_OUT.text(Language::Indonesian),
        ),
    ] {
        let commands = [Command::Questions, Command::Speak(language)];
        let mut screen = screen("shadows", [1280, 800], 1.0, commands);
        let menu = screen.session().localize(strings::MENU);
        screen.click(menu);
        screen.click(name);
        assert!(screen.session().look.skipped);
    }
}
