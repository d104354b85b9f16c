//! Gouraud shading: intensity at the vertices, interpolated along edges, then along scan lines
//! (Gouraud, "Continuous shading of curved surfaces", IEEE Transactions on Computers 1971, §III).
//!
//! N_v = Σ N_k / |Σ N_k| over the faces that share vertex v; I_v = illumination(N_v);
//! I_4 = (y_4−y_2)/(y_1−y_2)·I_1 + (y_1−y_4)/(y_1−y_2)·I_2 on an edge, and
//! I_P = (x_5−x_P)/(x_5−x_4)·I_4 + (x_P−x_4)/(x_5−x_4)·I_5 on a span. The slide counts y upward, the rows here count down;
//! the formulas are the same. What is drawn is the incremental value, I' = I + ΔI; the direct one is told beside it.

use super::focus::Focus;
use super::frame::Frame;
use super::illumination::{self, SurfacePoint, illuminate};
use super::scan_line::{self, Carried, Corner, Names, Part, ScanLine};
use super::stage::{self, Stage};
use super::vertex_normal::{self, vertex_normal};
use crate::color::Rgb;
use crate::record::{self, Fields, Line, Listing, Recorder};

pub static PSEUDOCODE: Listing = Listing {
    name: "Gouraud",
    lines: &[
        "for each polygon",
        "  for each vertex v not yet lit",
        "    N_v ← ΣN_k / |ΣN_k|",
        "    I_v ← illumination(v, N_v)",
        "  build the edge table",
        "  for each scan line y",
        "    for each active edge",
        "      I_4 ← interpolate I_1, I_2",
        "    for each span from x_4 to x_5",
        "      for each pixel x_P",
        "        if nearer than the depth buffer",
        "          I_P ← interpolate I_4, I_5",
        "          pixel ← I_P",
    ],
};

/// Draws the part of the stage that `focus` takes into `frame`, a band of the picture of the stage's view.
pub fn gouraud<R: Recorder<Event>>(
    stage: &Stage,
    focus: Focus,
    frame: &mut Frame,
    recorder: &mut R,
) {
    let region = focus.region(frame);
    let lighting = stage.lighting();
    let mut scan_line = ScanLine::default();
    let mut corners = Vec::new();
    let mut lit: Vec<Option<Rgb>> = Vec::new();
    let mut object = None;

    recorder.enter(|| stage.entered().into());
    for polygon in stage.polygons(focus, &region) {
        recorder.enter(|| polygon.entered().into());
        if object != Some(polygon.object) {
            object = Some(polygon.object);
            lit.clear();
            lit.resize(polygon.mesh.vertex_count(), None);
        }

        // Intensity at each vertex, once for all the polygons that share it
        corners.clear();
        for (vertex, place) in polygon.corners() {
            let value = *lit[vertex as usize].get_or_insert_with(|| {
                let position = polygon.mesh.position(vertex);
                recorder.enter(|| Event::Vertex { vertex, position });
                let normal = vertex_normal(polygon.mesh, vertex, recorder);
                let point = SurfacePoint {
                    position,
                    normal,
                    to_eye: (stage.view.eye - position).normalize_or_zero(),
                    material: polygon.material,
                    diffuse: polygon.material.diffuse,
                };
                let intensity = illuminate(&point, &lighting, recorder, |_, _| true);
                recorder.leave(|| Event::VertexLit { vertex, intensity });
                intensity
            });
            corners.push(Corner {
                position: place.camera,
                value,
            });
        }

        // Interpolation along edges and spans
        scan_line.fill(
            &corners,
            &stage.view,
            &region,
            frame,
            recorder,
            |_, fragment| fragment.value,
        );
        recorder.leave(|| stage::Event::PolygonDone.into());
    }
    recorder.leave(|| stage::Event::FrameDone.into());
}

/// Gouraud carries an intensity.
impl Carried for Rgb {
    const NAMES: Option<&'static Names> = Some(&Names {
        corner: "I",
        one: "I_1",
        two: "I_2",
        four: "I_4",
        four_incremental: "I_4_incremental",
        five: "I_5",
        pixel: "I_P",
        pixel_incremental: "I_P_incremental",
        step: "dI_dy",
    });

    fn tell(self, name: &'static str, fields: &mut Fields) {
        fields.push(name, self);
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Event {
    Stage(stage::Event),
    /// Opens a vertex of the object's mesh, at `position` in the world.
    Vertex {
        vertex: u32,
        position: glam::DVec3,
    },
    Normal(vertex_normal::Event),
    Illumination(illumination::Event),
    /// Closes `Vertex`.
    VertexLit {
        vertex: u32,
        intensity: Rgb,
    },
    ScanLine(scan_line::Event<Rgb>),
}

const _: () = assert!(size_of::<Event>() <= 64);

impl From<stage::Event> for Event {
    fn from(event: stage::Event) -> Self {
        Event::Stage(event)
    }
}

impl From<vertex_normal::Event> for Event {
    fn from(event: vertex_normal::Event) -> Self {
        Event::Normal(event)
    }
}

impl From<illumination::Event> for Event {
    fn from(event: illumination::Event) -> Self {
        Event::Illumination(event)
    }
}

impl From<scan_line::Event<Rgb>> for Event {
    fn from(event: scan_line::Event<Rgb>) -> Self {
        Event::ScanLine(event)
    }
}

impl record::Event for Event {
    fn kind(&self) -> &'static str {
        match self {
            Event::Stage(event) => event.kind(),
            Event::Vertex { .. } => "Vertex",
            Event::Normal(event) => event.kind(),
            Event::Illumination(event) => event.kind(),
            Event::VertexLit { .. } => "VertexLit",
            Event::ScanLine(event) => event.kind(),
        }
    }

    fn line(&self) -> Line {
        let number = match self {
            Event::Stage(_) => 0,
            Event::Vertex { .. } => 1,
            Event::Normal(_) => 2,
            Event::Illumination(event) => return event.line(),
            Event::VertexLit { .. } => 3,
            Event::ScanLine(event) => match (event.part(), event) {
                (Part::EdgeTable, _) => 4,
                (Part::ScanLine, _) => 5,
                (Part::Edge, scan_line::Event::Edge { .. }) => 6,
                (Part::Edge, _) => 7,
                (Part::Span, _) => 8,
                (Part::Pixel, _) => 9,
                (Part::Depth, _) => 10,
                (Part::Interpolation, _) => 11,
                (Part::Color, _) => 12,
            },
        };
        Line {
            listing: &PSEUDOCODE,
            number,
        }
    }

    fn fields(&self, fields: &mut Fields) {
        match *self {
            Event::Stage(event) => event.fields(fields),
            Event::Vertex { vertex, position } => {
                fields.push("vertex", vertex).push("P_v", position);
            }
            Event::Normal(event) => event.fields(fields),
            Event::Illumination(event) => event.fields(fields),
            Event::VertexLit { vertex, intensity } => {
                fields.push("vertex", vertex).push("I_v", intensity);
            }
            Event::ScanLine(event) => event.fields(fields),
        }
    }
}
