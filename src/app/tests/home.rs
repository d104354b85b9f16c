//! The page of all lessons.

use super::*;
use crate::app::session::{Listed, listed};

fn home(size: [u32; 2], commands: impl IntoIterator<Item = Command>) -> Screen {
    let commands = commands.into_iter().chain([Command::Home]);
    screen("gouraud-triangle", size, 1.0, commands)
}

fn named(message: crate::language::Message) -> &'static str {
    message.text(Language::English)
}

fn card<'a>(screen: &'a Screen, id: &str) -> egui_kittest::Node<'a> {
    let language = screen.session().look.language as usize;
    screen.harness.get_by_label(&lesson(id).title[language])
}

fn lesson(id: &str) -> &'static Listed {
    let mut all = listed().iter();
    all.find(|listed| listed.id == id).expect("a lesson")
}

#[test]
fn every_lesson_stands_on_the_page_and_can_be_scrolled_to() {
    for size in [[1280, 800], [900, 600]] {
        let mut screen = home(size, []);
        for listed in listed() {
            assert!(listed.chapter.is_some(), "{}", listed.id);
            card(&screen, &listed.id).focus();
            // Scrolling takes its time.
            screen.harness.run_steps(6);
            let rect = card(&screen, &listed.id).rect();
            let page = screen.harness.ctx.content_rect();
            assert!(page.contains_rect(rect), "{}: {rect} in {page}", listed.id);
        }
    }
}

#[test]
fn a_card_opens_its_lesson() {
    let mut screen = home([1280, 800], []);
    assert!(screen.session().window_title().ends_with("Lessons"));
    card(&screen, "distance").click();
    screen.harness.run();
    assert_eq!(screen.session().lesson().id, "distance");
    assert!(!screen.session().look.home);
}

/// The keyboard begins at the lesson that was open.
#[test]
fn cards_are_chosen_by_arrows_and_opened_by_enter() {
    let mut screen = home([1280, 800], []);
    assert!(card(&screen, "gouraud-triangle").is_focused());
    for (key, id) in [
        (Key::ArrowRight, "gouraud-teapot"),
        (Key::ArrowDown, "side-by-side"),
        (Key::ArrowLeft, "fast-phong"),
        (Key::ArrowUp, "gouraud-triangle"),
    ] {
        screen.press(Modifiers::NONE, key);
        assert!(card(&screen, id).is_focused(), "{key:?}");
    }
    assert_eq!(
        screen.session().step(),
        0,
        "no arrow walks through the lesson"
    );
    screen.press(Modifiers::NONE, Key::ArrowRight);
    screen.press(Modifiers::NONE, Key::Enter);
    assert_eq!(screen.session().lesson().id, "gouraud-teapot");
    screen.press(Modifiers::NONE, Key::H);
    assert!(screen.session().look.home);
    screen.press(Modifiers::NONE, Key::Escape);
    assert!(!screen.session().look.home);
}

#[test]
fn a_search_goes_through_all_texts_of_the_language() {
    let says = |id: &str, words: &str, language| lesson(id).says(words, language);
    assert!(says(
        "refraction",
        "Total  INTERNAL reflection",
        Language::English
    ));
    assert!(!says("refraction", "pemantulan", Language::English));
    assert!(says(
        "refraction",
        "pemantulan internal",
        Language::Indonesian
    ));
    assert!(says("gouraud-teapot", "", Language::English));

    let mut screen = home([1280, 800], []);
    screen.press(Modifiers::NONE, Key::Slash);
    screen
        .harness
        .event(egui::Event::Text("GOBLET highlight".into()));
    screen.harness.run();
    let shown = |screen: &Screen, listed: &&Listed| {
        screen.harness.query_by_label(&listed.title[0]).is_some()
    };
    let found: Vec<&Listed> = listed()
        .iter()
        .filter(|listed| shown(&screen, listed))
        .collect();
    assert_eq!(found.len(), 1, "{found:?}");
    screen.keep("home-search");
    screen.press(Modifiers::NONE, Key::Enter);
    assert_eq!(screen.session().lesson().id, found[0].id);

    screen.press(Modifiers::NONE, Key::H);
    screen.press(Modifiers::NONE, Key::Slash);
    screen
        .harness
        .event(egui::Event::Text(" teapotless".into()));
    screen.harness.run();
    screen.harness.get_by_label(named(strings::NO_LESSON_FOUND));
}

#[test]
fn a_card_shows_how_far_one_has_come() {
    let mut session_commands = vec![Command::End, Command::Skip, Command::NextNarrated];
    session_commands.push(Command::Open("gouraud-teapot".into()));
    let screen = home([1280, 800], session_commands);
    screen.keep("home-progress");
    let card = card(&screen, "gouraud-triangle");
    let description = card.accesskit_node().description().expect("words");
    assert!(description.contains("of 14"), "{description}");
    assert!(description.contains("0 of "), "{description}");
}

#[test]
fn one_lesson_leads_to_the_next() {
    let mut screen = triangle([]);
    screen.click(named(strings::NEXT_LESSON));
    assert_eq!(screen.session().lesson().id, "gouraud-teapot");
    screen.press(Modifiers::COMMAND, Key::PageUp);
    assert_eq!(screen.session().lesson().id, "gouraud-triangle");
    let (first, last) = (&listed()[0], &listed()[listed().len() - 1]);
    for (end, command, why) in [
        (first, Command::PreviousLesson, strings::NO_PREVIOUS_LESSON),
        (last, Command::NextLesson, strings::NO_NEXT_LESSON),
    ] {
        let session = screen.session_mut();
        session
            .update(Command::Open(end.id.clone()))
            .expect("a lesson");
        assert_eq!(session.allows(&command), Err(why.into()));
        assert_eq!(session.update(command), Err(why.into()));
    }
}

#[test]
fn the_page_is_painted_in_every_theme_and_size() {
    for (name, size, theme, language) in [
        ("home", [1280, 800], Theme::Light, Language::English),
        ("home-dark", [900, 600], Theme::Dark, Language::Indonesian),
        (
            "home-projector",
            [1280, 800],
            Theme::Projector,
            Language::English,
        ),
    ] {
        let looks = [Command::Theme(theme), Command::Speak(language)];
        let mut screen = home(size, looks);
        screen.harness.run();
        screen.keep(name);
    }
}
