//! The image enlarged, other layers of its pixels, and the values of a step in the inspector.

use super::{Screen, screen, strings, triangle};
use crate::app::session::Command;
use crate::language::Language;
use crate::panels::{ImageView, Panel, PixelLayer};
use crate::picture::Tag;
use egui::{Key, Modifiers};
use egui_kittest::kittest::Queryable;

fn english(message: crate::language::Message) -> &'static str {
    message.text(Language::English)
}

fn zoom(screen: &Screen) -> f32 {
    screen.session().image().shown.zoom
}

#[test]
fn the_picture_is_enlarged_by_buttons_pinch_and_keys_and_dragged() {
    let mut screen = triangle([Command::Questions, Command::End]);
    screen.click(english(strings::LARGER_PICTURE));
    assert_eq!(zoom(&screen), 2.0);
    let rect = screen.panel(Panel::Image);
    screen.harness.hover_at(rect.center());
    screen.harness.event(egui::Event::Zoom(2.0));
    screen.harness.run();
    assert!((zoom(&screen) - 4.0).abs() < 1e-3, "{}", zoom(&screen));
    let before = screen.session().image().shown.center;
    screen.harness.drag_at(rect.center());
    screen.harness.step();
    screen
        .harness
        .hover_at(rect.center() + egui::vec2(60.0, 20.0));
    screen.harness.step();
    screen
        .harness
        .drop_at(rect.center() + egui::vec2(60.0, 20.0));
    screen.harness.run();
    assert_ne!(screen.session().image().shown.center, before);
    screen.keep("image-enlarged");
    screen.click(english(strings::WHOLE_PICTURE));
    assert_eq!(screen.session().image(), ImageView::WHOLE);
}

#[test]
fn a_layer_is_found_when_it_is_asked_for() {
    let mut screen = screen("ray-tree", [1280, 800], 1.0, [Command::Questions]);
    let layer = PixelLayer::Rays;
    let view = ImageView {
        layer,
        ..ImageView::WHOLE
    };
    let session = screen.session_mut();
    assert!(session.panel_input().finished.layers.is_none());
    session.update(Command::ViewImage(view)).expect("a view");
    while screen.session().panel_input().finished.layers.is_none() {
        screen.harness.step();
        std::thread::sleep(std::time::Duration::from_millis(5));
    }
    screen.harness.run();
    screen.keep("image-rays");
    let at = screen.place_of(Panel::Image, Tag::Pixel { x: 284, y: 149 });
    screen.harness.hover_at(at.center());
    screen.harness.run();
    let said = english(layer.title());
    let mut found = screen.harness.query_all_by_label_contains(said);
    assert!(found.any(|node| node.value().is_none()), "{said}");
}

#[test]
fn the_inspector_is_searched_and_a_value_leads_to_the_step_that_recorded_it() {
    let mut screen = triangle([Command::Questions]);
    let walk = screen.session().walk();
    let step = (0..walk.len()).find(|&step| walk.kind(step) == "SpanInterpolated");
    let step = step.expect("a span");
    let session = screen.session_mut();
    session.update(Command::Seek(step)).expect("a step");
    session.update(Command::Inspector).expect("a drawer");
    screen.harness.run();
    screen.keep("inspector-drawer");
    let recorded = screen.session().walk().recorded(step);
    let outer = recorded.iter().find(|value| value.step != step);
    let outer = outer.expect("a value of a scope around");
    let field = screen
        .harness
        .get_by_role_and_label(egui::Role::TextInput, english(strings::SEARCH_VALUES));
    field.click();
    screen.harness.run();
    screen
        .harness
        .event(egui::Event::Text(outer.field.name.to_owned()));
    screen.harness.run();
    assert_eq!(screen.session().inspector().search, outer.field.name);
    screen.press(Modifiers::NONE, Key::Escape);
    let at = screen.place_of(Panel::Inspector, Tag::Field(outer.field.name));
    screen.harness.hover_at(at.center());
    screen.harness.drag_at(at.center());
    screen.harness.drop_at(at.center());
    screen.harness.run();
    assert_eq!(screen.session().step(), outer.step);
}

#[test]
fn the_wheel_scrolls_the_values_as_far_as_the_last() {
    let mut screen = screen(
        "ray-tree",
        [1280, 480],
        1.0,
        [Command::Questions, Command::Inspector],
    );
    let last = screen.session().last_step();
    let session = screen.session_mut();
    session.update(Command::Seek(last / 2)).expect("a step");
    screen.harness.run();
    let rect = screen.panel(Panel::Inspector);
    screen.harness.hover_at(rect.center());
    let scroll = |screen: &mut Screen, by: f32| {
        screen.harness.event(egui::Event::MouseWheel {
            unit: egui::MouseWheelUnit::Point,
            delta: egui::vec2(0.0, by),
            phase: egui::TouchPhase::Move,
            source: egui::MouseWheelSource::Wheel,
            modifiers: Modifiers::NONE,
        });
        for _ in 0..40 {
            screen.harness.step();
        }
        screen.session().inspector().first
    };
    assert_eq!(scroll(&mut screen, 200.0), 0);
    let down = scroll(&mut screen, -100.0);
    assert!(down > 0);
    let end = scroll(&mut screen, -1e5);
    assert!(end >= down && end < 200, "{end}");
    assert_eq!(scroll(&mut screen, -500.0), end);
    screen.keep("inspector-scrolled");
}
