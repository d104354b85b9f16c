//! Four triangles at once: a quick test in f32 that passes over most of those that a ray misses.
//!
//! It is the test of [`super::triangle`] with a margin for all that rounding to f32 does to it, so what it passes over the exact
//! test misses too.

use super::aim::Aim;
use glam::{Vec3, Vec4};

/// How many triangles are in a packet at most.
pub(super) const PACKET: usize = 4;

/// Marks a place that no triangle takes.
pub(super) const NONE: u32 = u32::MAX;

/// Twice the error of a sheared coordinate, in the unit frame. Corner (2⁻²⁵), origin (2⁻²³, being up to 4 away), their difference
/// (up to 5, 2⁻²²): 1.7·2⁻²² along each axis, and once more along the ray's main axis times a slope of at most 1; slope (2⁻²⁵ of 5),
/// product (up to 5, 2⁻²²) and difference (up to 10, 2⁻²¹): together below 7·2⁻²² < 2⁻¹⁹.
const TWICE_ERROR: f32 = 1.0 / (1 << 18) as f32;

/// Up to four triangles in a unit frame.
#[derive(Clone, Debug)]
pub(super) struct Packet {
    /// By corner and axis. Places that are not taken repeat the last triangle.
    corners: [[Vec4; 3]; 3],
    /// By place; [`NONE`] where it is not taken.
    pub triangles: [u32; PACKET],
    /// Their exact corners, as indices, by place.
    pub vertices: [[u32; 3]; PACKET],
}

/// A ray in the unit frame, and the shear that turns it along the last axis.
pub(super) struct UnitShear {
    origin: [Vec4; 3],
    axes: [usize; 3],
    slopes: [Vec4; 2],
}

impl UnitShear {
    pub fn new(origin: Vec3, aim: &Aim) -> Self {
        UnitShear {
            origin: aim.axes.map(|axis| Vec4::splat(origin[axis])),
            axes: aim.axes,
            slopes: aim.slopes.map(|slope| Vec4::splat(slope as f32)),
        }
    }
}

impl Packet {
    /// Of one triangle or more, up to [`PACKET`]; `corners_of` gives a triangle's corners as indices and in the unit frame.
    pub fn new(triangles: &[u32], corners_of: impl Fn(u32) -> ([u32; 3], [Vec3; 3])) -> Self {
        let mut packet = Packet {
            corners: [[Vec4::ZERO; 3]; 3],
            triangles: [NONE; PACKET],
            vertices: [[0; 3]; PACKET],
        };
        packet.triangles[..triangles.len()].copy_from_slice(triangles);
        for place in 0..PACKET {
            let (vertices, corners) = corners_of(triangles[place.min(triangles.len() - 1)]);
            packet.vertices[place] = vertices;
            for (to, corner) in packet.corners.iter_mut().zip(corners) {
                for axis in 0..3 {
                    to[axis][place] = corner[axis];
                }
            }
        }
        packet
    }

    /// The places of the triangles that the ray may meet.
    #[inline]
    pub fn candidates(&self, ray: &UnitShear) -> u32 {
        let sheared = |corner: &[Vec4; 3]| {
            let [x, y, z] = ray.axes.map(|axis| corner[axis]);
            let z = z - ray.origin[2];
            (
                x - ray.origin[0] - ray.slopes[0] * z,
                y - ray.origin[1] - ray.slopes[1] * z,
            )
        };
        let (ax, ay) = sheared(&self.corners[0]);
        let (bx, by) = sheared(&self.corners[1]);
        let (cx, cy) = sheared(&self.corners[2]);
        let u = cx * by - cy * bx;
        let v = ax * cy - ay * cx;
        let w = bx * ay - by * ax;
        let spread = (ax.abs() + ay.abs()) + (bx.abs() + by.abs()) + (cx.abs() + cy.abs());
        let margin = spread * TWICE_ERROR + Vec4::splat(TWICE_ERROR * TWICE_ERROR);
        let is_outside = u.min(v).min(w).cmplt(-margin) & u.max(v).max(w).cmpgt(margin);
        !is_outside.bitmask() & 0b1111
    }
}
