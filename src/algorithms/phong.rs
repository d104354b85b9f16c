//! Phong shading: the normal at the vertices, interpolated along edges, then along scan lines, and the illumination model at every
//! pixel (Phong, "Illumination for computer generated pictures", Communications of the ACM 18.6, 1975).
//!
//! N_4 and N_P are interpolated exactly as Gouraud's intensities are, directly and by increments; what is drawn with is the
//! incremental value, brought to unit length at the pixel. Where it vanishes (opposite vertex normals, half-way between) the
//! normal of the face stands for it. P is the point of the polygon that the pixel shows: L and V start there.

use super::fill::Fill;
use super::focus::Focus;
use super::frame::Frame;
use super::illumination::{SurfacePoint, illuminate};
use super::prepared_scene::{self, Polygon, PreparedScene};
use super::scan_line::{Carried, Fragment, Names};
use super::shading::{self, OnceAVertex, Shading, pixel_point};
use super::texture::AtPixel;
use super::vertex_normal::{VANISHED, vertex_normal};
use crate::record::{Listing, Recorder, Value};
use glam::DVec3;

pub static PSEUDOCODE: Listing = Listing {
    name: "Phong",
    lines: &[
        ("polygon", "for each polygon"),
        ("vertex", "  for each vertex v without a normal"),
        ("vertex-normal", "    N_v ← ΣN_k / |ΣN_k|"),
        ("edge-table", "  build the edge table"),
        ("scan-line", "  for each scan line y"),
        ("edge", "    for each active edge"),
        ("cut", "      N_4 ← interpolate N_1, N_2"),
        ("span", "    for each span from x_4 to x_5"),
        ("pixel", "      for each pixel x_P"),
        ("depth", "        if nearer than the depth buffer"),
        ("interpolation", "          N_P ← interpolate N_4, N_5"),
        (
            "point",
            "          P ← the point of the polygon that the pixel shows",
        ),
        ("normal", "          N ← N_P / |N_P|"),
        ("", "          I ← illumination(P, N)"),
        ("color", "          pixel ← I"),
    ],
};

/// Draws the part of the stage that `focus` takes into `frame`, a band of the picture of the stage's view.
pub fn phong<R: Recorder<Event>>(
    prepared: &PreparedScene,
    focus: Focus,
    frame: &mut Frame,
    recorder: &mut R,
) {
    shade_pixels(
        prepared,
        focus,
        frame,
        recorder,
        |polygon, seen, recorder| (seen.position, unit_normal(seen.normal, polygon, recorder)),
    );
}

/// What a pixel shows of a polygon: the point, and the normal interpolated there.
#[derive(Clone, Copy, Debug)]
pub(super) struct Seen {
    pub position: DVec3,
    pub normal: DVec3,
}

/// Carries vertex normals to the pixels and lights each pixel; `surface` tells the point that is lit and its unit normal.
pub(super) fn shade_pixels<M: Shading<Recorded = DVec3>, R: Recorder<shading::Event<M>>>(
    prepared: &PreparedScene,
    focus: Focus,
    frame: &mut Frame,
    recorder: &mut R,
    surface: impl Fn(&Polygon, Seen, &mut R) -> (DVec3, DVec3),
) {
    let region = focus.region(frame);
    let lighting = prepared.lighting();
    let mut fill: Fill<DVec3, DVec3> = Fill::new(prepared, &region);
    let mut normals = Vec::new();
    let mut found = OnceAVertex::default();

    recorder.enter(|| prepared.entered().into());
    for polygon in prepared.polygons(focus, &region) {
        recorder.enter(|| polygon.entered().into());

        // The normal at each vertex, once for all the polygons that share it
        normals.clear();
        for (vertex, _) in polygon.corners() {
            normals.push(found.at(&polygon, vertex, || {
                let position = polygon.mesh.position(vertex);
                recorder.enter(|| shading::Event::Vertex { vertex, position });
                let normal = vertex_normal(polygon.mesh, vertex, recorder);
                recorder.leave(|| shading::Event::VertexReady { vertex });
                normal
            }));
        }

        // Interpolation along edges and spans, illumination at every pixel
        let shade = |recorder: &mut R, fragment: Fragment<DVec3>, texture: Option<AtPixel>| {
            let seen = Seen {
                position: pixel_point(prepared, &fragment, recorder),
                normal: fragment.value,
            };
            let (position, normal) = surface(&polygon, seen, recorder);
            let k_d = polygon.material.diffuse;
            let diffuse = texture.map_or(k_d, |texture| texture.color_at(position, recorder) * k_d);
            let point = SurfacePoint {
                position,
                normal,
                to_eye: (prepared.view.eye - position).normalize_or_zero(),
                material: polygon.material,
                diffuse,
            };
            illuminate(&point, &lighting, recorder, |_, _| true).whole
        };
        fill.polygon(
            &polygon,
            &normals,
            frame,
            recorder,
            |recorder, fragment| shade(recorder, fragment, None),
            |recorder, fragment, texture| shade(recorder, fragment, Some(texture)),
        );
        recorder.leave(|| prepared_scene::Event::PolygonDone.into());
    }
    recorder.leave(|| prepared_scene::Event::FrameDone.into());
}

/// An interpolated normal brought to unit length; where it vanishes, the normal of the face.
pub(super) fn unit_normal<M: Shading, R: Recorder<shading::Event<M>>>(
    interpolated: DVec3,
    polygon: &Polygon,
    recorder: &mut R,
) -> DVec3 {
    let length = interpolated.length();
    if length > VANISHED {
        let normal = interpolated / length;
        recorder.step(|| shading::Event::PixelNormal { length, normal });
        normal
    } else {
        let normal = polygon.mesh.normal(polygon.face);
        recorder.step(|| shading::Event::PixelNormalLost { length, normal });
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

    fn value(self) -> Option<Value> {
        Some(self.into())
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Phong {}

impl Shading for Phong {
    type Recorded = DVec3;
    const LISTING: &'static Listing = &PSEUDOCODE;
}

pub type Event = shading::Event<Phong>;

const _: () = assert!(size_of::<Event>() <= 64);
