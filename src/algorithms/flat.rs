//! Flat shading: one intensity a polygon, at the mean of its vertices with its face normal (Bouknight 1970).
//!
//! Exact where the object really is a polyhedron, the light is far (N·L constant) and the viewer is far (V·R constant).

use super::focus::Focus;
use super::frame::Frame;
use super::illumination::{self, SurfacePoint, illuminate};
use super::scan_line::{self, Carried, Corner, Names, Part, ScanLine};
use super::stage::{self, Stage};
use crate::numeric::Linear;
use crate::record::{self, Fields, Line, Listing, Recorder};
use glam::DVec3;
use std::ops::{Add, Mul, Sub};

pub static PSEUDOCODE: Listing = Listing {
    name: "flat",
    lines: &[
        "for each polygon",
        "  P ← mean of the vertices",
        "  I ← illumination(P, N)",
        "  build the edge table",
        "  for each scan line y",
        "    for each active edge",
        "      x_4 ← where y cuts the edge",
        "    for each span from x_4 to x_5",
        "      for each pixel x_P",
        "        if nearer than the depth buffer",
        "          pixel ← I",
    ],
};

/// Draws the part of the stage that `focus` takes into `frame`, a band of the picture of the stage's view.
pub fn flat<R: Recorder<Event>>(stage: &Stage, focus: Focus, frame: &mut Frame, recorder: &mut R) {
    let region = focus.region(frame);
    let lighting = stage.lighting();
    let mut scan_line = ScanLine::default();
    let mut corners = Vec::new();

    recorder.enter(|| stage.entered().into());
    for polygon in stage.polygons(focus, &region) {
        recorder.enter(|| polygon.entered().into());
        let vertices = polygon.mesh.face(polygon.face);
        let position = vertices
            .iter()
            .map(|&vertex| polygon.mesh.position(vertex))
            .sum::<DVec3>()
            / vertices.len() as f64;
        recorder.step(|| Event::Middle { position });
        let normal = polygon.mesh.normal(polygon.face);
        let point = SurfacePoint {
            position,
            normal,
            to_eye: (stage.view.eye - position).normalize_or_zero(),
            material: polygon.material,
            diffuse: polygon.material.diffuse,
        };
        let intensity = illuminate(&point, &lighting, recorder, |_, _| true);

        corners.clear();
        corners.extend(polygon.corners().map(|(_, place)| Corner {
            position: place.camera,
            value: Nothing,
        }));
        scan_line.fill(&corners, &stage.view, &region, frame, recorder, |_, _| {
            intensity
        });
        recorder.leave(|| stage::Event::PolygonDone.into());
    }
    recorder.leave(|| stage::Event::FrameDone.into());
}

/// Flat shading carries nothing from the corners to the pixels.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Nothing;

impl Carried for Nothing {
    const NAMES: Option<&'static Names> = None;
    fn tell(self, _: &'static str, _: &mut Fields) {}
}

impl Linear for Nothing {}

impl Add for Nothing {
    type Output = Nothing;
    fn add(self, _: Nothing) -> Nothing {
        Nothing
    }
}

impl Sub for Nothing {
    type Output = Nothing;
    fn sub(self, _: Nothing) -> Nothing {
        Nothing
    }
}

impl Mul<f64> for Nothing {
    type Output = Nothing;
    fn mul(self, _: f64) -> Nothing {
        Nothing
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Event {
    Stage(stage::Event),
    /// The mean of the polygon's vertices, in the world.
    Middle {
        position: DVec3,
    },
    Illumination(illumination::Event),
    ScanLine(scan_line::Event<Nothing>),
}

const _: () = assert!(size_of::<Event>() <= 64);

impl From<stage::Event> for Event {
    fn from(event: stage::Event) -> Self {
        Event::Stage(event)
    }
}

impl From<illumination::Event> for Event {
    fn from(event: illumination::Event) -> Self {
        Event::Illumination(event)
    }
}

impl From<scan_line::Event<Nothing>> for Event {
    fn from(event: scan_line::Event<Nothing>) -> Self {
        Event::ScanLine(event)
    }
}

impl record::Event for Event {
    fn kind(&self) -> &'static str {
        match self {
            Event::Stage(event) => event.kind(),
            Event::Middle { .. } => "Middle",
            Event::Illumination(event) => event.kind(),
            Event::ScanLine(event) => event.kind(),
        }
    }

    fn line(&self) -> Line {
        let number = match self {
            Event::Stage(_) => 0,
            Event::Middle { .. } => 1,
            Event::Illumination(event) => return event.line(),
            Event::ScanLine(event) => match (event.part(), event) {
                (Part::EdgeTable, _) => 3,
                (Part::ScanLine, _) => 4,
                (Part::Edge, scan_line::Event::Edge { .. }) => 5,
                (Part::Edge, _) => 6,
                (Part::Span, _) => 7,
                (Part::Pixel, _) => 8,
                (Part::Depth, _) => 9,
                (Part::Interpolation | Part::Color, _) => 10,
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
            Event::Middle { position } => {
                fields.push("P_m", position);
            }
            Event::Illumination(event) => event.fields(fields),
            Event::ScanLine(event) => event.fields(fields),
        }
    }
}
