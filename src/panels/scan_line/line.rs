//! An edge of the wireframe, and the pixels that stand for it.

use crate::algorithms::wireframe::Event;
use crate::figure::{Fit, Labels};
use crate::language::Language;
use crate::picture::{Ink, Picture, Rect, Style, Tag};
use crate::replay::{Replay, wireframe};
use glam::{DVec2, Vec2};

/// The least zoom, in points a pixel: of longer lines the part around the current pixel is shown.
const ZOOM: f64 = 10.0;

pub(super) fn draw(
    picture: &mut Picture,
    replay: &Replay<Event, wireframe::State>,
    ends: [DVec2; 2],
    language: Language,
) {
    let state = replay.state();
    let area = picture.bounds().grown(-2.0);
    let inner = area.grown(-(0.12 * area.width.min(area.height)).max(18.0));
    let [start, end] = ends;
    let whole = Fit::new(start.min(end), start.max(end), inner);
    let fit = if whole.scale >= ZOOM {
        whole
    } else {
        let middle = state.pixel.map_or(start, |(_, _, exact)| exact);
        Fit::centered(middle, ZOOM, inner)
    };
    picture.clipped(area, |picture| {
        for (x, y) in plotted(replay) {
            let square = fit.pixels(x, x + 1, y);
            if !square.intersection(&area).is_empty() {
                picture.tagged(Tag::Pixel { x, y }, |picture| {
                    picture.rect(square, Ink::Faint.fill().outlined(Ink::Muted.stroke(1.0)));
                });
            }
        }
        picture.line(fit.place(start), fit.place(end), Ink::Linked.stroke(2.0));
        let mut labels = Labels::new(area);
        labels.avoid(fit.place(start), fit.place(end));
        if let Some((x, y, exact)) = state.pixel {
            let square = fit.pixels(x, x + 1, y);
            picture.rect(square, Ink::This.stroke(2.5));
            picture.circle(fit.place(exact), 3.5, Ink::This);
            labels.reserve(square);
            let place = [exact.x, exact.y].map(|v| language.short(v, 2));
            let text = format!("({})", language.list(place));
            let set = Style::LabelBold.size(13.0).ink(Ink::This);
            let disc = (square.center(), 0.5 * square.width);
            labels.put(picture, disc, Vec2::new(0.0, -1.0), &text, set);
        }
        for (point, names) in [(start, ["x_1", "y_1"]), (end, ["x_2", "y_2"])] {
            let place = fit.place(point);
            if !area.contains(place) {
                continue;
            }
            picture.circle(
                place,
                4.0,
                Ink::Surface.fill().outlined(Ink::Linked.stroke(2.0)),
            );
            labels.reserve(Rect::between(place, place).grown(4.0));
            let [x, y] = [point.x, point.y].map(|v| language.short(v, 2));
            let text = format!("{} = {x}, {} = {y}", names[0], names[1]);
            let set = Style::Label.size(12.0).ink(Ink::Muted);
            let away = (point - 0.5 * (start + end)).as_vec2();
            labels.put(picture, (place, 4.0), away, &text, set);
        }
    });
}

/// The pixels plotted on the current edge up to this step.
fn plotted(replay: &Replay<Event, wireframe::State>) -> impl Iterator<Item = (u32, u32)> {
    let (timeline, position) = (replay.timeline(), replay.position());
    let entered = timeline
        .outline()
        .scopes(position)
        .find(|&scope| matches!(timeline.event(scope), Event::Edge { .. }));
    (entered.unwrap_or(position)..=position).filter_map(move |step| match *timeline.event(step) {
        Event::PixelPlotted { x, y, .. } => Some((x, y)),
        _ => None,
    })
}
