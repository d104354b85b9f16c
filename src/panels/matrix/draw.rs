//! The map, what is marked in it, and what stands around it.

use super::grid::Grid;
use super::sides::Sides;
use super::{Hand, Layout, system};
use crate::figure::{color_strip, viridis};
use crate::language::power_of_ten;
use crate::panels::horizon::after_your_answer;
use crate::picture::{Ink, Paint, Picture, Rect, Style, Tag, Text};
use std::ops::Range;

const MARGIN: f32 = 8.0;
const TITLE: f32 = 20.0;
pub const LINE: f32 = 15.0;
pub const SMALL: f32 = 11.0;
/// Cells that can be pointed at one by one: at least so large, at most so many a side.
const LEAST_CELL: f32 = 4.0;
const MOST_CELLS: usize = 100;
/// A narrower panel has no bars of the sums, so that the cells are larger.
const WITH_SUMS: f32 = 360.0;
/// Between the matrix and the bars.
const GAP: f32 = 10.0;

pub fn draw(picture: &mut Picture, layout: &Layout) {
    let (width, height) = (picture.width, picture.height);
    let written = layout.written().filter(|_| {
        let columns = (layout.n + 1) as f32;
        height >= 260.0 && (width - 2.0 * MARGIN - 40.0) / columns >= 48.0
    });
    let sides = Sides::new(layout, [width, height]);
    let bars = match width >= WITH_SUMS {
        true => (0.18 * width).clamp(44.0, 130.0) + GAP,
        false => 0.0,
    };
    let below = LINE + 4.0 + written.map_or(0.0, |_| system::HEIGHT);
    let free = Rect::between(
        (MARGIN + sides.left(), MARGIN + TITLE + sides.top()),
        (width - MARGIN - bars, height - MARGIN - below),
    );
    let grid = Grid::new(&layout.matrix, layout.n, free);
    let area = grid.area;

    title(picture, layout);
    map(picture, layout, &grid);
    sides.draw(picture, layout, &grid);
    if bars > 0.0 {
        let x = area.right() + GAP;
        sums(
            picture,
            layout,
            &grid,
            Rect::new(x, area.y, bars - GAP, area.height),
        );
    }
    if let Some(hand) = layout.hand {
        marks(picture, &grid, hand);
    }
    let row = Rect::between(
        (MARGIN, area.bottom() + 3.0),
        (area.right(), area.bottom() + 3.0 + LINE),
    );
    legend(picture, &grid, row);
    if let Some((rho, emission)) = written {
        let y = height - MARGIN - 2.0 * LINE;
        let place = Rect::new(MARGIN, y, width - 2.0 * MARGIN, 2.0 * LINE);
        system::draw(picture, layout, rho, emission, place);
    }
}

pub fn small() -> Text {
    Style::Label.size(SMALL).ink(Ink::Muted)
}

/// The current patch, and the current form factor: the longest of several ways to say it that fits.
fn title(picture: &mut Picture, layout: &Layout) {
    let room = picture.width - 2.0 * MARGIN;
    let set = Style::LabelBold.size(12.0).ink(Ink::Text);
    let place = Rect::new(MARGIN, MARGIN - 3.0, room, TITLE - 2.0);
    let ways = layout.hand.map_or_else(
        || vec![format!("F, {} × {}", layout.n, layout.n)],
        |hand| ways_to_say(layout, hand),
    );
    let fitting = ways.iter().find(|text| set.width(text) <= room);
    picture.text_in(
        place,
        fitting.unwrap_or(&ways[ways.len() - 1]).as_str(),
        set,
    );
}

fn ways_to_say(layout: &Layout, hand: Hand) -> Vec<String> {
    let number = hand.i.to_string();
    let patch = |letter, i| format!("{letter} = {i}: {}", layout.name(i));
    let sum = (!hand.shoots()).then(|| {
        let sum = layout.row_sums[hand.i];
        let sum = layout.known(sum, |language, sum| language.fixed(sum, 4));
        format!("Σ_j F_i_j = {sum}")
    });
    let Some((row, column, f)) = hand.entry else {
        let named = patch('i', hand.i);
        let whole = sum.map(|sum| format!("{named}  ·  {sum}"));
        return whole
            .into_iter()
            .chain([named, format!("i = {number}")])
            .collect();
    };
    let (other, symbol) = match hand.shoots() {
        true => (row, "F_j_i"),
        false => (column, "F_i_j"),
    };
    let value = format!("{symbol} = {}", layout.language.number(f));
    let parts = [patch('i', hand.i), value.clone(), patch('j', other)];
    let whole = sum.map(|sum| [&parts[..], &[sum]].concat().join("  ·  "));
    let short = format!("i = {number}  ·  {value}  ·  j = {other}");
    whole
        .into_iter()
        .chain([parts.join("  ·  "), short, value])
        .collect()
}

/// The colours, and over them what can be pointed at.
fn map(picture: &mut Picture, layout: &Layout, grid: &Grid) {
    picture.rect(grid.area, Ink::Background);
    picture.image(grid.area, grid.image());
    picture.rect(grid.area.grown(1.0), Ink::Rule.stroke(1.0));
    if grid.is_mostly_hidden() {
        after_your_answer(picture, grid.area, layout.language);
    }
    let unseen = Ink::Surface.fill().opacity(0.0);
    let n = layout.n;
    if grid.cell().min_element() >= LEAST_CELL && n <= MOST_CELLS {
        for i in 0..n {
            for j in 0..n {
                picture.tagged(Tag::FormFactor { i, j }, |picture| {
                    picture.rect(grid.rect(i..i + 1, j..j + 1), unseen);
                });
            }
        }
        return;
    }
    for cell in 0..grid.cells {
        let rows = grid.entries(cell);
        picture.tagged(Tag::Patch(rows.start), |picture| {
            picture.rect(grid.rect(rows.clone(), 0..n), unseen);
        });
    }
}

/// Bars as long as the sums of the rows, with a line at 1: the sum in a closed room.
fn sums(picture: &mut Picture, layout: &Layout, grid: &Grid, place: Rect) {
    let current = |rows: &Range<usize>| {
        layout
            .hand
            .filter(|hand| !hand.shoots() && rows.contains(&hand.i))
    };
    let rows: Vec<(Range<usize>, usize, f64)> = (0..grid.cells)
        .map(|cell| {
            let rows = grid.entries(cell);
            let row = current(&rows).map_or(rows.start, |hand| hand.i);
            (rows, row, layout.row_sums[row])
        })
        .collect();
    let longest = rows.iter().map(|(_, _, sum)| *sum).fold(1.1, f64::max);
    let scale = place.width / longest as f32;
    let gap = if grid.cell().y >= LEAST_CELL {
        1.0
    } else {
        0.0
    };
    for (rows, row, sum) in rows {
        let [from, to] = grid.rows(rows.clone());
        let bar = Rect::new(
            place.x,
            from,
            scale * sum as f32,
            (to - from - gap).max(0.5),
        );
        let paint = match current(&rows) {
            Some(_) => Ink::This.fill(),
            None => Ink::Muted.fill().opacity(0.45),
        };
        if sum.is_nan() {
            continue;
        }
        picture.tagged(Tag::Patch(row), |picture| {
            picture.rect(bar, paint);
        });
    }
    picture.line(
        (place.x, place.y),
        (place.x, place.bottom()),
        Ink::Rule.stroke(1.0),
    );
    let one = place.x + scale;
    let stroke = Ink::Text.stroke(1.0).dashed();
    picture.line((one, place.y - 3.0), (one, place.bottom() + 2.0), stroke);
    let header = Rect::new(place.x, place.y - LINE - 3.0, place.width, LINE);
    picture.text_in(header, "Σ_j F_i_j", small());
    let below = Rect::new(one - 10.0, place.bottom() + 3.0, 20.0, LINE);
    picture.text_in(below, "1", small().middle());
}

/// The row that is gathered, or the column that is shot, and in it the current form factor.
fn marks(picture: &mut Picture, grid: &Grid, hand: Hand) {
    let this = hand.i..hand.i + 1;
    let line = if hand.shoots() {
        grid.rect(0..grid.n, this)
    } else {
        grid.rect(this, 0..grid.n)
    };
    picture.tagged(Tag::Patch(hand.i), |picture| {
        picture.rect(at_least(line, 4.0).grown(1.0), Ink::This.stroke(1.5));
    });
    if let Some((i, j, _)) = hand.entry {
        let cell = at_least(grid.rect(i..i + 1, j..j + 1), 5.0);
        picture.tagged(Tag::FormFactor { i, j }, |picture| {
            picture.rect(cell.grown(3.0), Ink::Surface.stroke(1.0));
            picture.rect(cell.grown(2.0), Ink::This.stroke(2.5));
        });
    }
}

/// A rectangle about the same centre with sides of `least` or more.
fn at_least(rect: Rect, least: f32) -> Rect {
    let (width, height) = (rect.width.max(least), rect.height.max(least));
    let center = rect.center();
    Rect::new(
        center.x - 0.5 * width,
        center.y - 0.5 * height,
        width,
        height,
    )
}

/// What the colours mean: nothing, and the powers of ten.
fn legend(picture: &mut Picture, grid: &Grid, place: Rect) {
    let decades = grid.decades().map(power_of_ten);
    let zero = Rect::new(place.x + 10.0, place.center().y - 4.5, 9.0, 9.0);
    picture.text_in(place, "0", small());
    picture.rect(zero, Ink::Background);
    picture.rect(zero, Paint::from(Ink::Rule.stroke(1.0)));
    let colors = Rect::between((zero.right() + 8.0, place.y), place.max());
    let ends = decades.each_ref().map(String::as_str);
    color_strip(picture, colors, ends, small(), viridis);
}
