//! The same picture by several methods side by side, with one cursor in all of them: where it stands, what each says there, what each
//! did for the picture and how long it took.

pub(super) mod cells;
pub(super) mod cursor;

use super::horizon::{UNKNOWN, srgb_bytes};
use super::message::{NOT_COMPARED, labelled, message};
use super::strings::focus;
use super::values::step_as_sentence;
use super::{PanelInput, Properties, names};
use crate::algorithms::focus::Focus;
use crate::color::Rgb;
use crate::language::{Language, Message};
use crate::methods::Method;
use crate::picture::{Image, Ink, Picture, Rect};
use crate::render::compare::Compared;
use cells::cells;
use cursor::Cursor;
use glam::Vec2;

const ILLUMINATED: Message = Message("comparison-illuminated");
const INTERPOLATED: Message = Message("comparison-interpolated");
const ROOTS: Message = Message("comparison-roots");
const SERIES: Message = Message("comparison-series");
const RAYS: Message = Message("comparison-rays");
const A_PIXEL: Message = Message("comparison-a-pixel");

pub const PANEL: Properties = Properties::titled(Message("app-comparison")).comparing();

/// Of text under a picture: its value, its time, and what was done for it.
const LINES: usize = 3;

/// What the pictures are called.
pub(super) fn titles<'a>(
    compared: impl IntoIterator<Item = &'a Compared>,
    language: Language,
) -> Vec<String> {
    let compared = compared.into_iter();
    compared
        .map(|compared| names::method(compared.method, language))
        .collect()
}

/// Where the picture nearest to a place of the panel stands: what zooming and dragging are reckoned by. None where there is none.
pub fn place(input: &PanelInput, size: Vec2, at: Vec2) -> Option<Rect> {
    let all = input.finished.compared.pictures();
    let titles = titles(all, input.language);
    let cells = cells(input, &all.first()?.frame, &titles, LINES, size);
    nearest(&cells, at)
}

pub(super) fn nearest(cells: &[cells::Cell], at: Vec2) -> Option<Rect> {
    let distance = |place: &Rect| place.center().distance(at);
    let places = cells.iter().map(|cell| cell.image);
    places.min_by(|a, b| distance(a).total_cmp(&distance(b)))
}

/// What every method says at a pixel, a line each; none where nothing is compared.
pub fn values(input: &PanelInput, x: u32, y: u32) -> Option<String> {
    let all = input.finished.compared.pictures();
    let first = &all.first()?.frame;
    let hidden = input.hidden_pixels(first);
    let cursor = Cursor {
        x: Some(x),
        y: Some(y),
    };
    let mut lines = vec![focus(Focus::Pixel { x, y }, input.language)];
    for compared in all {
        let color = cursor.value(&compared.frame)?;
        let is_hidden = hidden
            .as_ref()
            .is_some_and(|hidden| cursor.is_on(first, hidden));
        let value = match is_hidden {
            true => UNKNOWN.to_string(),
            false => intensity(color, input.language),
        };
        let name = names::method(compared.method, input.language);
        lines.push(labelled(&name, &value, input.language));
    }
    Some(lines.join("\n"))
}

/// One number where all channels are equal.
fn intensity(color: Rgb, language: Language) -> String {
    let channels = color.channels().map(|channel| language.fixed(channel, 3));
    match color.is_grey() {
        true => channels[0].clone(),
        false => language.list(channels),
    }
}

pub fn draw(input: &PanelInput, size: Vec2) -> Picture {
    let Some(first) = input.finished.compared.pictures().first() else {
        return message(NOT_COMPARED, input.language, size);
    };
    let cursor = Cursor::of(input);
    let hidden = input.hidden_pixels(&first.frame);
    let mut picture = Picture::new(size.x, size.y);
    let mut alt = step_as_sentence(input);
    let all = input.finished.compared.pictures();
    let titles = titles(all, input.language);
    let cells = cells(input, &first.frame, &titles, LINES, size);
    for ((compared, name), cell) in all.iter().zip(&titles).zip(cells) {
        let figures = figures(input, compared);
        cell.title(&mut picture, name, (compared.method, input.run.method()));
        let frame = &compared.frame;
        let bytes = srgb_bytes(frame, hidden.as_deref());
        let image = Image::new(frame.width, frame.rows.len() as u32, bytes);
        cell.pixels(&mut picture, image);
        cell.frame(&mut picture, &cursor, input.answered);
        // Wires carry no intensity.
        let shown = cursor
            .value(frame)
            .filter(|_| compared.method != Method::Wireframe);
        let unknown = hidden
            .as_deref()
            .is_some_and(|hidden| cursor.is_on(frame, hidden));
        let here = shown.map_or_else(String::new, |color| {
            let value = match unknown {
                true => UNKNOWN.to_string(),
                false => intensity(color, input.language),
            };
            format!("I = {value}")
        });
        let lines = [here, figures.1, figures.0];
        let inks = [Ink::Text, Ink::Muted, Ink::Muted];
        let written = lines.iter().map(String::as_str).zip(inks);
        cell.lines(&mut picture, written);
        let lines = labelled(name, &lines.join("; "), input.language);
        alt = format!("{alt} {lines}.");
    }
    picture.alt = alt;
    picture
}

/// A pixel's share of what was done and of the time.
fn figures(input: &PanelInput, compared: &Compared) -> (String, String) {
    let done = compared.operations;
    let pixels = done.pixels.max(1) as f64;
    let mut recorded = Vec::new();
    for (count, what) in [
        (done.illuminations, ILLUMINATED),
        (done.interpolations, INTERPOLATED),
        (done.unit_normals, ROOTS),
        (done.series, SERIES),
        (done.rays, RAYS),
    ] {
        if count > 0 {
            let count = input.language.significant(count as f64 / pixels, 3);
            recorded.push(what.format(input.language, &[("count", &count)]));
        }
    }
    let time = 1e9 * compared.seconds / pixels;
    let time = input.language.significant(time, 3);
    (
        recorded.join(" · "),
        A_PIXEL.format(input.language, &[("time", &time)]),
    )
}

#[cfg(test)]
mod tests;
