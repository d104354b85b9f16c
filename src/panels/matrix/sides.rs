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
const NAMES: f32 = 0.25;

/// The objects with their patches, and the room that they take.
pub struct Sides {
    objects: Vec<(String, Range<usize>)>,
    /// Of the longest name; 0 where names would take too much.
    name: f32,
    number: f32,
}

impl Sides {
    pub fn new(layout: &Layout, width: f32) -> Self {
        let surfaces = layout.room.patches.surfaces.iter().zip(0_u32..);
        let objects = surfaces.map(|(surface, number)| {
            let count = (surface.grid[0] * surface.grid[1]) as usize;
            let name = object(layout.prepared, number, layout.language);
            (name.to_string(), surface.first..surface.first + count)
        });
        let objects: Vec<_> = objects.collect();
        let longest = objects.iter().map(|(name, _)| small().width(name));
        let longest = longest.fold(0.0, f32::max) + APART;
        Sides {
            objects,
            name: if longest <= NAMES * width { longest } else { 0.0 },
            number: small().width(&(layout.n - 1).to_string()) + APART,
        }
    }

    pub fn left(&self) -> f32 {
        self.name + BRACKET + self.number
    }

    pub fn top(&self) -> f32 {
        2.0 * LINE + BRACKET
    }

    pub fn draw(&self, picture: &mut Picture, layout: &Layout, grid: &Grid) {
        self.left_side(picture, layout, grid);
        self.upper_side(picture, layout, grid);
    }

    fn left_side(&self, picture: &mut Picture, layout: &Layout, grid: &Grid) {
        let x = grid.area.x - self.number;
        let current = current(layout, false);
        let mut taken = Taken::default();
        for row in in_order(layout.n, current) {
            let [from, to] = grid.rows(row..row + 1);
            let y = 0.5 * (from + to - LINE);
            let place = Rect::new(x, y, self.number - 3.0, LINE);
            if taken.takes(place, [grid.area.y - 3.0, grid.area.bottom() + 3.0]) {
                let set = small().ink(ink(current == Some(row))).end();
                picture.text_in(place, row.to_string(), set);
            }
        }
        let mut taken = Taken::default();
        let holds = |range: &Range<usize>| current.is_some_and(|row| range.contains(&row));
        let (mut first, others): (Vec<_>, Vec<_>) =
            self.objects.iter().partition(|(_, range)| holds(range));
        first.extend(others);
        for (name, range) in first {
            let [from, to] = grid.rows(range.clone());
            let x = x - BRACKET;
            bracket(picture, [from, to], |at, depth| [x + depth, at]);
            let y = 0.5 * (from + to - LINE);
            let place = Rect::new(x - self.name, y, self.name - APART, LINE);
            let ends = [grid.area.y - 3.0, grid.area.bottom() + 3.0];
            if self.name > 0.0 && taken.takes(place, ends) {
                picture.text_in(place, name, small().ink(ink(holds(range))).end());
            }
        }
    }

    fn upper_side(&self, picture: &mut Picture, layout: &Layout, grid: &Grid) {
        let y = grid.area.y - LINE;
        let current = current(layout, true);
        let mut numbers: Vec<Rect> = Vec::new();
        for column in in_order(layout.n, current) {
            let [from, to] = grid.columns(column..column + 1);
            let width = self.number;
            let place = Rect::new(0.5 * (from + to - width), y - 1.0, width, LINE);
            if numbers.iter().all(|other| other.intersection(&place).is_empty()) {
                let set = small().ink(ink(current == Some(column))).middle();
                picture.text_in(place, column.to_string(), set);
                numbers.push(place);
            }
        }
        for (name, range) in &self.objects {
            let [from, to] = grid.columns(range.clone());
            let y = y - BRACKET;
            bracket(picture, [from, to], |at, depth| [at, y + depth]);
            if small().width(name) <= to - from - 4.0 {
                let place = Rect::new(from, y - LINE, to - from, LINE);
                picture.text_in(place, name.as_str(), small().middle());
            }
        }
    }
}

/// Places along the left that are taken.
#[derive(Default)]
struct Taken(Vec<Rect>);

impl Taken {
    /// Whether the place is free and within the ends; it is taken then.
    fn takes(&mut self, place: Rect, [top, bottom]: [f32; 2]) -> bool {
        let is_free = place.y >= top
            && place.bottom() <= bottom
            && self.0.iter().all(|other| other.intersection(&place).is_empty());
        if is_free {
            self.0.push(place);
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
