//! Phong shading: the normal at the vertices, interpolated along edges, then along scan lines, and the illumination model at every
//! pixel (Phong, "Illumination for computer generated pictures", Communications of the ACM 18.6, 1975).
//!
//! N_4 and N_P are interpolated exactly as Gouraud's intensities are, directly and by increments; what is drawn with is the
//! incremental value, brought to unit length at the pixel. Where it vanishes (opposite vertex normals, half-way between) the
//! normal of the face stands for it. P is the point of the polygon that the pixel shows: L and V start there.

use super::focus::Focus;
use super::frame::Frame;
use super::illumination::{SurfacePoint, illuminate};
use super::scan_line::{Carried, Corner, Fragment, Names, ScanLine};
use super::shading::{self, Lines, OnceAVertex, Shading};
use super::stage::{self, Stage};
use super::vertex_normal::{VANISHED, vertex_normal};
use crate::record::{Fields, Listing, Recorder};
use glam::DVec3;

pub static PSEUDOCODE: Listing = Listing {
    name: "Phong",
    lines: &[
        "for each polygon",
        "  for each vertex v without a normal",
        "    N_v ← ΣN_k / |ΣN_k|",
        "  build the edge table",
        "  for each scan line y",
        "    for each active edge",
        "      N_4 ← interpolate N_1, N_2",
        "    for each span from x_4 to x_5",
        "      for each pixel x_P",
        "        if nearer than the depth buffer",
        "          N_P ← interpolate N_4, N_5",
        "          N ← N_P / |N_P|",
        "          I ← illumination(P, N)",
        "          pixel ← I",
    ],
};

/// Draws the part of the stage that `focus` takes into `frame`, a band of the picture of the stage's view.
pub fn phong<R: Recorder<Event>>(stage: &Stage, focus: Focus, frame: &mut Frame, recorder: &mut R) {
    let region = focus.region(frame);
    let lighting = stage.lighting();
    let mut scan_line = ScanLine::default();
    let mut corners = Vec::new();
    let mut normals = OnceAVertex::default();

    recorder.enter(|| stage.entered().into());
    for polygon in stage.polygons(focus, &region) {
        recorder.enter(|| polygon.entered().into());

        // The normal at each vertex, once for all the polygons that share it
        corners.clear();
        for (vertex, place) in polygon.corners() {
            let value = normals.at(&polygon, vertex, || {
                let position = polygon.mesh.position(vertex);
                recorder.enter(|| Event::Vertex { vertex, position });
                let normal = vertex_normal(polygon.mesh, vertex, recorder);
                recorder.leave(|| Event::VertexReady { vertex });
                normal
            });
            corners.push(Corner {
                position: place.camera,
                value,
            });
        }

        // Interpolation along edges and spans, illumination at every pixel
        let face_normal = polygon.mesh.normal(polygon.face);
        let shade = |recorder: &mut R, fragment: Fragment<DVec3>| {
            let position = fragment.position(&stage.view);
            let point = SurfacePoint {
                position,
                normal: unit_normal(fragment.value, face_normal, recorder),
                to_eye: (stage.view.eye - position).normalize_or_zero(),
                material: polygon.material,
                diffuse: polygon.material.diffuse,
            };
            illuminate(&point, &lighting, recorder, |_, _| true)
        };
        scan_line.fill(&corners, &stage.view, &region, frame, recorder, shade);
        recorder.leave(|| stage::Event::PolygonDone.into());
    }
    recorder.leave(|| stage::Event::FrameDone.into());
}

/// The interpolated normal brought to unit length; where it vanishes, the normal of the face.
fn unit_normal<R: Recorder<Event>>(
    interpolated: DVec3,
    face_normal: DVec3,
    recorder: &mut R,
) -> DVec3 {
    let length = interpolated.length();
    if length > VANISHED {
        let normal = interpolated / length;
        recorder.step(|| Event::PixelNormal { length, normal });
        normal
    } else {
        let normal = face_normal;
        recorder.step(|| Event::PixelNormalLost { length, normal });
        normal
    }
}

/// Phong carries a normal.
impl Carried for DVec3 {
    const NAMES: Option<&'static Names> = Some(&Names {
        corner: "N",
        one: "N_1",
        two: "N_2",
        four: "N_4",
        four_incremental: "N_4_incremental",
        five: "N_5",
        pixel: "N_P",
        pixel_incremental: "N_P_incremental",
        step: "dN_dy",
    });

    fn tell(self, name: &'static str, fields: &mut Fields) {
        fields.push(name, self);
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Phong {}

impl Shading for Phong {
    type Told = DVec3;
    const LINES: Lines = Lines {
        listing: &PSEUDOCODE,
        vertex_normal: 2,
        vertex_done: 2,
        edge_table: 3,
        pixel_normal: 11,
    };
}

pub type Event = shading::Event<Phong>;

const _: () = assert!(size_of::<Event>() <= 64);
