//! The presentation, the list of a search, and pictures without a mouse.

use super::*;
use crate::app::presentation::Places;
use crate::app::session::Drawer;
use crate::lesson::builtins;
use crate::panels::fixtures::illegible;
use crate::picture::Shape;

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
        .text(Language::English)
        .split_inclusive(['.', '?'])
        .next();
    let node = screen.harness.get_by_label(first.expect("a sentence"));
    assert!(node.rect().height() >= height / 28.0);
    let places = Places::new(screen.harness.ctx.content_rect(), None);
    assert_eq!(places.zoom(), height / 28.0 / 11.0);
    for (panel, place) in [(Panel::Image, places.key), (Panel::Formula, places.formula)] {
        let shown = screen.panel(panel);
        // The harness leaves up to 10 pixels free on each side.
        assert!(
            (shown.size() - place.size()).length() < 30.0,
            "{}",
            panel.name()
        );
    }
}

#[test]
fn presented_questions_and_their_answers_fit_on_the_screen() {
    let mut faults = Vec::new();
    for builtin in builtins() {
        let mut screen = screen(builtin.id, [1280, 720], 1.0, [Command::Present]);
        let explained = screen.session().explained().iter();
        let asked = explained.filter(|said| said.question.is_some());
        let steps: Vec<usize> = asked.map(|said| said.step).collect();
        for step in steps {
            for command in [Command::Seek(step), Command::Skip] {
                screen.session_mut().update(command).expect("a question");
                for language in Language::ALL {
                    screen.session_mut().look.language = language;
                    screen.harness.run();
                    let (_, standing) = screen.session().question().expect("a question");
                    let whole = screen.harness.ctx.content_rect();
                    let card = Places::new(whole, Some(standing)).said;
                    let labels = screen
                        .harness
                        .query_all_by_role(egui::accesskit::Role::Label);
                    let bottom = labels.map(|label| label.rect().bottom()).reduce(f32::max);
                    let missing = bottom.expect("a question") - card.bottom();
                    if missing > 0.0 {
                        let code = language.code();
                        faults.push(format!(
                            "{} step {step} {code} {standing:?}: {missing} too high",
                            builtin.id
                        ));
                    }
                }
            }
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn a_search_or_a_drawer_ends_the_presentation_and_a_filled_window() {
    for covers in [Command::Present, Command::Fill] {
        let mut screen = triangle([covers.clone()]);
        screen.press(Modifiers::NONE, Key::Slash);
        // The field stands in the bar, which is shown again by now.
        screen.harness.run();
        screen
            .harness
            .event(egui::Event::Text("UNIT NORMAL".into()));
        screen.press(Modifiers::NONE, Key::Enter);
        assert_eq!(screen.session().look.drawer, Some(Drawer::Results));
        assert!(!screen.session().look.presenting && !screen.session().is_filled());
        screen.session_mut().update(covers).unwrap();
        // The drawer that was covered is shown, not closed.
        screen.session_mut().update(Command::Results).unwrap();
        assert_eq!(screen.session().look.drawer, Some(Drawer::Results));
        assert!(!screen.session().look.presenting && !screen.session().is_filled());
    }
}

/// At every explanation: all text as large as that of the sentence, and pictures beside each other 200 pixels wide.
fn check_presentation(lessons: std::ops::Range<usize>) {
    let mut faults = Vec::new();
    for builtin in &builtins()[lessons] {
        let mut session = Session::new(builtin.read().expect("a right lesson")).expect("a lesson");
        session.wait_for_picture();
        session.update(Command::Questions).expect("no questions");
        for (number, step) in session
            .panel_input()
            .narrated
            .to_vec()
            .into_iter()
            .enumerate()
        {
            session.update(Command::Seek(step)).expect("a step");
            session.look.language = Language::ALL[number % 2];
            for screen in [[1280.0, 800.0], [1920.0, 1080.0]] {
                let whole = egui::Rect::from_min_size(egui::Pos2::ZERO, screen.into());
                let places = Places::new(whole, None);
                let key = session.key_panel().expect("a panel");
                for (panel, place) in [(key, places.key), (Panel::Formula, places.formula)] {
                    let size = glam::Vec2::new(place.width(), place.height()) / places.zoom();
                    let picture = draw(panel, &session.panel_input(), size);
                    let mut found = illegible(&picture);
                    let images = picture.items.iter().filter_map(|item| match &item.shape {
                        Shape::Image { rect, .. } => Some(rect.width * places.zoom()),
                        _ => None,
                    });
                    let small = images.filter(|&width| panel == Panel::Comparison && width < 200.0);
                    found.extend(small.map(|width| format!("a picture {width} wide")));
                    let place =
                        format!("{} step {step} {} at {screen:?}", builtin.id, panel.name());
                    faults.extend(found.into_iter().map(|fault| format!("{place}: {fault}")));
                }
            }
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn presented_shading_lessons_can_be_read_from_the_back_row() {
    check_presentation(0..10);
}

#[test]
fn presented_lessons_on_rays_can_be_read_from_the_back_row() {
    check_presentation(10..17);
}

#[test]
fn presented_lessons_on_radiosity_and_studies_can_be_read_from_the_back_row() {
    check_presentation(17..31);
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
