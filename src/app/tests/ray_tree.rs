//! The ray tree in the window: zoomed, dragged, collapsed, and followed.

use super::{Screen, screen, strings};
use crate::algorithms::focus::Focus;
use crate::app::session::Command;
use crate::language::Language;
use crate::panels::{Panel, TreeView, draw};
use crate::picture::Tag;
use egui::{Key, Modifiers};

/// The lesson of the ray tree at its end, without questions in the way.
fn tree_screen() -> Screen {
    screen(
        "ray-tree",
        [1280, 800],
        1.0,
        [
            Command::Questions,
            Command::End,
            Command::Key(Panel::RayTree),
        ],
    )
}

/// A click on what shows `tag` in the panel.
fn click(screen: &mut Screen, tag: Tag) {
    let at = screen.place_of(Panel::RayTree, tag).center();
    screen.harness.hover_at(at);
    screen.harness.drag_at(at);
    screen.harness.drop_at(at);
    screen.harness.run();
}

fn tree(screen: &Screen) -> TreeView {
    screen.session().tree().clone()
}

#[test]
fn buttons_zoom_and_fit() {
    let mut screen = tree_screen();
    screen.keep("ray-tree");
    screen.click(strings::LARGER_TREE.text(Language::English));
    assert!((tree(&screen).zoom - 1.5).abs() < 1e-6);
    screen.click(strings::LARGER_TREE.text(Language::English));
    screen.click(strings::SMALLER_TREE.text(Language::English));
    assert!((tree(&screen).zoom - 1.5).abs() < 1e-6);
    screen.click(strings::WHOLE_TREE.text(Language::English));
    assert_eq!(tree(&screen), TreeView::WHOLE);
    // What cannot act is refused.
    let whole = Command::ViewTree(TreeView::WHOLE);
    assert!(screen.session().allows(&whole).is_err());
}

#[test]
fn a_pinch_zooms_about_the_pointer_and_a_drag_drags() {
    let mut screen = tree_screen();
    let rect = screen.panel(Panel::RayTree);
    screen
        .harness
        .hover_at(rect.center() + egui::vec2(40.0, -60.0));
    screen.harness.event(egui::Event::Zoom(3.0));
    screen.harness.run();
    let zoomed = tree(&screen);
    assert!((zoomed.zoom - 3.0).abs() < 1e-3, "{}", zoomed.zoom);
    let before = zoomed.held.expect("the node under the pointer");
    let from = rect.center() + egui::vec2(40.0, -60.0);
    screen.harness.drag_at(from);
    screen.harness.step();
    screen.harness.hover_at(from - egui::vec2(60.0, 20.0));
    screen.harness.step();
    screen.harness.drop_at(from - egui::vec2(60.0, 20.0));
    screen.harness.run();
    let after = tree(&screen).held.expect("the node that was dragged");
    assert!(
        after.ray != before.ray || after.at.x < before.at.x,
        "{before:?} {after:?}"
    );
    screen.keep("ray-tree-zoomed");
}

#[test]
fn a_click_on_the_sign_collapses_and_one_on_a_node_selects_it() {
    let mut screen = tree_screen();
    let walk = screen.session().walk();
    let rays: Vec<usize> = (0..walk.len())
        .filter(|&step| walk.kind(step) == "Ray")
        .collect();
    click(&mut screen, Tag::Fold(rays[0]));
    assert!(tree(&screen).collapsed.contains(&rays[0]));
    click(&mut screen, Tag::Fold(rays[0]));
    assert!(tree(&screen).collapsed.is_empty());
    let before = screen.session().step();
    click(&mut screen, Tag::Scope(rays[1]));
    assert_eq!(screen.session().step(), before, "one click selects");
    assert_eq!(screen.session().selected_step(), Some(rays[1]));
    screen.keep("selected-node");
    let way = strings::SHOW_THE_STEP.format(Language::English, &[("step", &rays[1].to_string())]);
    screen.click(&way);
    assert!(rays[1] < before && screen.session().step() == rays[1]);
}

#[test]
fn a_pinned_tree_stands_beside_that_of_another_pixel_until_it_is_taken_away() {
    let mut screen = tree_screen();
    screen.click(strings::PIN_TREE.text(Language::English));
    let pinned = screen.session().pinned().expect("it is pinned");
    assert_eq!(pinned.pixel, Some((284, 149)));
    let focus = Focus::Pixel { x: 140, y: 170 };
    screen.session_mut().update(Command::Focus(focus)).unwrap();
    screen
        .session_mut()
        .update(Command::Key(Panel::RayTree))
        .unwrap();
    screen.harness.run();
    let alt = |screen: &Screen| {
        let input = screen.session().panel_input();
        draw(Panel::RayTree, &input, glam::Vec2::new(700.0, 560.0)).alt
    };
    let said = alt(&screen);
    for part in [
        "pinned: pixel (284, 149)",
        "here: pixel (140, 170)",
        "First difference",
    ] {
        assert!(said.contains(part), "{part} in {said}");
    }
    screen.keep("ray-tree-pinned");
    screen.press(Modifiers::SHIFT, Key::P);
    assert!(screen.session().pinned().is_none());
    assert!(!alt(&screen).contains("pinned"));
    // Before there is a ray, there is no tree to pin.
    screen.session_mut().update(Command::Start).unwrap();
    let refused = screen.session().allows(&Command::Pin);
    assert_eq!(refused, Err(strings::NOTHING_TO_PIN.into()));
}
