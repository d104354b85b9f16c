//! What stands along the left and the top of the matrix: the objects with the numbers of their patches. Nothing is cut off: a
//! name or a number that does not fit is left out.

use super::Layout;
use super::draw::{LINE, small};
use super::grid::Grid;
use crate::panels::names::object;
use crate::picture::{Ink, Picture, Rect};
use std::ops::Range;

const BRACKET: f32 = 6.0;
/// Between two numbers.
const APART: f32 = 5.0;
/// Of the panel's width, at most so much is for names.
const NAMES: f32 = 0.16;
/// A lower panel has no names along the top.
const NAMED_ABOVE: f32 = 200.0;

/// The objects with their patches, and the room that they take.
pub struct Sides {
    objects: Vec<(String, Range<usize>)>,
    /// What names and brackets take at the left, and above; 0 where that would be too much.
    beside: f32,
    above: f32,
    number: f32,
}

impl Sides {
    pub fn new(layout: &Layout, [width, height]: [f32; 2]) -> Self {
        let surfaces = layout.room.patches.surfaces.iter().zip(0_u32..);
        let objects = surfaces.map(|(surface, number)| {
            let count = (surface.grid[0] * surface.grid[1]) as usize;
            let name = object(layout.prepared, number, layout.language);
            (name.to_string(), surface.first..surface.first + count)
        });
        let objects: Vec<_> = objects.collect();
        let longest = objects.iter().map(|(name, _)| small().width(name));
        let beside = longest.fold(0.0, f32::max) + APART + BRACKET;
        Sides {
            objects,
            beside: if beside <= NAMES * width { beside } else { 0.0 },
            above: if height >= NAMED_ABOVE {
                LINE + BRACKET
            } else {
                0.0
            },
            number: small().width(&(layout.n - 1).to_string()) + APART,
        }
    }

    pub fn left(&self) -> f32 {
        self.beside + self.number
    }

    pub fn top(&self) -> f32 {
        LINE + self.above
    }

    pub fn draw(&self, picture: &mut Picture, layout: &Layout, grid: &Grid) {
        self.rows(picture, layout, grid);
        self.columns(picture, layout, grid);
        let row = current(layout, false);
        if self.beside > 0.0 {
            self.names_beside(picture, row, grid);
        }
        if self.above > 0.0 {
            self.names_above(picture, grid);
        }
    }

    fn rows(&self, picture: &mut Picture, layout: &Layout, grid: &Grid) {
        let current = current(layout, false);
        let mut taken = Taken::along(grid);
        for row in in_order(layout.n, current) {
            let [from, to] = grid.rows(row..row + 1);
            let place = Rect::new(
                grid.area.x - self.number,
                0.5 * (from + to - LINE),
                self.number - 3.0,
                LINE,
            );
            if taken.takes(place) {
                let set = small().ink(ink(current == Some(row))).end();
                picture.text_in(place, row.to_string(), set);
            }
        }
    }

    fn columns(&self, picture: &mut Picture, layout: &Layout, grid: &Grid) {
        let current = current(layout, true);
        let mut taken = Taken::default();
        for column in in_order(layout.n, current) {
            let [from, to] = grid.columns(column..column + 1);
            // The last number may be wider than what is left beside the matrix.
            let x = (0.5 * (from + to - self.number)).min(picture.width - self.number);
            let place = Rect::new(x, grid.area.y - LINE - 1.0, self.number, LINE);
            if taken.takes(place) {
                let set = small().ink(ink(current == Some(column))).middle();
                picture.text_in(place, column.to_string(), set);
            }
        }
    }

    /// The object of the current row first, since it must not be left out.
    fn names_beside(&self, picture: &mut Picture, row: Option<usize>, grid: &Grid) {
        let holds = |range: &Range<usize>| row.is_some_and(|row| range.contains(&row));
        let mut objects: Vec<_> = self.objects.iter().collect();
        objects.sort_by_key(|(_, range)| !holds(range));
        let x = grid.area.x - self.number - BRACKET;
        let mut taken = Taken::along(grid);
        for (name, range) in objects {
            let [from, to] = grid.rows(range.clone());
            bracket(picture, [from, to], |at, depth| [x + depth, at]);
            let width = self.beside - BRACKET - APART;
            let y = 0.5 * (from + to - LINE);
            let place = Rect::new(x - APART - width, y, width, LINE);
            if taken.takes(place) {
                let set = small().ink(ink(holds(range))).end();
                picture.text_in(place, name.as_str(), set);
            }
        }
    }

    fn names_above(&self, picture: &mut Picture, grid: &Grid) {
        let y = grid.area.y - LINE - BRACKET;
        for (name, range) in &self.objects {
            let [from, to] = grid.columns(range.clone());
            bracket(picture, [from, to], |at, depth| [at, y + depth]);
            if small().width(name) <= to - from - 4.0 {
                let place = Rect::new(from, y - LINE, to - from, LINE);
                picture.text_in(place, name.as_str(), small().middle());
            }
        }
    }
}

/// Places that are taken, and how far up and down they may reach.
struct Taken {
    places: Vec<Rect>,
    ends: [f32; 2],
}

impl Default for Taken {
    fn default() -> Self {
        Taken {
            places: Vec::new(),
            ends: [f32::NEG_INFINITY, f32::INFINITY],
        }
    }
}

impl Taken {
    /// Beside the matrix.
    fn along(grid: &Grid) -> Self {
        Taken {
            ends: [grid.area.y - 3.0, grid.area.bottom() + 3.0],
            ..Taken::default()
        }
    }

    /// Whether the place is free and within the ends; it is taken then.
    fn takes(&mut self, place: Rect) -> bool {
        let [top, bottom] = self.ends;
        // Lines of text may touch.
        let inner = place.grown(-0.5);
        let overlaps = |other: &Rect| !other.intersection(&inner).is_empty();
        let is_free = place.y >= top && place.bottom() <= bottom;
        let is_free = is_free && !self.places.iter().any(overlaps);
        if is_free {
            self.places.push(place);
        }
        is_free
    }
}

/// The row, or the column, of the current patch or form factor.
fn current(layout: &Layout, column: bool) -> Option<usize> {
    let hand = layout.hand?;
    match hand.entry {
        Some((row, across, _)) => Some(if column { across } else { row }),
        None => Some(hand.i).filter(|_| column == hand.shoots()),
    }
}

/// All numbers, the current one first, since it must not be left out.
fn in_order(n: usize, current: Option<usize>) -> impl Iterator<Item = usize> {
    current.into_iter().chain(0..n)
}

fn ink(is_current: bool) -> Ink {
    if is_current { Ink::This } else { Ink::Muted }
}

/// Around a range along one side, open toward the matrix.
fn bracket(picture: &mut Picture, [from, to]: [f32; 2], at: impl Fn(f32, f32) -> [f32; 2]) {
    let inset = if to - from > 4.0 { 1.0 } else { 0.0 };
    let (from, to) = (from + inset, to - inset);
    let points = [at(from, 4.0), at(from, 1.0), at(to, 1.0), at(to, 4.0)];
    picture.polyline(points, Ink::Muted.stroke(1.0));
}
