//! The state of a scan-line method at one step: what is known so far of the current polygon, vertex, scan line and pixel, and
//! the picture as far as it is drawn. One state serves every method, whatever it interpolates.

use super::Canvas;
use super::Fold;
pub use super::current::{
    ActiveEdge, CurrentCorner, CurrentCut, CurrentLight, CurrentPixel, CurrentPoint,
    CurrentPolygon, CurrentRow, CurrentSpan, CurrentVertex, Interpolated,
};
use crate::algorithms::prepared_scene::{self, PreparedScene};
use crate::algorithms::scan_line::{Named, Names};
use crate::algorithms::shading::{Event, ShadingEvent};
use crate::algorithms::{scan_line, vertex_normal};
use crate::color::Rgb;
use crate::record::Value;
use glam::DVec3;
use std::sync::Arc;

/// A pixel of the picture so far.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dot {
    pub color: Rgb,
    /// The step that coloured it, if any.
    pub step: Option<u32>,
    /// Of what was drawn there, along the view; infinite where none was recorded.
    pub depth: f64,
}

impl Canvas<Dot> {
    /// The picture before the first step: background, coloured by no step.
    pub(super) fn blank(prepared: &PreparedScene) -> Self {
        let background = Dot {
            color: prepared.scene.background,
            step: None,
            depth: f64::INFINITY,
        };
        let view = &prepared.view;
        Canvas::new(view.width as usize, view.height as usize, background)
    }
}

#[derive(Clone, Debug)]
pub struct State {
    /// What does not change from step to step.
    pub prepared: Arc<PreparedScene>,
    /// The names of the values that the method interpolates, if any.
    pub names: Option<&'static Names>,
    pub canvas: Canvas<Dot>,
    pub polygon: Option<CurrentPolygon>,
    /// The vertex whose normal and intensity are being found.
    pub vertex: Option<CurrentVertex>,
    /// The vertices that were lit for the current polygon, with their intensities; others were lit for an earlier one.
    pub lit: Vec<(u32, Rgb)>,
    /// The vertices that were given their normals, and are not lit.
    pub normals: Vec<(u32, DVec3)>,
    /// The point that is being lit.
    pub point: Option<CurrentPoint>,
    pub corners: Vec<CurrentCorner>,
    pub edges: Vec<ActiveEdge>,
    pub scan_line: Option<CurrentRow>,
    /// The edge that is being cut, an index into `edges`.
    pub edge: Option<usize>,
    /// The edges that the current scan line has cut so far.
    cut: Vec<usize>,
    pub span: Option<CurrentSpan>,
    pub pixel: Option<CurrentPixel>,
}

impl State {
    /// Before the first step: an empty picture.
    pub fn new<A: Named>(prepared: Arc<PreparedScene>) -> Self {
        State {
            names: A::NAMES,
            canvas: Canvas::blank(&prepared),
            prepared,
            polygon: None,
            vertex: None,
            lit: Vec::new(),
            normals: Vec::new(),
            point: None,
            corners: Vec::new(),
            edges: Vec::new(),
            scan_line: None,
            edge: None,
            cut: Vec::new(),
            span: None,
            pixel: None,
        }
    }

    /// Bytes of a copy, the canvas aside.
    fn bytes(&self) -> usize {
        let faces = self
            .vertex
            .as_ref()
            .map_or(0, |vertex| size_of_val(&*vertex.faces));
        let lights = self
            .point
            .as_ref()
            .map_or(0, |point| size_of_val(&*point.lights));
        let lists = size_of_val(&*self.corners)
            + size_of_val(&*self.edges)
            + size_of_val(&*self.lit)
            + size_of_val(&*self.normals)
            + size_of_val(&*self.cut);
        size_of::<Self>() + faces + lights + lists
    }

    /// Forgets what belongs to one polygon.
    fn clear_polygon(&mut self) {
        self.vertex = None;
        self.lit.clear();
        self.normals.clear();
        self.point = None;
        self.corners.clear();
        self.edges.clear();
        self.clear_scan_line();
    }

    fn clear_scan_line(&mut self) {
        self.scan_line = None;
        self.edge = None;
        self.span = None;
        self.pixel = None;
        for cut in self.cut.drain(..) {
            if let Some(edge) = self.edges.get_mut(cut) {
                edge.cut = None;
            }
        }
    }

    fn find_polygon(&mut self, event: &prepared_scene::Event) {
        match *event {
            prepared_scene::Event::Polygon { polygon, .. } => {
                self.clear_polygon();
                self.polygon = Some(CurrentPolygon { polygon });
            }
            prepared_scene::Event::PolygonDone => {
                self.clear_polygon();
                self.polygon = None;
            }
            prepared_scene::Event::Frame { .. } | prepared_scene::Event::FrameDone => {}
        }
    }

    fn find_normal(&mut self, step: usize, event: &vertex_normal::Event) {
        let Some(vertex) = &mut self.vertex else {
            return;
        };
        match *event {
            vertex_normal::Event::FaceNormalAdded { face, normal, sum } => {
                vertex.faces.push((face, normal, step));
                vertex.sum = sum;
            }
            vertex_normal::Event::VertexNormal { normal, .. }
            | vertex_normal::Event::FileNormal { normal }
            | vertex_normal::Event::NormalVanished { normal, .. } => {
                vertex.normal = Some(normal);
            }
        }
    }
}

impl State {
    fn convert<A: Named>(&mut self, step: usize, event: &scan_line::Event<A>) {
        use scan_line::Event;
        match *event {
            Event::EdgeTable { .. } => {
                self.corners.clear();
                self.edges.clear();
            }
            Event::CornerPlaced { x, y, value, .. } => self.corners.push(CurrentCorner {
                x,
                y,
                value: value.value(),
            }),
            Event::EdgeEntered {
                edge,
                upper,
                lower,
                first,
                end,
                slope,
                step,
            } => {
                self.edges.push(ActiveEdge {
                    edge,
                    upper,
                    lower,
                    first,
                    end,
                    slope,
                    value_step: step.value(),
                    cut: None,
                });
            }
            Event::CornerTransformed { .. }
            | Event::CornerTextured { .. }
            | Event::EdgeSkipped { .. }
            | Event::EdgeTableBuilt { .. } => {}
            Event::ScanLine { y, y_4 } => {
                self.clear_scan_line();
                self.scan_line = Some(CurrentRow { y, y_4 });
            }
            Event::ScanLineDone => self.clear_scan_line(),
            Event::Edge { edge, x_4, .. } => {
                // Edges enter the table in the order of their numbers.
                self.edge = self
                    .edges
                    .binary_search_by_key(&edge, |known| known.edge)
                    .ok();
                self.cut.extend(self.edge);
                self.current_cut(|edge| {
                    edge.cut = Some(CurrentCut {
                        x_4,
                        values: None,
                        step,
                    })
                });
            }
            Event::EdgeEnds { .. } | Event::EdgeTextured { .. } | Event::SpanTextured { .. } => {}
            Event::EdgeInterpolated {
                direct,
                incremental,
            } => self.current_cut(|edge| {
                if let Some(cut) = &mut edge.cut {
                    cut.values = Interpolated::new(direct, incremental);
                    cut.step = step;
                }
            }),
            Event::EdgeCut => {}
            Event::Span {
                x_4,
                x_5,
                first,
                end,
                ..
            } => {
                self.edge = None;
                self.pixel = None;
                self.span = Some(CurrentSpan {
                    x_4,
                    x_5,
                    first,
                    end,
                    ends: None,
                });
            }
            Event::SpanEnds { left, right } => {
                if let Some(span) = &mut self.span {
                    span.ends = left.value().zip(right.value()).map(<[Value; 2]>::from);
                }
            }
            Event::SpanDone => {
                self.span = None;
                self.pixel = None;
            }
            Event::Pixel { x, y, x_p } => {
                self.pixel = Some(CurrentPixel {
                    x,
                    y,
                    x_p,
                    depth: None,
                    values: None,
                    step,
                })
            }
            Event::DepthTested { z, nearest, nearer } => {
                if let Some(pixel) = &mut self.pixel {
                    pixel.depth = Some((z, nearest, nearer));
                }
            }
            Event::SpanInterpolated {
                direct,
                incremental,
            } => {
                if let Some(pixel) = &mut self.pixel {
                    pixel.values = Interpolated::new(direct, incremental);
                }
            }
            Event::PixelColored { color } => {
                if let Some(pixel) = &self.pixel {
                    self.canvas.set(
                        pixel.x as usize,
                        pixel.y as usize,
                        Dot {
                            color,
                            step: Some(step as u32),
                            depth: pixel.depth.map_or(f64::INFINITY, |(z, ..)| z),
                        },
                    );
                }
            }
            Event::PixelHidden => {}
        }
    }

    fn current_cut(&mut self, change: impl FnOnce(&mut ActiveEdge)) {
        if let Some(edge) = self.edge.and_then(|edge| self.edges.get_mut(edge)) {
            change(edge);
        }
    }
}

/// Events that a method has beyond its family change nothing here.
impl<E: ShadingEvent> Fold<E> for State {
    fn apply(&mut self, step: usize, event: &E) {
        let Some(event) = event.shading() else {
            return;
        };
        match *event {
            Event::PreparedScene(ref event) => self.find_polygon(event),
            Event::Middle { .. }
            | Event::PixelPoint { .. }
            | Event::Texture(_)
            | Event::PixelNormal { .. }
            | Event::PixelNormalLost { .. }
            | Event::TruePoint { .. } => {}
            Event::Vertex { vertex, position } => {
                self.point = None;
                self.vertex = Some(CurrentVertex {
                    vertex,
                    position,
                    faces: Vec::new(),
                    sum: DVec3::ZERO,
                    normal: None,
                    intensity: None,
                });
            }
            Event::VertexReady { vertex } => {
                let normal = self.vertex.as_ref().and_then(|vertex| vertex.normal);
                self.normals.extend(normal.map(|normal| (vertex, normal)));
            }
            Event::Normal(ref event) => self.find_normal(step, event),
            Event::Illumination(ref event) => CurrentPoint::light(&mut self.point, step, event),
            Event::VertexLit { vertex, intensity } => {
                self.lit.push((vertex, intensity));
                if let Some(vertex) = &mut self.vertex {
                    vertex.intensity = Some(intensity);
                }
            }
            Event::ScanLine(ref event) => {
                // A point stays with what it was lit for: a vertex, a pixel, or the whole polygon.
                let of_vertex = self.vertex.take().is_some();
                let lit = self.point.as_ref().map(|point| point.step);
                let of_pixel = self.pixel.is_some_and(|pixel| lit > Some(pixel.step))
                    && !matches!(event, scan_line::Event::PixelColored { .. });
                if of_vertex || of_pixel {
                    self.point = None;
                }
                self.convert(step, event);
            }
        }
    }

    fn bytes_beyond(&self, before: &Self) -> usize {
        self.bytes() + self.canvas.bytes_beyond(&before.canvas)
    }
}
