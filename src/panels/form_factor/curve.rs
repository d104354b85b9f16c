//! The value as it runs, against the reference; of samples with the band of its standard error, which narrows as the value settles.

use super::{EXACT, Layout};
use crate::figure::{Axis, LEGEND_SAMPLE, Plot, Scale, legend};
use crate::picture::{Ink, Picture, Rect, Style, Tag};
use crate::replay::form_factor::Batch;
use glam::Vec2;

/// More values than these are thinned.
const MOST: usize = 400;
/// Up to so many values each has its dot.
const DOTTED: usize = 60;
/// Of samples, as many values are drawn from one power of ten to the next.
const A_DECADE: f64 = 60.0;
/// Opacity of the band.
const BAND: f32 = 0.22;
/// Size of a name in the legend, and what is left free behind it.
const TEXT: f32 = 11.0;
const GAP: f32 = 8.0;

pub fn draw(picture: &mut Picture, layout: &Layout, place: Rect) {
    let (running, symbol) = layout.settling();
    let batches: Vec<Batch> = layout.state.batches.iter().copied().collect();
    let is_sampled = layout.state.is_sampled();
    let of_f = symbol == "F_i_j";
    let exact = layout.reference().filter(|_| of_f);
    let end = match of_f {
        true => layout.state.found,
        false => layout.state.visible,
    };
    let ends = batches.iter().flat_map(band);
    let values = running.iter().map(|&(value, _)| value);
    let values = values.chain(exact).chain(end.map(|(value, _)| value));
    let last = running.len().max(1) as f64;
    // One more sample says less the more there are.
    let across = match is_sampled {
        true => Scale::decades([1.0, last]),
        false => Scale::whole(0.0, last),
    };
    let plot = Plot::new(
        Axis::new(
            across,
            if is_sampled { "n" } else { "" },
            layout.input.language,
        ),
        Axis::new(
            Scale::around(values.chain(ends)),
            symbol,
            layout.input.language,
        ),
        place,
    );
    plot.draw(picture);
    draw_band(picture, &plot, &batches);
    let mut entries = Vec::new();
    if let Some(exact) = exact {
        let stroke = Ink::Text.stroke(1.0).dashed();
        plot.level(picture, exact, stroke);
        entries.push((stroke, EXACT.text(layout.input.language)));
    }
    if !batches.is_empty() {
        let stroke = Ink::Linked.stroke(7.0).opacity(BAND);
        entries.push((stroke, "± s"));
    }
    let row = plot.beside_name();
    let width = |name: &str| LEGEND_SAMPLE + Style::Body.size(TEXT).width(name) + GAP;
    let mut free = row.width;
    entries.retain(|(_, name)| {
        let fits = width(name) <= free;
        free -= if fits { width(name) } else { 0.0 };
        fits
    });
    legend(picture, entries, row, row.x);
    let mut points: Vec<(Vec2, usize)> = Vec::new();
    for (at, &(value, step)) in running.iter().enumerate() {
        if value.is_finite() && (is_kept(at, running.len(), is_sampled) || at + 1 == running.len())
        {
            points.push((plot.point((at + 1) as f64, value), step));
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
    let end = end.map(|(value, step)| (plot.point(last, value), step));
    if let Some((at, step)) = end.or(points.last().copied()) {
        picture.tagged(Tag::Step(step), |picture| {
            picture.circle(at, 4.0, Ink::This);
        });
    }
}

/// One standard error below and above.
fn band(batch: &Batch) -> [f64; 2] {
    [batch.value - batch.error, batch.value + batch.error]
}

/// From the end of each batch to that of the next, as the steps that close them say.
fn draw_band(picture: &mut Picture, plot: &Plot, batches: &[Batch]) {
    let at = |batch: &Batch, side: usize| plot.point(batch.samples.into(), band(batch)[side]);
    if batches.len() > 1 {
        let below = batches.iter().map(|batch| at(batch, 0));
        let above = batches.iter().rev().map(|batch| at(batch, 1));
        let outline: Vec<Vec2> = below.chain(above).collect();
        picture.polygon(outline, Ink::Linked.fill().opacity(BAND));
    }
    for batch in batches {
        picture.tagged(Tag::Step(batch.step), |picture| {
            picture.line(at(batch, 0), at(batch, 1), Ink::Linked.stroke(2.0));
        });
    }
}

/// Whether a value is drawn: of many, those as far apart as the axis shows them.
fn is_kept(at: usize, count: usize, is_sampled: bool) -> bool {
    if is_sampled {
        let place = |n: usize| (A_DECADE * (n as f64).log10()) as i64;
        return at == 0 || place(at + 1) != place(at);
    }
    at.is_multiple_of(count.div_ceil(MOST).max(1))
}
