//! The value as it runs, against the reference.

use super::{EXACT, Layout};
use crate::picture::{Ink, Picture, Rect, Style, Tag};
use glam::Vec2;

/// More values than these are thinned.
const MOST: usize = 400;
/// Up to so many values each has its dot.
const DOTTED: usize = 60;
const TEXT: f32 = 11.0;

pub fn draw(picture: &mut Picture, layout: &Layout, place: Rect) {
    let running = layout.running();
    let exact = layout.state.reference.map(|(f, _)| f);
    let found = layout.state.found;
    let all = running.iter().map(|&(f, _)| f);
    let all = all.chain(exact).chain(found.map(|(f, _)| f));
    let finite = all.filter(|f| f.is_finite());
    let (low, high) = finite.fold((0.0_f64, 0.0_f64), |(low, high), f| {
        (low.min(f), high.max(f))
    });
    let high = if high > low { high } else { low + 1.0 };

    let set = Style::Label.size(TEXT).ink(Ink::Muted);
    let frame = Rect::new(
        place.x + 1.0,
        place.y + 18.0,
        place.width - 2.0,
        place.height - 34.0,
    );
    let scale = 0.9 * f64::from(frame.height) / (high - low);
    let y = |f: f64| frame.bottom() - (scale * (f - low)) as f32;
    let last = running.len().max(1) as f32;
    let x = |count: usize| frame.x + (frame.width - 5.0) * count as f32 / last;

    picture.text_in(Rect::new(place.x, place.y, place.width, 16.0), "F_i_j", set);
    let axis = [
        frame.min(),
        Vec2::new(frame.x, y(0.0)),
        Vec2::new(frame.right(), y(0.0)),
    ];
    picture.polyline(axis, Ink::Rule.stroke(1.0));
    let below = Rect::new(place.x, frame.bottom() + 1.0, place.width, 15.0);
    picture.text_in(below, "0", set);
    if !running.is_empty() {
        picture.text_in(below, running.len().to_string(), set.end());
    }
    if let Some(exact) = exact {
        let at = y(exact);
        let stroke = Ink::Text.stroke(1.0).dashed();
        picture.line((frame.x, at), (frame.right(), at), stroke);
        let strings = EXACT.text(layout.input.language);
        let label = Rect::new(place.x + 40.0, place.y, place.width - 40.0, 16.0);
        // In the header, where no curve is.
        picture.line(
            (label.right() - set.width(strings) - 26.0, label.center().y),
            (label.right() - set.width(strings) - 5.0, label.center().y),
            stroke,
        );
        picture.text_in(label, strings, set.end());
    }
    let stride = running.len().div_ceil(MOST).max(1);
    let mut points: Vec<(Vec2, usize)> = Vec::new();
    for (at, &(f, step)) in running.iter().enumerate() {
        if f.is_finite() && (at % stride == 0 || at + 1 == running.len()) {
            points.push((Vec2::new(x(at + 1), y(f)), step));
        }
    }
    if points.len() > 1 {
        picture.polyline(points.iter().map(|(at, _)| *at), Ink::Linked.stroke(1.5));
    }
    if points.len() <= DOTTED {
        for &(at, step) in &points {
            picture.tagged(Tag::Step(step), |picture| {
                picture.circle(at, 2.0, Ink::Linked);
            });
        }
    }
    let end = found.map(|(f, step)| (Vec2::new(x(last as usize), y(f)), step));
    if let Some((at, step)) = end.or(points.last().copied()) {
        picture.tagged(Tag::Step(step), |picture| {
            picture.circle(at, 4.0, Ink::This);
        });
    }
}
