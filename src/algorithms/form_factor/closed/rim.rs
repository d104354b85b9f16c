//! The rim of polygons: the edges that no other edge passes in the opposite direction.

use super::super::polygon::Polygon;
use glam::DVec3;
use std::collections::HashMap;

/// The most edges that are compared in pairs.
const MOST_UNPAIRED: usize = 1 << 13;

/// A part of the rim, passed from the first end to the second, or where `passes` is negative back.
#[derive(Clone, Copy, Debug)]
pub struct Edge {
    pub ends: [DVec3; 2],
    pub passes: i32,
}

impl Edge {
    fn length(&self) -> f64 {
        self.ends[0].distance(self.ends[1])
    }
}

/// The rim, empty where along every line edges run as often in one direction as in the other. `slack` is how far apart corners are one
/// place. None where too many edges would have to be compared.
pub fn rim<'a>(
    polygons: impl Iterator<Item = &'a Polygon<'static>>,
    slack: f64,
) -> Option<Vec<Edge>> {
    let mut places = Places::new(slack);
    // By ends, the lower number first: how often the edge is passed upward, less how often downward.
    let mut passes: HashMap<[u32; 2], i32> = HashMap::new();
    for polygon in polygons {
        let corners = polygon.corners.iter();
        let numbers: Vec<u32> = corners.map(|&at| places.number(at)).collect();
        for (k, &a) in numbers.iter().enumerate() {
            let b = numbers[(k + 1) % numbers.len()];
            match a.cmp(&b) {
                std::cmp::Ordering::Less => *passes.entry([a, b]).or_default() += 1,
                std::cmp::Ordering::Greater => *passes.entry([b, a]).or_default() -= 1,
                std::cmp::Ordering::Equal => {}
            }
        }
    }
    let unpaired = passes.into_iter().filter(|&(_, passes)| passes != 0);
    let edges: Vec<Edge> = unpaired
        .map(|(ends, passes)| Edge {
            ends: ends.map(|end| places.at[end as usize]),
            passes,
        })
        .collect();
    (edges.len() <= MOST_UNPAIRED).then(|| left_along_lines(edges, 4.0 * slack))
}

/// Places that are one within a slack, numbered.
struct Places {
    slack: f64,
    at: Vec<DVec3>,
    /// By cell of a grid as wide as the slack.
    cells: HashMap<[i64; 3], Vec<u32>>,
}

impl Places {
    fn new(slack: f64) -> Self {
        Places {
            slack: slack.max(f64::MIN_POSITIVE),
            at: Vec::new(),
            cells: HashMap::new(),
        }
    }

    fn number(&mut self, place: DVec3) -> u32 {
        let cell = (place / self.slack).round().to_array().map(|x| x as i64);
        for offset in 0..27 {
            let beside = [1, 3, 9].map(|step| offset / step % 3 - 1);
            let near = std::array::from_fn(|axis| cell[axis].saturating_add(beside[axis]));
            let numbers = self.cells.get(&near).into_iter().flatten();
            for &number in numbers {
                if self.at[number as usize].distance(place) <= self.slack {
                    return number;
                }
            }
        }
        let number = self.at.len() as u32;
        self.at.push(place);
        self.cells.entry(cell).or_default().push(number);
        number
    }
}

/// What is left of edges that share a line where they do not cancel along it: their ends differ where patches of different size meet.
fn left_along_lines(mut edges: Vec<Edge>, slack: f64) -> Vec<Edge> {
    let mut left = Vec::new();
    // A long edge knows its line best.
    edges.sort_by(|a, b| a.length().total_cmp(&b.length()));
    while let Some(longest) = edges.pop() {
        let origin = longest.ends[0];
        let direction = (longest.ends[1] - origin).normalize_or_zero();
        let along = |point: DVec3| (point - origin).dot(direction);
        let is_on_line = |edge: &Edge| {
            let from_line = |end: DVec3| (end - origin - along(end) * direction).length();
            edge.ends.iter().all(|&end| from_line(end) <= slack)
        };
        let (mut on_line, rest): (Vec<Edge>, Vec<Edge>) = edges.into_iter().partition(is_on_line);
        edges = rest;
        on_line.push(longest);
        // Where along the line edges begin and end, and by how much the number of passes changes there.
        let changes = on_line.iter().flat_map(|edge| {
            let [start, end] = edge.ends;
            [
                (along(start), start, edge.passes),
                (along(end), end, -edge.passes),
            ]
        });
        let mut changes: Vec<(f64, DVec3, i32)> = changes.collect();
        changes.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut passes = 0;
        for pair in changes.windows(2) {
            let [(from, start, change), (to, end, _)] = [pair[0], pair[1]];
            passes += change;
            if passes != 0 && to - from > slack {
                left.push(Edge {
                    ends: [start, end],
                    passes,
                });
            }
        }
    }
    left
}
