//! Where one is in a lesson: the row over the narration, the outline, and the end.

use super::*;
use crate::app::session::{Sheet, listed};
use egui_kittest::Node;

fn named(message: crate::language::Message) -> &'static str {
    message.text(Language::English)
}

/// The line of an explanation, counted from 1, in the outline.
fn line<'a>(screen: &'a Screen, number: usize) -> Node<'a> {
    let start = format!("Explanation {number}: ");
    screen.harness.get_by(move |node| {
        let label = node.label().unwrap_or_default();
        node.role() == egui::Role::Button && label.starts_with(&start)
    })
}

fn at(screen: &Screen) -> Option<usize> {
    screen.session().explanation().map(|index| index + 1)
}

fn shows(screen: &Screen, label: &str) -> bool {
    screen.harness.query_by_label(label).is_some()
}

#[test]
fn the_row_says_which_explanation_this_is_and_leads_back() {
    let mut screen = triangle([Command::Questions]);
    let count = screen.session().explanations();
    let row = |number| format!("outline: explanation {number} of {count}");
    while at(&screen) != Some(4) {
        screen.press(Modifiers::NONE, Key::N);
    }
    assert_eq!(at(&screen), Some(4));
    assert!(shows(&screen, &row(4)));
    screen.keep("whereabouts");
    screen.click(named(strings::PREVIOUS_SAID));
    assert!(shows(&screen, &row(3)));
    let narrated = screen.session().panel_input().narrated.to_vec();
    let (index, step) = (narrated.iter().enumerate())
        .find(|(_, step)| !narrated.contains(&(*step + 1)))
        .expect("a step without an explanation");
    let between = Command::Seek(step + 1);
    screen.session_mut().update(between).expect("a step");
    screen.harness.run();
    assert!(shows(&screen, &row(index + 1)));
    screen.click(named(strings::START_AGAIN));
    assert_eq!(screen.session().step(), 0);
}

#[test]
fn between_explanations_the_one_before_is_not_repeated() {
    let mut screen = triangle([Command::Questions]);
    screen.press(Modifiers::NONE, Key::N);
    let said = screen.session().narration_here().expect("an explanation");
    let said = said.text(Language::English).to_owned();
    let begins = |screen: &Screen| {
        let start = said[..20].to_owned();
        let mut found = screen.harness.query_all_by(move |node| {
            let text = node.value().or(node.label()).unwrap_or_default();
            text.starts_with(&start)
        });
        found.next().is_some()
    };
    assert!(begins(&screen));
    screen.press(Modifiers::NONE, Key::ArrowRight);
    assert!(!begins(&screen));
}

#[test]
fn a_line_of_the_outline_leads_to_its_explanation() {
    let mut screen = triangle([Command::Questions]);
    screen.press(Modifiers::NONE, Key::O);
    screen.keep("outline");
    line(&screen, 5).click();
    screen.harness.run();
    assert_eq!(at(&screen), Some(5));
    assert_eq!(screen.session().look.sheet, None);
    // Also from another part of the picture.
    let scan_line = Command::Focus(Focus::ScanLine(3));
    screen.session_mut().update(scan_line).expect("a line");
    screen.press(Modifiers::NONE, Key::O);
    line(&screen, 2).click();
    screen.harness.run();
    assert!(screen.session().follows_lesson());
    assert_eq!(at(&screen), Some(2));
}

#[test]
fn the_outline_is_used_by_keyboard() {
    let mut screen = triangle([Command::Questions]);
    while at(&screen) != Some(1) {
        screen.press(Modifiers::NONE, Key::N);
    }
    screen.press(Modifiers::NONE, Key::O);
    assert!(line(&screen, 1).is_focused());
    for _ in 0..2 {
        screen.press(Modifiers::NONE, Key::ArrowDown);
    }
    assert!(line(&screen, 3).is_focused());
    screen.press(Modifiers::NONE, Key::Enter);
    assert_eq!(at(&screen), Some(3));
    screen.press(Modifiers::NONE, Key::O);
    screen.press(Modifiers::NONE, Key::Escape);
    assert_eq!(screen.session().look.sheet, None);
}

/// A question stops also who goes through the outline, and until it is answered the outline does not say what follows.
#[test]
fn no_line_leads_past_a_question() {
    let mut screen = triangle([]);
    screen.press(Modifiers::NONE, Key::O);
    let last = screen.session().explanations();
    line(&screen, last).click();
    screen.harness.run();
    let asked = screen.session().step();
    assert!(screen.session().question_at(asked));
    let here = at(&screen).expect("an explanation");
    screen.press(Modifiers::NONE, Key::O);
    screen.keep("outline-question");
    let next = line(&screen, here + 1);
    assert!(next.accesskit_node().is_disabled());
    assert!(next.accesskit_node().label().unwrap().contains('…'));
    let before = line(&screen, here - 1);
    assert!(!before.accesskit_node().is_disabled());
    screen.press(Modifiers::NONE, Key::O);
    screen.press(Modifiers::NONE, Key::S);
    screen.press(Modifiers::NONE, Key::O);
    let label = line(&screen, here).accesskit_node().label().unwrap();
    assert!(label.contains(named(strings::SKIPPED)), "{label}");
    assert!(!line(&screen, here + 1).accesskit_node().is_disabled());
}

/// Goes on to the last explanation, and skips all questions.
fn to_the_last(screen: &mut Screen) {
    let session = screen.session_mut();
    while !session.is_last_explanation() {
        session.update(Command::Skip).ok();
        session.update(Command::NextNarrated).expect("a way on");
    }
    session.update(Command::Skip).ok();
    screen.harness.run();
}

#[test]
fn the_end_sums_up_and_leads_on() {
    let mut screen = triangle([]);
    to_the_last(&mut screen);
    assert!(shows(&screen, named(strings::FINISH)));
    screen.press(Modifiers::NONE, Key::N);
    assert_eq!(screen.session().look.sheet, Some(Sheet::Finished));
    screen.keep("finished");
    assert!(shows(&screen, named(strings::LEARNED)));
    let questions = screen.session().lesson().questions();
    assert!(shows(&screen, &format!("0 of {questions} questions right")));
    let outline = screen.session().outline();
    let missed = outline.iter().position(|entry| entry.standing.is_some());
    let missed = missed.expect("a question");
    line(&screen, missed + 1).click();
    screen.harness.run();
    assert_eq!(at(&screen), Some(missed + 1));
    assert_eq!(screen.session().look.sheet, None);
    to_the_last(&mut screen);
    screen.press(Modifiers::NONE, Key::N);
    let triangle = listed()
        .iter()
        .position(|listed| listed.id == "gouraud-triangle");
    let next = &listed()[triangle.expect("the lesson") + 1];
    screen.click(&format!("Next: {}", next.title[0]));
    assert_eq!(screen.session().lesson().id, next.id);
    assert_eq!(screen.session().look.sheet, None);
}

#[test]
fn outline_and_end_are_painted_in_every_theme() {
    for (name, size, theme, language) in [
        ("dark", [1280, 800], Theme::Dark, Language::Indonesian),
        ("projector", [900, 600], Theme::Projector, Language::English),
    ] {
        for sheet in [Sheet::Outline, Sheet::Finished] {
            let looks = [
                Command::Theme(theme),
                Command::Speak(language),
                Command::End,
                Command::Skip,
                Command::Sheet(sheet),
            ];
            let mut screen = screen("gouraud-triangle", size, 1.0, looks);
            screen.harness.run();
            screen.keep(&format!("{sheet:?}-{name}"));
        }
    }
}
