//! The share of an exchange that passes convex blockers: exact from a point of the receiver, by quadrature over the receiver.
//!
//! The receiver is divided into cells. In each, what is seen of the source is found at 3 × 3 Gauss points, and compared with what the
//! middle points alone say along each side. The cell that may be off the most is halved across the side along which it changes the most,
//! so that cells gather where the visible shape changes, until the errors together are a small share of the sum.

use super::Event;
use super::gauss::gauss;
use super::polygon::Polygon;
use super::view::{Blocker, Seen, View};
use crate::record::Recorder;
use glam::DVec3;

/// ∫F over the receiver, of the whole source and of what is seen of it, and an estimate of the error of what is seen.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Passing {
    pub whole: f64,
    pub visible: f64,
    pub error: f64,
    /// How many points of the receiver were looked from.
    pub points: u32,
}

/// The error of F, seen from the smaller patch, that is aimed at: as a share of what is seen, the one that is of no account, and the one
/// that is never allowed. The difference of two rules may miss what the visible shape does between their points, so that true errors
/// are larger: with these, no F above 1e-5 differs by more than 0.8 % from what a quarter of them gives, in Cornell boxes of 99 and 684
/// patches.
const RELATIVE: f64 = 4e-4;
const LEAST: f64 = 5e-9;
const MOST: f64 = 1e-5;

/// How far ∫F may be off.
fn tolerance(visible: f64, smaller_area: f64) -> f64 {
    (RELATIVE * visible).clamp(LEAST * smaller_area, MOST * smaller_area)
}

/// The estimate that is reported, in units of the one that cells are divided by: true errors of rows reach twice that (in a Cornell box of 236
/// patches, against a tolerance of 2e-5).
const SAFETY: f64 = 2.0;
/// So many cells are looked at in a pair at most.
const MOST_CELLS: usize = 1500;
/// What the difference of the two rules is worth as an error of the better one: at first, and at least. In between it is what halving
/// the cell above has changed.
const AT_FIRST: f64 = 0.3;
const AT_LEAST: f64 = 0.05;
/// What the mean deviation along a border is worth where all points inside agree.
const OF_BORDER: f64 = 0.3;
const POINTS: usize = 3;

/// `parts` of the receiver and the source lie in front of each other, the blockers in front of both. `grid` is how many cells each way a
/// part has at first.
pub fn passing<R: Recorder<Event>>(
    parts: &[Polygon],
    source: &Polygon,
    blockers: &[Blocker],
    grid: u32,
    slack: f64,
    recorder: &mut R,
) -> Passing {
    let receiver: f64 = parts.iter().map(|part| part.area).sum();
    let smaller_area = receiver.min(source.area);
    let mut look = Look {
        view: View::default(),
        normal: parts.first().map_or(DVec3::Z, |part| part.normal),
        source: &source.corners,
        blockers,
        slack,
        points: 0,
        recorder,
    };
    let mut cells = Vec::new();
    let span = |k: u32| [k, k + 1].map(|k| f64::from(k) / f64::from(grid));
    for corners in parts.iter().flat_map(|part| quadrilaterals(&part.corners)) {
        for row in 0..grid {
            cells.extend(
                (0..grid).map(|column| look.at(corners, [span(column), span(row)], AT_FIRST)),
            );
        }
    }
    loop {
        let sum = |of: fn(&Cell) -> f64| cells.iter().map(of).sum::<f64>();
        let (whole, visible) = (sum(|cell| cell.whole), sum(|cell| cell.visible));
        let share = if whole > 0.0 { visible / whole } else { 0.0 };
        let mut error = 0.0;
        let (mut worst, mut number, mut side) = (0.0, 0, 0);
        for (k, cell) in cells.iter().enumerate() {
            let errors = cell.errors(share);
            error += errors[0] + errors[1];
            let is_tie = errors[0] == errors[1];
            let larger = usize::from(errors[1] > errors[0] || is_tie && cell.is_high());
            if errors[larger] > worst {
                (worst, number, side) = (errors[larger], k, larger);
            }
        }
        let is_exact = error <= tolerance(visible, smaller_area);
        if is_exact || worst == 0.0 || cells.len() >= MOST_CELLS {
            return Passing {
                whole,
                visible,
                error: SAFETY * error,
                points: look.points,
            };
        }
        let cell = cells[number];
        let [from, to] = cell.spans[side];
        let middle = 0.5 * (from + to);
        let mut halves = [[from, middle], [middle, to]].map(|half| {
            let mut spans = cell.spans;
            spans[side] = half;
            look.at(cell.corners, spans, AT_LEAST)
        });
        let change =
            cell.deviation(share) - halves[0].deviation(share) - halves[1].deviation(share);
        let difference = cell.errors(share).iter().sum::<f64>() / cell.factor;
        let factor = (change.abs() / difference).clamp(AT_LEAST, AT_FIRST);
        halves.iter_mut().for_each(|half| half.factor = factor);
        cells[number] = halves[0];
        cells.push(halves[1]);
    }
}

/// A part of a quadrilateral of the receiver.
#[derive(Clone, Copy, Debug)]
struct Cell {
    corners: [DVec3; 4],
    /// From where to where, of 1 along v0→v1 and along v0→v3.
    spans: [[f64; 2]; 2],
    whole: f64,
    visible: f64,
    /// The same by the middle points along each side.
    by_middle: [[f64; 2]; 2],
    /// Where all points agree, how far the border along each side departs from them.
    by_border: [f64; 2],
    factor: f64,
}

impl Cell {
    /// Whether its second side is about the longer one.
    fn is_high(&self) -> bool {
        let [a, b, _, d] = self.corners;
        let [width, height] = self.spans.map(|[from, to]| to - from);
        height * a.distance(d) > width * a.distance(b)
    }

    /// By how much more is seen than if `share` of the whole were.
    fn deviation(&self, share: f64) -> f64 {
        self.visible - share * self.whole
    }

    /// How far the deviation may be off, by the side along which it changes.
    fn errors(&self, share: f64) -> [f64; 2] {
        let found = self.deviation(share);
        std::array::from_fn(|side| {
            let [whole, visible] = self.by_middle[side];
            self.factor * (visible - share * whole - found).abs() + OF_BORDER * self.by_border[side]
        })
    }
}

/// What the points of the receiver look at.
struct Look<'a, R> {
    view: View,
    normal: DVec3,
    source: &'a [DVec3],
    blockers: &'a [Blocker],
    slack: f64,
    points: u32,
    recorder: &'a mut R,
}

impl<R: Recorder<Event>> Look<'_, R> {
    fn from(&mut self, x: DVec3) -> Seen {
        self.points += 1;
        let seen = self
            .view
            .of(x, self.normal, self.source, self.blockers, self.slack);
        self.recorder.step(|| Event::Seen {
            x,
            whole: seen.whole,
            visible: seen.visible,
        });
        seen
    }

    fn at(&mut self, corners: [DVec3; 4], spans: [[f64; 2]; 2], factor: f64) -> Cell {
        let [a, b, c, d] = corners;
        let (along, across, twist) = (b - a, d - a, (c - d) - (b - a));
        let [width, height] = spans.map(|[from, to]| to - from);
        let place = |s: f64, t: f64| (spans[0][0] + s * width, spans[1][0] + t * height);
        let point = |s: f64, t: f64| {
            let (s, t) = place(s, t);
            a + s * along + t * (across + s * twist)
        };
        let mut cell = Cell {
            corners,
            spans,
            whole: 0.0,
            visible: 0.0,
            by_middle: [[0.0; 2]; 2],
            by_border: [0.0; 2],
            factor,
        };
        let (mut all_visible, mut all_hidden) = (true, true);
        for (row, &[t, weight_t]) in gauss(POINTS).iter().enumerate() {
            for (column, &[s, weight_s]) in gauss(POINTS).iter().enumerate() {
                let Seen { whole, visible } = self.from(point(s, t));
                all_visible &= visible == whole;
                all_hidden &= visible == 0.0;
                let (s, t) = place(s, t);
                let stretch = (along + t * twist)
                    .cross(across + s * twist)
                    .dot(self.normal);
                let add = |to: &mut [f64; 2], weight: f64| {
                    to[0] += weight * stretch * width * height * whole;
                    to[1] += weight * stretch * width * height * visible;
                };
                let mut sum = [cell.whole, cell.visible];
                add(&mut sum, weight_s * weight_t);
                [cell.whole, cell.visible] = sum;
                if column == POINTS / 2 {
                    add(&mut cell.by_middle[0], weight_t);
                }
                if row == POINTS / 2 {
                    add(&mut cell.by_middle[1], weight_s);
                }
            }
        }
        if (all_visible || all_hidden) && !self.blockers.is_empty() {
            // By side, what differs at its start and at its end.
            let mut ends = [[0.0; 2]; 2];
            for [s, t] in BORDER {
                let Seen { whole, visible } = self.from(point(s, t));
                let share = if whole > 0.0 { visible / whole } else { 0.0 };
                let unexpected = if all_visible && whole > 0.0 {
                    1.0 - share
                } else {
                    share
                };
                ends[0][usize::from(s > 0.5)] += unexpected;
                ends[1][usize::from(t > 0.5)] += unexpected;
            }
            let mean = (ends[0][0] + ends[0][1]) / BORDER.len() as f64;
            let changes = ends.map(|[start, end]: [f64; 2]| (end - start).abs());
            let all = changes[0] + changes[1];
            cell.by_border = changes.map(|change| {
                let share = if all > 0.0 { change / all } else { 0.5 };
                share * mean * cell.whole
            });
        }
        cell
    }
}

/// Points near the corners of a cell.
const BORDER: [[f64; 2]; 4] = [[0.01, 0.02], [0.98, 0.01], [0.99, 0.98], [0.02, 0.99]];

/// A convex polygon as quadrilaterals: one of four corners is itself, any other a fan of triangles, whose last two corners are one.
fn quadrilaterals(corners: &[DVec3]) -> Vec<[DVec3; 4]> {
    match *corners {
        [a, b, c, d] => vec![[a, b, c, d]],
        _ => corners[1..]
            .windows(2)
            .map(|pair| [corners[0], pair[0], pair[1], pair[1]])
            .collect(),
    }
}
