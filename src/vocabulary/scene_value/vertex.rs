//! Where a vertex of a divided sphere, cylinder or Bézier patch is, in the terms of the division.

use super::{Given, Recorded, SceneValue, index, one, value, vector};
use crate::record::Value;
use crate::scene::{CYLINDER_SIDES, Object, Shape, grid_weights, patch_point, ring_axes};
use glam::DVec3;
use std::f64::consts::{PI, TAU};

pub(super) const VALUES: &[SceneValue] = &[
    value("latitude_step", "i", |given, recorded| {
        one(on_sphere(given, recorded)?[0])
    }),
    value("longitude_step", "j", |given, recorded| {
        one(on_sphere(given, recorded)?[1])
    }),
    value("latitude_steps", "n", |given, recorded| {
        on_sphere(given, recorded)?;
        one(object(given, recorded)?.divisions)
    }),
    value("ring_base", "B", |given, recorded| {
        one(ring(given, recorded)?.base)
    }),
    value("ring_axis", "e", |given, recorded| {
        one(ring(given, recorded)?.axis)
    }),
    value("ring_height", "h", |given, recorded| {
        one(ring(given, recorded)?.height)
    }),
    value("ring_radius", "r", |given, recorded| {
        one(ring(given, recorded)?.radius)
    }),
    value("ring_across_x", "e_1", |given, recorded| {
        one(ring_axes(ring(given, recorded)?.axis)[0])
    }),
    value("ring_across_y", "e_2", |given, recorded| {
        one(ring_axes(ring(given, recorded)?.axis)[1])
    }),
    value("ring_step", "i", |given, recorded| {
        one(ring(given, recorded)?.step)
    }),
    value("ring_steps", "n", |_, _| one(CYLINDER_SIDES)),
    value("patch_row", "i", |given, recorded| {
        one(on_patch(given, recorded)?.1[0])
    }),
    value("patch_column", "j", |given, recorded| {
        one(on_patch(given, recorded)?.1[1])
    }),
    value("patch_steps", "n", |given, recorded| {
        match object(given, recorded)?.shape {
            Shape::Bezier { divisions, .. } => one(divisions),
            _ => None,
        }
    }),
    value("control_00", "P_{00}", |given, recorded| {
        control_point(given, recorded, 0)
    }),
    value("control_01", "P_{01}", |given, recorded| {
        control_point(given, recorded, 1)
    }),
    value("control_02", "P_{02}", |given, recorded| {
        control_point(given, recorded, 2)
    }),
    value("control_03", "P_{03}", |given, recorded| {
        control_point(given, recorded, 3)
    }),
    value("control_10", "P_{10}", |given, recorded| {
        control_point(given, recorded, 4)
    }),
    value("control_11", "P_{11}", |given, recorded| {
        control_point(given, recorded, 5)
    }),
    value("control_12", "P_{12}", |given, recorded| {
        control_point(given, recorded, 6)
    }),
    value("control_13", "P_{13}", |given, recorded| {
        control_point(given, recorded, 7)
    }),
    value("control_20", "P_{20}", |given, recorded| {
        control_point(given, recorded, 8)
    }),
    value("control_21", "P_{21}", |given, recorded| {
        control_point(given, recorded, 9)
    }),
    value("control_22", "P_{22}", |given, recorded| {
        control_point(given, recorded, 10)
    }),
    value("control_23", "P_{23}", |given, recorded| {
        control_point(given, recorded, 11)
    }),
    value("control_30", "P_{30}", |given, recorded| {
        control_point(given, recorded, 12)
    }),
    value("control_31", "P_{31}", |given, recorded| {
        control_point(given, recorded, 13)
    }),
    value("control_32", "P_{32}", |given, recorded| {
        control_point(given, recorded, 14)
    }),
    value("control_33", "P_{33}", |given, recorded| {
        control_point(given, recorded, 15)
    }),
];

fn object<'a>(given: Given<'a>, recorded: Recorded) -> Option<&'a Object> {
    given.prepared.scene.objects.get(index(recorded, "object")?)
}

/// Steps from the north pole down, and from the z axis toward the x axis: as many in half a turn.
fn on_sphere(given: Given, recorded: Recorded) -> Option<[u32; 2]> {
    let object = object(given, recorded)?;
    let Shape::Sphere { center, .. } = object.shape else {
        return None;
    };
    let from_center = vector(recorded, "P_v")? - center;
    let steps = |angle: f64| (angle / PI * f64::from(object.divisions)).round() as u32;
    let latitude = steps(from_center.x.hypot(from_center.z).atan2(from_center.y));
    let longitude = steps(from_center.x.atan2(from_center.z).rem_euclid(TAU));
    Some([latitude, longitude % (2 * object.divisions)])
}

/// The ring of a cylinder that the vertex is on, so high above the base, and how many steps it is from its first direction.
struct Ring {
    base: DVec3,
    axis: DVec3,
    radius: f64,
    height: f64,
    step: u32,
}

fn ring(given: Given, recorded: Recorded) -> Option<Ring> {
    let Shape::Cylinder {
        base,
        axis,
        radius,
        height,
        ..
    } = object(given, recorded)?.shape
    else {
        return None;
    };
    let from_base = vector(recorded, "P_v")? - base;
    let is_upper = from_base.dot(axis) > 0.5 * height;
    let [x, y] = ring_axes(axis).map(|across| from_base.dot(across));
    let turns = y.atan2(x).rem_euclid(TAU) / TAU;
    Some(Ring {
        base,
        axis,
        radius,
        height: if is_upper { height } else { 0.0 },
        step: (turns * f64::from(CYLINDER_SIDES)).round() as u32 % CYLINDER_SIDES,
    })
}

/// The first patch that the vertex is on, and its row and column there.
fn on_patch<'a>(given: Given<'a>, recorded: Recorded) -> Option<(&'a [DVec3; 16], [u32; 2])> {
    let Shape::Bezier { patches, divisions } = &object(given, recorded)?.shape else {
        return None;
    };
    let (vertex, n) = (vector(recorded, "P_v")?, *divisions);
    let weights: Vec<[f64; 4]> = (0..=n).map(|i| grid_weights(i, n)).collect();
    let places = patches.iter().flat_map(|points| {
        (0..=n).flat_map(move |row| (0..=n).map(move |column| (points, [row, column])))
    });
    let distance = |&(points, [row, column]): &(&[DVec3; 16], [u32; 2])| {
        let place = patch_point(points, &weights[column as usize], &weights[row as usize]);
        place.distance_squared(vertex)
    };
    places.min_by(|a, b| distance(a).total_cmp(&distance(b)))
}

fn control_point(given: Given, recorded: Recorded, number: usize) -> Option<Vec<Value>> {
    one(on_patch(given, recorded)?.0[number])
}
