//! What a lesson opens and ends with.

use super::*;
use crate::lesson::builtins;
use crate::picture::{Shape, rasterize};
use glam::Vec2;
use std::collections::HashMap;

const SIZE: Vec2 = Vec2::new(740.0, 560.0);
/// A colour of fewer pixels is not noticed.
const LEAST_PIXELS: u32 = 1500;

/// The colours that are seen in a panel, as bytes.
fn colors(session: &Session, panel: Panel) -> Vec<[u8; 3]> {
    let picture = draw(panel, &session.panel_input(), SIZE);
    let pixels = rasterize(&picture, Theme::Light, 1.0).expect("pixels");
    let mut counts: HashMap<[u8; 3], u32> = HashMap::new();
    for pixel in pixels.pixels() {
        let color = [pixel.red(), pixel.green(), pixel.blue()];
        *counts.entry(color.map(|byte| byte & 0xf8)).or_default() += 1;
    }
    let seen = counts
        .into_iter()
        .filter(|&(_, count)| count >= LEAST_PIXELS);
    seen.map(|(color, _)| color).collect()
}

/// The first explanation stands where the lesson opens, and both it and the last one show a picture, not an empty frame.
#[test]
fn every_lesson_opens_and_ends_with_a_picture() {
    let mut faults = Vec::new();
    for builtin in builtins() {
        let lesson = builtin.read().expect("a right lesson");
        let mut session = Session::new(lesson).expect("a lesson that resolves");
        session.wait_for_picture();
        session.update(Command::Questions).expect("no questions");
        if session.explanation() != Some(0) {
            faults.push(format!("{} opens without an explanation", builtin.id));
        }
        let last = *session.panel_input().narrated.last().expect("explanations");
        for step in [session.step(), last] {
            session.update(Command::Seek(step)).expect("a step");
            let panel = session.key_panel().expect("panels");
            let least = match panel {
                Panel::Image | Panel::Comparison => 4,
                // A room in which only the lamp shines, on its ground.
                Panel::Radiosity => 3,
                _ => usize::MAX,
            };
            let colors = colors(&session, panel).len();
            if colors < least {
                let name = panel.name();
                faults.push(format!(
                    "{} step {step}: {name} with {colors} colours",
                    builtin.id
                ));
            }
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn the_picture_of_a_room_is_as_bright_as_its_patches_are_shown() {
    let lesson = builtin("cornell-box").expect("a lesson").read();
    let mut session = Session::new(lesson.expect("a right lesson")).expect("it resolves");
    session.wait_for_picture();
    session.update(Command::Questions).expect("no questions");
    session.update(Command::End).expect("the last step");
    let input = session.panel_input();
    let room = draw(Panel::Radiosity, &input, SIZE);
    let patches = room.items.iter().filter_map(|item| match item.shape {
        Shape::Polygon { paint, .. } => match paint.fill?.ink {
            Ink::Rgb(color) => Some(color.to_srgb8().map(|byte| byte & 0xf8)),
            _ => None,
        },
        _ => None,
    });
    let patches: Vec<[u8; 3]> = patches.collect();
    let seen = colors(&session, Panel::Image);
    let shared = seen.iter().filter(|color| patches.contains(color)).count();
    assert!(shared >= 4, "{seen:?} and {patches:?}");
}
