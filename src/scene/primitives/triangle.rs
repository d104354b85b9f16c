//! Rays and triangles without a gap at shared edges and corners (Woop, Benthin & Wald 2013, "Watertight Ray/Triangle
//! Intersection", Journal of Computer Graphics Techniques 2.1).
//!
//! Space is sheared so that the ray runs along an axis from the origin. A corner becomes the same point in all triangles that share it,
//! and the sign of the area that the ray makes with an edge is exact. Zero counts as inside on both sides. So no ray passes between two
//! triangles, and none meets a triangle that it does not pass.

use super::aim::Aim;
use super::error::gamma;
use super::{Ray, Surface};
use glam::DVec3;

/// A ray, and the shear that turns it along the last axis.
#[derive(Clone, Copy, Debug)]
pub(super) struct Shear<'a> {
    ray: &'a Ray,
    aim: &'a Aim,
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
/// a fused multiplication finds exactly.
#[inline]
fn area(a: f64, b: f64, c: f64, d: f64) -> f64 {
    let (ab, cd) = (a * b, c * d);
    if ab == cd {
        a.mul_add(b, -ab) - c.mul_add(d, -cd)
    } else {
        ab - cd
    }
}

/// A bound on the error of t, from the sheared corners, their distances along the ray and twice the area that the ray sees of the triangle
/// (Pharr, Jakob & Humphreys 2016, §3.9.6).
fn error_of_t(sheared: [[f64; 2]; 3], z: [f64; 3], determinant: f64) -> f64 {
    let largest = |values: [f64; 3]| values.into_iter().map(f64::abs).fold(0.0, f64::max);
    let (x, y, z) = (
        largest(sheared.map(|[x, _]| x)),
        largest(sheared.map(|[_, y]| y)),
        largest(z),
    );
    let (error_of_x, error_of_y, error_of_z) =
        (gamma(5) * (x + z), gamma(5) * (y + z), gamma(3) * z);
    let error_of_area = 2.0 * (gamma(2) * x * y + error_of_y * x + error_of_x * y);
    let area = determinant.abs();
    3.0 * (gamma(3) * z + error_of_z + error_of_area / area * z)
}

impl<'a> Shear<'a> {
    /// `aim` is that of the ray.
    pub fn new(ray: &'a Ray, aim: &'a Aim) -> Self {
        Shear { ray, aim }
    }

    /// Where the ray meets a triangle, on either side, its edges and corners included. None where it runs along the triangle's
    /// plane, or the triangle has no area.
    #[inline]
    pub fn meet(&self, corners: [DVec3; 3]) -> Option<Meeting> {
        let Aim {
            axes,
            slopes,
            length,
            ..
        } = self.aim;
        let [a, b, c] = corners.map(|corner| turned(corner - self.ray.origin, axes[2]));
        let sheared = |[x, y, z]: [f64; 3]| [x - slopes[0] * z, y - slopes[1] * z];
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
        let z = [a[2], b[2], c[2]].map(|z| length * z);
        let t = u * z[0] + v * z[1] + w * z[2];
        let nearest = z[0].min(z[1]).min(z[2]);
        // Only a triangle that reaches back to the origin can be met there by an error.
        let is_ahead =
            nearest > 0.0 || t > error_of_t([[ax, ay], [bx, by], [cx, cy]], z, determinant);
        (is_ahead && t > 0.0 && t.is_finite()).then(|| Meeting {
            t: t_across(corners, self.ray).unwrap_or(t),
            weights: [v, w],
        })
    }
}

/// The t of a ray that meets a triangle whose plane stands across a coordinate axis. It is the same, to the bit, for all triangles and
/// planes there, which an area would round differently for each. None for triangles aslant.
pub(super) fn t_across([a, b, c]: [DVec3; 3], ray: &Ray) -> Option<f64> {
    let axis = (0..3).find(|&axis| a[axis] == b[axis] && a[axis] == c[axis])?;
    let t = (a[axis] - ray.origin[axis]) / ray.direction[axis];
    (t > 0.0 && t.is_finite()).then_some(t)
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
    let [ab, ac, ap] = scaled(corners, point);
    let axis = ab.cross(ac).abs().max_position();
    let [ab, ac, ap] = [ab, ac, ap].map(|edge| turned(edge, axis));
    let area = |p: [f64; 3], q: [f64; 3]| p[0] * q[1] - p[1] * q[0];
    let whole = area(ab, ac);
    if whole == 0.0 {
        return [0.0, 0.0];
    }
    [area(ap, ac) / whole, area(ab, ap) / whole]
}

/// The axis across that coordinate plane; none where no area is seen along it.
pub(super) fn facing_axis(corners: [DVec3; 3]) -> Option<DVec3> {
    let [ab, ac, _] = scaled(corners, corners[0]);
    let areas = ab.cross(ac).abs();
    (areas.max_element() > 0.0).then(|| DVec3::AXES[areas.max_position()])
}

/// The second and third corner, and a point, from the first corner in units of the longest extent.
fn scaled([a, b, c]: [DVec3; 3], point: DVec3) -> [DVec3; 3] {
    let longest = (b - a).abs().max((c - a).abs()).max_element();
    let longest = longest.max(f64::MIN_POSITIVE);
    [b, c, point].map(|corner| (corner - a) / longest)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::Random;

    /// The usual test, without the care (Möller & Trumbore 1997, "Fast, Minimum Storage Ray-Triangle Intersection").
    fn moller_trumbore(ray: &Ray, [a, b, c]: [DVec3; 3]) -> bool {
        let (ab, ac, ao) = (b - a, c - a, ray.origin - a);
        let p = ray.direction.cross(ac);
        let q = ao.cross(ab);
        let determinant = ab.dot(p);
        let u = ao.dot(p) / determinant;
        let v = ray.direction.dot(q) / determinant;
        u >= 0.0 && v >= 0.0 && u + v <= 1.0 && ac.dot(q) / determinant > 0.0
    }

    fn woop(ray: &Ray, corners: [DVec3; 3]) -> bool {
        Shear::new(ray, &Aim::of(ray.direction))
            .meet(corners)
            .is_some()
    }

    /// Of rays aimed exactly at an edge that two triangles share, the share that passes between them.
    fn leaks(meets: fn(&Ray, [DVec3; 3]) -> bool) -> f64 {
        const COUNT: u32 = 20_000;
        let mut random = Random(1);
        let mut point =
            |z: f64| DVec3::new(random.number(), random.number(), z + 0.1 * random.number());
        let leaked = (0..COUNT).filter(|&i| {
            let (from, to) = (point(0.0), point(0.0));
            let across = (to - from).cross(DVec3::Z);
            let middle = 0.5 * (from + to);
            let (left, right) = (middle + across, middle - 1.5 * across);
            let share = (f64::from(i) + 0.5) / f64::from(COUNT);
            let origin = point(5.0);
            let aimed_at = from + share * (to - from);
            let ray = Ray {
                origin,
                direction: (aimed_at - origin).normalize(),
            };
            !meets(&ray, [from, to, left]) && !meets(&ray, [to, from, right])
        });
        leaked.count() as f64 / f64::from(COUNT)
    }

    #[test]
    fn no_ray_leaks_through_a_shared_edge() {
        let careless = leaks(moller_trumbore);
        assert!((0.03..0.09).contains(&careless), "{careless}");
        assert_eq!(leaks(woop), 0.0);
    }

    #[test]
    fn no_ray_leaks_through_a_corner_that_many_triangles_share() {
        let center = DVec3::new(0.1, 0.7, -0.3);
        let rim = |i: i32| {
            let (sin, cos) = (f64::from(i % 7) * 0.897_597_901_025_655).sin_cos();
            center + DVec3::new(1.3 * cos, 0.9 * sin, 0.2 * sin * cos)
        };
        for i in 0..2000 {
            let (sin, cos) = f64::from(i).sin_cos();
            let origin = center + DVec3::new(sin, 0.3 * cos, 3.0);
            let ray = Ray {
                origin,
                direction: (center - origin).normalize(),
            };
            assert!((0..7).any(|i| woop(&ray, [center, rim(i), rim(i + 1)])));
        }
    }

    #[test]
    fn a_ray_meets_both_sides_and_the_rim() {
        let corners = [DVec3::ZERO, DVec3::X, DVec3::Y];
        let toward = |x: f64, y: f64, down: f64| {
            let ray = Ray {
                origin: DVec3::new(x, y, 2.0 * down),
                direction: DVec3::NEG_Z * down,
            };
            Shear::new(&ray, &Aim::of(ray.direction))
                .meet(corners)
                .map(|meeting| meeting.t)
        };
        for down in [1.0, -1.0] {
            for (x, y) in [(0.25, 0.25), (0.0, 0.0), (0.5, 0.0), (0.5, 0.5), (0.0, 1.0)] {
                assert_eq!(toward(x, y, down), Some(2.0));
            }
            for (x, y) in [
                (0.5 + 1e-15, 0.5),
                (-1e-300, 0.5),
                (0.5, -1e-300),
                (2.0, 2.0),
            ] {
                assert_eq!(toward(x, y, down), None);
            }
        }
    }

    #[test]
    fn nothing_degenerate_is_met() {
        let (o, x, y) = (DVec3::ZERO, DVec3::X, DVec3::Y);
        let rays = [
            (DVec3::new(-1.0, 0.25, 0.0), x),
            (DVec3::new(0.25, 0.25, 1.0), DVec3::NEG_Z),
            (o, x),
            (DVec3::new(-1.0, 0.0, 0.0), x),
        ];
        for (origin, direction) in rays {
            let ray = Ray { origin, direction };
            assert!(!woop(&ray, [o, o, o]));
            assert!(!woop(&ray, [o, x, x]));
            assert!(!woop(&ray, [o, x, 2.0 * x]));
        }
        // In the plane
        assert!(!woop(
            &Ray {
                origin: DVec3::new(-1.0, 0.25, 0.0),
                direction: x
            },
            [o, x, y]
        ));
    }

    #[test]
    fn weights_come_back_from_the_position() {
        let corners = [
            DVec3::new(1e7, 2.0, 3.0),
            DVec3::new(1e7 + 1.0, 2.5, 3.0),
            DVec3::new(1e7, 2.0, 5.0),
        ];
        let [v, w] = weights_at(corners, surface(corners, [0.25, 0.5], None).position);
        assert!((v - 0.25).abs() < 1e-8 && (w - 0.5).abs() < 1e-8);
        assert_eq!(weights_at([DVec3::ONE; 3], DVec3::ONE), [0.0, 0.0]);
    }
}
