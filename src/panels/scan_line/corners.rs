//! The corners of the current polygon, with the values known so far.

use crate::figure::{Fit, Labels};
use crate::picture::{Picture, Stroke, Tag};
use crate::record::Value;
use crate::replay::shading::State;
use glam::{DVec2, Vec2};

/// Length of a unit normal that lies in the screen.
const NORMAL: f32 = 36.0;

/// A corner of the polygon on the screen.
pub(super) struct Corner {
    pub place: DVec2,
    pub tag: Tag,
    /// The value there, once it is known.
    pub value: Option<Value>,
    /// Whether it is what the step is about.
    pub current: bool,
}

/// The corners of the current polygon as recorded; before that, as prepared.
pub(super) fn corners(state: &State) -> Vec<Corner> {
    if !state.edges.is_empty() {
        let recorded = state.corners.iter().enumerate();
        return recorded
            .map(|(number, corner)| Corner {
                place: DVec2::new(corner.x, corner.y),
                tag: Tag::Corner(number),
                value: corner.value,
                current: false,
            })
            .collect();
    }
    let number = state.polygon.map(|polygon| polygon.polygon as usize);
    let Some(polygon) = number.and_then(|number| state.prepared.polygon(number)) else {
        return Vec::new();
    };
    let current = state.vertex.as_ref();
    // Where normals are what is interpolated, that of the vertex counts as soon as it is found.
    let of_normals = state
        .names
        .is_some_and(|names| matches!(names.zero, Value::Vector(_)));
    let found = |vertex| {
        let known = current.filter(|known| of_normals && known.vertex == vertex);
        known.and_then(|known| known.normal)
    };
    polygon
        .corners()
        .filter(|(_, place)| place.camera.z >= state.prepared.view.near)
        .enumerate()
        .map(|(number, (vertex, place))| {
            let lit = state.lit.iter().find(|(known, _)| *known == vertex);
            let normal = state.normals.iter().find(|(known, _)| *known == vertex);
            let normal = normal.map(|(_, normal)| *normal).or(found(vertex));
            let recorded = state.corners.get(number);
            Corner {
                place: place.screen,
                tag: Tag::Vertex(vertex),
                value: recorded
                    .and_then(|corner| corner.value)
                    .or(lit.map(|(_, intensity)| (*intensity).into()))
                    .or(normal.map(Value::from)),
                current: current.is_some_and(|known| known.vertex == vertex)
                    || recorded.is_some() && number + 1 == state.corners.len(),
            }
        })
        .collect()
}

/// The places of the corners' discs: those of the corners, but beside an earlier disc where it would be covered.
pub(super) fn discs(corners: &[Corner], fit: &Fit, radius: f32) -> Vec<Vec2> {
    let mut discs: Vec<Vec2> = Vec::new();
    for corner in corners {
        let mut place = fit.place(corner.place);
        let covered = |place: Vec2| discs.iter().any(|&disc| disc.distance(place) < radius);
        for _ in 0..discs.len() {
            if covered(place) {
                place.x += 2.0 * radius;
            }
        }
        discs.push(place);
    }
    discs
}

/// A normal as it is seen on the screen, from the edge of a disc on: short where it points at the eye or away from it.
pub(super) fn draw_normal(
    picture: &mut Picture,
    labels: &mut Labels,
    state: &State,
    (place, radius): (Vec2, f32),
    value: Option<Value>,
    stroke: Stroke,
) {
    let Some(Value::Vector(normal)) = value else {
        return;
    };
    let view = &state.prepared.view;
    let seen = DVec2::new(normal.dot(view.right), -normal.dot(view.up)).as_vec2();
    let tip = place + NORMAL * seen;
    if NORMAL * seen.length() > radius + 4.0 {
        picture.arrow(place, tip, stroke);
        labels.avoid(place, tip);
    }
}
