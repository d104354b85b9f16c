//! Whether a scene is closed: from the front of every patch nothing is seen but fronts of patches, so that each row of form factors
//! sums to 1. It is decided by where the patches lie, and never by the sums themselves, from which a small opening could not be told
//! apart from an error.
//!
//! Two things must hold.
//!
//! - The patches have no rim: along every line, edges run as often in one direction as in the other. Then the winding number of
//!   the patches around a point is whole, and changes by 1 only across a patch (Jacobson, Kavan & Sorkine-Hornung, "Robust
//!   inside-outside segmentation using generalized winding numbers", SIGGRAPH 2013, §3).
//! - It is −1 in front of every patch, so 0 behind it. A ray from there comes to infinity, where it is 0, only across a patch; and
//!   the first one that it meets has −1 on its near side, so its front.

use crate::scene::patches::Patches;
use glam::DVec3;
use std::collections::HashMap;
use std::f64::consts::TAU;

/// How far apart corners are one place, as a share of the scene's extent.
const SLACK: f64 = 1e-9;

/// The most edges that are compared in pairs.
const MOST_UNPAIRED: usize = 1 << 13;

/// The most triangles whose solid angle is taken.
const MOST_SOLID_ANGLES: usize = 1 << 23;

/// Whether the patches close a scene in, as far as can be told at a bounded cost: a scene with too many patches counts as open.
pub fn is_closed(patches: &Patches) -> bool {
    !patches.is_empty() && has_no_rim(patches) && is_in_front_of_fronts(patches)
}

fn corners(patches: &Patches) -> impl Iterator<Item = DVec3> {
    let pieces = (0..patches.len()).flat_map(|patch| patches.pieces(patch));
    pieces.flat_map(|piece| piece.corners.iter().copied())
}

fn has_no_rim(patches: &Patches) -> bool {
    let low = corners(patches).fold(DVec3::INFINITY, DVec3::min);
    let high = corners(patches).fold(DVec3::NEG_INFINITY, DVec3::max);
    let rounding = 8.0 * f64::EPSILON * low.abs().max(high.abs()).max_element();
    let slack = SLACK * low.distance(high) + rounding;
    let mut places = Places::new(slack);
    // By ends, the lower number first: how often the edge is passed upward, less how often downward.
    let mut passes: HashMap<[u32; 2], i32> = HashMap::new();
    for patch in 0..patches.len() {
        for piece in patches.pieces(patch) {
            let numbers: Vec<u32> = piece.corners.iter().map(|&at| places.number(at)).collect();
            for (k, &a) in numbers.iter().enumerate() {
                let b = numbers[(k + 1) % numbers.len()];
                match a.cmp(&b) {
                    std::cmp::Ordering::Less => *passes.entry([a, b]).or_default() += 1,
                    std::cmp::Ordering::Greater => *passes.entry([b, a]).or_default() -= 1,
                    std::cmp::Ordering::Equal => {}
                }
            }
        }
    }
    let unpaired = passes.into_iter().filter(|&(_, passes)| passes != 0);
    let edges = unpaired.map(|(ends, passes)| Edge {
        ends: ends.map(|end| places.at[end as usize]),
        passes,
    });
    cancel_along_lines(edges.collect(), 4.0 * slack)
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

struct Edge {
    ends: [DVec3; 2],
    /// From the first end to the second.
    passes: i32,
}

impl Edge {
    fn length(&self) -> f64 {
        self.ends[0].distance(self.ends[1])
    }
}

/// Whether edges that share a line cancel along it, although their ends differ: where patches of different size meet.
fn cancel_along_lines(mut edges: Vec<Edge>, slack: f64) -> bool {
    if edges.len() > MOST_UNPAIRED {
        return false;
    }
    // A long edge knows its line best.
    edges.sort_by(|a, b| a.length().total_cmp(&b.length()));
    while let Some(longest) = edges.pop() {
        let origin = longest.ends[0];
        let direction = (longest.ends[1] - origin).normalize_or_zero();
        let along = |point: DVec3| (point - origin).dot(direction);
        let is_on_line = |edge: &Edge| {
            let off = |end: DVec3| (end - origin - along(end) * direction).length();
            edge.ends.iter().all(|&end| off(end) <= slack)
        };
        let (mut on_line, rest): (Vec<Edge>, Vec<Edge>) = edges.into_iter().partition(is_on_line);
        edges = rest;
        on_line.push(longest);
        // Where along the line edges begin and end, and by how much the number of passes changes there.
        let changes = on_line.iter().flat_map(|edge| {
            let [start, end] = edge.ends.map(along);
            [(start, edge.passes), (end, -edge.passes)]
        });
        let mut changes: Vec<(f64, i32)> = changes.collect();
        changes.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut passes = 0;
        for pair in changes.windows(2) {
            passes += pair[0].1;
            if passes != 0 && pair[1].0 - pair[0].0 > slack {
                return false;
            }
        }
    }
    true
}

/// Whether the winding number is −1 in front of the patches: of all, or in large scenes of as many as there is time for.
fn is_in_front_of_fronts(patches: &Patches) -> bool {
    let triangles: Vec<[DVec3; 3]> = (0..patches.len())
        .flat_map(|patch| patches.pieces(patch))
        .flat_map(|piece| {
            let fan = piece.corners[1..].windows(2);
            fan.map(|pair| [piece.corners[0], pair[0], pair[1]])
        })
        .collect();
    let affordable = (MOST_SOLID_ANGLES / triangles.len()).max(1);
    let stride = patches.len().div_ceil(affordable);
    // An object of its own may be turned the wrong way by itself.
    let firsts = patches.surfaces.iter().map(|surface| surface.first);
    if firsts.len() > 4 * affordable {
        return false;
    }
    let mut tested = (0..patches.len()).step_by(stride).chain(firsts);
    tested.all(|patch| {
        let mut pieces = patches.pieces(patch);
        pieces.all(|piece| {
            let middle = piece.corners.iter().sum::<DVec3>() / piece.corners.len() as f64;
            let point = middle + 1e-6 * piece.area.sqrt() * piece.normal;
            let sum: f64 = triangles.iter().map(|&t| solid_angle(t, point)).sum();
            // Normals point away from where the winding number of closed surfaces is counted as 1.
            (sum / (2.0 * TAU) + 1.0).abs() < 1e-3
        })
    })
}

/// The solid angle of a triangle seen from `point`, positive from behind: where normals point away
/// (Van Oosterom & Strackee, "The solid angle of a plane triangle", 1983, equation 8).
fn solid_angle(triangle: [DVec3; 3], point: DVec3) -> f64 {
    let [a, b, c] = triangle.map(|corner| corner - point);
    let [la, lb, lc] = [a, b, c].map(DVec3::length);
    let below = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
    2.0 * a.dot(b.cross(c)).atan2(below)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algorithms::fixtures::{Cuboid, polygon, scene};

    fn is_closed_in(objects: &[String]) -> bool {
        is_closed(&Patches::of(&scene("", objects), 100_000).unwrap())
    }

    const BLOCK: Cuboid = Cuboid {
        low: [0.3, 0.2, 0.35],
        high: [0.6, 0.7, 0.6],
    };

    fn room() -> Vec<String> {
        Cuboid::UNIT.room("wall", [2; 6])
    }

    #[test]
    fn rooms_are_closed_empty_and_furnished_and_however_they_are_divided() {
        assert!(is_closed_in(&room()));
        let uneven = Cuboid::UNIT.room("wall", [1, 2, 3, 4, 5, 7]);
        assert!(is_closed_in(&uneven));
        let sphere = r#"{"name": "s", "material": "m", "sphere": {"center": [0.8, 0.8, 0.8], "radius": 0.1}}"#;
        let furnished = [uneven, BLOCK.block("block", 2), vec![sphere.into()]].concat();
        assert!(is_closed_in(&furnished));
        let far = Cuboid {
            low: [1e6, -1e6, 1e6],
            high: [1e6 + 1.0, 1.0 - 1e6, 1e6 + 1.0],
        };
        assert!(is_closed_in(&far.room("wall", [3; 6])));
    }

    #[test]
    fn the_smallest_opening_leaves_a_room_open() {
        assert!(!is_closed_in(&room()[..5]));
        for missing in [1e-7, 1e-3] {
            let short = 1.0 - missing;
            let mut open = room();
            let corners = [[0., 1., 0.], [1., 1., 0.], [1., 1., short], [0., 1., short]];
            open[5] = polygon("wall5", &corners, 2);
            assert!(!is_closed_in(&open), "{missing}");
        }
    }

    #[test]
    fn a_back_that_is_seen_leaves_a_room_open() {
        let with = |more: &[String]| is_closed_in(&[&room()[..], more].concat());
        assert!(!with(&BLOCK.block("sheet", 1)[..1]));
        assert!(!with(&BLOCK.room("block inside out", [1; 6])));
        assert!(!is_closed_in(&Cuboid::UNIT.block("room inside out", 2)));
        let low = [0.3, -0.2, 0.35];
        let sunk = Cuboid { low, ..BLOCK };
        assert!(!with(&sunk.block("block through the floor", 1)));
    }
}
