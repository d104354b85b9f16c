//! Polygons that cross themselves, as the regions that the even-odd rule fills: the faces of the planar subdivision that the edges make,
//! of odd winding number (Foley, van Dam, Feiner, Hughes 1990, §3.6 and §19.2).
//!
//! A closed line is in one piece, so each face of its subdivision has one border, without holes.

mod borders;

use borders::Borders;
use glam::DVec2;
use std::collections::{BTreeMap, HashMap};

/// Within this distance, where the polygon's extent is 1, two places are one.
const TOUCHING: f64 = 1e-12;

/// The most places at which a polygon may meet itself.
const MOST_CONTACTS: usize = 20_000;

/// A corner of a region: at `share` of the edge that leaves corner `edge` of the polygon. Share 0 is that corner itself.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Place {
    pub edge: u32,
    pub share: f64,
}

/// How a polygon lies in its plane.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Outline {
    /// It winds once around every point inside. It may touch itself, as one with a hole joined to its rim does.
    Simple,
    /// The regions that the even-odd rule fills, counter-clockwise, apart but for their borders.
    Crossing(Vec<Vec<Place>>),
    /// It meets itself too often to be worked out.
    TooOften,
}

/// The outline of a polygon whose extent is about 1. `pairs` is how many pairs of edges may still be compared; it is counted down.
pub(super) fn outline(corners: &[DVec2], pairs: &mut usize) -> Outline {
    let mut subdivision = Subdivision::new(corners);
    match subdivision.cut(pairs) {
        None => Outline::TooOften,
        Some(0) if !subdivision.repeats => Outline::Simple,
        Some(_) => subdivision.regions(),
    }
}

/// Edges cut where they meet others. Nodes are the corners, then the crossings.
struct Subdivision {
    nodes: Vec<(Place, DVec2)>,
    /// A node that stands for the same place, in the end itself.
    same: Vec<u32>,
    /// Each once, however often the polygon runs along it.
    edges: Vec<Edge>,
    /// Whether it comes back to a corner or an edge.
    repeats: bool,
    contacts: usize,
}

struct Edge {
    from: u32,
    to: u32,
    /// The edge of the polygon that first runs along it, from `from` to `to`.
    first: u32,
    /// How often the polygon runs along it that way, less how often the other way.
    turns: i32,
    /// The nodes on it and their shares.
    cuts: Vec<(f64, u32)>,
}

impl Subdivision {
    fn new(corners: &[DVec2]) -> Self {
        let nodes: Vec<(Place, DVec2)> = (0..)
            .zip(corners)
            .map(|(edge, &at)| (Place { edge, share: 0.0 }, at))
            .collect();
        let mut first_at = HashMap::new();
        let same: Vec<u32> = (0..)
            .zip(corners)
            .map(|(corner, &at)| {
                *first_at
                    .entry((at + DVec2::ZERO).to_array().map(f64::to_bits))
                    .or_insert(corner)
            })
            .collect();
        let mut repeats = first_at.len() < corners.len();
        let mut number_of = HashMap::new();
        let mut edges: Vec<Edge> = Vec::new();
        for (first, &from) in (0..).zip(&same) {
            let to = same[(first as usize + 1) % same.len()];
            if from == to {
                continue;
            }
            let number = *number_of
                .entry([from.min(to), from.max(to)])
                .or_insert(edges.len());
            match edges.get_mut(number) {
                Some(edge) => {
                    edge.turns += if edge.from == from { 1 } else { -1 };
                    repeats = true;
                }
                None => edges.push(Edge {
                    from,
                    to,
                    first,
                    turns: 1,
                    cuts: Vec::new(),
                }),
            }
        }
        Subdivision {
            nodes,
            same,
            edges,
            repeats,
            contacts: 0,
        }
    }

    fn at(&self, node: u32) -> DVec2 {
        self.nodes[node as usize].1
    }

    /// Finds where edges meet, by a sweep along x. Returns how often; none where that is too much work.
    fn cut(&mut self, pairs: &mut usize) -> Option<usize> {
        let boxes: Vec<[DVec2; 2]> = (self.edges.iter())
            .map(|edge| [edge.from, edge.to].map(|node| self.at(node)))
            .map(|[a, b]| [a.min(b) - TOUCHING, a.max(b) + TOUCHING])
            .collect();
        let mut order: Vec<usize> = (0..boxes.len()).collect();
        order.sort_by(|&a, &b| boxes[a][0].x.total_cmp(&boxes[b][0].x));
        for (place, &a) in order.iter().enumerate() {
            let [low, high] = boxes[a];
            for &b in &order[place + 1..] {
                if boxes[b][0].x > high.x {
                    break;
                }
                *pairs = pairs.checked_sub(1)?;
                if boxes[b][0].y <= high.y && boxes[b][1].y >= low.y {
                    self.meet(a, b);
                }
                if self.contacts > MOST_CONTACTS {
                    return None;
                }
            }
        }
        Some(self.contacts)
    }

    /// Cuts two edges where they cross, touch or lie on each other.
    fn meet(&mut self, a: usize, b: usize) {
        let [ends, others] = [a, b].map(|edge| [self.edges[edge].from, self.edges[edge].to]);
        let touching = [(ends[0], b), (ends[1], b), (others[0], a), (others[1], a)]
            .map(|(corner, edge)| self.touch(corner, edge));
        let are_neighbours = ends.iter().any(|end| others.contains(end));
        if are_neighbours || touching.contains(&true) {
            return;
        }
        let [[p, q], [r, s]] = [ends, others].map(|ends| ends.map(|node| self.at(node)));
        let (along, across) = (q - p, s - r);
        let side = |point: DVec2| along.perp_dot(point - p);
        let other_side = |point: DVec2| across.perp_dot(point - r);
        if side(r) * side(s) >= 0.0 || other_side(p) * other_side(q) >= 0.0 {
            return;
        }
        let share = other_side(p) / (other_side(p) - other_side(q));
        let node = self.nodes.len() as u32;
        let edge = self.edges[a].first;
        self.nodes.push((Place { edge, share }, p + share * along));
        self.same.push(node);
        self.edges[a].cuts.push((share, node));
        let share = side(r) / (side(r) - side(s));
        self.edges[b].cuts.push((share, node));
        self.contacts += 1;
    }

    /// Joins a corner to an edge that it lies on, or to the end of one. Whether it does.
    fn touch(&mut self, corner: u32, edge: usize) -> bool {
        let Edge { from, to, .. } = self.edges[edge];
        if corner == from || corner == to {
            return false;
        }
        let (point, start) = (self.at(corner), self.at(from));
        let along = self.at(to) - start;
        let share = ((point - start).dot(along) / along.length_squared()).clamp(0.0, 1.0);
        if point.distance(start + share * along) > TOUCHING {
            return false;
        }
        let length = along.length();
        if share * length <= TOUCHING {
            self.join(corner, from);
        } else if (1.0 - share) * length <= TOUCHING {
            self.join(corner, to);
        } else {
            self.edges[edge].cuts.push((share, corner));
        }
        self.contacts += 1;
        true
    }

    fn node(&self, mut node: u32) -> u32 {
        while self.same[node as usize] != node {
            node = self.same[node as usize];
        }
        node
    }

    fn join(&mut self, a: u32, b: u32) {
        let (a, b) = (self.node(a), self.node(b));
        self.same[a.max(b) as usize] = a.min(b);
    }

    /// The pieces of edges between neighbouring nodes, from the lower to the higher: how often they are run along that way, less how often the
    /// other way.
    fn pieces(&mut self) -> BTreeMap<[u32; 2], i32> {
        let mut edges = std::mem::take(&mut self.edges);
        for edge in &mut edges {
            edge.cuts.sort_by(|a, b| a.0.total_cmp(&b.0));
            let length = self.at(edge.from).distance(self.at(edge.to));
            for pair in edge.cuts.windows(2) {
                if (pair[1].0 - pair[0].0) * length <= TOUCHING {
                    self.join(pair[0].1, pair[1].1);
                }
            }
        }
        let mut pieces = BTreeMap::new();
        for edge in &edges {
            let mut from = self.node(edge.from);
            for to in edge.cuts.iter().map(|&(_, node)| node).chain([edge.to]) {
                let to = self.node(to);
                if to != from {
                    let turns = pieces.entry([from.min(to), from.max(to)]).or_insert(0);
                    *turns += if from < to { edge.turns } else { -edge.turns };
                }
                from = to;
            }
        }
        pieces
    }

    fn regions(mut self) -> Outline {
        let pieces = self.pieces();
        // Half-edge 2k runs from the lower to the higher node of piece k, and 2k + 1 back.
        let halves: Vec<[u32; 2]> = pieces.keys().flat_map(|&[a, b]| [[a, b], [b, a]]).collect();
        let turns: Vec<i32> = pieces.values().flat_map(|&turns| [turns, -turns]).collect();
        let borders = Borders::new(&self.nodes, &halves);
        let Some(windings) = borders.windings(&turns) else {
            return Outline::Simple;
        };
        let is_simple = |inside: i32| {
            windings
                .iter()
                .all(|&winding| winding == 0 || winding == inside)
        };
        if is_simple(1) || is_simple(-1) {
            return Outline::Simple;
        }
        let odd = (0..windings.len()).filter(|&border| windings[border] % 2 != 0);
        let regions = odd.map(|border| {
            let nodes = without_spikes(borders.nodes[border].clone());
            nodes
                .iter()
                .map(|&node| self.nodes[node as usize].0)
                .collect()
        });
        Outline::Crossing(
            regions
                .filter(|region: &Vec<Place>| region.len() > 2)
                .collect(),
        )
    }
}

/// Nodes in a ring, without those at which it turns back on itself.
fn without_spikes(ring: Vec<u32>) -> Vec<u32> {
    let mut nodes: Vec<u32> = Vec::with_capacity(ring.len());
    for node in ring {
        match nodes[..] {
            [.., before, _] if before == node => {
                nodes.pop();
            }
            _ => nodes.push(node),
        }
    }
    // The same across the end of the list
    while let [first, second, .., before, last] = nodes[..] {
        if last == second {
            nodes.remove(0);
        } else if before == first {
            nodes.pop();
        } else {
            break;
        }
        nodes.pop();
    }
    nodes
}

#[cfg(test)]
mod tests;
