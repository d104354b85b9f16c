//! The edge table of the current polygon: which edges are active on the scan line, where it cuts them, and the values there.

mod columns;

use super::message::{NO_POLYGONS, message};
use super::values::step_as_sentence;
use super::{PanelInput, Properties};
use crate::figure::Cell;
use crate::language::{Language, Message};
use crate::picture::{Ink, Picture, Rect, Style, Tag, Text};
use crate::record::Value;
use crate::replay::shading::{ActiveEdge, State};
use crate::replay::{Run, Walk};
use columns::{Column, columns, place};
use glam::Vec2;

const SIZE: f32 = 12.5;
const ROW: f32 = 24.0;
const MARGIN: f32 = 8.0;
/// What the square that shows a colour takes.
const SWATCH: f32 = 17.0;

const NO_EDGES: Message = Message("active-edges-no-edges");
const NO_TABLE: Message = Message("active-edges-no-table");
const EDGE: Message = Message("active-edges-edge");
const FROM: Message = Message("active-edges-from");
const TO: Message = Message("active-edges-to");
const A_LINE: Message = Message("active-edges-a-line");
const WAITS: Message = Message("active-edges-waits");
const DONE: Message = Message("active-edges-done");
const MORE: Message = Message("inspector-more");

pub const PANEL: Properties = Properties::titled(Message("app-active-edges"));

pub fn draw(input: &PanelInput, size: Vec2) -> Picture {
    let mut picture = match input.run {
        Run::Shading(_, replay) => table(input, replay.state(), size),
        Run::Wireframe(_) => message(NO_TABLE, input.language, size),
        Run::Rays(..) | Run::Radiosity(..) | Run::FormFactor(..) | Run::Hierarchical(..) => {
            message(NO_POLYGONS, input.language, size)
        }
    };
    picture.alt = format!("{} {}", step_as_sentence(input), picture.alt);
    picture
}

#[derive(Clone, Copy, PartialEq, Debug)]
enum Turn {
    Waits,
    Active,
    Done,
}

/// A row of the table, written out.
struct Row {
    number: usize,
    turn: Turn,
    current: bool,
    /// The value where the scan line cuts the edge.
    color: Option<Value>,
    /// In the order of [`columns::ORDER`].
    cells: [String; 7],
}

fn table(input: &PanelInput, state: &State, size: Vec2) -> Picture {
    if state.edges.is_empty() {
        return message(NO_EDGES, input.language, size);
    }
    let y = current_row(input.run.walk(), state);
    let rows: Vec<Row> = state
        .edges
        .iter()
        .enumerate()
        .map(|(index, edge)| row(edge, y, state.edge == Some(index), input.language))
        .collect();
    let titles = titles(state, input.language);
    let columns = columns(&titles, &rows, size.x - 2.0 * MARGIN);
    let mut picture = Picture::new(size.x, size.y);

    let header = Style::Label.size(12.0).ink(Ink::Muted);
    for &(column, right, width) in &columns {
        let cell = Rect::new(right - width, 4.0, width, ROW);
        let title = &titles[place(column)];
        let set = if column == Column::Edge {
            header
        } else {
            header.end()
        };
        picture.text_in(cell, title.clone(), set);
    }
    picture.line(
        (MARGIN, ROW + 4.0),
        (size.x - MARGIN, ROW + 4.0),
        Ink::Rule.stroke(1.0),
    );

    let room = ((size.y - ROW - 8.0) / ROW).floor().max(1.0) as usize;
    let (first, count) = window(&rows, room);
    for (i, row) in rows[first..first + count].iter().enumerate() {
        let top = ROW + 6.0 + i as f32 * ROW;
        let area = Rect::new(2.0, top, size.x - 4.0, ROW - 2.0);
        picture.tagged(Tag::Edge(row.number), |picture| {
            draw_row(picture, row, &columns, area, input.language);
        });
    }
    if count < rows.len() {
        let area = Rect::new(
            MARGIN,
            ROW + 6.0 + count as f32 * ROW,
            size.x - 2.0 * MARGIN,
            ROW,
        );
        let more = (rows.len() - count).to_string();
        let text = MORE.format(input.language, &[("count", &more)]);
        if area.bottom() <= size.y {
            picture.text_in(area, text, Style::Body.size(12.0).ink(Ink::Muted));
        }
    }
    let active = rows.iter().filter(|row| row.turn == Turn::Active);
    let names: Vec<&str> = active.map(|row| row.cells[0].as_str()).collect();
    picture.alt = names.join(", ");
    picture
}

/// The current scan line; while it is being closed, that one still.
fn current_row(walk: &dyn Walk, state: &State) -> Option<u32> {
    let recorded = || match walk.fields(walk.position()).get("y") {
        Some(Value::Integer(y)) => u32::try_from(y).ok(),
        _ => None,
    };
    state.scan_line.map(|row| row.y).or_else(recorded)
}

fn row(edge: &ActiveEdge, y: Option<u32>, current: bool, language: Language) -> Row {
    let turn = match y {
        Some(y) if y >= edge.end => Turn::Done,
        Some(y) if y >= edge.first => Turn::Active,
        _ => Turn::Waits,
    };
    let cut = edge.cut.as_ref();
    let value = cut
        .and_then(|cut| cut.values)
        .map(|values| values.incremental);
    let yet = match turn {
        Turn::Waits => WAITS.text(language),
        Turn::Done => DONE.text(language),
        Turn::Active => "–",
    };
    let step = edge.value_step;
    let numbers = |value| numbers(value, 3, language);
    Row {
        number: edge.edge as usize,
        turn,
        current,
        color: value,
        cells: [
            format!("{}–{}", edge.upper + 1, edge.lower + 1),
            edge.first.to_string(),
            (edge.end - 1).to_string(),
            cut.map_or(yet.to_string(), |cut| language.fixed(cut.x_4, 2)),
            value.map_or_else(String::new, numbers),
            step.map_or_else(String::new, |step| a_line(step, language)),
            language.fixed(edge.slope, 3),
        ],
    }
}

/// What a value grows by from line to line: over many lines too little for a fixed number of decimals.
fn a_line(step: Value, language: Language) -> String {
    match step {
        Value::Rgb(color) if color.is_grey() => language.significant(color.r, 3),
        step => numbers(step, 3, language),
    }
}

/// A grey as one number, another colour and a vector as three.
fn numbers(value: Value, digits: usize, language: Language) -> String {
    match value {
        Value::Vector(vector) => vector
            .to_array()
            .map(|v| language.fixed(v, digits))
            .join(" "),
        Value::Rgb(color) if !color.is_grey() => color
            .channels()
            .map(|channel| language.fixed(channel, digits))
            .join(" "),
        Value::Rgb(color) => language.fixed(color.r, digits),
        value => super::values::short(value, digits, language),
    }
}

fn titles(state: &State, language: Language) -> [String; 7] {
    let symbol = state.names.map_or("", |names| names.corner);
    let step = match symbol {
        "" => String::new(),
        name => A_LINE.format(language, &[("value", name)]),
    };
    [
        EDGE.text(language).to_string(),
        FROM.text(language).to_string(),
        TO.text(language).to_string(),
        "x".to_string(),
        symbol.to_string(),
        step,
        "Δx/Δy".to_string(),
    ]
}

/// Which rows are shown: all, or as many as fit around the active ones, with a line left for what is left out.
fn window(rows: &[Row], room: usize) -> (usize, usize) {
    if rows.len() <= room {
        return (0, rows.len());
    }
    let count = (room - 1).max(1);
    let wanted = rows.iter().position(|row| row.current);
    let wanted = wanted.or(rows.iter().position(|row| row.turn == Turn::Active));
    let first = wanted.unwrap_or(0).saturating_sub(count / 2);
    (first.min(rows.len() - count), count)
}

fn draw_row(
    picture: &mut Picture,
    row: &Row,
    columns: &[(Column, f32, f32)],
    area: Rect,
    language: Language,
) {
    let set = match row.turn {
        Turn::Active if row.current => Style::MonoBold.size(SIZE).ink(Ink::This),
        Turn::Active => Style::MonoBold.size(SIZE),
        Turn::Waits | Turn::Done => Style::Mono.size(SIZE).ink(Ink::Muted),
    };
    if row.current {
        let paint = Ink::ThisTint.fill().outlined(Ink::This.stroke(1.5));
        picture.rounded_rect(area, 4.0, paint);
    } else if row.turn == Turn::Active {
        picture.rounded_rect(area, 4.0, Ink::LinkedTint.fill().opacity(0.6));
    } else {
        picture.rect(area, Ink::Surface);
    }
    for &(column, right, width) in columns {
        let text = &row.cells[place(column)];
        let strings = [WAITS, DONE].map(|strings| strings.text(language));
        let set = match column {
            Column::Edge => set,
            _ if strings.contains(&text.as_str()) => in_body(set).end(),
            _ => set.end(),
        };
        let swatch = match row.color {
            Some(Value::Rgb(color)) if column == Column::Value => Some(Ink::Rgb(color)),
            _ => None,
        };
        let cell = Rect::new(right - width, area.y, width, area.height);
        Cell::new(text.as_str(), set)
            .swatch(swatch)
            .draw(picture, cell);
    }
}

/// Message among numbers: set as words.
fn in_body(set: Text) -> Text {
    Text {
        style: Style::Body,
        size: 12.0,
        ..set
    }
}

#[cfg(test)]
mod tests {
    use super::super::fixture::Fixture;
    use super::super::fixtures::{SIZES, assert_legible, fixtures, nothing, texts};
    use super::*;
    use crate::color::Rgb;
    use crate::render::Method;

    #[test]
    fn numbers_are_those_of_the_event() {
        let mut fixture = Fixture::triangle(Method::Gouraud);
        fixture.go_to("EdgeInterpolated", 20);
        let walk = fixture.run.walk();
        let recorded = walk.fields(walk.position());
        let picture = draw(&fixture.input(), Vec2::new(600.0, 200.0));
        let texts = texts(&picture);
        let shown = |text: &str| texts.iter().any(|(shown, _)| *shown == text);
        let Some(Value::Number(x_4)) = recorded.get("x_4") else {
            panic!("an edge has x_4")
        };
        assert!(shown(&Language::English.fixed(x_4, 2)));
        assert!(shown(&numbers(
            recorded.get("I_4_incremental").unwrap(),
            3,
            Language::English
        )));
        let (Some(Value::Integer(upper)), Some(Value::Integer(lower))) =
            (recorded.get("upper"), recorded.get("lower"))
        else {
            panic!("an edge has its ends")
        };
        assert!(shown(&format!("{}–{}", upper + 1, lower + 1)));
        assert!(picture.alt.contains("Edge interpolated"));
    }

    #[test]
    fn what_grows_little_from_line_to_line_is_not_written_as_nothing() {
        let step = |grey| a_line(Rgb::splat(grey).into(), Language::English);
        assert_eq!(step(0.0006357), "0.000636");
        assert_eq!(step(-0.25), "−0.25");
    }

    #[test]
    fn a_row_answers_with_its_edge_and_edges_take_turns() {
        let mut fixture = Fixture::triangle(Method::Flat);
        fixture.go_to("EdgeCut", 0);
        let picture = draw(&fixture.input(), Vec2::new(420.0, 200.0));
        let row = |n: f32| (60.0, ROW + 6.0 + (n + 0.5) * ROW);
        assert_eq!(picture.hit(row(0.0)), Some(Tag::Edge(0)));
        assert_eq!(picture.hit(row(2.0)), Some(Tag::Edge(2)));
        let strings = |fixture: &Fixture| -> Vec<String> {
            let picture = draw(&fixture.input(), Vec2::new(420.0, 200.0));
            let texts = texts(&picture);
            texts
                .into_iter()
                .map(|(text, _)| text.to_string())
                .collect()
        };
        assert!(strings(&fixture).contains(&"waits".to_string()));
        let last = fixture.run.walk().len() - 3;
        fixture.run.walk_mut().seek(last);
        assert!(strings(&fixture).contains(&"done".to_string()));
    }

    #[test]
    fn nothing_is_cut_at_any_size() {
        for mut fixture in [
            Fixture::triangle(Method::Gouraud),
            fixtures(Method::Gouraud),
            fixtures(Method::Phong),
            fixtures(Method::Flat),
            fixtures(Method::Wireframe),
            nothing(),
        ] {
            for step in (0..fixture.run.walk().len().max(1)).step_by(23) {
                fixture.run.walk_mut().seek(step);
                for size in SIZES {
                    for language in Language::ALL {
                        let input = PanelInput {
                            language,
                            ..fixture.input()
                        };
                        assert_legible(&draw(&input, size), &format!("step {step} at {size}"));
                    }
                }
            }
        }
    }
}
