//! How far each method's picture is from the reference's, pixel by pixel: brighter, darker, and by how much at most and on average.

use super::comparison::cells::{ROW, cells};
use super::comparison::cursor::Cursor;
use super::comparison::{nearest, titles};
use super::horizon::{UNKNOWN, hatched};
use super::message::{NOT_COMPARED, labelled, message};
use super::values::step_as_sentence;
use super::{PanelInput, Properties};
use crate::figure::{color_strip, diverging, elided};
use crate::language::{Language, Message};
use crate::picture::{Image, Ink, Picture, Rect, Style};
use crate::render::compare::{Compared, Difference};
use glam::Vec2;

const TEXT: f32 = 11.0;
const SCALE: f32 = 18.0;
/// Of text under a picture.
const LINES: usize = 2;

const AGAINST: Message = Message("difference-against");
const RMS: Message = Message("difference-rms");
const LARGEST: Message = Message("difference-largest");
const HERE: Message = Message("difference-here");

pub const PANEL: Properties = Properties::titled(Message("app-difference")).comparing();

pub fn draw(input: &PanelInput, size: Vec2) -> Picture {
    // Wires shade nothing: how far they are says nothing.
    let compared = &input.finished.compared;
    let differences = compared.differences();
    let mut others = compared.shaded();
    let Some((_, reference)) = others.next_back().filter(|_| !differences.is_empty()) else {
        return message(NOT_COMPARED, input.language, size);
    };
    let valued = |message: Message, value: f64| {
        let value = input.language.significant(value, 3);
        message.format(input.language, &[("value", &value)])
    };
    let cursor = Cursor::of(input);
    let hidden = input.hidden_pixels(&reference.frame);
    let most = differences
        .iter()
        .fold(0.0, |most: f64, d| most.max(d.largest));
    let mut picture = Picture::new(size.x, size.y);
    let against = against(reference, input.language);
    let mut alt = format!("{} {against}.", step_as_sentence(input));
    let others: Vec<&Compared> = others.map(|(_, compared)| compared).collect();
    let titles = titles(others.iter().copied(), input.language);
    let cells = cells(input, &reference.frame, &titles, LINES, room(size));
    let all = others.into_iter().zip(&titles).zip(differences);
    for (((compared, name), difference), cell) in all.zip(cells) {
        cell.title(&mut picture, name, (compared.method, input.run.method()));
        let image = image(compared, difference, most, hidden.as_deref());
        cell.pixels(&mut picture, image);
        cell.frame(&mut picture, &cursor, input.answered);
        let width = compared.frame.width as usize;
        let here = match (cursor.x, cursor.y) {
            (Some(x), Some(y)) => difference.signed.get(y as usize * width + x as usize),
            _ => None,
        };
        let figures = [
            valued(RMS, difference.rms),
            valued(LARGEST, difference.largest),
        ];
        let figures = figures.join(" · ");
        let unknown = hidden.as_deref();
        let unknown = unknown.is_some_and(|hidden| cursor.is_on(&compared.frame, hidden));
        let here = here.map_or_else(String::new, |&here| match unknown {
            true => HERE.format(input.language, &[("value", UNKNOWN)]),
            false => valued(HERE, here),
        });
        // Where the two figures do not stand beside each other, each has a row.
        let style = Style::Body.size(TEXT);
        let figures_fit = style.width(&figures) <= cell.below.width;
        let mut lines = match figures_fit {
            true => vec![figures.as_str()],
            false => figures.split(" · ").collect(),
        };
        lines.push(&here);
        let lines = lines.into_iter().map(|line| (line, Ink::Text));
        cell.lines(&mut picture, lines);
        let figures = labelled(name, &figures, input.language);
        alt = format!("{alt} {figures}.");
    }
    scale(&mut picture, most, &against, input, size);
    picture.alt = alt;
    picture
}

/// Where the picture nearest to a place of the panel stands: what zooming and dragging are reckoned by. None where there is none.
pub fn place(input: &PanelInput, size: Vec2, at: Vec2) -> Option<Rect> {
    let compared = &input.finished.compared;
    let mut others = compared.shaded();
    let (_, reference) = others.next_back()?;
    let titles = titles(others.map(|(_, compared)| compared), input.language);
    let cells = cells(input, &reference.frame, &titles, LINES, room(size));
    nearest(&cells, at)
}

/// Of a panel, what is for the pictures: the scale is below them.
fn room(size: Vec2) -> Vec2 {
    Vec2::new(size.x, size.y - SCALE - ROW)
}

fn image(
    compared: &Compared,
    difference: &Difference,
    most: f64,
    hidden: Option<&[bool]>,
) -> Image {
    let colors = difference.signed.iter();
    let colors = colors.map(|d| diverging(d / most.max(f64::MIN_POSITIVE)).to_srgb8());
    let bytes = hatched(colors, compared.frame.width, hidden);
    Image::new(
        compared.frame.width,
        compared.frame.rows.len() as u32,
        bytes,
    )
}

fn against(reference: &Compared, language: Language) -> String {
    let method = super::names::method(reference.method, language);
    AGAINST.format(language, &[("method", &method)])
}

/// Under the images: what the colours mean.
fn scale(picture: &mut Picture, most: f64, against: &str, input: &PanelInput, size: Vec2) {
    let style = Style::Body.size(TEXT).ink(Ink::Muted);
    let row = Rect::new(6.0, size.y - SCALE - ROW, size.x - 12.0, ROW);
    elided(picture, row, against, style);
    let row = Rect::new(6.0, size.y - SCALE, size.x - 12.0, SCALE - 2.0);
    let ends = ["−", "+"].map(|sign| format!("{sign}{}", input.language.significant(most, 3)));
    let ends = ends.each_ref().map(String::as_str);
    color_strip(picture, row, ends, style, |share| {
        diverging(2.0 * share - 1.0)
    });
}
