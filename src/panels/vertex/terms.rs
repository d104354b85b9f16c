//! The values of the current point, and its intensity as a sum of terms.

use super::super::channels;
use super::super::values::short;
use crate::color::Rgb;
use crate::figure::{Cell, Row, mono_or_narrow};
use crate::language::{Language, Message};
use crate::picture::{Ink, Picture, Rect, Style, Tag, symbol};
use crate::record::Value;
use crate::replay::shading::{CurrentPoint, State};

const SIZE: f32 = 12.0;
const ROW: f32 = 17.0;
const BAR: f32 = 13.0;
/// Of the column of names.
const NAMES: f32 = 34.0;
const SWATCH: f32 = 16.0;
/// Ambient, diffuse and specular: the ink of the bar, its letter, and the ink of the letter on it.
const TERMS: [Term; 3] = [
    Term(Ink::Series(0), "a", Ink::Rgb(Rgb::WHITE)),
    Term(Ink::Series(1), "d", Ink::Rgb(Rgb::BLACK)),
    Term(Ink::Series(2), "s", Ink::Rgb(Rgb::BLACK)),
];
/// The least decimals that still say something.
const FEWEST: usize = 2;

const LIGHT: Message = Message("common-light");

#[derive(Clone, Copy)]
struct Term(Ink, &'static str, Ink);

/// A named value, with the ink that stands for it in the bars.
struct Named {
    name: &'static str,
    shown: String,
    value: Value,
    ink: Option<Ink>,
}

impl Named {
    fn new(name: &'static str, value: impl Into<Value>) -> Self {
        Named {
            name,
            shown: symbol(name),
            value: value.into(),
            ink: None,
        }
    }

    fn ink(self, ink: Ink) -> Self {
        Named {
            ink: Some(ink),
            ..self
        }
    }

    fn row(&self, language: Language) -> Row {
        let set = Style::Label.size(SIZE).ink(Ink::Muted);
        // The most decimals that fit, in the widest face that does; of what does not fit, nothing.
        let values = (FEWEST..=3).rev().flat_map(|digits| {
            mono_or_narrow(short(self.value, digits, language), SIZE, Ink::Text)
        });
        let values = values.chain([(String::new(), set)]);
        // Names stand below each other, with a swatch or without.
        let name = Cell::new(self.shown.clone(), set).swatch(self.ink);
        let before = if self.ink.is_some() { 0.0 } else { SWATCH };
        let start = SWATCH + NAMES.max(set.width(&self.shown) + 6.0);
        Row::new(Tag::Field(self.name))
            .cell(before, name)
            .cell(start, Cell::forms(values))
    }
}

pub(super) fn draw(picture: &mut Picture, state: &State, language: Language, area: Rect) {
    let (rows, parts) = match &state.point {
        Some(point) => (rows_of_point(point, language), parts(point)),
        None => (rows_of_normals(state), Vec::new()),
    };
    let bars = channels(&parts);
    let bars_height = bars.len() as f32 * (BAR + 3.0);
    let room = area.height - bars_height - 8.0;
    let fitting = (room / ROW).floor().max(0.0) as usize;
    // Where not all rows fit, the last ones matter most: they are the newest.
    let skipped = rows.len().saturating_sub(fitting);
    let rows = &rows[skipped..];
    let top = area.y + 0.5 * (room - rows.len() as f32 * ROW).max(0.0);
    for (i, row) in rows.iter().enumerate() {
        let place = Rect::new(area.x + 4.0, top + i as f32 * ROW, area.width - 8.0, ROW);
        row.row(language).draw(picture, place);
    }
    let top = top + rows.len() as f32 * ROW + 6.0;
    let whole = parts
        .iter()
        .map(|(term, _)| *term)
        .sum::<Rgb>()
        .max_channel()
        .max(1.0);
    for (i, channel) in bars.into_iter().enumerate() {
        let y = top + i as f32 * (BAR + 3.0);
        let bar = Rect::new(area.x + 4.0, y, area.width - 8.0, BAR);
        draw_bar(picture, bar, &parts, channel, whole);
    }
}

/// What is known of the point, the current light at the end.
fn rows_of_point(point: &CurrentPoint, language: Language) -> Vec<Named> {
    let mut rows = Vec::new();
    rows.extend(
        point
            .ambient
            .map(|term| Named::new("I_a", term).ink(TERMS[0].0)),
    );
    if let Some(light) = point.lights.last() {
        let mut number = Named::new("light", light.light);
        number.shown = LIGHT.text(language).to_string();
        rows.push(number);
        rows.push(Named::new("f_att", light.attenuation));
        rows.extend(
            light
                .to_light
                .map(|(_, cosine)| Named::new("N_dot_L", cosine)),
        );
        rows.extend(
            light
                .diffuse
                .map(|term| Named::new("I_d", term).ink(TERMS[1].0)),
        );
        rows.extend(
            light
                .halfway
                .map(|(_, cosine)| Named::new("N_dot_H", cosine)),
        );
        rows.extend(
            light
                .mirrored
                .map(|(_, cosine)| Named::new("R_dot_V", cosine)),
        );
        rows.extend(
            light
                .specular
                .map(|term| Named::new("I_s", term).ink(TERMS[2].0)),
        );
    }
    rows.extend(point.intensity.map(|intensity| Named::new("I", intensity)));
    rows
}

/// The normal added last, the sum so far, and their mean.
fn rows_of_normals(state: &State) -> Vec<Named> {
    let Some(vertex) = &state.vertex else {
        return Vec::new();
    };
    let mut rows = vec![Named::new("P_v", vertex.position)];
    if let Some(&(_, normal, _)) = vertex.faces.last() {
        let mut sum = Named::new("sum_N", vertex.sum);
        sum.shown = "ΣN_k".to_string();
        rows.extend([Named::new("N_k", normal), sum]);
    }
    rows.extend(vertex.normal.map(|normal| Named::new("N_v", normal)));
    rows
}

/// The terms recorded so far, light by light, with their inks.
fn parts(point: &CurrentPoint) -> Vec<(Rgb, Term)> {
    let mut parts: Vec<(Rgb, Term)> = point
        .ambient
        .map(|term| (term, TERMS[0]))
        .into_iter()
        .collect();
    for light in &point.lights {
        parts.extend(light.diffuse.map(|term| (term, TERMS[1])));
        parts.extend(light.specular.map(|term| (term, TERMS[2])));
    }
    parts
}

/// A bar for all channels where every term is grey, else one for each.
fn channels(parts: &[(Rgb, Term)]) -> Vec<usize> {
    if parts.is_empty() {
        Vec::new()
    } else if parts.iter().all(|(term, _)| term.is_grey()) {
        vec![0]
    } else {
        vec![0, 1, 2]
    }
}

/// The terms of a channel end to end; the bar is `whole` long.
fn draw_bar(picture: &mut Picture, bar: Rect, parts: &[(Rgb, Term)], channel: usize, whole: f64) {
    let letter = Style::Body.size(11.0).middle();
    let bar = if parts.iter().all(|(term, _)| term.is_grey()) {
        bar
    } else {
        let name = Rect::new(bar.x, bar.y, 12.0, bar.height);
        picture.text_in(
            name,
            channels::DRAWN[channel].letter,
            letter.ink(Ink::Muted),
        );
        Rect::new(name.right(), bar.y, bar.width - name.width, bar.height)
    };
    picture.rect(bar, Ink::Faint);
    let place = |intensity: f64| bar.x + (intensity / whole).clamp(0.0, 1.0) as f32 * bar.width;
    let mut sum = 0.0;
    for &(term, Term(ink, name, on_ink)) in parts {
        let start = place(sum);
        sum += term.channels()[channel];
        let part = Rect::between((start, bar.y), (place(sum), bar.bottom()));
        if part.width > 0.5 {
            picture.rect(part, ink.fill().outlined(Ink::Surface.stroke(0.5)));
        }
        if part.width >= 12.0 {
            picture.text_in(part, name, letter.ink(on_ink));
        }
    }
    picture.rect(bar, Ink::Rule.stroke(1.0));
}
