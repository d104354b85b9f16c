//! The view of error against run time.

use super::*;
use crate::app::session::{PointAt, StudyCommand};
use crate::render::Method;
use crate::study::form::Drawn;
use crate::study::tests::findings;
use egui::Role;
use std::sync::Arc;

/// The window with a study of two curves, of which the first point draws the lesson's stage.
fn study(commands: impl IntoIterator<Item = Command>) -> Screen {
    let mut screen = triangle(commands);
    let setup = Arc::new(screen.session().setup().clone());
    let found = findings();
    let studying = screen.session_mut().studying_mut();
    (studying.of, studying.parts) = (Some((found.study, true)), found.parts);
    studying.parts[0].lines[0].points[0].drawn = Some(Drawn {
        setup,
        method: Method::RayCasting,
    });
    studying.is_open = true;
    screen.harness.run();
    screen
}

#[test]
fn the_view_is_opened_from_the_menu_or_by_its_key_and_escape_closes_it() {
    let mut screen = triangle([]);
    screen.click(strings::MENU.text(Language::English));
    screen.click(strings::STUDIES.text(Language::English));
    assert!(screen.session().studying().is_open);
    screen
        .harness
        .get_by_label(strings::MEASURE.text(Language::English));
    screen.press(Modifiers::NONE, Key::ArrowRight);
    assert_eq!(
        screen.session().step(),
        0,
        "the run behind it stays where it is"
    );
    screen.press(Modifiers::NONE, Key::Escape);
    assert!(!screen.session().studying().is_open);
    screen.press(Modifiers::NONE, Key::E);
    assert!(screen.session().studying().is_open);
    screen.keep("study-empty");
}

#[test]
fn a_study_is_measured_from_its_button_and_no_frame_waits() {
    let mut screen = triangle([Command::Study(StudyCommand::View)]);
    screen.click(strings::MEASURE.text(Language::English));
    assert!(screen.session().studying().percent().is_some());
    screen
        .harness
        .get_by_label(strings::CALL_OFF.text(Language::English));
    screen.click(strings::CALL_OFF.text(Language::English));
    screen
        .harness
        .get_by_label(strings::CALLED_OFF.text(Language::English));
}

#[test]
fn a_point_that_is_pointed_at_is_named_and_a_click_opens_it() {
    let mut screen = study([]);
    let plot = screen
        .harness
        .get_by_role_and_label(Role::Image, strings::STUDY_PLOT.text(Language::English));
    let rect = plot.rect();
    // Somewhere in the plot is the only point that draws something.
    let mut found = None;
    'search: for row in 0..60 {
        for column in 0..60 {
            let share = egui::vec2(column as f32, row as f32) / 60.0;
            let at = rect.min + share * rect.size();
            screen.harness.hover_at(at);
            // What is said of a point follows the pointer a frame later.
            screen.harness.step();
            screen.harness.step();
            let here = screen
                .harness
                .query_all_by_label_contains(strings::CLICK_OPENS_IT.text(Language::English))
                .next();
            if here.is_some() {
                found = Some(at);
                break 'search;
            }
        }
    }
    let at = found.expect("the point is in the plot");
    screen.harness.run();
    screen.keep("study-hovered");
    screen.harness.drag_at(at);
    screen.harness.step();
    screen.harness.drop_at(at);
    screen.harness.run();
    assert_eq!(screen.session().lesson().method, Method::RayCasting);
    assert!(!screen.session().studying().is_open);
    screen.session_mut().wait_for_picture();
    screen.harness.run();
    screen.keep("study-opened");
}

#[test]
fn a_pinch_zooms_the_plot_and_back_until_all_of_it_is_shown() {
    let mut screen = study([]);
    let plot = screen
        .harness
        .get_by_role_and_label(Role::Image, strings::STUDY_PLOT.text(Language::English));
    let middle = plot.rect().center();
    screen.harness.hover_at(middle);
    screen.harness.run();
    let whole = screen.painted();
    screen.harness.event(egui::Event::Zoom(3.0));
    screen.harness.run();
    screen.keep("study-zoomed");
    assert_ne!(screen.painted(), whole);
    screen.harness.event(egui::Event::Zoom(0.2));
    screen.harness.run();
    assert_eq!(screen.painted(), whole);
}

#[test]
fn every_point_is_a_button_that_the_keyboard_reaches() {
    let mut screen = study([]);
    screen.harness.get_by_label("fine, n = 8").focus();
    screen.harness.run();
    screen
        .harness
        .get_by_label_contains("lightwalk study made-up --quick --out found");
    screen.press(Modifiers::NONE, Key::Enter);
    let picked = PointAt {
        part: 0,
        line: 1,
        point: 2,
    };
    assert_eq!(screen.session().studying().picked, Some(picked));
    screen.harness.get_by_label("rough, n = 2").focus();
    screen.press(Modifiers::NONE, Key::Space);
    assert_eq!(screen.session().lesson().method, Method::RayCasting);
}

#[test]
fn the_view_is_painted_in_every_theme_and_language() {
    let mut kept = Vec::new();
    for (name, theme, language) in [
        ("study-light", Theme::Light, Language::English),
        ("study-dark", Theme::Dark, Language::Indonesian),
        ("study-projector", Theme::Projector, Language::Indonesian),
    ] {
        let screen = study([Command::Theme(theme), Command::Speak(language)]);
        screen.keep(name);
        let painted = screen.painted();
        assert!(!kept.contains(&painted), "{name}");
        kept.push(painted);
    }
}
