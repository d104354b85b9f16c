//! The patches of the room as the scene's camera sees them, each in its light so far or, where that is chosen, in the light that
//! it has still to shoot; with the current exchange, and the form factors between the two patches that are selected.

mod colors;
pub(super) mod exchange;
mod order;
pub(super) mod pair;
pub(super) mod room_view;
mod smooth;

use super::message::{NO_PATCHES, labelled, message};
use super::values::step_as_sentence;
use super::{PanelInput, Properties, names};
use crate::algorithms::enclosure::{CHANNELS, Enclosure};
use crate::algorithms::prepared_scene::PreparedScene;
use crate::color::Rgb;
use crate::figure::{color_strip, elided, viridis};
use crate::language::{Language, Message};
use crate::picture::{Ink, Picture, Rect, Style, Tag};
use crate::replay::Run;
use crate::replay::radiosity::State;
use colors::{DECADES, shares};
use exchange::Exchange;
use glam::Vec2;
use room_view::RoomView;

const MARGIN: f32 = 5.0;
const TEXT: f32 = 11.0;
/// Of the title above and of the scale below.
const ROW: f32 = 18.0;
/// With more lines than that, patches have no outlines.
const MOST_LINES: usize = 500;
/// By how much patches reach under their neighbours, in points, so that nothing shows between them.
const OVERLAP: f32 = 0.4;

pub(super) const RADIOSITY: Message = Message("radiosity-radiosity");
const WITH_UNSHOT: Message = Message("radiosity-with-unshot");
const UNSHOT: Message = Message("radiosity-unshot");
const EMISSION: Message = Message("radiosity-emission");
const REFLECTANCE: Message = Message("radiosity-reflectance");
const PATCHES: Message = Message("radiosity-patches");
const CURRENT: Message = Message("radiosity-current");
pub(super) const NO_ROOM: Message = Message("radiosity-no-room");

pub const PANEL: Properties = Properties::titled(Message("app-radiosity"));

pub fn draw(input: &PanelInput, size: Vec2) -> Picture {
    let (Run::Radiosity(setup, _) | Run::FormFactor(setup, _) | Run::Hierarchical(setup, _)) =
        input.run
    else {
        return message(NO_PATCHES, input.language, size);
    };
    let prepared = &setup.prepared;
    let Some(room) = input.run.enclosure() else {
        return message(NO_ROOM, input.language, size);
    };
    let view = RoomView::new(prepared, room);
    let exchange = Exchange::of(input.run, input.focus);
    let mut picture = Picture::new(size.x, size.y);
    picture.alt = in_words(input, prepared, room, &view, exchange.as_ref());
    let coloring = coloring(input, room);
    let place = place(&picture);
    let between = input.pair.map(|pair| pair::in_words(input, pair));
    let area = coloring.frame(&mut picture, place, between.as_deref());
    let fit = view.fit(area);
    let has_room = !area.is_empty();
    let smooth = input.smooth.filter(|_| coloring.may_be_smooth && has_room);
    if let Some(draw) = smooth {
        let (place, image) = smooth::image(draw, room, &view, &fit, &coloring.patches);
        picture.image(place, image);
    }
    let outlined = view.corners() <= MOST_LINES;
    for seen in &view.seen {
        let paint = Ink::Rgb(coloring.patches[seen.patch]).fill();
        let paint = match (smooth.is_some(), outlined) {
            // Not seen, but pointed at.
            (true, _) => paint.opacity(0.0),
            (false, true) => paint.outlined(Ink::Muted.stroke(0.75).opacity(0.6)),
            (false, false) => paint,
        };
        picture.tagged(Tag::Patch(seen.patch), |picture| {
            for piece in &seen.pieces {
                let corners: Vec<Vec2> = piece.iter().map(|&corner| fit.place(corner)).collect();
                picture.polygon(overlapping(&corners), paint);
            }
        });
    }
    input.answered.draw(&mut picture, |tag| {
        let Tag::Patch(patch) = tag else { return None };
        let center = view.center(patch)?;
        Some(Rect::between(fit.place(center), fit.place(center)))
    });
    if let Some(pair) = input.pair {
        pair::draw(&mut picture, pair, (&view, &fit), area);
    }
    if let Some(exchange) = &exchange {
        exchange.draw(
            &mut picture,
            (prepared, room),
            input.language,
            &view,
            &fit,
            area,
        );
    }
    picture
}

fn place(picture: &Picture) -> Rect {
    picture.bounds().grown(-MARGIN)
}

/// What the patches are coloured by.
struct Coloring {
    title: String,
    patches: Vec<Rgb>,
    /// Whether what lies between two patches has a meaning: of light it has.
    may_be_smooth: bool,
    scale: Option<Scale>,
}

/// The colours of the scale from 0 to 1, with what stands at its ends.
struct Scale {
    color: fn(f64) -> Rgb,
    ends: [String; 2],
}

/// The light so far, or what patches have still to shoot, where they shoot and that is chosen. Of a form factor, what the surfaces
/// look like.
fn coloring(input: &PanelInput, room: &Enclosure) -> Coloring {
    let localize = |strings: Message| strings.text(input.language);
    let Some((light, exposure)) = input.run.light() else {
        return Coloring {
            title: localize(REFLECTANCE).to_string(),
            patches: room.reflectance.clone(),
            may_be_smooth: false,
            scale: None,
        };
    };
    let (unshot, title) = match input.run {
        Run::Radiosity(_, replay) => {
            let state = replay.state();
            (state.unshot(room), title(state, room, input.language))
        }
        _ => (None, localize(RADIOSITY).to_string()),
    };
    if let Some(unshot) = unshot.filter(|_| input.unshot) {
        let least = unshot.brightest * 10_f64.powi(-DECADES);
        let channel = names::word(unshot.channel, input.language);
        return Coloring {
            title: UNSHOT.format(input.language, &[("channel", &channel)]),
            patches: shares(&unshot).into_iter().map(viridis).collect(),
            may_be_smooth: false,
            scale: Some(Scale {
                color: viridis,
                ends: [
                    format!("≤ {}", input.language.significant(least, 3)),
                    input.language.significant(unshot.brightest, 3),
                ],
            }),
        };
    }
    Coloring {
        title,
        patches: light.into_iter().map(|b| b * exposure).collect(),
        may_be_smooth: true,
        scale: Some(Scale {
            color: Rgb::splat,
            ends: [
                "0".to_string(),
                format!("≥ {}", input.language.significant(1.0 / exposure, 3)),
            ],
        }),
    }
}

/// What is shown, and of which channels.
pub(super) fn title(state: &State, room: &Enclosure, language: Language) -> String {
    let localize = |strings: Message| strings.text(language);
    let Some(now) = state.channel() else {
        return localize(EMISSION).to_string();
    };
    let what = if now.solver.shoots() {
        WITH_UNSHOT
    } else {
        RADIOSITY
    };
    let recorded = |c: usize| {
        let mut recorded = state.channels.iter();
        recorded.any(|channel| channel.channel == Some(CHANNELS[c]))
    };
    let lit = (0..CHANNELS.len()).filter(|&c| recorded(c) || recorded(room.first_equal_channel(c)));
    let words: Vec<String> = lit.map(|c| names::word(CHANNELS[c], language)).collect();
    labelled(localize(what), &words.join(", "), language)
}

impl Coloring {
    /// Draws title, scale and, in a row of its own, what passes between the patches that are selected. Returns the place that is
    /// left for the room.
    fn frame(&self, picture: &mut Picture, place: Rect, between: Option<&str>) -> Rect {
        let style = Style::Body.size(TEXT).ink(Ink::Muted);
        let row = Rect {
            height: ROW,
            ..place
        };
        elided(picture, row, &self.title, style);
        let mut inside = Rect::between((place.x, place.y + ROW), place.max());
        if let Some(between) = between {
            let row = row.shifted(Vec2::new(0.0, ROW));
            let style = Style::LabelBold.size(TEXT).ink(Ink::Linked);
            elided(picture, row, between, style);
            inside = Rect::between((place.x, place.y + 2.0 * ROW), place.max());
        }
        if let Some(scale) = &self.scale {
            inside.height -= ROW;
            let below = row.shifted(Vec2::new(0.0, place.height - ROW));
            let ends = scale.ends.each_ref().map(String::as_str);
            color_strip(picture, below, ends, style, scale.color);
        }
        // A quiet ground, on which both black and white patches stand out.
        picture.rect(inside, Ink::Faint);
        inside.grown(-4.0)
    }
}

/// The convex polygon with its edges moved outwards.
pub(super) fn overlapping(corners: &[Vec2]) -> Vec<Vec2> {
    let count = corners.len();
    let edge = |i: usize| (corners[(i + 1) % count] - corners[i % count]).normalize_or_zero();
    let turn: f32 = (0..count).map(|i| edge(i).perp_dot(edge(i + 1))).sum();
    let outward = |i: usize| -turn.signum() * edge(i).perp();
    (0..count)
        .map(|i| {
            let [before, after] = [outward(i + count - 1), outward(i)];
            // Sharp corners would reach far.
            let along = (1.0 + before.dot(after)).max(0.3);
            corners[i] + OVERLAP / along * (before + after)
        })
        .collect()
}

fn in_words(
    input: &PanelInput,
    prepared: &PreparedScene,
    room: &Enclosure,
    view: &RoomView,
    exchange: Option<&Exchange>,
) -> String {
    let [patches, seen] = [room.patches.len(), view.seen.len()].map(|count| count.to_string());
    let mut sentences = vec![
        step_as_sentence(input),
        PATCHES.format(input.language, &[("patches", &patches), ("seen", &seen)]),
    ];
    if let Some(exchange) = exchange {
        let exchange = exchange.in_words(prepared, room, input.language);
        sentences.push(CURRENT.format(input.language, &[("exchange", &exchange)]));
    }
    sentences.join(" ")
}

#[cfg(test)]
mod tests;
