//! The page of classic mistakes.

use super::*;
use crate::methods::Mistake;

/// The page, with all its pictures.
fn page(language: Language, size: [u32; 2]) -> Screen {
    let commands = [Command::Speak(language), Command::Mistakes];
    let mut screen = screen("gouraud-triangle", size, 1.0, commands);
    let ctx = screen.harness.ctx.clone();
    screen.harness.state_mut().1.mistakes.wait(&ctx);
    screen.harness.run_steps(3);
    screen
}

#[test]
fn each_mistake_has_two_pictures_its_name_and_its_sentence() {
    for (language, size) in [
        (Language::English, [1280, 800]),
        (Language::Indonesian, [1920, 1080]),
    ] {
        let screen = page(language, size);
        let drawn = screen.harness.state().1.mistakes.drawn();
        assert_eq!(drawn, Mistake::ALL.len());
        for mistake in Mistake::ALL {
            let title = mistake.title(language);
            let card = screen.harness.get_by_label(&title);
            let said = card.accesskit_node().description();
            assert_eq!(said, Some(mistake.about(language)));
        }
        screen.keep(&format!("mistakes-{}", language.code()));
    }
}

#[test]
fn a_click_on_a_card_walks_the_scene_with_that_mistake_and_m_leads_back() {
    let mut screen = page(Language::English, [1280, 800]);
    screen.click(&Mistake::MirrorX.title(Language::English));
    let session = screen.session();
    assert!(!session.look.mistakes && session.lesson().is_free_walk());
    assert_eq!(session.what_if().on, Some(Mistake::MirrorX));
    screen.press(Modifiers::NONE, Key::M);
    assert!(screen.session().look.mistakes);
    screen.press(Modifiers::NONE, Key::Escape);
    assert!(screen.session().look.home && !screen.session().look.mistakes);
    screen.click(strings::MISTAKES.text(Language::English));
    assert!(screen.session().look.mistakes);
}
