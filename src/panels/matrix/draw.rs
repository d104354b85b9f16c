//! The map, what is marked in it, and what stands around it.

use super::grid::Grid;
use super::{Hand, Layout};
use crate::algorithms::radiosity::SolverEvent;
use crate::figure::{color_strip, elided, joined, viridis};
use crate::language::power_of_ten;
use crate::panels::horizon::after_your_answer;
use crate::picture::{Ink, Paint, Picture, Rect, Style, Tag, elide};
use std::ops::Range;

const MARGIN: f32 = 8.0;
const TITLE: f32 = 20.0;
const LINE: f32 = 15.0;
const SMALL: f32 = 11.0;
const BRACKET: f32 = 6.0;
/// Cells that can be pointed at one by one: at least so large, at most so many a side.
const LEAST_CELL: f32 = 4.0;
const MOST_CELLS: usize = 64;
/// The most patches whose row of the system is written out.
const MOST_WRITTEN: usize = 8;

pub fn draw(picture: &mut Picture, layout: &Layout) {
    let (width, height) = (picture.width, picture.height);
    let written = layout.written().filter(|_| {
        let columns = (layout.n + 1) as f32;
        height >= 260.0 && (width - 2.0 * MARGIN - 40.0) / columns >= 48.0
    });
    let names = names(layout);
    let longest = names.iter().map(|(name, _)| small().width(name));
    let left = longest.fold(0.0, f32::max).min(0.2 * width).min(110.0) + BRACKET + 3.0;
    let bars = (0.18 * width).clamp(44.0, 130.0);
    let top = MARGIN + TITLE + LINE + BRACKET;
    let bottom = LINE
        + 4.0
        + if written.is_some() {
            2.0 * LINE + 4.0
        } else {
            0.0
        };
    let free = Rect::new(
        MARGIN + left,
        top,
        width - 2.0 * MARGIN - left - bars - 10.0,
        height - top - bottom - MARGIN,
    );
    let mut grid = Grid::new(&layout.matrix, layout.n, free);
    // Everything in the middle.
    grid.area.x += (0.5 * (free.width - grid.area.width)).max(0.0).floor();
    let area = grid.area;
    let bars = Rect::new(area.right() + 10.0, area.y, bars, area.height);

    title(picture, layout);
    map(picture, layout, &grid);
    objects_left(picture, layout, &grid, &names, left);
    objects_above(picture, &grid, &names);
    sums(picture, layout, &grid, bars);
    if let Some(hand) = layout.hand {
        marks(picture, &grid, hand);
    }
    let legend_place = Rect::new(
        (area.x - left).max(MARGIN),
        area.bottom() + 3.0,
        bars.x - 6.0 - (area.x - left).max(MARGIN),
        LINE,
    );
    legend(picture, &grid, legend_place);
    if let Some((rho, emission)) = written {
        let place = Rect::new(
            MARGIN,
            height - MARGIN - 2.0 * LINE,
            width - 2.0 * MARGIN,
            2.0 * LINE,
        );
        system(picture, layout, rho, emission, place);
    }
}

fn small() -> crate::picture::Text {
    Style::Label.size(SMALL).ink(Ink::Muted)
}

/// The objects' names, and the patches of each.
fn names(layout: &Layout) -> Vec<(String, Range<usize>)> {
    let surfaces = layout.room.patches.surfaces.iter().zip(0_u32..);
    surfaces
        .map(|(surface, object)| {
            let count = (surface.grid[0] * surface.grid[1]) as usize;
            let name =
                super::super::names::object(layout.prepared, object, layout.language).to_string();
            (name, surface.first..surface.first + count)
        })
        .collect()
}

/// The current patch, and the current form factor, as far as there is room.
fn title(picture: &mut Picture, layout: &Layout) {
    let room = picture.width - 2.0 * MARGIN;
    let set = Style::LabelBold.size(12.0).ink(Ink::Text);
    let mut parts = vec![format!("F, {} × {}", layout.n, layout.n)];
    if let Some(hand) = layout.hand {
        let name = layout.name(hand.i);
        parts = vec![format!("i = {}: {name}", hand.i)];
        if let Some((row, column, f)) = hand.entry {
            let (other, symbol) = if hand.shoots() {
                (row, "F_j_i")
            } else {
                (column, "F_i_j")
            };
            parts.push(format!("{symbol} = {}", layout.language.number(f)));
            parts.push(format!("j = {other}: {}", layout.name(other)));
        }
        if !hand.shoots() {
            parts.push(format!(
                "Σ_j F_i_j = {}",
                layout.known(layout.row_sums[hand.i], |language, sum| language
                    .fixed(sum, 4))
            ));
        }
    }
    let place = Rect::new(MARGIN, MARGIN - 3.0, room, TITLE - 2.0);
    elided(picture, place, &joined(parts, "  ·  ", set, room), set);
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
    if grid.cell() >= LEAST_CELL && n <= MOST_CELLS {
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

/// Brackets along the left, and names where they do not cover each other: first that of the current patch.
fn objects_left(
    picture: &mut Picture,
    layout: &Layout,
    grid: &Grid,
    names: &[(String, Range<usize>)],
    left: f32,
) {
    let (x, y) = (grid.area.x - BRACKET, grid.area.y);
    let current = |range: &Range<usize>| layout.hand.is_some_and(|hand| range.contains(&hand.i));
    let mut order: Vec<&(String, Range<usize>)> = names.iter().collect();
    order.sort_by_key(|(_, range)| !current(range));
    let mut taken: Vec<Rect> = Vec::new();
    for (name, range) in order {
        let [from, to] = grid.span(range.clone()).map(|at| y + at);
        bracket(picture, [from, to], |at, depth| [x + depth, at]);
        let ink = if current(range) {
            Ink::This
        } else {
            Ink::Muted
        };
        let place = Rect::new(
            x - left + BRACKET,
            (0.5 * (from + to) - 0.5 * LINE).min(grid.area.bottom() + 3.0 - LINE),
            left - BRACKET - 4.0,
            LINE,
        );
        if taken
            .iter()
            .all(|other| other.intersection(&place).is_empty())
        {
            elided(picture, place, name, small().ink(ink).end());
            taken.push(place);
        }
    }
}

/// Brackets along the top, and the names that fit their ranges.
fn objects_above(picture: &mut Picture, grid: &Grid, names: &[(String, Range<usize>)]) {
    let (x, y) = (grid.area.x, grid.area.y - BRACKET);
    for (name, range) in names {
        let [from, to] = grid.span(range.clone()).map(|at| x + at);
        bracket(picture, [from, to], |at, depth| [at, y + depth]);
        let name = elide(name, Style::Label, SMALL, to - from - 4.0);
        if name.chars().count() >= 5 || !name.ends_with('…') && !name.is_empty() {
            let place = Rect::new(from, y - LINE, to - from, LINE);
            picture.text_in(place, name, small().middle());
        }
    }
}

/// Around a range along one side, open toward the matrix.
fn bracket(picture: &mut Picture, [from, to]: [f32; 2], at: impl Fn(f32, f32) -> [f32; 2]) {
    let inset = if to - from > 4.0 { 1.0 } else { 0.0 };
    let (from, to) = (from + inset, to - inset);
    let points = [at(from, 4.0), at(from, 1.0), at(to, 1.0), at(to, 4.0)];
    picture.polyline(points, Ink::Muted.stroke(1.0));
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
    let gap = if grid.cell() >= LEAST_CELL { 1.0 } else { 0.0 };
    for (rows, row, sum) in rows {
        let [from, to] = grid.span(rows.clone()).map(|at| place.y + at);
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
    let header = Rect::new(place.x, place.y - BRACKET - LINE, place.width, LINE);
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

impl Layout<'_> {
    /// ρ_i and E_i of the patch that gathers, where its row of the system is short enough to be written.
    fn written(&self) -> Option<(f64, f64)> {
        match self.hand?.recorded {
            SolverEvent::Gathering { rho_i, e_i, .. } if self.n <= MOST_WRITTEN => {
                Some((rho_i, e_i))
            }
            _ => None,
        }
    }
}

/// The row of I − ρF, and E_i.
fn system(picture: &mut Picture, layout: &Layout, rho: f64, emission: f64, place: Rect) {
    let Some(hand) = layout.hand else { return };
    let head = 40.0;
    let width = (place.width - head) / (layout.n + 1) as f32;
    let column = hand.entry.map(|(_, column, _)| column);
    let cell = |at: usize, line: usize| {
        let x = place.x + head + at as f32 * width;
        Rect::new(x, place.y + line as f32 * LINE, width, LINE)
    };
    picture.line(
        (place.x, place.y - 2.0),
        (place.right(), place.y - 2.0),
        Ink::Rule.stroke(1.0),
    );
    let first = Rect {
        width: head,
        height: LINE,
        ..place
    };
    picture.text_in(first, "j", small());
    let second = first.shifted([0.0, LINE].into());
    picture.text_in(second, format!("i = {}", hand.i), small());
    for (j, f) in layout.row(hand.i).iter().enumerate() {
        let diagonal = j == hand.i;
        let symbol = match diagonal {
            _ if width < 84.0 => format!("{j}"),
            true => "1 − ρ_i F_i_i".to_string(),
            false => format!("−ρ_i F_i_{j}"),
        };
        let value = f64::from(u8::from(diagonal)) - rho * f;
        let (style, ink) = if column == Some(j) {
            (Style::LabelBold, Ink::This)
        } else {
            (Style::Label, Ink::Text)
        };
        picture.tagged(Tag::FormFactor { i: hand.i, j }, |picture| {
            picture.text_in(cell(j, 0), symbol, small().end());
            picture.text_in(
                cell(j, 1),
                layout.known(value, |language, value| language.fixed(value, 3)),
                style.size(SMALL).ink(ink).end(),
            );
        });
    }
    let last = cell(layout.n, 0);
    picture.line(
        (last.x + 5.0, place.y),
        (last.x + 5.0, place.bottom()),
        Ink::Muted.stroke(1.0),
    );
    picture.text_in(last, "E_i", small().end());
    let set = Style::Label.size(SMALL).end();
    picture.text_in(cell(layout.n, 1), layout.language.fixed(emission, 3), set);
}
