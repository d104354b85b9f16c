//! The outlines of objects in a parallel projection, and how much room they take.

use super::view::View;
use crate::algorithms::prepared_scene::PreparedScene;
use crate::scene::{Mesh, Shape};
use glam::{DVec2, DVec3, Vec2};

/// Of meshes with more faces, only the hull of some vertices is drawn.
const MOST_FACES: usize = 20_000;
const HULL_VERTICES: usize = 4_000;
const CIRCLE: usize = 72;

/// Lines, each within the view, of the outline of an object.
pub fn outline(prepared: &PreparedScene, object: usize, view: &View) -> Vec<[Vec2; 2]> {
    match &prepared.scene.objects[object].shape {
        Shape::Sphere { center, radius } => closed(
            &circle(view.place(*center), *radius as f32 * view.scale()),
            view,
        ),
        Shape::Plane { point, normal } => plane(*point, *normal, prepared.view.eye, view)
            .into_iter()
            .collect(),
        _ => {
            let mesh = &prepared.tessellation.meshes[object];
            if mesh.face_count() > MOST_FACES {
                closed(&hull(mesh, view), view)
            } else {
                silhouette(mesh, view)
            }
        }
    }
}

/// Corners of the room that eye, target and finite objects take, cut off `reach` times the distance from eye to target
/// around the target.
pub fn extent(prepared: &PreparedScene, reach: f64) -> Vec<DVec3> {
    let eye = prepared.view.eye;
    let target = prepared
        .scene
        .camera
        .map_or(eye + prepared.view.forward, |camera| camera.target);
    let reach = DVec3::splat(reach * eye.distance(target));
    let mut places = vec![eye, target];
    for (object, mesh) in prepared
        .scene
        .objects
        .iter()
        .zip(&prepared.tessellation.meshes)
    {
        let [low, high] = match &object.shape {
            Shape::Sphere { center, radius } => [*center - *radius, *center + *radius],
            Shape::Plane { .. } => continue,
            _ => bounds(mesh),
        };
        let (low, high) = (low.max(target - reach), high.min(target + reach));
        if low.cmple(high).all() {
            places.extend([low, high]);
            // All corners: the view's axes are not those of the world.
            for corner in 1..7 {
                let mask = DVec3::new(
                    f64::from(corner & 1),
                    f64::from(corner >> 1 & 1),
                    f64::from(corner >> 2),
                );
                places.push(low + mask * (high - low));
            }
        }
    }
    places
}

fn bounds(mesh: &Mesh) -> [DVec3; 2] {
    let positions = (0..mesh.vertex_count() as u32).map(|vertex| mesh.position(vertex));
    positions.fold(
        [DVec3::INFINITY, DVec3::NEG_INFINITY],
        |[low, high], place| [low.min(place), high.max(place)],
    )
}

pub fn circle(middle: Vec2, radius: f32) -> Vec<Vec2> {
    (0..CIRCLE)
        .map(|i| {
            let turn = i as f32 / CIRCLE as f32 * std::f32::consts::TAU;
            middle + radius * Vec2::from_angle(turn)
        })
        .collect()
}

fn closed(points: &[Vec2], view: &View) -> Vec<[Vec2; 2]> {
    let next = points.iter().cycle().skip(1);
    points
        .iter()
        .zip(next)
        .filter_map(|(&from, &to)| view.cut(from, to))
        .collect()
}

/// Where a plane cuts the plane of view through the eye; none where it faces the viewer too much to be a line.
fn plane(point: DVec3, normal: DVec3, eye: DVec3, view: &View) -> Option<[Vec2; 2]> {
    let flat = view.flat(normal);
    if flat.length() < 0.5 {
        return None;
    }
    // n·(eye + a·across + b·up − point) = 0, at the foot of the eye.
    let foot = eye
        - (eye - point).dot(normal) / flat.length_squared()
            * (flat.x * view.projection.across + flat.y * view.projection.up);
    let along = flat.perp().normalize();
    let along = along.x * view.projection.across + along.y * view.projection.up;
    let far = view.beyond(along);
    view.line(foot - far * along, foot + far * along)
}

/// Edges between a face that is turned toward the viewer and one that is not, and edges of one face alone.
fn silhouette(mesh: &Mesh, view: &View) -> Vec<[Vec2; 2]> {
    let toward = view.projection.toward_viewer();
    let front: Vec<bool> = (0..mesh.face_count())
        .map(|face| mesh.normal(face).dot(toward) > 0.0)
        .collect();
    let mut lines = Vec::new();
    for face in 0..mesh.face_count() {
        let corners = mesh.face(face);
        let next = corners.iter().cycle().skip(1);
        for (&from, &to) in corners.iter().zip(next) {
            let mut others = mesh.faces_around(from).iter().filter(|&&other| {
                other as usize != face && mesh.face(other as usize).contains(&to)
            });
            // Of the two faces at an edge the lower one draws it.
            let drawn = match others.next() {
                None => true,
                Some(&other) => face < other as usize && front[face] != front[other as usize],
            };
            if drawn {
                lines.extend(view.line(mesh.position(from), mesh.position(to)));
            }
        }
    }
    lines
}

/// The convex hull of the vertices, or of every so many (Andrew's monotone chain, 1979).
fn hull(mesh: &Mesh, view: &View) -> Vec<Vec2> {
    let stride = mesh.vertex_count().div_ceil(HULL_VERTICES).max(1);
    let mut places: Vec<DVec2> = (0..mesh.vertex_count() as u32)
        .step_by(stride)
        .map(|vertex| view.place(mesh.position(vertex)).as_dvec2())
        .collect();
    places.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
    let mut chains = [Vec::new(), Vec::new()];
    for (chain, backward) in chains.iter_mut().zip([false, true]) {
        let count = places.len();
        for i in 0..count {
            let place = places[if backward { count - 1 - i } else { i }];
            while let [.., before, last] = chain[..] {
                let last: DVec2 = last;
                if (last - before).perp_dot(place - last) > 0.0 {
                    break;
                }
                chain.pop();
            }
            chain.push(place);
        }
        chain.pop();
    }
    chains
        .concat()
        .into_iter()
        .map(|place| place.as_vec2())
        .collect()
}
