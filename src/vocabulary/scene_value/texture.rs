//! The texture of the object of the step, and the chart that gives (u, v) at P.

use super::corner::{Corner, corner, corner_position, material, polygon};
use super::intersection::triangle_met;
use super::{Given, Recorded, SceneValue, index, number, one, value, vector};
use crate::scene::Texture;
use crate::scene::primitives::{ChartPart, FaceChart, Hit};
use glam::{DVec2, DVec3};

pub(super) const VALUES: &[SceneValue] = &[
    value("axis_x", "e_x", |_, _| one(DVec3::X)),
    value("axis_y", "e_y", |_, _| one(DVec3::Y)),
    value("axis_z", "e_z", |_, _| one(DVec3::Z)),
    value("chart_center", "C", |given, recorded| {
        match chart(given, recorded)? {
            ChartPart::Sphere { center } => one(center),
            _ => None,
        }
    }),
    value("chart_point", "A", |given, recorded| {
        one(plane(given, recorded)?.0)
    }),
    value("chart_along_u", "e_u", |given, recorded| {
        one(plane(given, recorded)?.1[0])
    }),
    value("chart_along_v", "e_v", |given, recorded| {
        one(plane(given, recorded)?.1[1])
    }),
    value("chart_base", "B", |given, recorded| {
        one(cylinder(given, recorded)?.0)
    }),
    value("chart_across_x", "e_1", |given, recorded| {
        one(cylinder(given, recorded)?.1[0])
    }),
    value("chart_across_y", "e_2", |given, recorded| {
        one(cylinder(given, recorded)?.1[1])
    }),
    value("chart_axis", "e", |given, recorded| {
        one(cylinder(given, recorded)?.2)
    }),
    value("chart_height", "h", |given, recorded| {
        one(cylinder(given, recorded)?.3)
    }),
    value("quadrilateral_a", "A", |given, recorded| {
        one(quadrilateral(given, recorded)?[0])
    }),
    value("quadrilateral_b", "B", |given, recorded| {
        one(quadrilateral(given, recorded)?[1])
    }),
    value("quadrilateral_c", "C", |given, recorded| {
        one(quadrilateral(given, recorded)?[2])
    }),
    value("quadrilateral_d", "D", |given, recorded| {
        one(quadrilateral(given, recorded)?[3])
    }),
    value("chart_a", "A", |given, recorded| {
        one(triangle(given, recorded)?.0[0])
    }),
    value("chart_b", "B", |given, recorded| {
        one(triangle(given, recorded)?.0[1])
    }),
    value("chart_c", "C", |given, recorded| {
        one(triangle(given, recorded)?.0[2])
    }),
    value("u_a", "u_A", |given, recorded| {
        one(triangle(given, recorded)?.1[0].x)
    }),
    value("u_b", "u_B", |given, recorded| {
        one(triangle(given, recorded)?.1[1].x)
    }),
    value("u_c", "u_C", |given, recorded| {
        one(triangle(given, recorded)?.1[2].x)
    }),
    value("v_a", "v_A", |given, recorded| {
        one(triangle(given, recorded)?.1[0].y)
    }),
    value("v_b", "v_B", |given, recorded| {
        one(triangle(given, recorded)?.1[1].y)
    }),
    value("v_c", "v_C", |given, recorded| {
        one(triangle(given, recorded)?.1[2].y)
    }),
    value("facing_axis", "e", |given, recorded| {
        one(triangle(given, recorded)?.2)
    }),
    value("rectangle_corner", "Q", |given, recorded| {
        one(rectangle(given, recorded)?.0)
    }),
    value("rectangle_along_u", "s_u", |given, recorded| {
        one(rectangle(given, recorded)?.1[0])
    }),
    value("rectangle_along_v", "s_v", |given, recorded| {
        one(rectangle(given, recorded)?.1[1])
    }),
    value("corner_is_pole", "pole", |given, recorded| {
        one(sphere_corner(given, recorded)?.0)
    }),
    value("corner_turns", "k", |given, recorded| {
        one(sphere_corner(given, recorded)?.1)
    }),
    value("hidden_u", "u_h", |given, recorded| {
        one(cut(given, recorded)?[0].x)
    }),
    value("hidden_v", "v_h", |given, recorded| {
        one(cut(given, recorded)?[0].y)
    }),
    value("seen_u", "u_s", |given, recorded| {
        one(cut(given, recorded)?[1].x)
    }),
    value("seen_v", "v_s", |given, recorded| {
        one(cut(given, recorded)?[1].y)
    }),
    value("checker_scale", "s", |given, recorded| {
        let Texture::Checker { scale, .. } = material(given, recorded)?.texture?;
        one(scale)
    }),
    value("checker_even", "c_0", |given, recorded| {
        let Texture::Checker { colors, .. } = material(given, recorded)?.texture?;
        one(colors[0])
    }),
    value("checker_odd", "c_1", |given, recorded| {
        let Texture::Checker { colors, .. } = material(given, recorded)?.texture?;
        one(colors[1])
    }),
];

/// The chart of the object, on the face of the polygon, or where the ray met it.
fn chart(given: Given, recorded: Recorded) -> Option<ChartPart> {
    let prepared = given.prepared;
    let object = index(recorded, "object")?;
    if let Some(chart) = face_chart(given, recorded) {
        let is_at_corner = given.own.get("u_k").is_some();
        let corner = is_at_corner.then(|| corner_position(given, recorded));
        let at = corner.unwrap_or_else(|| vector(recorded, "P"));
        return chart.part(at?);
    }
    let primitives = prepared.primitives();
    let t = number(recorded, "NearestT")?;
    let triangle = if t == 0.0 {
        // A surface that touches the one that the ray leaves: any part of it will do.
        primitives.flat_part(object).map(|_| 0)?
    } else {
        let ray = [vector(recorded, "O")?, vector(recorded, "u")?];
        triangle_met(given, object, ray, t)?
    };
    let object = u32::try_from(object).ok()?;
    primitives.chart_part(&Hit {
        t,
        object,
        triangle,
    })
}

/// That of the object on the face of the polygon.
fn face_chart<'a>(given: Given<'a>, recorded: Recorded) -> Option<FaceChart<'a>> {
    let polygon = polygon(given, recorded)?;
    let shape = &given.prepared.scene.objects.get(polygon.object)?.shape;
    Some(FaceChart::new(shape, polygon.mesh, polygon.face))
}

/// Whether the corner of the step is a pole of a sphere, and how many turns beyond its longitude u goes on, to lie beside the other
/// corners.
fn sphere_corner(given: Given, recorded: Recorded) -> Option<(bool, f64)> {
    let ChartPart::Sphere { .. } = chart(given, recorded)? else {
        return None;
    };
    let chart = face_chart(given, recorded)?;
    let longitude = chart.uv(corner_position(given, recorded)?).x;
    let Corner::Own(corner) = corner(given, recorded)? else {
        return None;
    };
    let uv = chart.corners().get(corner)?;
    let is_pole = uv.y == 0.0 || uv.y == 1.0;
    Some((is_pole, (longitude - uv.x).round()))
}

/// (u, v) at the hidden and the seen end of the edge that the corner of the step cuts.
fn cut(given: Given, recorded: Recorded) -> Option<[DVec2; 2]> {
    let Corner::Cut { hidden, seen } = corner(given, recorded)? else {
        return None;
    };
    let chart = face_chart(given, recorded)?;
    let at = |corner: usize| chart.corners().get(corner).copied();
    Some([at(hidden)?, at(seen)?])
}

fn plane(given: Given, recorded: Recorded) -> Option<(DVec3, [DVec3; 2])> {
    match chart(given, recorded)? {
        ChartPart::Plane { point, axes } => Some((point, axes)),
        _ => None,
    }
}

/// Base, directions across, axis and height.
fn cylinder(given: Given, recorded: Recorded) -> Option<(DVec3, [DVec3; 2], DVec3, f64)> {
    match chart(given, recorded)? {
        ChartPart::Cylinder {
            base,
            across,
            axis,
            height,
        } => Some((base, across, axis, height)),
        _ => None,
    }
}

fn quadrilateral(given: Given, recorded: Recorded) -> Option<[DVec3; 4]> {
    match chart(given, recorded)? {
        ChartPart::Quadrilateral { corners } => Some(corners),
        _ => None,
    }
}

fn triangle(given: Given, recorded: Recorded) -> Option<([DVec3; 3], [DVec2; 3], DVec3)> {
    match chart(given, recorded)? {
        ChartPart::Triangle { corners, uvs, axis } => Some((corners, uvs, axis)),
        _ => None,
    }
}

fn rectangle(given: Given, recorded: Recorded) -> Option<(DVec3, [DVec3; 2])> {
    match chart(given, recorded)? {
        ChartPart::Rectangle { corner, sides } => Some((corner, sides)),
        _ => None,
    }
}
