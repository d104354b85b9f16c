//! The presentation, the list of a search, and pictures without a mouse.

use super::*;
use crate::app::session::Drawer;

#[test]
fn in_a_presentation_the_room_is_asked_and_a_key_shows_the_answer() {
    let mut screen = triangle([Command::End, Command::Present]);
    let (question, standing) = screen.session().question().expect("a question waits");
    assert_eq!(standing, Standing::Open);
    let (asked, why) = (
        question.ask(Language::English).to_owned(),
        question.why(Language::English).to_owned(),
    );
    screen.harness.get_by_label(&asked);
    assert!(screen.harness.query_by_label(&why).is_none());
    screen.keep("presented-question");
    screen.press(Modifiers::NONE, Key::A);
    screen.harness.get_by_label(&asked);
    screen.press(Modifiers::NONE, Key::PageDown);
    assert!(screen.harness.query_by_label(&asked).is_none());
}

#[test]
fn all_that_is_presented_is_a_28th_of_the_screen_high() {
    let screen = triangle([Command::Present]);
    let height = screen.harness.ctx.content_rect().height();
    let said = screen.session().narration_here().expect("an explanation");
    let first = said
        .say(Language::English)
        .split_inclusive(['.', '?'])
        .next();
    let node = screen.harness.get_by_label(first.expect("a sentence"));
    assert!(node.rect().height() >= height / 28.0);
    for panel in [Panel::Image, Panel::Formula] {
        let rect = screen.panel(panel);
        let zoom = height / 28.0 / 11.0;
        let size = glam::Vec2::new(rect.width(), rect.height()) / zoom;
        let picture = draw(panel, &screen.session().panel_input(), size);
        crate::panels::fixtures::assert_legible(&picture, panel.name());
    }
}

#[test]
fn a_search_in_ones_own_words_lists_steps_and_stops_at_the_question() {
    let mut screen = triangle([]);
    screen.press(Modifiers::NONE, Key::Slash);
    screen
        .harness
        .event(egui::Event::Text("UNIT NORMAL".into()));
    screen.press(Modifiers::NONE, Key::Enter);
    assert_eq!(screen.session().look.drawer, Some(Drawer::Results));
    let results = screen.session().results().expect("results").clone();
    let question = results.question.expect("a question stops the search");
    assert!(results.rows.iter().all(|row| row.step <= question));
    assert!(!results.rows.is_empty());
    screen.keep("results");
    let row = results.rows.last().expect("a row");
    screen.click(&format!("{}  {}", row.step, row.title));
    assert_eq!(screen.session().step(), row.step);
}

#[test]
fn a_picture_with_the_focus_is_clicked_with_the_keyboard() {
    let mut screen = triangle([Command::Questions]);
    let label = Panel::Image.title().text(Language::English);
    let image = screen
        .harness
        .get_by_role_and_label(egui::accesskit::Role::Image, label);
    image.focus();
    screen.harness.run();
    for _ in 0..2 {
        screen.press(Modifiers::NONE, Key::ArrowRight);
    }
    let before = screen.session().focus();
    assert_eq!(screen.session().step(), 0, "the arrows move the crosshair");
    let under = screen.session().hovered();
    let Some(Tag::Pixel { x, y }) = under else {
        panic!("the crosshair is on {under:?}");
    };
    screen.press(Modifiers::NONE, Key::Enter);
    assert_ne!(screen.session().focus(), before);
    assert_eq!(screen.session().focus(), Focus::Pixel { x, y });
    screen.keep("crosshair");
}
