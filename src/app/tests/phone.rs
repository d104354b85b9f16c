//! The window of a phone.

use super::*;
use crate::app::layout::TARGET;
use crate::lesson::builtins;
use egui_kittest::Node;

/// Points of usual phones, upright and held across.
const PHONES: [[u32; 2]; 4] = [[360, 640], [390, 844], [640, 360], [844, 390]];

/// What can be pressed, by name, with its place.
fn pressed(screen: &Screen) -> Vec<(String, egui::Rect)> {
    let nodes = screen.harness.root().children_recursive();
    let nodes = nodes.into_iter().filter(|node: &Node| {
        let roles = [
            egui::Role::Button,
            egui::Role::CheckBox,
            egui::Role::RadioButton,
            egui::Role::TextInput,
            egui::Role::Link,
        ];
        roles.contains(&node.accesskit_node().role())
    });
    nodes
        .map(|node| {
            (
                node.accesskit_node().label().unwrap_or_default(),
                node.rect(),
            )
        })
        .collect()
}

/// What a finger cannot meet, or what reaches out of the window. `name` says what is shown.
fn faults(screen: &Screen, name: &str) -> Vec<String> {
    let window = screen.harness.ctx.content_rect();
    let place = format!("{name}-{}x{}", screen.size[0], screen.size[1]);
    screen.keep(&format!("phone-{place}"));
    let mut faults = Vec::new();
    for (name, rect) in pressed(screen) {
        let [width, height] = [rect.width(), rect.height()].map(|side| side + 0.01);
        if width < TARGET || height < TARGET {
            faults.push(format!("{place}: {name} is {} large", rect.size()));
        }
        let in_row = rect.left() >= 0.0 && rect.right() <= window.right();
        // The names of panels scroll sideways.
        let is_name = rect.top() < 2.5 * TARGET;
        if !in_row && !is_name {
            faults.push(format!(
                "{place}: {name} reaches to {} in {window}",
                rect.x_range().max
            ));
        }
    }
    faults
}

#[test]
fn what_can_be_pressed_is_as_large_as_a_finger_needs_it() {
    let mut found = Vec::new();
    for (number, builtin) in builtins().iter().enumerate() {
        let phone = PHONES[number % PHONES.len()];
        let language = Language::ALL[number / PHONES.len() % 2];
        for (name, commands) in [("begin", vec![]), ("question", vec![Command::End])] {
            let speak = [Command::Speak(language)];
            let screen = screen(builtin.id, phone, 1.0, speak.into_iter().chain(commands));
            found.extend(faults(&screen, &format!("{}-{name}", builtin.id)));
        }
    }
    assert!(
        found.is_empty(),
        "{} faults:\n{}",
        found.len(),
        found.join("\n")
    );
}

#[test]
fn sheets_and_pages_fit_a_phone() {
    let mut found = Vec::new();
    for (name, commands) in [
        ("home", vec![Command::Home]),
        ("outline", vec![Command::Sheet(Sheet::Outline)]),
        ("finished", vec![Command::Sheet(Sheet::Finished)]),
        ("forget", vec![Command::Sheet(Sheet::Forget)]),
        ("parameters", vec![Command::Parameters]),
        ("inspector", vec![Command::Inspector]),
        ("filled", vec![Command::Fill]),
        ("keys", vec![Command::Keys]),
        ("skipped", vec![Command::Skipped]),
        ("what-if", vec![Command::Questions, Command::WhatIf]),
        ("mistakes", vec![Command::Mistakes]),
    ] {
        for phone in PHONES {
            let screen = screen("gouraud-triangle", phone, 1.0, commands.clone());
            found.extend(faults(&screen, name));
        }
    }
    assert!(
        found.is_empty(),
        "{} faults:\n{}",
        found.len(),
        found.join("\n")
    );
}
