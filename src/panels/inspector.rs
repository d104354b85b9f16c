//! All values known at the step: its own first, then those of the scopes around it from the innermost outwards, each with
//! where it was told. A name that several scopes tell is shown once: the inner one holds.

use super::Show;
use super::message::{NO_STEPS, message};
use super::names;
use super::values::shown;
use super::words::Words;
use crate::picture::{Ink, Picture, Rect, Style, Tag, elide, measure, symbol};
use crate::record::{Field, Value};
use crate::replay::{Told, Walk};
use glam::Vec2;

const MARGIN: f32 = 10.0;
const GAP: f32 = 14.0;
const LINE_HEIGHT: f32 = 1.6;
/// Room for a swatch, in sizes of the text.
const SWATCH: f32 = 1.4;
const LARGEST: f32 = 14.0;
const SMALLEST: f32 = 11.0;

const STEP: Words = Words::new("step", "langkah");
const DEPTH: Words = Words::new("depth", "kedalaman");
const THIS_STEP: Words = Words::new("this step", "langkah ini");
const MORE: Words = Words::new("more", "lagi");
const NO_VALUES: Words = Words::new(
    "This step tells no values.",
    "Langkah ini tidak memuat nilai.",
);

pub fn draw(show: &Show, size: Vec2) -> Picture {
    let walk = show.run.walk();
    if walk.is_empty() {
        return message(NO_STEPS, show.language, size);
    }
    let step = walk.position();
    let told = known(walk, step);
    let sheet = Sheet::of(&told, show, size);

    let mut picture = Picture::new(size.x, size.y);
    picture.alt = sheet.in_words(&told, show);
    title(&mut picture, show, size);
    if told.is_empty() {
        let style = Style::Body.size(12.0).ink(Ink::Muted);
        let line = Rect::new(MARGIN, TITLE, size.x - 2.0 * MARGIN, 20.0);
        picture.text_in(line, NO_VALUES.in_language(show.language), style);
        return picture;
    }
    let room = sheet.capacity(size);
    let (rows, more) = if sheet.rows.len() <= room {
        (sheet.rows.len(), 0)
    } else {
        (room.saturating_sub(1), sheet.rows.len() + 1 - room)
    };
    for (i, row) in sheet.rows.iter().take(rows).enumerate() {
        picture.tagged(Tag::Field(row.told.field.name), |picture| {
            sheet.draw(picture, row, sheet.place(i, size), step);
        });
    }
    if more > 0 {
        let style = Style::Body.size(sheet.size).ink(Ink::Muted);
        let text = format!("… {more} {}", MORE.in_language(show.language));
        picture.text_in(sheet.place(rows, size), text, style);
    }
    picture
}

const TITLE: f32 = 30.0;

/// The kind of the step, its number and its depth.
fn title(picture: &mut Picture, show: &Show, size: Vec2) {
    let walk = show.run.walk();
    let step = walk.position();
    let line = Rect::new(MARGIN, 6.0, size.x - 2.0 * MARGIN, 20.0);
    let words = |words: Words| words.in_language(show.language);
    let place = Style::Body.size(12.0).ink(Ink::Muted).end();
    let long = format!(
        "{} {} · {} {}",
        words(STEP),
        step,
        words(DEPTH),
        walk.outline().depth(step)
    );
    let short = format!("{} {}", words(STEP), step);
    let kind = Style::Bold.size(14.0).ink(Ink::This);
    let room = line.width - kind.width(walk.kind(step)) - GAP;
    let text = if place.width(&long) <= room {
        long
    } else {
        short
    };
    picture.tagged(Tag::Step(step), |picture| {
        picture.text_in(line, walk.kind(step), kind);
        picture.text_in(line, text, place);
    });
    let y = TITLE - 3.0;
    picture.line((MARGIN, y), (size.x - MARGIN, y), Ink::Rule.stroke(1.0));
}

/// What is known at `step`, each name once, the latest teller first.
fn known(walk: &dyn Walk, step: usize) -> Vec<Told> {
    let told = walk.told(step);
    let mut known: Vec<Told> = Vec::new();
    for group in told.chunk_by(|a, b| a.step == b.step).rev() {
        for &value in group {
            if known
                .iter()
                .all(|inner| inner.field.name != value.field.name)
            {
                known.push(value);
            }
        }
    }
    known
}

struct Row {
    told: Told,
    name: String,
    value: String,
    from: String,
}

/// The rows as they are written, and the widths of their columns.
struct Sheet {
    rows: Vec<Row>,
    size: f32,
    name: f32,
    value: f32,
    from: f32,
    /// Columns of rows beside each other: a low, wide panel has several.
    columns: usize,
}

impl Sheet {
    /// The largest text at which all rows fit, shorter forms only where the smallest text does not help; where no form
    /// lets all rows fit, the first of the smallest text that is not too wide.
    fn of(told: &[Told], show: &Show, size: Vec2) -> Self {
        /// Decimals, and whether an origin names its kind.
        const FORMS: [(usize, bool); 5] =
            [(4, true), (3, true), (3, false), (2, false), (1, false)];
        let steps = (2.0 * (LARGEST - SMALLEST)) as usize;
        let mut narrow = None;
        for (decimals, with_kind) in FORMS {
            let mut sheet = Sheet::with(told, show, decimals, with_kind);
            for i in 0..=steps {
                sheet.set_size(LARGEST - 0.5 * i as f32, size);
                if sheet.columns > 0 && sheet.rows.len() <= sheet.capacity(size) {
                    return sheet;
                }
            }
            if sheet.columns > 0 {
                narrow.get_or_insert(sheet);
            }
        }
        narrow.unwrap_or_else(|| {
            let mut sheet = Sheet::with(told, show, 1, false);
            sheet.set_size(SMALLEST, size);
            sheet.columns = 1;
            // Long names are shortened; a longer value takes the place of its origin.
            let room = size.x - 2.0 * MARGIN - sheet.from - 2.0 * GAP;
            sheet.value = sheet.value.min(room - sheet.name.min(60.0));
            sheet.name = room - sheet.value;
            sheet
        })
    }

    /// The widths are in sizes of the text until it has one.
    fn with(told: &[Told], show: &Show, decimals: usize, with_kind: bool) -> Self {
        let walk = show.run.walk();
        let words = |words: Words| words.in_language(show.language);
        let stage = names::stage(show.run);
        let value = |field: Field| {
            let value = shown(field.value, decimals, show.language);
            match names::of_field(stage, field.name, field.value, show.language) {
                Some(name) => format!("{value} · {name}"),
                None => value,
            }
        };
        let rows: Vec<Row> = told
            .iter()
            .map(|&told| Row {
                told,
                name: symbol(told.field.name),
                value: value(told.field),
                from: match (told.step == walk.position(), with_kind) {
                    (true, _) => words(THIS_STEP).to_string(),
                    (false, true) => format!("{} {}", walk.kind(told.step), told.step),
                    (false, false) => format!("{} {}", words(STEP), told.step),
                },
            })
            .collect();
        let widest = |width: &dyn Fn(&Row) -> f32| rows.iter().map(width).fold(0.0, f32::max);
        let name = widest(&|row| measure(&row.name, Style::Label, 1.0));
        let value = widest(&|row| {
            let swatch = if swatch(row).is_some() { SWATCH } else { 0.0 };
            swatch + measure(&row.value, Style::Mono, 1.0)
        });
        let from = widest(&|row| measure(&row.from, Style::Body, 1.0));
        Sheet {
            rows,
            size: 1.0,
            name,
            value,
            from,
            columns: 0,
        }
    }

    /// Scales the columns to a size of text, and says how many stand beside each other in a panel of `size`.
    fn set_size(&mut self, text: f32, size: Vec2) {
        let factor = text / self.size;
        for width in [
            &mut self.size,
            &mut self.name,
            &mut self.value,
            &mut self.from,
        ] {
            *width *= factor;
        }
        let column = self.name + self.value + self.from + 2.0 * GAP;
        self.columns = ((size.x - 2.0 * MARGIN + 2.0 * GAP) / (column + 2.0 * GAP)) as usize;
    }

    /// How many rows fit.
    fn capacity(&self, size: Vec2) -> usize {
        self.columns * self.rows_a_column(size)
    }

    fn rows_a_column(&self, size: Vec2) -> usize {
        ((size.y - TITLE - 4.0) / (LINE_HEIGHT * self.size)).max(1.0) as usize
    }

    /// The place of the `i`-th row.
    fn place(&self, i: usize, size: Vec2) -> Rect {
        let rows = self.rows_a_column(size);
        let height = LINE_HEIGHT * self.size;
        let column = (size.x - 2.0 * MARGIN + 2.0 * GAP) / self.columns as f32;
        Rect::new(
            MARGIN + (i / rows) as f32 * column,
            TITLE + (i % rows) as f32 * height,
            column - 2.0 * GAP,
            height,
        )
    }

    fn draw(&self, picture: &mut Picture, row: &Row, place: Rect, step: usize) {
        let own = row.told.step == step;
        let name = elide(&row.name, Style::Label, self.size, self.name);
        picture.text_in(place, name, Style::Label.size(self.size).ink(Ink::Muted));

        let mut x = place.x + self.name + GAP;
        if let Some(color) = swatch(row) {
            let side = (0.85 * self.size).round();
            let swatch = Rect::new(x, place.center().y - 0.5 * side, side, side);
            picture.rect(swatch, color.fill().outlined(Ink::Rule.stroke(1.0)));
            x += SWATCH * self.size;
        }
        let style = if own { Style::MonoBold } else { Style::Mono };
        let ink = if own { Ink::This } else { Ink::Text };
        let value = elide(&row.value, style, self.size, place.right() - x);
        let end = x + measure(&value, style, self.size);
        picture.text_in(Rect { x, ..place }, value, style.size(self.size).ink(ink));

        let x = place.x + self.name + self.value + 2.0 * GAP;
        if x < end {
            return;
        }
        let ink = if own { Ink::This } else { Ink::Linked };
        picture.tagged(Tag::Step(row.told.step), |picture| {
            let from = Style::Body.size(self.size).ink(ink);
            picture.text_in(Rect { x, ..place }, row.from.as_str(), from);
        });
    }

    /// The step with its own values.
    fn in_words(&self, told: &[Told], show: &Show) -> String {
        let walk = show.run.walk();
        let step = walk.position();
        let own: Vec<String> = told
            .iter()
            .filter(|told| told.step == step)
            .map(|told| {
                let value = shown(told.field.value, 4, show.language);
                format!("{} = {value}", told.field.name)
            })
            .collect();
        let head = format!(
            "{} {}, {}",
            STEP.in_language(show.language),
            step,
            walk.kind(step)
        );
        if own.is_empty() {
            format!("{head}.")
        } else {
            format!("{head}: {}.", own.join(", "))
        }
    }
}

fn swatch(row: &Row) -> Option<Ink> {
    match row.told.field.value {
        Value::Rgb(color) => Some(Ink::Rgb(color)),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::super::crowd::{self, SIZES, assert_legible, texts};
    use super::super::words::Language;
    use super::*;
    use crate::render::Method;

    #[test]
    fn every_step_is_legible_at_every_size() {
        for method in Method::ALL {
            let mut sample = crowd::crowd(method);
            for step in sample.some_steps(997) {
                sample.seek(step);
                for size in SIZES {
                    for language in Language::ALL {
                        let picture = draw(&sample.show_in(language), size);
                        let what = format!("{} {step} at {size}", sample.walk().kind(step));
                        assert_legible(&picture, &what);
                    }
                }
            }
        }
    }

    #[test]
    fn all_names_are_there_once_or_counted_as_more() {
        let mut sample = crowd::crowd(Method::Gouraud);
        for step in sample.some_steps(997) {
            sample.seek(step);
            let names = known(sample.walk(), step);
            for size in SIZES {
                let picture = draw(&sample.show(), size);
                let more = texts(&picture).into_iter().find_map(|(text, _)| {
                    let count = text.strip_prefix("… ")?.strip_suffix(" more")?;
                    count.parse::<usize>().ok()
                });
                let mut rows: Vec<&str> = picture
                    .items
                    .iter()
                    .filter_map(|item| match item.tag {
                        Some(Tag::Field(name)) => Some(name),
                        _ => None,
                    })
                    .collect();
                rows.dedup();
                assert_eq!(
                    rows.len() + more.unwrap_or(0),
                    names.len(),
                    "{step} at {size}"
                );
            }
        }
    }

    #[test]
    fn the_inner_word_holds_and_own_values_come_first() {
        let mut sample = crowd::crowd(Method::Gouraud);
        let step = sample.first("EdgeInterpolated");
        let known = known(sample.seek(step).walk(), step);
        assert_eq!(known[0].field.name, "I_4");
        assert_eq!(known[0].step, step);
        let fields = sample.walk().fields(step);
        for told in &known {
            assert_eq!(fields.get(told.field.name), Some(told.field.value));
        }
    }

    #[test]
    fn objects_and_lights_are_called_by_their_names() {
        let mut sample = crowd::rays(Method::RayTracing, 1);
        sample.go_to("BetweenTested", 0);
        let picture = draw(&sample.show(), SIZES[5]);
        for value in ["0 · floor", "0 · point light"] {
            assert!(
                texts(&picture).iter().any(|(text, _)| *text == value),
                "{value}"
            );
        }
    }

    #[test]
    fn nothing_recorded_is_said() {
        let sample = crowd::nothing();
        for language in Language::ALL {
            assert_legible(&draw(&sample.show_in(language), SIZES[0]), "empty");
        }
    }
}
