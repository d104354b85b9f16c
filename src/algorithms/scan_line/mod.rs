//! Scan conversion of one polygon: edge table, active edge list, spans, depth buffer
//! (Wylie, Romney, Evans, Erdahl 1967; Catmull 1974; Foley, van Dam, Feiner, Hughes 1990, §3.6 and §15.4).
//!
//! Convex and concave polygons, even–odd. A pixel belongs to a polygon when its centre is inside, half-open: on an edge
//! shared by two polygons it belongs to exactly one of them. Whatever is carried by the corners (an intensity, a normal)
//! is interpolated along edges and then along spans, linearly on the screen, by increments; the direct value is computed
//! where somebody looks. Where an edge lies is always computed directly, so that no drift moves a pixel across it.
//!
//! Screen frame: pixels, x to the right, y down; pixel (x, y) has its centre at (x + 0.5, y + 0.5). Depth is the distance
//! along the viewing direction; its inverse is linear on the screen.

mod clip;
mod edge;
mod event;

use super::focus::Region;
use super::frame::Frame;
use crate::color::Rgb;
use crate::numeric::{Linear, Ramp, interpolate};
use crate::record::{Recorder, Value};
use crate::scene::View;
use edge::Edge;
use glam::{DVec2, DVec3};
use std::fmt::Debug;

pub use clip::clip_near;
pub use event::{Event, Names};

#[cfg(test)]
mod tests;

/// What the corners of a polygon carry, and how its values are called.
pub trait Carried: Linear + Default + PartialEq + Debug + Send + Sync + 'static {
    /// Names of the interpolated values; `None` where nothing is carried and so nothing is told of it.
    const NAMES: Option<&'static Names>;
    /// As a recorded value.
    fn value(self) -> Option<Value>;
}

/// What goes from the corners to the pixels: a carried value alone, or with more that goes along untold.
pub trait Cargo: Linear {
    type Recorded: Carried;
    fn recorded(self) -> Self::Recorded;
}

impl<A: Carried> Cargo for A {
    type Recorded = A;
    fn recorded(self) -> A {
        self
    }
}

/// A corner in the camera frame with what it carries.
#[derive(Clone, Copy, Debug)]
pub struct Corner<A> {
    pub position: DVec3,
    pub value: A,
}

impl<A> Corner<A> {
    /// The same corner with another value.
    pub fn with<B>(&self, value: B) -> Corner<B> {
        Corner {
            position: self.position,
            value,
        }
    }
}

/// A corner on the screen.
#[derive(Clone, Copy, Debug)]
struct ScreenCorner<A> {
    x: f64,
    y: f64,
    inverse_depth: f64,
    value: A,
}

/// A pixel inside a polygon, nearer than what was drawn there before.
#[derive(Clone, Copy, Debug)]
pub struct Fragment<A> {
    pub x: u32,
    pub y: u32,
    /// The first pixel of its span.
    pub first: u32,
    /// As interpolated by increments.
    pub value: A,
    /// 1/depth, likewise.
    pub inverse_depth: f64,
}

impl<A> Fragment<A> {
    /// The same pixel with another value.
    pub fn with<B>(self, value: B) -> Fragment<B> {
        let Fragment {
            x,
            y,
            first,
            inverse_depth,
            ..
        } = self;
        Fragment {
            x,
            y,
            first,
            value,
            inverse_depth,
        }
    }

    /// The point of the polygon that the pixel's centre shows, in the world. 1/depth is linear on the screen, so it lies on the
    /// polygon however much the depth changes from corner to corner.
    pub fn position(&self, view: &View) -> DVec3 {
        let centre = DVec2::new(f64::from(self.x) + 0.5, f64::from(self.y) + 0.5);
        view.from_screen(centre, 1.0 / self.inverse_depth)
    }
}

/// Scan converter with the memory that it uses from polygon to polygon.
pub struct ScanLine<A> {
    clipped: Vec<Corner<A>>,
    corners: Vec<ScreenCorner<A>>,
    edge_table: Vec<Edge<A>>,
    /// Indices into the edge table.
    active: Vec<usize>,
}

impl<A> Default for ScanLine<A> {
    fn default() -> Self {
        ScanLine {
            clipped: Vec::new(),
            corners: Vec::new(),
            edge_table: Vec::new(),
            active: Vec::new(),
        }
    }
}

impl<A: Cargo> ScanLine<A> {
    /// Draws a polygon into `frame`, in the pixels of `region` only. `shade` turns a fragment into a colour.
    ///
    /// The values of a pixel do not depend on the region: increments count from the border of the frame.
    pub fn fill<E: From<Event<A::Recorded>>, R: Recorder<E>>(
        &mut self,
        polygon: &[Corner<A>],
        view: &View,
        region: &Region,
        frame: &mut Frame,
        recorder: &mut R,
        mut shade: impl FnMut(&mut R, Fragment<A>) -> Rgb,
    ) {
        clip_near(polygon, view.near, &mut self.clipped);
        self.project(view);
        self.build_edge_table(view.height, recorder);

        let first = self
            .edge_table
            .iter()
            .map(|edge| edge.first)
            .min()
            .unwrap_or(0);
        let end = self
            .edge_table
            .iter()
            .map(|edge| edge.end)
            .max()
            .unwrap_or(0)
            .min(region.rows.end);
        self.active.clear();
        let mut next = 0;
        for y in first..end {
            while next < self.edge_table.len() && self.edge_table[next].first == y {
                self.active.push(next);
                next += 1;
            }
            self.active.retain(|&edge| self.edge_table[edge].end > y);
            if region.rows.contains(&y) {
                self.scan(y, region, frame, recorder, &mut shade);
            }
            for &edge in &self.active {
                self.edge_table[edge].advance();
            }
        }
    }

    fn project(&mut self, view: &View) {
        self.corners.clear();
        self.corners.extend(self.clipped.iter().map(|corner| {
            let screen = view.to_screen(corner.position);
            ScreenCorner {
                x: screen.x,
                y: screen.y,
                inverse_depth: 1.0 / corner.position.z,
                value: corner.value,
            }
        }));
    }

    /// Every edge that passes the centre of a row, sorted by the first such row.
    fn build_edge_table<E: From<Event<A::Recorded>>>(
        &mut self,
        height: u32,
        recorder: &mut impl Recorder<E>,
    ) {
        let count = self.corners.len();
        recorder.enter(|| {
            Event::EdgeTable {
                corners: count as u32,
            }
            .into()
        });
        for (number, corner) in self.corners.iter().enumerate() {
            let ScreenCorner {
                x,
                y,
                inverse_depth,
                value,
            } = *corner;
            recorder.step(|| {
                Event::CornerPlaced {
                    corner: number as u32,
                    x,
                    y,
                    z: 1.0 / inverse_depth,
                    value: value.recorded(),
                }
                .into()
            });
        }
        self.edge_table.clear();
        for from in 0..count {
            let to = (from + 1) % count;
            match Edge::between(&self.corners, from, to, height) {
                Some(edge) => {
                    recorder.step(|| edge.entered().into());
                    self.edge_table.push(edge);
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
        self.edge_table.sort_by_key(|edge| edge.first);
        recorder.leave(|| {
            Event::EdgeTableBuilt {
                edges: self.edge_table.len() as u32,
            }
            .into()
        });
    }

    /// One scan line: where it cuts the active edges, and the spans between each pair of cuts.
    fn scan<E: From<Event<A::Recorded>>, R: Recorder<E>>(
        &mut self,
        y: u32,
        region: &Region,
        frame: &mut Frame,
        recorder: &mut R,
        shade: &mut impl FnMut(&mut R, Fragment<A>) -> Rgb,
    ) {
        let y_4 = f64::from(y) + 0.5;
        recorder.enter(|| Event::ScanLine { y, y_4 }.into());
        for &active in &self.active {
            let edge = &mut self.edge_table[active];
            edge.cut(y_4);
            recorder.enter(|| edge.scope().into());
            if A::Recorded::NAMES.is_some() {
                recorder.step(|| {
                    Event::EdgeEnds {
                        a_1: edge.upper.value.recorded(),
                        a_2: edge.lower.value.recorded(),
                    }
                    .into()
                });
                recorder.leave(|| {
                    Event::EdgeInterpolated {
                        direct: edge.value_at(y_4).recorded(),
                        incremental: edge.value.value.recorded(),
                    }
                    .into()
                });
            } else {
                recorder.leave(|| Event::EdgeCut.into());
            }
        }
        self.active
            .sort_by(|&a, &b| self.edge_table[a].x_4.total_cmp(&self.edge_table[b].x_4));
        for pair in self.active.chunks_exact(2) {
            fill_span(
                y,
                &self.edge_table[pair[0]],
                &self.edge_table[pair[1]],
                region,
                frame,
                recorder,
                shade,
            );
        }
        recorder.leave(|| Event::ScanLineDone.into());
    }
}

/// The pixels of row `y` whose centres lie between two edges, the left one included.
fn fill_span<A: Cargo, E: From<Event<A::Recorded>>, R: Recorder<E>>(
    y: u32,
    left: &Edge<A>,
    right: &Edge<A>,
    region: &Region,
    frame: &mut Frame,
    recorder: &mut R,
    shade: &mut impl FnMut(&mut R, Fragment<A>) -> Rgb,
) {
    let (x_4, x_5) = (left.x_4, right.x_4);
    let (a_4, a_5) = (left.value.value, right.value.value);
    let first = first_centre(x_4, frame.width);
    let end = first_centre(x_5, frame.width);
    recorder.enter(|| {
        Event::Span {
            x_4,
            x_5,
            first,
            end,
        }
        .into()
    });
    if A::Recorded::NAMES.is_some() {
        let [a_4, a_5] = [a_4, a_5].map(Cargo::recorded);
        recorder.step(|| Event::SpanEnds { a_4, a_5 }.into());
    }
    if first < end {
        let start = f64::from(first) + 0.5;
        let mut value = Ramp::start(a_4, x_4, a_5, x_5, start);
        let mut inverse_depth = Ramp::start(
            left.inverse_depth.value,
            x_4,
            right.inverse_depth.value,
            x_5,
            start,
        );
        for x in first..end.min(region.columns.end) {
            if x >= region.columns.start {
                let x_p = f64::from(x) + 0.5;
                recorder.enter(|| Event::Pixel { x, y, x_p }.into());
                let index = frame.index(x, y);
                let nearer = inverse_depth.value > frame.inverse_depth[index];
                recorder.step(|| {
                    Event::DepthTested {
                        z: 1.0 / inverse_depth.value,
                        nearest: 1.0 / frame.inverse_depth[index],
                        nearer,
                    }
                    .into()
                });
                if nearer {
                    if A::Recorded::NAMES.is_some() {
                        recorder.step(|| {
                            Event::SpanInterpolated {
                                direct: interpolate(a_4, x_4, a_5, x_5, x_p).recorded(),
                                incremental: value.value.recorded(),
                            }
                            .into()
                        });
                    }
                    let color = shade(
                        recorder,
                        Fragment {
                            x,
                            y,
                            first,
                            value: value.value,
                            inverse_depth: inverse_depth.value,
                        },
                    );
                    frame.inverse_depth[index] = inverse_depth.value;
                    frame.color[index] = color;
                    recorder.leave(|| Event::PixelColored { color }.into());
                } else {
                    recorder.leave(|| Event::PixelHidden.into());
                }
            }
            value.advance();
            inverse_depth.advance();
        }
    }
    recorder.leave(|| Event::SpanDone.into());
}

/// The first row or column, within 0..=size, whose centre is not before `edge`.
#[inline]
pub fn first_centre(edge: f64, size: u32) -> u32 {
    // A cast from float saturates, and takes NaN to 0.
    ((edge - 0.5).ceil() as u32).min(size)
}
