//! The edge table of the polygon in hand: which edges are active on the scan line, where it cuts them, what they carry there.

mod columns;

use super::Show;
use super::message::{NO_POLYGONS, message};
use super::values::{told_in_words, value_of};
use super::words::{Language, Words};
use crate::algorithms::scan_line::Carried;
use crate::picture::{Ink, Picture, Rect, Style, Tag, Text, fixed};
use crate::record::Value;
use crate::replay::shading::{EdgeInHand, State};
use crate::replay::{Run, Walk};
use columns::{Column, columns, place};
use glam::Vec2;

const SIZE: f32 = 12.5;
const ROW: f32 = 24.0;
const MARGIN: f32 = 8.0;
/// Side of the square that shows a colour.
const SWATCH: f32 = 11.0;

const NO_EDGES: Words = Words::new(
    "No edge table is at hand at this step: each polygon builds its own. There each edge gets a row, and the active ones stand out.",
    "Pada langkah ini tidak ada tabel sisi: setiap poligon membuat tabelnya sendiri. Di sana setiap sisi mendapat satu baris, dan sisi aktif ditonjolkan.",
);
const NO_TABLE: Words = Words::new(
    "A wireframe needs no edge table: its edges are drawn one by one. Open a flat or Gouraud lesson to see one.",
    "Rangka kawat tidak memerlukan tabel sisi: sisinya digambar satu per satu. Buka pelajaran datar atau Gouraud.",
);
const EDGE: Words = Words::new("edge", "sisi");
const FROM: Words = Words::new("y from", "y dari");
const TO: Words = Words::new("y to", "y sampai");
const A_LINE: Words = Words::new("line", "baris");
const WAITS: Words = Words::new("waits", "menunggu");
const DONE: Words = Words::new("done", "selesai");
const MORE: Words = Words::new("more", "lagi");

pub fn draw(show: &Show, size: Vec2) -> Picture {
    let mut picture = match show.run {
        Run::Gouraud(replay) => table(show, replay.state(), size),
        Run::Phong(replay) => table(show, replay.state(), size),
        Run::FastPhong(replay) => table(show, replay.state(), size),
        Run::Exact(replay) => table(show, replay.state(), size),
        Run::Flat(replay) => table(show, replay.state(), size),
        Run::Wireframe(_) => message(NO_TABLE, show.language, size),
        Run::RayCasting(_) | Run::RayTracing(_) | Run::Radiosity(..) | Run::FormFactor(..) => {
            message(NO_POLYGONS, show.language, size)
        }
    };
    picture.alt = format!("{} {}", told_in_words(show), picture.alt);
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
    in_hand: bool,
    /// What is carried where the scan line cuts the edge.
    color: Option<Value>,
    /// In the order of [`columns::ORDER`].
    cells: [String; 7],
}

fn table<A: Carried>(show: &Show, state: &State<A>, size: Vec2) -> Picture {
    if state.edges.is_empty() {
        return message(NO_EDGES, show.language, size);
    }
    let y = row_in_hand(show.run.walk(), state);
    let rows: Vec<Row> = state
        .edges
        .iter()
        .enumerate()
        .map(|(index, edge)| row(edge, y, state.edge == Some(index), show.language))
        .collect();
    let titles = titles::<A>(show.language);
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
            draw_row(picture, row, &columns, area, show.language);
        });
    }
    if count < rows.len() {
        let area = Rect::new(
            MARGIN,
            ROW + 6.0 + count as f32 * ROW,
            size.x - 2.0 * MARGIN,
            ROW,
        );
        let text = format!(
            "… {} {}",
            rows.len() - count,
            MORE.in_language(show.language)
        );
        if area.bottom() <= size.y {
            picture.text_in(area, text, Style::Body.size(12.0).ink(Ink::Muted));
        }
    }
    let active = rows.iter().filter(|row| row.turn == Turn::Active);
    let names: Vec<&str> = active.map(|row| row.cells[0].as_str()).collect();
    picture.alt = names.join(", ");
    picture
}

/// The scan line in hand; as it is left, the one that was.
fn row_in_hand<A>(walk: &dyn Walk, state: &State<A>) -> Option<u32> {
    let told = || match walk.fields(walk.position()).get("y") {
        Some(Value::Integer(y)) => u32::try_from(y).ok(),
        _ => None,
    };
    state.scan_line.map(|row| row.y).or_else(told)
}

fn row<A: Carried>(edge: &EdgeInHand<A>, y: Option<u32>, in_hand: bool, language: Language) -> Row {
    let turn = match y {
        Some(y) if y >= edge.end => Turn::Done,
        Some(y) if y >= edge.first => Turn::Active,
        _ => Turn::Waits,
    };
    let cut = edge.cut.as_ref();
    let carried = cut
        .and_then(|cut| cut.values)
        .and_then(|(_, incremental)| value_of(incremental));
    let yet = match turn {
        Turn::Waits => WAITS.in_language(language),
        Turn::Done => DONE.in_language(language),
        Turn::Active => "–",
    };
    let step = value_of(edge.value_step);
    let numbers = |value| numbers(value, 3);
    Row {
        number: edge.edge as usize,
        turn,
        in_hand,
        color: carried,
        cells: [
            format!("{}–{}", edge.upper + 1, edge.lower + 1),
            edge.first.to_string(),
            (edge.end - 1).to_string(),
            cut.map_or(yet.to_string(), |cut| fixed(cut.x_4, 2)),
            carried.map_or_else(String::new, numbers),
            step.map_or_else(String::new, numbers),
            fixed(edge.slope, 3),
        ],
    }
}

/// A grey as one number, another colour and a vector as three.
fn numbers(value: Value, digits: usize) -> String {
    match value {
        Value::Vector(vector) => vector.to_array().map(|v| fixed(v, digits)).join(" "),
        Value::Rgb(color) if !color.is_grey() => color
            .channels()
            .map(|channel| fixed(channel, digits))
            .join(" "),
        Value::Rgb(color) => fixed(color.r, digits),
        value => super::values::short(value, digits),
    }
}

fn titles<A: Carried>(language: Language) -> [String; 7] {
    let carried = A::NAMES.map_or("", |names| names.corner);
    let step = match carried {
        "" => String::new(),
        name => format!("Δ{name}/{}", A_LINE.in_language(language)),
    };
    [
        EDGE.in_language(language).to_string(),
        FROM.in_language(language).to_string(),
        TO.in_language(language).to_string(),
        "x".to_string(),
        carried.to_string(),
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
    let wanted = rows.iter().position(|row| row.in_hand);
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
        Turn::Active if row.in_hand => Style::MonoBold.size(SIZE).ink(Ink::This),
        Turn::Active => Style::MonoBold.size(SIZE),
        Turn::Waits | Turn::Done => Style::Mono.size(SIZE).ink(Ink::Muted),
    };
    if row.in_hand {
        let paint = Ink::ThisTint.fill().outlined(Ink::This.stroke(1.5));
        picture.rounded_rect(area, 4.0, paint);
    } else if row.turn == Turn::Active {
        picture.rounded_rect(area, 4.0, Ink::LinkedTint.fill().opacity(0.6));
    } else {
        picture.rect(area, Ink::Surface);
    }
    for &(column, right, width) in columns {
        let cell = Rect::new(right - width, area.y, width, area.height);
        let text = &row.cells[place(column)];
        let words = [WAITS, DONE].map(|words| words.in_language(language));
        let set = match column {
            Column::Edge => set,
            _ if words.contains(&text.as_str()) => in_body(set).end(),
            _ => set.end(),
        };
        picture.text_in(cell, text.clone(), set);
        if column == Column::Value
            && let Some(Value::Rgb(color)) = row.color
        {
            let top = area.center().y - 0.5 * SWATCH;
            let paint = Ink::Rgb(color).fill().outlined(Ink::Rule.stroke(1.0));
            picture.rect(Rect::new(cell.x, top, SWATCH, SWATCH), paint);
        }
    }
}

/// Words among numbers: set as words.
fn in_body(set: Text) -> Text {
    Text {
        style: Style::Body,
        size: 12.0,
        ..set
    }
}

#[cfg(test)]
mod tests {
    use super::super::crowd::{SIZES, assert_legible, crowd, nothing, texts};
    use super::super::sample::Sample;
    use super::*;
    use crate::render::Method;

    #[test]
    fn numbers_are_those_of_the_event() {
        let mut sample = Sample::triangle(Method::Gouraud);
        sample.go_to("EdgeInterpolated", 20);
        let walk = sample.run.walk();
        let told = walk.fields(walk.position());
        let picture = draw(&sample.show(), Vec2::new(600.0, 200.0));
        let texts = texts(&picture);
        let shown = |text: &str| texts.iter().any(|(shown, _)| *shown == text);
        let Some(Value::Number(x_4)) = told.get("x_4") else {
            panic!("an edge tells x_4")
        };
        assert!(shown(&fixed(x_4, 2)));
        assert!(shown(&numbers(told.get("I_4_incremental").unwrap(), 3)));
        let (Some(Value::Integer(upper)), Some(Value::Integer(lower))) =
            (told.get("upper"), told.get("lower"))
        else {
            panic!("an edge tells its ends")
        };
        assert!(shown(&format!("{}–{}", upper + 1, lower + 1)));
        assert!(picture.alt.contains("EdgeInterpolated"));
    }

    #[test]
    fn a_row_answers_with_its_edge_and_edges_take_turns() {
        let mut sample = Sample::triangle(Method::Flat);
        sample.go_to("EdgeCut", 0);
        let picture = draw(&sample.show(), Vec2::new(420.0, 200.0));
        let row = |n: f32| (60.0, ROW + 6.0 + (n + 0.5) * ROW);
        assert_eq!(picture.hit(row(0.0)), Some(Tag::Edge(0)));
        assert_eq!(picture.hit(row(2.0)), Some(Tag::Edge(2)));
        let words = |sample: &Sample| -> Vec<String> {
            let picture = draw(&sample.show(), Vec2::new(420.0, 200.0));
            let texts = texts(&picture);
            texts
                .into_iter()
                .map(|(text, _)| text.to_string())
                .collect()
        };
        assert!(words(&sample).contains(&"waits".to_string()));
        let last = sample.run.walk().len() - 3;
        sample.run.walk_mut().seek(last);
        assert!(words(&sample).contains(&"done".to_string()));
    }

    #[test]
    fn nothing_is_cut_at_any_size() {
        for mut sample in [
            Sample::triangle(Method::Gouraud),
            crowd(Method::Gouraud),
            crowd(Method::Phong),
            crowd(Method::Flat),
            crowd(Method::Wireframe),
            nothing(),
        ] {
            for step in (0..sample.run.walk().len().max(1)).step_by(23) {
                sample.run.walk_mut().seek(step);
                for size in SIZES {
                    for language in Language::ALL {
                        let show = Show {
                            language,
                            ..sample.show()
                        };
                        assert_legible(&draw(&show, size), &format!("step {step} at {size}"));
                    }
                }
            }
        }
    }
}
