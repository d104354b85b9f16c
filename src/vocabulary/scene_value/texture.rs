//! The texture of the object of the step, and the chart that gives (u, v) at P.

use super::corner::{material, polygon};
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
    if let Some(polygon) = polygon(given, recorded) {
        let shape = &prepared.scene.objects.get(object)?.shape;
        let chart = FaceChart::new(shape, polygon.mesh, polygon.face);
        return chart.part(vector(recorded, "P")?);
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
