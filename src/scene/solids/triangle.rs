//! Rays and triangles without a gap at shared edges and corners (Woop, Benthin & Wald 2013, "Watertight Ray/Triangle
//! Intersection", Journal of Computer Graphics Techniques 2.1).
//!
//! Space is sheared so that the ray runs along an axis from the origin. A corner becomes the same point in all triangles that share it,
//! and the sign of the area that the ray makes with an edge is exact. Zero counts as inside on both sides. So no ray passes between two
//! triangles, and none meets a triangle that it does not pass.

use super::error::gamma;
use super::{Ray, Surface};
use glam::DVec3;

/// A ray, and the shear that turns it along the last axis.
#[derive(Clone, Copy, Debug)]
pub(super) struct Shear {
    origin: DVec3,
    /// The axis along which the ray runs the most, which becomes the last.
    pub axis: usize,
    x: f64,
    y: f64,
    z: f64,
}

/// Where a ray meets a triangle.
#[derive(Clone, Copy, Debug)]
pub(super) struct Meeting {
    pub t: f64,
    /// The weights of the second and third corner.
    pub weights: [f64; 2],
}

/// The coordinates of a vector in a cyclic order that ends with `axis`.
#[inline]
fn turned(vector: DVec3, axis: usize) -> [f64; 3] {
    match axis {
        0 => [vector.y, vector.z, vector.x],
        1 => [vector.z, vector.x, vector.y],
        _ => [vector.x, vector.y, vector.z],
    }
}

/// a·b − c·d, of the right sign: rounding is monotonic, so it could only be lost to zero. There the errors of the two products decide, which
/// a fused multiplication tells exactly.
#[inline]
fn area(a: f64, b: f64, c: f64, d: f64) -> f64 {
    let (ab, cd) = (a * b, c * d);
    if ab == cd {
        a.mul_add(b, -ab) - c.mul_add(d, -cd)
    } else {
        ab - cd
    }
}

impl Shear {
    pub fn of(ray: &Ray) -> Self {
        let axis = ray.direction.abs().max_position();
        let [x, y, z] = turned(ray.direction, axis);
        Shear {
            origin: ray.origin,
            axis,
            x: x / z,
            y: y / z,
            z: 1.0 / z,
        }
    }

    /// The slopes of the ray against its main axis, in cyclic order.
    pub fn slopes(&self) -> [f64; 2] {
        [self.x, self.y]
    }

    /// Where the ray meets a triangle, on either side, its edges and corners included. None where it runs along the triangle's
    /// plane, or the triangle has no area.
    #[inline]
    pub fn meet(&self, corners: [DVec3; 3]) -> Option<Meeting> {
        let [a, b, c] = corners.map(|corner| turned(corner - self.origin, self.axis));
        let sheared = |[x, y, z]: [f64; 3]| [x - self.x * z, y - self.y * z];
        let ([ax, ay], [bx, by], [cx, cy]) = (sheared(a), sheared(b), sheared(c));
        let u = area(cx, by, cy, bx);
        let v = area(ax, cy, ay, cx);
        let w = area(bx, ay, by, ax);
        let is_inside = (u >= 0.0 && v >= 0.0 && w >= 0.0) || (u <= 0.0 && v <= 0.0 && w <= 0.0);
        if !is_inside {
            return None;
        }
        let determinant = u + v + w;
        let [u, v, w] = [u, v, w].map(|area| area / determinant);
        let t = self.z * (u * a[2] + v * b[2] + w * c[2]);
        (t > 0.0 && t.is_finite()).then_some(Meeting { t, weights: [v, w] })
    }
}

/// The surface at the weights of a meeting. `normal` is that of the face where it is known better than from this triangle.
pub(super) fn surface(corners: [DVec3; 3], weights: [f64; 2], normal: Option<DVec3>) -> Surface {
    let [a, b, c] = corners;
    let (ab, ac) = (b - a, c - a);
    let position = a + weights[0] * ab + weights[1] * ac;
    Surface {
        position,
        normal: normal.unwrap_or_else(|| normal_of(ab, ac)),
        // Of the position, and of the shear in the next ray's test, which sees the corners as far away as the edges are long.
        error: gamma(6) * position.abs() + gamma(20) * (ab.abs() + ac.abs()),
    }
}

/// The unit normal, also of edges whose squares would vanish or overflow.
fn normal_of(ab: DVec3, ac: DVec3) -> DVec3 {
    let shortened = |edge: DVec3| edge / edge.abs().max_element().max(f64::MIN_POSITIVE);
    shortened(ab).cross(shortened(ac)).normalize_or(DVec3::Y)
}

/// The weights of the second and third corner at a point of a triangle's plane, from areas in the coordinate plane that it faces most.
pub(super) fn weights_at(corners: [DVec3; 3], point: DVec3) -> [f64; 2] {
    let [a, b, c] = corners;
    let longest = (b - a).abs().max((c - a).abs()).max_element();
    let [ab, ac, ap] = [b, c, point].map(|corner| (corner - a) / longest);
    let axis = ab.cross(ac).abs().max_position();
    let [ab, ac, ap] = [ab, ac, ap].map(|edge| turned(edge, axis));
    let area = |p: [f64; 3], q: [f64; 3]| p[0] * q[1] - p[1] * q[0];
    let whole = area(ab, ac);
    if whole == 0.0 {
        return [0.0, 0.0];
    }
    [area(ap, ac) / whole, area(ab, ap) / whole]
}
