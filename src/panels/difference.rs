//! How far each method's picture is from the reference's, pixel by pixel: brighter, darker, and by how much at most and on average.

use super::PanelInput;
use super::comparison::cells::{ROW, cells};
use super::comparison::cursor::Cursor;
use super::message::{NOT_COMPARED, message};
use super::values::told_in_words;
use crate::color::Rgb;
use crate::language::Message;
use crate::picture::{Image, Ink, Picture, Rect, Style, elide};
use crate::render::compare::{Compared, Difference};
use glam::Vec2;

const TEXT: f32 = 11.0;
const SCALE: f32 = 18.0;

const AGAINST: Message = Message("difference-against");
const RMS: Message = Message("difference-rms");
const LARGEST: Message = Message("difference-largest");
const HERE: Message = Message("difference-here");

pub fn draw(input: &PanelInput, size: Vec2) -> Picture {
    // Wires shade nothing: how far they are says nothing.
    let compared = &input.finished.compared;
    let differences = compared.differences();
    let mut others = compared.shaded();
    let Some((_, reference)) = others.next_back().filter(|_| !differences.is_empty()) else {
        return message(NOT_COMPARED, input.language, size);
    };
    let localize = |strings: Message| strings.text(input.language);
    let cursor = Cursor::of(input);
    let most = differences
        .iter()
        .fold(0.0, |most: f64, d| most.max(d.largest));
    let mut picture = Picture::new(size.x, size.y);
    let mut alt = format!(
        "{} {} {}.",
        told_in_words(input),
        localize(AGAINST),
        reference.method.name()
    );
    let room = Vec2::new(size.x, size.y - SCALE - ROW);
    let cells = cells(&reference.frame, differences.len(), 2, room);
    for (((_, compared), difference), cell) in others.zip(differences).zip(cells) {
        cell.title(
            &mut picture,
            compared.method,
            input.run.method() == compared.method,
        );
        picture.pixels(cell.image, image(compared, difference, most), (0, 0));
        cell.frame(&mut picture, &cursor);
        let width = compared.frame.width as usize;
        let here = match (cursor.x, cursor.y) {
            (Some(x), Some(y)) => difference.signed.get(y as usize * width + x as usize),
            _ => None,
        };
        let rms = format!(
            "{} {}",
            localize(RMS),
            input.language.significant(difference.rms, 3)
        );
        let largest = format!(
            "{} {}",
            localize(LARGEST),
            input.language.significant(difference.largest, 3)
        );
        let figures = format!("{rms} · {largest}");
        let here = here.map_or_else(String::new, |here| {
            format!(
                "{}: {}",
                localize(HERE),
                input.language.significant(*here, 3)
            )
        });
        let style = Style::Body.size(TEXT);
        // In a narrow cell the two figures take both rows.
        let lines = match style.width(&figures) <= cell.below.width {
            true => [&figures, &here],
            false => [&rms, &largest],
        };
        for (row, line) in lines.into_iter().enumerate() {
            let place = Rect {
                y: cell.below.y + ROW * row as f32,
                height: ROW,
                ..cell.below
            };
            picture.text_in(
                place,
                elide(line, style.style, style.size, place.width),
                style,
            );
        }
        alt = format!("{alt} {}: {figures}.", compared.method.name());
    }
    scale(&mut picture, most, reference, input, size);
    picture.alt = alt;
    picture
}

fn image(compared: &Compared, difference: &Difference, most: f64) -> Image {
    let bytes: Vec<u8> = difference
        .signed
        .iter()
        .flat_map(|d| diverging(d / most.max(f64::MIN_POSITIVE)).to_srgb8())
        .collect();
    Image::new(
        compared.frame.width,
        compared.frame.rows.len() as u32,
        bytes,
    )
}

/// From −1, blue, over 0, nearly white, to 1, orange: distinct also to those who see red and green alike.
fn diverging(share: f64) -> Rgb {
    const ENDS: [[u8; 3]; 2] = [[0x08, 0x45, 0x94], [0xb3, 0x58, 0x06]];
    const MIDDLE: [u8; 3] = [0xf7, 0xf7, 0xf7];
    let share = share.clamp(-1.0, 1.0);
    let end = ENDS[usize::from(share > 0.0)];
    // A root, so that small differences are seen too.
    let part = share.abs().sqrt();
    Rgb::from_srgb8([0, 1, 2].map(|c| {
        let [from, to] = [MIDDLE[c], end[c]].map(f64::from);
        (from + part * (to - from)).round() as u8
    }))
}

/// Under the images: what the colours mean.
fn scale(picture: &mut Picture, most: f64, reference: &Compared, input: &PanelInput, size: Vec2) {
    const COLORS: u32 = 65;
    let style = Style::Body.size(TEXT).ink(Ink::Muted);
    let row = Rect::new(6.0, size.y - SCALE - ROW, size.x - 12.0, ROW);
    let strings = format!(
        "{} {}",
        AGAINST.text(input.language),
        reference.method.name()
    );
    picture.text_in(
        row,
        elide(&strings, style.style, style.size, row.width),
        style,
    );
    let row = Rect::new(6.0, size.y - SCALE, size.x - 12.0, SCALE - 2.0);
    let (low, high) = (
        format!("−{}", input.language.significant(most, 3)),
        format!("+{}", input.language.significant(most, 3)),
    );
    let around = style.width(&low) + style.width(&high) + 12.0;
    let strip = Rect::new(
        row.x + style.width(&low) + 6.0,
        row.y + 3.0,
        (row.width - around).clamp(20.0, 200.0),
        row.height - 6.0,
    );
    let middle = f64::from(COLORS / 2);
    let bytes: Vec<u8> = (0..COLORS)
        .flat_map(|step| diverging(f64::from(step) / middle - 1.0).to_srgb8())
        .collect();
    picture.text_in(row, low, style);
    picture.image(strip, Image::new(COLORS, 1, bytes));
    picture.rect(strip, Ink::Rule.stroke(1.0));
    let right = Rect {
        x: strip.right() + 6.0,
        ..row
    };
    picture.text_in(right, high, style);
}
