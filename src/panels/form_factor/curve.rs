//! The value as it runs, against the reference.

use super::{EXACT, Layout};
use crate::figure::{Axis, Plot, Scale, legend};
use crate::picture::{Ink, Picture, Rect, Tag};
use glam::Vec2;

/// More values than these are thinned.
const MOST: usize = 400;
/// Up to so many values each has its dot.
const DOTTED: usize = 60;

pub fn draw(picture: &mut Picture, layout: &Layout, place: Rect) {
    let running = layout.running();
    let exact = layout.reference();
    let found = layout.state.found;
    let values = running.iter().map(|&(f, _)| f);
    let values = values.chain(exact).chain(found.map(|(f, _)| f));
    let last = running.len().max(1);
    let plot = Plot::new(
        Axis::new(Scale::whole(0.0, last as f64), "", layout.input.language),
        Axis::new(Scale::around(values), "F_i_j", layout.input.language),
        place,
    );
    plot.draw(picture);
    if let Some(exact) = exact {
        let stroke = Ink::Text.stroke(1.0).dashed();
        plot.level(picture, exact, stroke);
        let row = plot.beside_name();
        let name = EXACT.text(layout.input.language);
        legend(picture, [(stroke, name)], row, row.x);
    }
    let stride = running.len().div_ceil(MOST).max(1);
    let mut points: Vec<(Vec2, usize)> = Vec::new();
    for (at, &(f, step)) in running.iter().enumerate() {
        if f.is_finite() && (at % stride == 0 || at + 1 == running.len()) {
            points.push((plot.point((at + 1) as f64, f), step));
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
    let end = found.map(|(f, step)| (plot.point(last as f64, f), step));
    if let Some((at, step)) = end.or(points.last().copied()) {
        picture.tagged(Tag::Step(step), |picture| {
            picture.circle(at, 4.0, Ink::This);
        });
    }
}
