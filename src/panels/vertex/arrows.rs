//! The faces around the point, and the unit vectors that start there.

use super::super::values::swatch;
use crate::figure::{Arrow, Labels, Projection, within};
use crate::picture::{Ink, Picture, Rect, Stroke, Tag};
use crate::record::Value;
use crate::replay::shading::{CurrentLight, CurrentPoint, CurrentVertex, State};
use glam::{DVec3, Vec2};

/// How high above the surface it is looked at from, in degrees.
const ELEVATION: f64 = 30.0;
/// Radius of the point.
const POINT: f32 = 6.0;
/// How much longer than the face normals the vectors at the point are.
const LONGER: f64 = 1.1;
/// Room for a name beyond the tip of its vector.
const NAME: f32 = 22.0;

/// Right and up of one who looks at a surface from its side: its `normal` points up, and a vector `to_eye` leans to the right by its
/// full angle.
fn beside(normal: DVec3, to_eye: DVec3) -> [DVec3; 2] {
    let side = to_eye.cross(normal).try_normalize();
    let side = side.unwrap_or_else(|| normal.any_orthonormal_vector());
    let (sin, cos) = ELEVATION.to_radians().sin_cos();
    let toward_viewer = cos * side + sin * normal;
    let up = cos * normal - sin * side;
    [up.cross(toward_viewer), up]
}

/// A face with its corners in the world.
struct Face {
    /// Within the object, and over all objects.
    face: u32,
    number: usize,
    corners: Vec<DVec3>,
    normal: DVec3,
}

/// A vector in the world that starts at a place.
struct Vector {
    name: String,
    from: DVec3,
    vector: DVec3,
    stroke: Stroke,
    /// Whether this step is about it.
    here: bool,
    tag: Tag,
}

struct Drawing {
    projection: Projection,
    labels: Labels,
    /// Points to a unit vector.
    unit: f32,
}

pub(super) fn draw(picture: &mut Picture, state: &State, kind: &str, area: Rect) {
    let Some(at) = position(state) else { return };
    let faces = faces(state);
    let normal = faces.iter().map(|face| face.normal).sum::<DVec3>();
    let to_eye = state.prepared.view.eye - at;
    let normal = normal.try_normalize().unwrap_or(state.prepared.view.up);
    // The panel shows the side that the eye sees.
    let normal = if normal.dot(to_eye) < 0.0 {
        -normal
    } else {
        normal
    };
    let unit = (0.42 * area.width.min(area.height)).min(150.0);
    let above = LONGER as f32 * unit;
    let margin = 0.08 * area.width;
    let ground = Rect::new(
        area.x + margin,
        area.y + above,
        area.width - 2.0 * margin,
        area.height - above - margin,
    );
    let [across, up] = beside(normal, to_eye);
    let corners = faces.iter().flat_map(|face| &face.corners);
    let corners = corners.chain([&at]).copied();
    let mut drawing = Drawing {
        projection: Projection::around(across, up, corners, ground),
        labels: Labels::new(area),
        unit,
    };
    picture.clipped(area, |picture| {
        let lit = state.point.is_some();
        drawing.draw_faces(picture, &faces, state.vertex.as_ref(), lit);
        let point = state.vertex.as_ref().and_then(|vertex| vertex.intensity);
        let point = point.or(state.point.as_ref().and_then(|point| point.intensity));
        let place = drawing.place(at);
        drawing
            .labels
            .reserve(Rect::between(place, place).grown(POINT));
        let vectors = match (&state.point, &state.vertex) {
            (Some(point), _) => vectors(at, point, kind),
            (None, Some(vertex)) => normals(at, &faces, vertex, kind),
            (None, None) => Vec::new(),
        };
        drawing.shorten(&vectors, area.grown(-NAME));
        for vector in &vectors {
            drawing.arrow(picture, vector);
        }
        let disc = swatch(point.map(Value::from))
            .fill()
            .outlined(Ink::Text.stroke(2.0));
        match &state.vertex {
            Some(vertex) => picture.tagged(Tag::Vertex(vertex.vertex), |picture| {
                picture.circle(place, POINT, disc);
            }),
            None => picture.circle(place, POINT, disc),
        };
    });
}

fn position(state: &State) -> Option<DVec3> {
    let vertex = state.vertex.as_ref().map(|vertex| vertex.position);
    vertex.or(state.point.as_ref().map(|point| point.position))
}

/// The faces around the current vertex, or the current polygon alone.
fn faces(state: &State) -> Vec<Face> {
    let number = state.polygon.map(|polygon| polygon.polygon as usize);
    let Some(polygon) = number.and_then(|number| state.prepared.polygon(number)) else {
        return Vec::new();
    };
    let around = match &state.vertex {
        Some(vertex) => polygon.mesh.faces_around(vertex.vertex).to_vec(),
        None => vec![polygon.face as u32],
    };
    around
        .into_iter()
        .map(|face| Face {
            face,
            number: polygon.number - polygon.face + face as usize,
            normal: polygon.mesh.normal(face as usize),
            corners: polygon
                .mesh
                .face(face as usize)
                .iter()
                .map(|&vertex| polygon.mesh.position(vertex))
                .collect(),
        })
        .collect()
}

impl Drawing {
    fn place(&self, point: DVec3) -> Vec2 {
        self.projection.place(point)
    }

    /// Faces whose normals were added are tinted; fainter once the point is being lit.
    fn draw_faces(
        &self,
        picture: &mut Picture,
        faces: &[Face],
        vertex: Option<&CurrentVertex>,
        lit: bool,
    ) {
        for face in faces {
            let added = vertex.and_then(|vertex| order(vertex, face));
            let outline = Ink::Muted.stroke(1.25);
            let opacity = if lit { 0.12 } else { 0.35 };
            let paint = match added {
                Some(k) => Ink::Series(k as u8)
                    .fill()
                    .opacity(opacity)
                    .outlined(outline),
                None => Ink::Faint.fill().opacity(0.4).outlined(outline),
            };
            picture.tagged(Tag::Polygon(face.number), |picture| {
                picture.polygon(face.corners.iter().map(|&corner| self.place(corner)), paint);
            });
        }
    }

    /// Makes all unit vectors shorter by as much as keeps every tip within `area`.
    fn shorten(&mut self, vectors: &[Vector], area: Rect) {
        for vector in vectors {
            let from = self.place(vector.from);
            let to = self.tip(vector);
            let part = within([from, to], area).map_or(0.0, |[_, end]| end.distance(from));
            let whole = to.distance(from);
            if area.contains(from) && part < whole {
                self.unit *= part / whole;
            }
        }
    }

    /// Of a unit vector's own length, whatever the size of the faces.
    fn tip(&self, vector: &Vector) -> Vec2 {
        let along = f64::from(self.unit) * self.projection.flat(vector.vector);
        self.place(vector.from) + along.as_vec2()
    }

    fn arrow(&mut self, picture: &mut Picture, vector: &Vector) {
        let arrow = Arrow {
            from: self.place(vector.from),
            to: self.tip(vector),
            stroke: vector.stroke,
            tag: vector.tag,
            name: &vector.name,
            size: 14.0,
            here: vector.here,
        };
        arrow.draw(picture, &mut self.labels);
    }
}

/// N_k from the middle of each face, their sum so far, and N_v. The sum is drawn at the scale of the mean: as long as N_v where all the
/// normals agree.
fn normals(at: DVec3, faces: &[Face], vertex: &CurrentVertex, kind: &str) -> Vec<Vector> {
    let mut vectors = Vec::new();
    let last = vertex.faces.len();
    for face in faces {
        let Some(k) = order(vertex, face) else {
            continue;
        };
        let (_, normal, step) = vertex.faces[k];
        vectors.push(Vector {
            name: format!("N_{}", k + 1),
            from: face.corners.iter().sum::<DVec3>() / face.corners.len() as f64,
            vector: normal,
            stroke: Ink::Series(k as u8).stroke(2.0),
            here: k + 1 == last && kind == "FaceNormalAdded",
            tag: Tag::Step(step),
        });
    }
    if let Some(normal) = vertex.normal {
        vectors.push(Vector {
            name: "N_v".into(),
            from: at,
            vector: normal * LONGER,
            stroke: Ink::Text.stroke(4.0),
            here: ["VertexNormal", "FileNormal", "NormalVanished"].contains(&kind),
            tag: Tag::Field("N_v"),
        });
    } else if last > 0 {
        let mean = vertex.sum / faces.len().max(1) as f64;
        vectors.push(Vector {
            name: "ΣN_k".into(),
            from: at,
            vector: mean * LONGER,
            stroke: Ink::Text.stroke(2.5).dashed(),
            here: false,
            tag: Tag::Field("sum_N"),
        });
    }
    vectors
}

/// N, V, and of the current light L and H or R.
fn vectors(at: DVec3, point: &CurrentPoint, kind: &str) -> Vec<Vector> {
    let light = point.lights.last();
    let of_light = |vector: fn(&CurrentLight) -> Option<(DVec3, f64)>| {
        light.and_then(vector).map(|(vector, _)| vector)
    };
    let to_light = of_light(|light| light.to_light);
    let halfway = of_light(|light| light.halfway);
    let mirrored = of_light(|light| light.mirrored);
    let vectors = [
        ("N", Some(point.normal), "Illumination", Ink::Text, 3.5),
        ("V", point.to_eye, "Viewer", Ink::Series(0), 2.5),
        ("L", to_light, "ToLight", Ink::Series(1), 2.5),
        ("H", halfway, "Halfway", Ink::Series(2), 2.5),
        ("R", mirrored, "Mirrored", Ink::Series(3), 2.5),
    ];
    let vectors = vectors.into_iter();
    let named = vectors.filter_map(|(name, vector, recorded_by, ink, width)| {
        Some(Vector {
            name: name.into(),
            from: at,
            vector: vector? * LONGER,
            stroke: ink.stroke(width),
            here: kind == recorded_by,
            tag: Tag::Field(name),
        })
    });
    named.collect()
}

/// When the normal of a face was added, counted from 0.
fn order(vertex: &CurrentVertex, face: &Face) -> Option<usize> {
    vertex
        .faces
        .iter()
        .position(|(added, ..)| *added == face.face)
}
