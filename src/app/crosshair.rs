//! The crosshair of a picture that has the focus: the arrows move it from one thing to the next, and Enter clicks what it is on.

use super::picture_place::Place;
use super::{arrow_focus, style};
use crate::picture::{Ink, Picture, Tag};
use egui::{Key, Response, Stroke, Ui};
use glam::Vec2;

/// How far the crosshair goes where there is nothing to go to, in points of the picture.
const STEP: f32 = 8.0;
/// How far the next thing may be.
const REACH: f32 = 120.0;
const ARM: f32 = 9.0;

/// Shows the crosshair and moves it as the arrows say; returns what it is on.
pub fn show(picture: &Picture, place: Place, response: &Response, ui: &Ui) -> Option<Tag> {
    arrow_focus::claim(ui.ctx());
    ui.memory_mut(|memory| {
        let arrows = egui::EventFilter {
            horizontal_arrows: true,
            vertical_arrows: true,
            ..Default::default()
        };
        memory.set_focus_lock_filter(response.id, arrows);
    });
    let id = response.id.with("crosshair");
    let size = Vec2::new(picture.width, picture.height);
    let kept: Option<Vec2> = ui.data(|data| data.get_temp(id));
    let mut at = kept.unwrap_or(0.5 * size).min(size);
    for (key, direction) in [
        (Key::ArrowLeft, Vec2::NEG_X),
        (Key::ArrowRight, Vec2::X),
        (Key::ArrowUp, Vec2::NEG_Y),
        (Key::ArrowDown, Vec2::Y),
    ] {
        // With Alt the arrows turn a scene.
        let presses = ui.input(|input| match input.modifiers.alt {
            true => 0,
            false => input.num_presses(key),
        });
        for _ in 0..presses {
            at = moved(picture, at, direction).clamp(Vec2::ZERO, size);
        }
    }
    ui.data_mut(|data| data.insert_temp(id, at));
    let center = place.on_screen(at);
    for (width, ink) in [(4.0, Ink::Surface), (2.0, Ink::Linked)] {
        let stroke = Stroke::new(width, style::color(place.theme, ink));
        let painter = ui.painter();
        painter.hline(center.x - ARM..=center.x + ARM, center.y, stroke);
        painter.vline(center.x, center.y - ARM..=center.y + ARM, stroke);
    }
    picture.hit(at)
}

/// The middle of the way through the next thing in that direction; a step on where there is none near.
fn moved(picture: &Picture, from: Vec2, direction: Vec2) -> Vec2 {
    let here = picture.hit(from);
    let along = |distance: usize| from + distance as f32 * direction;
    let other = |distance: &usize| {
        let there = picture.hit(along(*distance));
        there.is_some() && there != here
    };
    let Some(first) = (1..REACH as usize).find(other) else {
        return from + STEP * direction;
    };
    let next = picture.hit(along(first));
    let end =
        (first..first + REACH as usize).find(|&distance| picture.hit(along(distance)) != next);
    let end = end.unwrap_or(first + REACH as usize);
    along(first.midpoint(end - 1))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::picture::Rect;

    #[test]
    fn arrows_go_from_thing_to_thing_and_on_where_there_is_none() {
        let mut picture = Picture::new(200.0, 20.0);
        for x in [0, 1] {
            picture.tagged(Tag::Pixel { x, y: 0 }, |picture| {
                let left = 10.0 + 20.0 * x as f32;
                picture.rect(Rect::new(left, 0.0, 20.0, 20.0), Ink::Faint);
            });
        }
        let first = moved(&picture, Vec2::new(2.0, 10.0), Vec2::X);
        assert_eq!(picture.hit(first), Some(Tag::Pixel { x: 0, y: 0 }));
        let second = moved(&picture, first, Vec2::X);
        assert_eq!(picture.hit(second), Some(Tag::Pixel { x: 1, y: 0 }));
        assert!((second.x - 40.0).abs() <= 1.0, "{second}");
        let behind = moved(&picture, second, Vec2::X);
        assert_eq!(behind.x, second.x + STEP);
        let back = moved(&picture, second, Vec2::NEG_X);
        assert!((back.x - 20.0).abs() <= 1.0, "{back}");
    }
}
