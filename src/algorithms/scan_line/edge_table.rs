//! The edge table of a polygon, its active edge list, and the spans between the active edges.

use super::clip::clip_near;
use super::corner::{Corner, ScreenCorner};
use super::edge::Edge;
use super::event::Event;
use super::span::Span;
use super::varying::Varying;
use crate::algorithms::focus::Region;
use crate::record::Recorder;
use crate::scene::View;
use std::ops::Range;

/// Every edge of a polygon that passes the centre of a row, sorted by the first such row, and the edges that the current row
/// cuts. It keeps its memory from polygon to polygon.
pub struct EdgeTable<'a, V> {
    view: &'a View,
    region: &'a Region,
    polygon: Vec<Corner<V>>,
    clipped: Vec<Corner<V>>,
    corners: Vec<ScreenCorner<V>>,
    edges: Vec<Edge<V>>,
    /// Indices of the edges that the current row cuts.
    active: Vec<usize>,
    /// How many edges have become active so far.
    activated: usize,
    /// The rows that are still to come.
    rows: Range<u32>,
}

/// A row of pixels, and the height of their centres.
#[derive(Clone, Copy, Debug)]
pub struct ScanLine {
    pub y: u32,
    pub y_4: f64,
}

impl ScanLine {
    pub fn entered<A>(self) -> Event<A> {
        let ScanLine { y, y_4 } = self;
        Event::ScanLine { y, y_4 }
    }
}

impl<'a, V: Varying> EdgeTable<'a, V> {
    /// An empty table for polygons that `view` projects, of which the pixels within `region` are drawn.
    pub fn new(view: &'a View, region: &'a Region) -> Self {
        EdgeTable {
            view,
            region,
            polygon: Vec::new(),
            clipped: Vec::new(),
            corners: Vec::new(),
            edges: Vec::new(),
            active: Vec::new(),
            activated: 0,
            rows: 0..0,
        }
    }

    /// Clips a polygon at the near plane, projects it, and lists its edges.
    pub fn build<E: From<Event<V::Recorded>>>(
        &mut self,
        polygon: impl IntoIterator<Item = Corner<V>>,
        recorder: &mut impl Recorder<E>,
    ) {
        self.polygon.clear();
        self.polygon.extend(polygon);
        clip_near(&self.polygon, self.view.near, &mut self.clipped);
        let corners = self.clipped.len() as u32;
        recorder.enter(|| Event::EdgeTable { corners }.into());
        self.project(recorder);
        self.list_edges(recorder);
        let edges = self.edges.len() as u32;
        recorder.leave(|| Event::EdgeTableBuilt { edges }.into());
    }

    fn project<E: From<Event<V::Recorded>>>(&mut self, recorder: &mut impl Recorder<E>) {
        self.corners.clear();
        for (number, corner) in self.clipped.iter().enumerate() {
            let screen = self.view.to_screen(corner.position);
            let inverse_depth = 1.0 / corner.position.z;
            let number = number as u32;
            recorder.step(|| {
                Event::CornerTransformed {
                    corner: number,
                    position: corner.position,
                }
                .into()
            });
            recorder.step(|| {
                Event::CornerPlaced {
                    corner: number,
                    x: screen.x,
                    y: screen.y,
                    z: 1.0 / inverse_depth,
                    value: corner.value.recorded(),
                }
                .into()
            });
            if let Some(uv) = corner.value.texture() {
                recorder.step(|| Event::CornerTextured { corner: number, uv }.into());
            }
            self.corners.push(ScreenCorner {
                x: screen.x,
                y: screen.y,
                inverse_depth,
                value: corner.value,
            });
        }
    }

    fn list_edges<E: From<Event<V::Recorded>>>(&mut self, recorder: &mut impl Recorder<E>) {
        self.edges.clear();
        let count = self.corners.len();
        for from in 0..count {
            let to = (from + 1) % count;
            match Edge::between(&self.corners, from, to, self.view.height) {
                Some(edge) => {
                    recorder.step(|| edge.listed().into());
                    self.edges.push(edge);
                }
                None => recorder.step(|| {
                    Event::EdgeSkipped {
                        from: from as u32,
                        to: to as u32,
                    }
                    .into()
                }),
            }
        }
        self.edges.sort_by_key(|edge| edge.first);
        self.active.clear();
        self.activated = 0;
        let first = self.edges.first().map_or(0, |edge| edge.first);
        let end = self.edges.iter().map(|edge| edge.end).max().unwrap_or(0);
        self.rows = first..end.min(self.region.rows.end);
    }

    /// Goes down to the next row of the region, and brings the active edge list there. Rows above the region are passed one by
    /// one: increments count from the polygon's first row, so that the values of a pixel do not depend on the region.
    pub fn next_scan_line(&mut self) -> Option<ScanLine> {
        for y in self.rows.by_ref() {
            for &edge in &self.active {
                self.edges[edge].advance();
            }
            while self.activated < self.edges.len() && self.edges[self.activated].first == y {
                self.active.push(self.activated);
                self.activated += 1;
            }
            self.active.retain(|&edge| self.edges[edge].end > y);
            if self.region.rows.contains(&y) {
                let y_4 = f64::from(y) + 0.5;
                for &edge in &self.active {
                    self.edges[edge].cut(y_4);
                }
                return Some(ScanLine { y, y_4 });
            }
        }
        None
    }

    /// The edges that the current scan line cuts.
    pub fn active_edges(&self) -> impl Iterator<Item = &Edge<V>> {
        self.active.iter().map(|&edge| &self.edges[edge])
    }

    /// The spans of the current scan line, between each pair of active edges from left to right.
    pub fn spans(&mut self, line: ScanLine) -> impl Iterator<Item = Span<V>> {
        self.active
            .sort_by(|&a, &b| self.edges[a].x_4.total_cmp(&self.edges[b].x_4));
        let (edges, columns, view) = (&self.edges, &self.region.columns, self.view);
        self.active.chunks_exact(2).map(move |pair| {
            let (left, right) = (&edges[pair[0]], &edges[pair[1]]);
            Span::between(left, right, line.y, columns, view)
        })
    }
}
