//! The window for those who use no mouse, or cannot see it.

use super::*;
use egui::Rect;
use egui_kittest::Node;

/// Where the keyboard is, by name.
fn focused(screen: &Screen) -> Option<(String, Rect)> {
    let nodes = screen.harness.root().children_recursive();
    let node = nodes.into_iter().find(Node::is_focused)?;
    Some((
        node.accesskit_node().label().unwrap_or_default(),
        node.rect(),
    ))
}

/// All stops of the Tab key, from the first on.
fn stops(screen: &mut Screen) -> Vec<(String, Rect)> {
    let mut stops: Vec<(String, Rect)> = Vec::new();
    for _ in 0..120 {
        screen.press(Modifiers::NONE, Key::Tab);
        let Some(stop) = focused(screen) else {
            continue;
        };
        if stops.contains(&stop) {
            return stops;
        }
        stops.push(stop);
    }
    panic!("the keyboard does not come back: {stops:?}");
}

/// The card in which a stop stands, in the order of reading: the bar, the column, the key panel, the panels beside it, the time line.
fn card(screen: &Screen, stop: Rect) -> usize {
    let window = screen.harness.ctx.content_rect();
    let side = screen.panel(screen.session().key_panel().expect("panels"));
    // What scrolls may reach far below its card.
    let at = egui::pos2(stop.center().x, stop.top());
    match () {
        () if at.y < 40.0 => 0,
        () if at.y > side.bottom() + 8.0 => 4,
        () if at.x < side.left() - 4.0 => 1,
        () if at.x < side.right() + 4.0 => 2,
        () => {
            assert!(window.contains(at), "{stop} in {window}");
            3
        }
    }
}

/// From the first stop on, the keyboard goes from card to card, and in each from row to row, in rows from left to right.
#[test]
fn the_focus_goes_as_one_reads_and_every_stop_has_a_name() {
    for (size, commands) in [
        ([1280, 800], vec![]),
        ([1280, 800], vec![Command::End]),
        ([900, 600], vec![Command::Speak(Language::Indonesian)]),
    ] {
        let mut screen = screen("gouraud-triangle", size, 1.0, commands);
        let mut stops = stops(&mut screen);
        let unnamed: Vec<_> = stops.iter().filter(|(name, _)| name.is_empty()).collect();
        assert!(unnamed.is_empty(), "at {size:?}: {unnamed:?}");
        // A field that asks for the focus is the first stop.
        let first = stops
            .iter()
            .position(|&(_, place)| card(&screen, place) == 0);
        stops.rotate_left(first.expect("the bar has buttons"));
        for pair in stops.windows(2) {
            let [(before, from), (name, to)] = pair else {
                continue;
            };
            let cards = [card(&screen, *from), card(&screen, *to)];
            let below = to.top() >= from.center().y;
            let beside = to.left() >= from.left() && to.bottom() > from.top();
            let goes_on = cards[0] < cards[1] || cards[0] == cards[1] && (below || beside);
            assert!(goes_on, "at {size:?}: {name} {to} after {before} {from}");
        }
        for card_number in 0..5 {
            let any = stops
                .iter()
                .any(|&(_, place)| card(&screen, place) == card_number);
            let has_side = size[0] >= 1280 || card_number != 3;
            assert!(
                any || !has_side,
                "no stop in card {card_number} at {size:?}"
            );
        }
    }
}

#[test]
fn what_is_off_says_why_and_sliders_say_their_range_and_unit() {
    let screen = screen("distance", [1280, 800], 1.0, [Command::Parameters]);
    let described = |label: &str| {
        let node = screen.harness.get_by_label(label);
        node.accesskit_node().description().unwrap_or_default()
    };
    let first = strings::AT_THE_START_NAME.text(Language::English);
    assert_eq!(
        described(first),
        strings::AT_THE_START.text(Language::English)
    );
    let reset = strings::LESSONS_VALUES.text(Language::English);
    assert_eq!(
        described(reset),
        strings::NOTHING_CHANGED.text(Language::English)
    );
    let sliders = screen.harness.get_all_by_role(egui::Role::Slider);
    let mut lengths = 0;
    for slider in sliders {
        let words = slider.accesskit_node().description().unwrap_or_default();
        let in_lengths = words.ends_with(strings::LENGTHS.text(Language::English));
        assert!(words.contains(" to ") || in_lengths, "{words}");
        lengths += usize::from(in_lengths && words.contains(" to "));
    }
    assert!(lengths > 0, "a light's distance has a unit");
}

/// Around the column, which scrolls; also in the least window, and with text twice as large.
#[test]
fn no_control_covers_another_or_leaves_the_window() {
    let large = || vec![Command::LargerText; 5];
    for (lesson, size, commands) in [
        ("linear-system", [900, 600], vec![]),
        (
            "flat-shading",
            [900, 600],
            vec![Command::Questions, Command::End],
        ),
        ("gouraud-triangle", [1280, 800], large()),
        ("linear-system", [1280, 800], large()),
        ("ray-tree", [1366, 768], large()),
    ] {
        for language in Language::ALL {
            let commands = commands.iter().cloned().chain([Command::Speak(language)]);
            let screen = screen(lesson, size, 1.0, commands);
            screen.keep(&format!("controls-{lesson}-{}", size[0]));
            let window = screen.harness.ctx.content_rect();
            let nodes = screen.harness.root().children_recursive();
            let controls = nodes.filter(|node| {
                let role = node.accesskit_node().role();
                matches!(role, egui::Role::Button | egui::Role::TextInput)
            });
            let controls: Vec<(String, Rect)> = controls
                .map(|node| {
                    (
                        node.accesskit_node().label().unwrap_or_default(),
                        node.rect(),
                    )
                })
                .filter(|&(_, place)| card(&screen, place) != 1)
                .collect();
            assert!(controls.len() > 12);
            for (i, (name, place)) in controls.iter().enumerate() {
                let what = format!("{lesson} at {size:?}: {name} {place}");
                assert!(window.expand(0.5).contains_rect(*place), "{what}");
                for (other, there) in &controls[..i] {
                    let common = place.intersect(*there);
                    let covers = common.width() > 1.0 && common.height() > 1.0;
                    assert!(!covers, "{what} on {other} {there}");
                }
            }
        }
    }
}
