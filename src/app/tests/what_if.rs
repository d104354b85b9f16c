//! Classic mistakes beside the right picture, in their drawer.

use super::*;
use crate::methods::Mistake;

/// The drawer over a lesson that asks nothing.
fn drawer(language: Language) -> Screen {
    let mut screen = triangle([Command::Questions, Command::Speak(language)]);
    screen.press(Modifiers::NONE, Key::W);
    screen.session_mut().wait_for_mistakes();
    screen.harness.run_steps(3);
    screen
}

#[test]
fn the_list_says_how_much_each_changes_and_a_click_shows_it() {
    for language in Language::ALL {
        let mut screen = drawer(language);
        let session = screen.session();
        let (shown, idle): (Vec<Mistake>, Vec<Mistake>) = session
            .possible_mistakes()
            .partition(|&mistake| session.what_if().off(mistake) != Some(0));
        assert!(shown.contains(&Mistake::FlipY) && !idle.is_empty());
        for mistake in &shown {
            screen.harness.get_by_label(&mistake.title(language));
        }
        screen
            .harness
            .get_by_label(strings::WHAT_IF_UNCHANGED.text(language));
        screen.keep(&format!("what-if-{}", language.code()));

        screen.click(&Mistake::FlipY.title(language));
        screen.session_mut().wait_for_mistakes();
        screen.harness.run_steps(3);
        for title in [
            strings::WHAT_IF_WRONG,
            strings::WHAT_IF_RIGHT,
            strings::WHAT_IF_DIFFERENCE,
        ] {
            screen.picture(title.text(language));
        }
        screen.keep(&format!("what-if-one-{}", language.code()));
        screen.click(strings::WHAT_IF_NEXT.text(language));
        assert_eq!(screen.session().what_if().on, Some(Mistake::MirrorX));
        screen.click(strings::WHAT_IF_ALL.text(language));
        assert_eq!(screen.session().what_if().on, None);
    }
}

#[test]
fn a_click_on_a_differing_pixel_walks_it() {
    let mut screen = drawer(Language::English);
    let command = Command::Mistake(Some(Mistake::FlipY));
    screen.session_mut().update(command).unwrap();
    screen.session_mut().wait_for_mistakes();
    screen.harness.run_steps(3);
    let title = strings::WHAT_IF_WRONG.text(Language::English);
    let place = screen.picture(title);
    screen.click_at(place.center());
    assert!(matches!(screen.session().focus(), Focus::Pixel { .. }));
}

#[test]
fn nothing_of_the_picture_is_shown_while_a_question_waits() {
    let mut screen = drawer(Language::English);
    screen.session_mut().update(Command::Questions).unwrap();
    while !screen.session().panel_input().is_pending() {
        let next = screen.session_mut().update(Command::NextNarrated);
        next.expect("a question ahead");
    }
    screen.harness.run_steps(3);
    let title = Mistake::FlipY.title(Language::English);
    assert!(screen.harness.query_all_by_label(&title).next().is_none());
}

#[test]
fn the_explanation_of_what_can_go_wrong_leads_to_the_mistake() {
    let mut screen = triangle([Command::Questions]);
    let session = screen.session_mut();
    while session
        .narration_here()
        .and_then(|said| said.mistake)
        .is_none()
    {
        let next = session.update(Command::NextNarrated);
        next.expect("an explanation with a mistake");
    }
    screen.harness.run_steps(3);
    let language = screen.session().look.language;
    let mistake = Mistake::InclusiveScanRule;
    let words = mistake.in_words(language);
    screen.click(&strings::WHAT_IF_HERE.format(language, &[("mistake", &words)]));
    assert_eq!(screen.session().what_if().on, Some(mistake));
}
