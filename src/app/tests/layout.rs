//! What must hold of the window's layout at every explanation of every lesson, seen on the display lists of its panels.

use super::*;
use crate::app::layout::{self, MARGIN, Narrow, SMALL, Wishes};
use crate::lesson::builtins;
use crate::panels::fixtures::{illegible, texts};
use crate::panels::{formula_height, time_line_heights, whole_formula_height};
use crate::picture::{Picture, Shape};
use glam::Vec2;

const USUAL: Least = Least {
    share: 0.45,
    width: 400.0,
};
/// With text twice as large on the smaller screens the column keeps its least width and scrolls, and panels at the side give way to their
/// names.
const LARGE: Least = Least {
    share: 0.37,
    width: 360.0,
};

/// Pixels of usual screens.
const SCREENS: [[f32; 2]; 3] = [[1280.0, 800.0], [1366.0, 768.0], [1920.0, 1080.0]];

/// The room inside a card below its title.
fn inside(card: egui::Rect) -> Vec2 {
    Vec2::new(
        card.width() - 2.0 * MARGIN,
        card.height() - MARGIN - layout::TITLE,
    )
    .floor()
}

/// Draws a panel, and writes down what cannot be read in it.
fn drawn(session: &Session, panel: Panel, size: Vec2, faults: &mut Vec<String>) -> Picture {
    let picture = draw(panel, &session.panel_input(), size);
    let found = illegible(&picture).into_iter();
    faults.extend(found.map(|fault| format!("{} at {size}: {fault}", panel.name())));
    picture
}

/// What the key panel has at least.
#[derive(Clone, Copy)]
struct Least {
    /// Of the window.
    share: f32,
    /// Of a picture, in pixels.
    width: f32,
}

/// Checks the window at the session's step on a screen of that many pixels.
fn check(session: &Session, screen: [f32; 2], at_least: Least, faults: &mut Vec<String>) {
    let zoom = session.look.zoom();
    let window = egui::Vec2::from(screen) / zoom;
    let key = session.key_panel().expect("a lesson has panels");
    let others = session.other_panels();
    let heights = time_line_heights(session.walk());
    let placed = layout::layout(
        window,
        Wishes {
            column: None,
            time_line: None,
            time_line_heights: [*heights.start(), *heights.end()],
            others: others.len(),
            drawer: None,
        },
    );
    let share = placed.key.area() / (window.x * window.y);
    if share < at_least.share {
        faults.push(format!("the key panel has {share} of the window"));
    }
    let picture = drawn(session, key, inside(placed.key), faults);
    if key == Panel::Image {
        let widths = picture.items.iter().filter_map(|item| match &item.shape {
            Shape::Image { rect, .. } => Some(rect.width * zoom),
            _ => None,
        });
        let widest = widths.fold(0.0, f32::max);
        if widest < at_least.width {
            faults.push(format!("a picture {widest} pixels wide"));
        }
    }
    for (&panel, card) in others.iter().zip(&placed.side) {
        let room = inside(*card);
        let least = Vec2::new(SMALL.x, SMALL.y);
        let smaller = (room / least).min_element().min(1.0);
        // Of the least text of a panel.
        if smaller * 11.0 < 9.99 {
            faults.push(format!("{} has text of {}", panel.name(), smaller * 11.0));
        }
        drawn(session, panel, room / smaller, faults);
    }

    let width = placed.column.width() - 2.0 * MARGIN;
    let least = formula_height(&session.panel_input(), width);
    for said in [0.0, 2000.0] {
        let formula = least + 2.0 * MARGIN + 1.0;
        let mut whole = placed.column;
        let height = layout::column_height(whole.height(), said, formula);
        whole.max.y = whole.min.y + height;
        let column = layout::column(whole, said, formula);
        let room = |region: egui::Rect| Vec2::new(width, region.height() - 2.0 * MARGIN).floor();
        let code = drawn(session, Panel::Code, room(column.code), faults);
        let current = code.items.iter().any(
            |item| matches!(item.shape, Shape::Rect { paint, .. } if paint == Ink::ThisTint.into()),
        );
        if !current {
            faults.push("no current line".into());
        }
        let formula = drawn(session, Panel::Formula, room(column.formula), faults);
        if room(column.formula).y < least.floor() || texts(&formula).is_empty() {
            faults.push(format!("the formula needs {least}"));
        }
    }
}

/// Goes to every explanation of these lessons, set up by `commands`. `check` is given its number, and writes down what cannot be read.
fn check_explanations(
    numbers: std::ops::Range<usize>,
    commands: &[Command],
    mut check: impl FnMut(&mut Session, usize, &mut Vec<String>),
) {
    let mut all = Vec::new();
    for builtin in &builtins()[numbers] {
        let lesson = builtin.read().expect("a right lesson");
        let mut session = Session::new(lesson).expect("a lesson that resolves");
        session.wait_for_picture();
        for command in commands {
            session
                .update(command.clone())
                .expect("a command that can act");
        }
        let narrated = session.panel_input().narrated.to_vec();
        for (number, step) in narrated.into_iter().enumerate() {
            session.update(Command::Seek(step)).expect("a step");
            let mut faults = Vec::new();
            check(&mut session, number, &mut faults);
            let place = format!("{} step {step}", builtin.id);
            all.extend(faults.into_iter().map(|fault| format!("{place}: {fault}")));
        }
    }
    assert!(all.is_empty(), "{} faults:\n{}", all.len(), all.join("\n"));
}

fn check_lessons(numbers: std::ops::Range<usize>) {
    check_explanations(numbers, &[Command::Questions], |session, _, faults| {
        for theme in [Theme::Light, Theme::Projector] {
            session.look.theme = theme;
            for language in Language::ALL {
                session.look.language = language;
                for screen in SCREENS {
                    let mut here = Vec::new();
                    check(session, screen, USUAL, &mut here);
                    let place = format!("{theme:?} {} {screen:?}", language.code());
                    faults.extend(here.into_iter().map(|fault| format!("{place}: {fault}")));
                }
            }
        }
    });
}

fn check_large_text(numbers: std::ops::Range<usize>) {
    let mut commands = vec![Command::LargerText; 5];
    commands.push(Command::Questions);
    check_explanations(numbers, &commands, |session, number, faults| {
        assert_eq!(session.look.zoom(), 2.0);
        session.look.language = Language::ALL[number % 2];
        for (screen, at_least) in SCREENS.into_iter().zip([LARGE, LARGE, USUAL]) {
            check(session, screen, at_least, faults);
        }
    });
}

/// On a phone a panel is drawn for a phone's room.
fn check_phones(numbers: std::ops::Range<usize>) {
    check_explanations(numbers, &[Command::Questions], |session, number, faults| {
        session.look.language = Language::ALL[number % 2];
        for phone in [[360.0, 640.0], [390.0, 844.0], [640.0, 360.0]] {
            let placed = Narrow::new(phone.into());
            let room =
                |card: egui::Rect| Vec2::new(card.width(), card.height()).floor() - 2.0 * MARGIN;
            for panel in session.panels() {
                drawn(session, panel, room(placed.key), faults);
            }
            let width = room(placed.column).x;
            let formula = whole_formula_height(&session.panel_input(), width).ceil();
            let formula = formula + 2.0 * MARGIN;
            let mut whole = placed.column;
            whole.max.y = whole.min.y + layout::stacked_height(0.0, formula);
            let column = layout::stacked(whole, formula);
            drawn(session, Panel::Formula, room(column.formula), faults);
            drawn(session, Panel::Code, room(column.code), faults);
        }
    });
}

#[test]
fn shading_lessons_can_be_read_with_text_twice_as_large() {
    check_large_text(0..10);
}

#[test]
fn lessons_on_rays_can_be_read_with_text_twice_as_large() {
    check_large_text(10..17);
}

#[test]
fn lessons_on_radiosity_and_studies_can_be_read_with_text_twice_as_large() {
    check_large_text(17..31);
}

#[test]
fn the_panels_of_shading_lessons_can_be_read_at_every_explanation() {
    check_lessons(0..10);
}

#[test]
fn the_panels_of_lessons_on_rays_can_be_read_at_every_explanation() {
    check_lessons(10..17);
}

#[test]
fn the_panels_of_lessons_on_radiosity_and_studies_can_be_read_at_every_explanation() {
    check_lessons(17..31);
}

#[test]
fn shading_lessons_can_be_read_on_a_phone() {
    check_phones(0..10);
}

#[test]
fn lessons_on_rays_can_be_read_on_a_phone() {
    check_phones(10..17);
}

#[test]
fn lessons_on_radiosity_and_studies_can_be_read_on_a_phone() {
    check_phones(17..31);
}
