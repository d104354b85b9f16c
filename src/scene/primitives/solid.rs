//! An object as rays meet it.

use super::super::{Material, Mesh, Object, Shape};
use super::closed::Winding;
use super::cylinder::Cylinder;
use super::faces::Faces;
use super::plane::Plane;
use super::shells::shells;
use crate::color::Rgb;
use glam::DVec3;

#[derive(Clone, Debug)]
pub(super) enum Solid {
    Sphere {
        center: DVec3,
        radius: f64,
    },
    Plane(Plane),
    Cylinder(Cylinder),
    /// `vertices` are those of a polygon, and none of other shapes.
    Faces {
        faces: Box<Faces>,
        vertices: Vec<DVec3>,
    },
}

impl Solid {
    /// Also whether its surface is closed. `mesh` is what the object is divided into.
    pub fn of(object: &Object, material: &Material, mesh: &Mesh) -> (Self, bool) {
        let is_textured = material.texture.is_some();
        match &object.shape {
            &Shape::Sphere { center, radius } => (Solid::Sphere { center, radius }, true),
            &Shape::Plane { point, normal } => (Solid::Plane(Plane { point, normal }), false),
            &Shape::Cylinder {
                base,
                axis,
                radius,
                height,
                capped,
            } => {
                let cylinder = Cylinder {
                    base,
                    axis,
                    radius,
                    height,
                    capped,
                };
                (Solid::Cylinder(cylinder), capped)
            }
            Shape::Polygon { vertices } => {
                let faces = Box::new(Faces::new(mesh, false, &[], &[]));
                let vertices = vertices.clone();
                (Solid::Faces { faces, vertices }, false)
            }
            Shape::Bezier { .. } | Shape::Mesh(_) => {
                let is_transparent = material.transmission != Rgb::BLACK;
                let (turned, is_closed) = match Winding::of(mesh) {
                    // Of an opaque body both sides look the same.
                    Winding::Closed { turned } if is_transparent => (turned, true),
                    Winding::Closed { .. } => (Vec::new(), true),
                    Winding::Open { .. } => (Vec::new(), false),
                };
                let shells = match is_transparent && is_closed {
                    true => shells(mesh),
                    false => Vec::new(),
                };
                let faces = Box::new(Faces::new(mesh, is_textured, &turned, &shells));
                let vertices = Vec::new();
                (Solid::Faces { faces, vertices }, is_closed)
            }
        }
    }

    /// The corners of the box around it, unless it is infinite.
    pub fn bounds(&self) -> Option<[DVec3; 2]> {
        let a_step_outward =
            |low: DVec3, high: DVec3| Some([low.map(f64::next_down), high.map(f64::next_up)]);
        match self {
            // The radius may be lost against the centre's coordinates.
            &Solid::Sphere { center, radius } => a_step_outward(center - radius, center + radius),
            Solid::Plane(_) => None,
            Solid::Cylinder(cylinder) => Some(cylinder.bounds()),
            // The origin of a ray that is moved near the faces is rounded to their coordinates.
            Solid::Faces { faces, .. } => a_step_outward(faces.low, faces.high),
        }
    }
}
