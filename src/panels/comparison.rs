//! The same picture by several methods side by side, with one cursor in all of them: where it stands, what each says there, what each
//! did for the picture and how long it took.

pub(super) mod cells;
pub(super) mod cursor;

use super::horizon::{UNKNOWN, srgb_bytes};
use super::message::{NOT_COMPARED, labelled, message};
use super::values::step_as_sentence;
use super::{PanelInput, Properties, names};
use crate::language::Message;
use crate::methods::Method;
use crate::picture::{Image, Ink, Picture};
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

pub fn draw(input: &PanelInput, size: Vec2) -> Picture {
    let Some(first) = input.finished.compared.pictures().first() else {
        return message(NOT_COMPARED, input.language, size);
    };
    let cursor = Cursor::of(input);
    let hidden = input.hidden_pixels(&first.frame);
    let mut picture = Picture::new(size.x, size.y);
    let mut alt = step_as_sentence(input);
    let all = input.finished.compared.pictures();
    for (compared, cell) in all.iter().zip(cells(&first.frame, all.len(), 3, size)) {
        let figures = figures(input, compared);
        let name = names::method(compared.method, input.language);
        cell.title(&mut picture, &name, (compared.method, input.run.method()));
        let frame = &compared.frame;
        let bytes = srgb_bytes(frame, hidden.as_deref());
        let image = Image::new(frame.width, frame.rows.len() as u32, bytes);
        picture.pixels(cell.image, image, (0, 0));
        cell.frame(&mut picture, &cursor, input.answered);
        // Wires carry no intensity.
        let shown = cursor
            .value(frame)
            .filter(|_| compared.method != Method::Wireframe);
        let unknown = hidden
            .as_deref()
            .is_some_and(|hidden| cursor.is_on(frame, hidden));
        let here = shown.map_or_else(String::new, |color| {
            let [r, g, b] = color.channels();
            match r == g && g == b {
                _ if unknown => format!("I = {UNKNOWN}"),
                true => format!("I = {}", input.language.fixed(r, 3)),
                false => {
                    let channels = color
                        .channels()
                        .map(|channel| input.language.fixed(channel, 3));
                    format!("I = {}", input.language.list(channels))
                }
            }
        });
        let lines = [here, figures.1, figures.0];
        let inks = [Ink::Text, Ink::Muted, Ink::Muted];
        let written = lines.iter().map(String::as_str).zip(inks);
        cell.lines(&mut picture, written);
        let lines = labelled(&name, &lines.join("; "), input.language);
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
