//! All values known at the step, or at the one that is selected: its own first, then those of the scopes around it from the innermost outwards, each with
//! where it was recorded. Of a name that several scopes record the innermost value is shown.

use super::message::{NO_STEPS, message};
use super::names;
use super::values::{self, sentence, shown};
use super::{PanelInput, Properties};
use crate::figure::Cell;
use crate::language::Message;
use crate::picture::{Ink, Picture, Rect, Style, Tag, elide};
use crate::record::{Field, Value};
use crate::replay::{RecordedField, Walk};
use crate::vocabulary::counted;
use glam::Vec2;

const MARGIN: f32 = 10.0;
const GAP: f32 = 14.0;
const LINE_HEIGHT: f32 = 1.6;
const LARGEST: f32 = 14.0;
const SMALLEST: f32 = 11.0;

pub const PANEL: Properties = Properties::titled(Message("app-inspector"));

pub fn draw(input: &PanelInput, size: Vec2) -> Picture {
    let walk = input.run.walk();
    if walk.is_empty() {
        return message(NO_STEPS, input.language, size);
    }
    let step = shown_step(input);
    let recorded = known(walk, step);
    let layout = Layout::of(&recorded, input, size);

    let mut picture = Picture::new(size.x, size.y);
    picture.alt = layout.in_words(&recorded, input);
    title(&mut picture, input, size);
    if recorded.is_empty() {
        let style = Style::Body.size(12.0).ink(Ink::Muted);
        let line = Rect::new(MARGIN, TITLE, size.x - 2.0 * MARGIN, 20.0);
        let nothing = Message("inspector-no-values").text(input.language);
        picture.text_in(line, nothing, style);
        return picture;
    }
    let room = layout.capacity(size);
    let (rows, more) = if layout.rows.len() <= room {
        (layout.rows.len(), 0)
    } else {
        (room.saturating_sub(1), layout.rows.len() + 1 - room)
    };
    for (i, row) in layout.rows.iter().take(rows).enumerate() {
        picture.tagged(Tag::Field(row.recorded.field.name), |picture| {
            layout.draw(picture, row, layout.place(i, size), walk.position());
        });
    }
    if more > 0 {
        let style = Style::Body.size(layout.size).ink(Ink::Muted);
        let count = more.to_string();
        let text = Message("inspector-more").format(input.language, &[("count", &count)]);
        picture.text_in(layout.place(rows, size), text, style);
    }
    picture
}

const TITLE: f32 = 30.0;

/// The selected step, unless a question waits and it lies ahead; else the one that is shown.
fn shown_step(input: &PanelInput) -> usize {
    let selected = input.selected.filter(|&step| step <= input.last_known());
    selected.unwrap_or(input.run.walk().position())
}

/// The kind of the step, its number and its depth; in blue where it is another one than is shown elsewhere.
fn title(picture: &mut Picture, input: &PanelInput, size: Vec2) {
    let walk = input.run.walk();
    let step = shown_step(input);
    let ink = match step == walk.position() {
        true => Ink::This,
        false => Ink::Linked,
    };
    let line = Rect::new(MARGIN, 6.0, size.x - 2.0 * MARGIN, 20.0);
    let place = Style::Body.size(12.0).ink(Ink::Muted).end();
    let [number, depth] = [step, walk.outline().depth(step)].map(|number| number.to_string());
    let long = Message("inspector-step-and-depth")
        .format(input.language, &[("step", &number), ("depth", &depth)]);
    let short = step_in_words(step, input);
    let name = names::kind(walk.kind(step), input.language);
    let kind = Style::Bold.size(14.0).ink(ink);
    let room = line.width - kind.width(&name) - GAP;
    let fits = place.width(&long) <= room;
    let text = if fits { long } else { short };
    let room = line.width - place.width(&text) - GAP;
    picture.tagged(Tag::Step(step), |picture| {
        picture.text_in(line, elide(&name, kind.style, kind.size, room), kind);
        picture.text_in(line, text, place);
    });
    let y = TITLE - 3.0;
    picture.line((MARGIN, y), (size.x - MARGIN, y), Ink::Rule.stroke(1.0));
}

/// What is known at `step`, each name once, the innermost first.
fn known(walk: &dyn Walk, step: usize) -> Vec<RecordedField> {
    let recorded = walk.recorded(step);
    let mut known: Vec<RecordedField> = Vec::new();
    for group in recorded.chunk_by(|a, b| a.step == b.step).rev() {
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

/// A value: its name, the value itself, and where it was recorded.
struct Known {
    recorded: RecordedField,
    cells: [String; 3],
}

impl Known {
    /// Set in text of `size` points; the step's own values stand out.
    fn cells(&self, size: f32, step: usize) -> [Cell; 3] {
        let own = self.recorded.step == step;
        let (style, ink, link) = match own {
            true => (Style::MonoBold, Ink::This, Ink::This),
            false => (Style::Mono, Ink::Text, Ink::Linked),
        };
        let [name, value, from] = self.cells.each_ref().map(String::as_str);
        let swatch = match self.recorded.field.value {
            Value::Rgb(color) => Some(Ink::Rgb(color)),
            _ => None,
        };
        [
            Cell::new(name, Style::Label.size(size).ink(Ink::Muted)),
            Cell::new(value, style.size(size).ink(ink)).swatch(swatch),
            Cell::new(from, Style::Body.size(size).ink(link)),
        ]
    }
}

/// The rows as they are written, and the widths of their columns.
struct Layout {
    rows: Vec<Known>,
    size: f32,
    /// Of names, values and origins.
    widths: [f32; 3],
    /// Columns of rows beside each other: a low, wide panel has several.
    columns: usize,
}

impl Layout {
    /// The largest text at which all rows fit, shorter forms only where the smallest text does not help; where no form
    /// lets all rows fit, the first of the smallest text that is not too wide.
    fn of(recorded: &[RecordedField], input: &PanelInput, size: Vec2) -> Self {
        /// Decimals, and whether an origin names its kind.
        const FORMS: [(usize, bool); 5] =
            [(4, true), (3, true), (3, false), (2, false), (1, false)];
        let steps = (2.0 * (LARGEST - SMALLEST)) as usize;
        let mut narrow = None;
        for (decimals, with_kind) in FORMS {
            let mut layout = Layout::with(recorded, input, decimals, with_kind);
            for i in 0..=steps {
                layout.set_size(LARGEST - 0.5 * i as f32, size);
                if layout.columns > 0 && layout.rows.len() <= layout.capacity(size) {
                    return layout;
                }
            }
            if layout.columns > 0 {
                narrow.get_or_insert(layout);
            }
        }
        narrow.unwrap_or_else(|| {
            let mut layout = Layout::with(recorded, input, 1, false);
            layout.set_size(SMALLEST, size);
            layout.columns = 1;
            // Long names are shortened; a longer value takes the place of its origin.
            let [name, value, from] = &mut layout.widths;
            let room = size.x - 2.0 * MARGIN - *from - 2.0 * GAP;
            *value = value.min(room - name.min(60.0));
            *name = room - *value;
            layout
        })
    }

    /// In the largest text.
    fn with(
        recorded: &[RecordedField],
        input: &PanelInput,
        decimals: usize,
        with_kind: bool,
    ) -> Self {
        let walk = input.run.walk();
        let prepared = input.run.prepared();
        let this_step = Message("inspector-this-step").text(input.language);
        let value = |field: Field| {
            let counted = counted(field.name, field.value);
            let value = shown(counted, decimals, input.language);
            match names::of_field(prepared, field.name, field.value, input.language) {
                Some(name) => format!("{value} · {name}"),
                None => value,
            }
        };
        let rows: Vec<Known> = recorded
            .iter()
            .map(|&recorded| Known {
                recorded,
                cells: [
                    walk.declared(recorded.step)
                        .quantity(recorded.field.name)
                        .map_or_else(
                            || recorded.field.name.to_string(),
                            |quantity| names::quantity(quantity, input.language),
                        ),
                    value(recorded.field),
                    match (recorded.step == walk.position(), with_kind) {
                        (true, _) => this_step.to_string(),
                        (false, true) => {
                            let kind = names::kind(walk.kind(recorded.step), input.language);
                            names::numbered(&kind, &recorded.step.to_string(), input.language)
                        }
                        (false, false) => step_in_words(recorded.step, input),
                    },
                ],
            })
            .collect();
        let cells = |row: &Known| row.cells(LARGEST, walk.position()).map(|cell| cell.width());
        let widest = |all: [f32; 3], row: [f32; 3]| std::array::from_fn(|i| all[i].max(row[i]));
        Layout {
            widths: rows.iter().map(cells).fold([0.0; 3], widest),
            rows,
            size: LARGEST,
            columns: 0,
        }
    }

    /// Scales the columns to a size of text, and says how many stand beside each other in a panel of `size`.
    fn set_size(&mut self, text: f32, size: Vec2) {
        let factor = text / self.size;
        self.size = text;
        self.widths = self.widths.map(|width| factor * width);
        let column = self.widths.iter().sum::<f32>() + 2.0 * GAP;
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

    fn draw(&self, picture: &mut Picture, row: &Known, place: Rect, step: usize) {
        let [name, value, from] = row.cells(self.size, step);
        name.draw(
            picture,
            Rect {
                width: self.widths[0],
                ..place
            },
        );
        let start = place.x + self.widths[0] + GAP;
        let end = value.draw(picture, Rect::between((start, place.y), place.max()));
        // A long value takes the place of its origin.
        let x = start + self.widths[1] + GAP;
        if x >= end {
            picture.tagged(Tag::Step(row.recorded.step), |picture| {
                from.draw(picture, Rect::between((x, place.y), place.max()));
            });
        }
    }

    /// The step with its own values.
    fn in_words(&self, recorded: &[RecordedField], input: &PanelInput) -> String {
        let walk = input.run.walk();
        let step = shown_step(input);
        let heading = match input.selected {
            Some(_) => {
                let kind = names::kind(walk.kind(step), input.language);
                names::numbered(&kind, &step.to_string(), input.language)
            }
            None => values::step_in_words(input),
        };
        let own: Vec<String> = recorded
            .iter()
            .filter(|recorded| recorded.step == step)
            .map(|recorded| {
                let Field { name, value } = recorded.field;
                let value = shown(counted(name, value), 4, input.language);
                let name = names::field(name, input.language);
                format!("{name} = {value}")
            })
            .collect();
        sentence(&heading, &own, input.language)
    }
}

fn step_in_words(step: usize, input: &PanelInput) -> String {
    Message("inspector-step").format(input.language, &[("step", &step.to_string())])
}

#[cfg(test)]
mod tests;
