//! What a hit is on: the part of an object, in the terms of its equation.

use super::Primitives;
use super::cylinder::{LOWER_CAP, UPPER_CAP};
use super::solid::Solid;
use glam::DVec3;

/// The sphere, plane, side or triangle that a ray is tested against. All directions are unit vectors.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Part {
    Sphere {
        center: DVec3,
        radius: f64,
    },
    Plane {
        point: DVec3,
        normal: DVec3,
    },
    /// The round side of a cylinder.
    Side {
        base: DVec3,
        axis: DVec3,
        radius: f64,
    },
    /// An end of a cylinder, at that height over its base.
    End {
        base: DVec3,
        axis: DVec3,
        height: f64,
    },
    /// `normal` is that of the whole face, where it is not taken from the corners.
    Triangle {
        corners: [DVec3; 3],
        normal: Option<DVec3>,
    },
}

impl Primitives {
    /// Part `number` of an object, counted as [`Hit::triangle`](super::Hit::triangle) is.
    pub fn part(&self, object: usize, number: u32) -> Option<Part> {
        Some(match self.primitives.get(object)? {
            &Solid::Sphere { center, radius } => Part::Sphere { center, radius },
            Solid::Plane(plane) => Part::Plane {
                point: plane.point,
                normal: plane.normal,
            },
            Solid::Cylinder(cylinder) => {
                let (base, axis) = (cylinder.base, cylinder.axis);
                let end = |height| Part::End { base, axis, height };
                match number {
                    LOWER_CAP => end(0.0),
                    UPPER_CAP => end(cylinder.height),
                    _ => Part::Side {
                        base,
                        axis,
                        radius: cylinder.radius,
                    },
                }
            }
            Solid::Faces { faces, .. } if (number as usize) < faces.triangle_count() => {
                Part::Triangle {
                    corners: faces.corners(number),
                    normal: faces.plane_of(number),
                }
            }
            Solid::Faces { .. } => return None,
        })
    }

    /// Any part of an object whose parts lie in one plane, or that has one alone.
    pub fn flat_part(&self, object: usize) -> Option<Part> {
        match self.primitives.get(object)? {
            Solid::Faces { vertices, .. } if vertices.is_empty() => self.single_part(object),
            _ => self.part(object, 0),
        }
    }

    /// The only part that an object has to be tested, where it has one alone; of a cylinder its side.
    pub fn single_part(&self, object: usize) -> Option<Part> {
        match self.primitives.get(object)? {
            Solid::Faces { faces, .. } if faces.triangle_count() != 1 => None,
            _ => self.part(object, 0),
        }
    }
}
