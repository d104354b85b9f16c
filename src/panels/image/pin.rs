//! The pixel whose ray tree is pinned: a pin that sticks in it, with its name.

use super::placing::Placing;
use crate::algorithms::focus::Focus;
use crate::language::{Language, Message};
use crate::panels::message::labelled;
use crate::panels::strings::focus;
use crate::picture::{Ink, Picture, Rect, Style, ascent};
use crate::replay::rays::State;
use glam::{UVec2, Vec2};

/// From the pixel to the head of the pin, in points.
const NEEDLE: Vec2 = Vec2::new(11.0, -17.0);
const HEAD: f32 = 5.0;
const TEXT: f32 = 11.0;
/// Around the name.
const PAD: f32 = 3.0;

/// The pinned pixel, where it is one of a picture of that size.
pub(super) fn pixel(pinned: Option<&State>, pixels: UVec2) -> Option<(u32, u32)> {
    let pixel = pinned?.pixel?;
    (pixel.0 < pixels.x && pixel.1 < pixels.y).then_some(pixel)
}

/// `pinned: pixel (3, 4)`.
pub(super) fn in_words((x, y): (u32, u32), language: Language) -> String {
    let pixel = focus(Focus::Pixel { x, y }, language);
    labelled(Message("ray-tree-pinned").text(language), &pixel, language)
}

/// The needle ends in the middle of the pixel; it leans away from the nearer sides of the frame.
pub(super) fn draw(
    picture: &mut Picture,
    (x, y): (u32, u32),
    placing: &Placing,
    language: Language,
) {
    let at = placing.fit.pixels(x, x + 1, y).center();
    let frame = placing.frame;
    if !frame.contains(at) {
        return;
    }
    let name = in_words((x, y), language);
    let set = Style::LabelBold.size(TEXT).ink(Ink::Text);
    let plate = Vec2::new(set.width(&name) + 2.0 * PAD, TEXT + 2.0 * PAD);
    let is_left = at.x + NEEDLE.x + HEAD + plate.x > frame.right();
    let is_below = at.y + NEEDLE.y - HEAD < frame.y;
    let lean = Vec2::new(
        if is_left { -NEEDLE.x } else { NEEDLE.x },
        if is_below { -NEEDLE.y } else { NEEDLE.y },
    );
    let head = at + lean;
    let beside = HEAD + 2.0;
    let left = if is_left {
        head.x - beside - plate.x
    } else {
        head.x + beside
    };
    let plate = Rect::new(left, head.y - 0.5 * plate.y, plate.x, plate.y);
    picture.line(at, head, Ink::Surface.stroke(4.0));
    picture.line(at, head, Ink::Linked.stroke(2.0));
    let paint = Ink::Linked.fill().outlined(Ink::Surface.stroke(1.5));
    picture.circle(head, HEAD, paint);
    picture.rect(plate, Ink::Surface.fill().opacity(0.85));
    let baseline = plate.center().y + 0.5 * ascent(Style::LabelBold, TEXT) - 1.0;
    picture.text((plate.x + PAD, baseline), name, set);
}
