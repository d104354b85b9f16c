//! The faces of a planar subdivision, and how often the line that makes it winds around each.

use super::Place;
use glam::DVec2;
use std::collections::BTreeMap;

/// The borders of the faces of a subdivision.
pub(super) struct Borders {
    /// Of each half-edge, the border to whose left it runs.
    of: Vec<usize>,
    /// Of each border, counter-clockwise; that of the outer face clockwise.
    pub nodes: Vec<Vec<u32>>,
    areas: Vec<f64>,
}

impl Borders {
    pub fn new(places: &[(Place, DVec2)], halves: &[[u32; 2]]) -> Self {
        let at = |node: u32| places[node as usize].1;
        let mut leaving: BTreeMap<u32, Vec<usize>> = BTreeMap::new();
        for (half, [from, _]) in halves.iter().enumerate() {
            leaving.entry(*from).or_default().push(half);
        }
        // Behind a half-edge comes the one that, at its end, stands clockwise next to the way back.
        let mut next = vec![0; halves.len()];
        for leaving in leaving.values_mut() {
            let angle = |half: usize| {
                let [from, to] = halves[half];
                let along = at(to) - at(from);
                along.y.atan2(along.x)
            };
            leaving.sort_by(|&a, &b| angle(a).total_cmp(&angle(b)));
            for (place, &half) in leaving.iter().enumerate() {
                let clockwise = (place + leaving.len() - 1) % leaving.len();
                next[half ^ 1] = leaving[clockwise];
            }
        }
        const NONE: usize = usize::MAX;
        let mut borders = Borders {
            of: vec![NONE; halves.len()],
            nodes: Vec::new(),
            areas: Vec::new(),
        };
        for start in 0..halves.len() {
            if borders.of[start] != NONE {
                continue;
            }
            let (mut nodes, mut area, mut half) = (Vec::new(), 0.0, start);
            while borders.of[half] == NONE {
                borders.of[half] = borders.nodes.len();
                let [from, to] = halves[half];
                area += at(from).perp_dot(at(to));
                nodes.push(from);
                half = next[half];
            }
            borders.nodes.push(nodes);
            borders.areas.push(area);
        }
        borders
    }

    /// The winding number of each face. None where there are none.
    pub fn windings(&self, turns: &[i32]) -> Option<Vec<i32>> {
        let outer =
            (0..self.areas.len()).min_by(|&a, &b| self.areas[a].total_cmp(&self.areas[b]))?;
        let mut around: Vec<Vec<usize>> = vec![Vec::new(); self.nodes.len()];
        for (half, &border) in self.of.iter().enumerate() {
            around[border].push(half);
        }
        let mut windings = vec![None; self.nodes.len()];
        windings[outer] = Some(0);
        let mut open = vec![outer];
        while let Some(border) = open.pop() {
            let here = windings[border]?;
            for &half in &around[border] {
                let beyond = self.of[half ^ 1];
                if windings[beyond].is_none() {
                    // To the left of an edge the polygon winds once more than to its right.
                    windings[beyond] = Some(here - turns[half]);
                    open.push(beyond);
                }
            }
        }
        windings.into_iter().collect()
    }
}
