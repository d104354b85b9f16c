//! How (u, v) follow from a point of an object, in the terms of their formula.

use super::solid::Solid;
use super::{Hit, Primitives, chart, triangle};
use glam::{DVec2, DVec3};

/// The part of an object's chart that holds at a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ChartPart {
    /// Longitude and latitude.
    Sphere { center: DVec3 },
    /// Lengths along two unit vectors.
    Plane { point: DVec3, axes: [DVec3; 2] },
    /// The longitude from the first toward the second of two unit vectors across the axis, and the share of the height.
    Cylinder {
        base: DVec3,
        across: [DVec3; 2],
        axis: DVec3,
        height: f64,
    },
    /// The bilinear mix of four corners of a plane.
    Quadrilateral { corners: [DVec3; 4] },
    /// The mix of the (u, v) of the corners, by areas seen along `axis`.
    Triangle {
        corners: [DVec3; 3],
        uvs: [DVec2; 3],
        axis: DVec3,
    },
    /// Shares of two sides from a corner.
    Rectangle { corner: DVec3, sides: [DVec3; 2] },
}

impl ChartPart {
    /// None where it has no area.
    pub(super) fn triangle(corners: [DVec3; 3], uvs: [DVec2; 3]) -> Option<ChartPart> {
        let axis = triangle::facing_axis(corners)?;
        Some(ChartPart::Triangle { corners, uvs, axis })
    }
}

impl Primitives {
    /// The chart at a hit; none where the object has none there.
    pub fn chart_part(&self, hit: &Hit) -> Option<ChartPart> {
        match &self.primitives[hit.object as usize] {
            &Solid::Sphere { center, .. } => Some(ChartPart::Sphere { center }),
            Solid::Plane(plane) => Some(plane.chart_part()),
            Solid::Cylinder(cylinder) => Some(cylinder.chart_part()),
            Solid::Faces { faces, vertices } if vertices.is_empty() => {
                faces.chart_part(hit.triangle)
            }
            Solid::Faces { vertices, .. } => chart::polygon_part(vertices),
        }
    }
}
