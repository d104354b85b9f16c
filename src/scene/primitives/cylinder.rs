//! Cylinders, with the discs at their ends where they are capped.

use super::error::gamma;
use super::{ChartPart, Ray, Surface};
use crate::numeric::sphere_roots;
use glam::{DVec2, DVec3};
use std::f64::consts::TAU;

/// A right circular cylinder. Its parts are numbered as triangles of other objects are.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cylinder {
    /// The middle of the lower end.
    pub base: DVec3,
    /// Unit, from the base to the other end.
    pub axis: DVec3,
    pub radius: f64,
    pub height: f64,
    pub capped: bool,
}

const MANTLE: u32 = 0;
pub(super) const LOWER_CAP: u32 = 1;
pub(super) const UPPER_CAP: u32 = 2;

impl Cylinder {
    /// The nearest t > 0, and the part that is met there.
    ///
    /// A capped cylinder is what two half spaces and a round bar have in common, so a ray enters at the last of their entries and
    /// leaves at the first of their exits: none passes between the mantle and a cap.
    pub fn meet(&self, ray: &Ray) -> Option<(f64, u32)> {
        let from_base = ray.origin - self.base;
        let (height, rise) = (from_base.dot(self.axis), ray.direction.dot(self.axis));
        let bar = self.bar(from_base, ray.direction)?;
        let ends = [-height / rise, (self.height - height) / rise];
        let (slab, caps) = if rise > 0.0 {
            (ends, [LOWER_CAP, UPPER_CAP])
        } else if rise < 0.0 {
            ([ends[1], ends[0]], [UPPER_CAP, LOWER_CAP])
        } else if (0.0..=self.height).contains(&height) {
            ([f64::NEG_INFINITY, f64::INFINITY], [LOWER_CAP; 2])
        } else {
            return None;
        };
        let enters = if slab[0] > bar[0] {
            (slab[0], caps[0])
        } else {
            (bar[0], MANTLE)
        };
        let leaves = if slab[1] < bar[1] {
            (slab[1], caps[1])
        } else {
            (bar[1], MANTLE)
        };
        let is_there =
            |&(t, part): &(f64, u32)| t > 0.0 && t.is_finite() && (self.capped || part == MANTLE);
        (enters.0 <= leaves.0)
            .then(|| [enters, leaves].into_iter().find(is_there))
            .flatten()
    }

    /// Where a ray enters and leaves the bar of infinite length. Along the axis: from and to infinity.
    fn bar(&self, from_base: DVec3, direction: DVec3) -> Option<[f64; 2]> {
        let across = |vector: DVec3| vector.reject_from_normalized(self.axis);
        let (from_axis, direction) = (across(from_base), across(direction));
        let Some(unit) = direction.try_normalize() else {
            let is_inside = from_axis.length() <= self.radius;
            return is_inside.then_some([f64::NEG_INFINITY, f64::INFINITY]);
        };
        let roots = sphere_roots(from_axis.to_array(), unit.to_array(), self.radius)?;
        Some(roots.map(|t| t / direction.length()))
    }

    /// The surface of a part at a point that is on it but for rounding: the point is moved onto it. The normal points outward.
    ///
    /// The error has a part for the position, and one for the next ray's test, as on a sphere.
    pub fn surface(&self, part: u32, near: DVec3) -> Surface {
        let from_base = near - self.base;
        let height = from_base.dot(self.axis);
        let (position, normal) = match part {
            LOWER_CAP => (near - height * self.axis, -self.axis),
            UPPER_CAP => (near + (self.height - height) * self.axis, self.axis),
            _ => {
                let across = from_base.reject_from_normalized(self.axis);
                let normal =
                    (across / self.radius).normalize_or(self.axis.any_orthonormal_vector());
                let on_axis = self.base + height * self.axis;
                (on_axis + self.radius * normal, normal)
            }
        };
        let extent = self.radius + self.height;
        let of_position = gamma(16) * (position.abs() + self.base.abs());
        Surface {
            position,
            normal,
            error: of_position + gamma(32) * DVec3::splat(extent),
        }
    }

    /// u = longitude/2π, from a direction across the axis; v = the share of the height.
    pub fn uv(&self, point: DVec3) -> DVec2 {
        let from_base = point - self.base;
        let [x, y] = self.across();
        let longitude = from_base.dot(y).atan2(from_base.dot(x)).rem_euclid(TAU);
        let share = from_base.dot(self.axis) / self.height;
        DVec2::new(longitude / TAU, share.clamp(0.0, 1.0))
    }

    pub fn chart_part(&self) -> ChartPart {
        ChartPart::Cylinder {
            base: self.base,
            across: self.across(),
            axis: self.axis,
            height: self.height,
        }
    }

    /// Two directions, unit, across the axis: longitudes run from the first toward the second.
    fn across(&self) -> [DVec3; 2] {
        let x = self.axis.any_orthonormal_vector();
        [x, self.axis.cross(x)]
    }

    /// Whether it is closed, and the point inside.
    pub fn contains(&self, point: DVec3) -> bool {
        let from_base = point - self.base;
        let height = from_base.dot(self.axis);
        let across = from_base.reject_from_normalized(self.axis);
        self.capped && height > 0.0 && height < self.height && across.length() < self.radius
    }

    /// The corners of the box around it: on each axis a disc takes radius·√(1 − axis²).
    pub fn bounds(&self) -> [DVec3; 2] {
        let tip = self.base + self.height * self.axis;
        let lean = self.axis * self.axis;
        let reach = self.radius * (DVec3::ONE - lean).max(DVec3::ZERO).map(f64::sqrt);
        let margin = gamma(16) * (self.base.abs() + tip.abs() + self.radius);
        let reach = reach + margin;
        [self.base.min(tip) - reach, self.base.max(tip) + reach]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::Random;

    fn cylinder(capped: bool) -> Cylinder {
        Cylinder {
            base: DVec3::new(0.3, -0.2, 0.1),
            axis: DVec3::new(1.0, 2.0, 2.0) / 3.0,
            radius: 0.5,
            height: 2.0,
            capped,
        }
    }

    /// How far a point is outside the solid, by its definition.
    fn outside(cylinder: &Cylinder, point: DVec3) -> f64 {
        let from = point - cylinder.base;
        let height = from.dot(cylinder.axis);
        let across = from.reject_from_normalized(cylinder.axis).length();
        (across - cylinder.radius)
            .max(height - cylinder.height)
            .max(-height)
    }

    #[test]
    fn rays_meet_the_solid_where_they_pass_its_border() {
        let (closed, open) = (cylinder(true), cylinder(false));
        let mut random = Random(3);
        let (mut mantle, mut caps) = (0, 0);
        for _ in 0..5000 {
            let mut point = || 2.0 * DVec3::from_array(std::array::from_fn(|_| random.number()));
            let (origin, to) = (point(), point());
            let ray = Ray {
                origin,
                direction: (to - origin).normalize(),
            };
            // Sampled along the ray, the sign changes at most twice.
            let inside = |i: i32| outside(&closed, ray.at(f64::from(i) * 0.01)) < 0.0;
            let crossing = (0..700).find(|&i| inside(i) != inside(i + 1));
            match (closed.meet(&ray), crossing) {
                (Some((t, part)), Some(i)) => {
                    assert!(
                        t >= f64::from(i) * 0.01 - 1e-12 && t <= f64::from(i + 1) * 0.01 + 1e-12
                    );
                    let surface = closed.surface(part, ray.at(t));
                    assert!(outside(&closed, ray.at(t)).abs() < 1e-14);
                    assert!(surface.position.distance(ray.at(t)) < 1e-14);
                    assert!((surface.normal.length() - 1.0).abs() < 1e-14);
                    let out = outside(&closed, surface.position + 1e-6 * surface.normal);
                    assert!((out - 1e-6).abs() < 1e-10, "{out}");
                    if part == MANTLE {
                        mantle += 1;
                    } else {
                        caps += 1;
                    }
                }
                // A corner that is passed between two samples
                (Some((t, _)), None) => assert!(outside(&closed, ray.at(t + 0.005)) > -0.01),
                (None, crossing) => assert_eq!(crossing, None),
            }
            if let Some((t, part)) = open.meet(&ray) {
                assert_eq!(part, MANTLE);
                assert!(outside(&closed, ray.at(t)).abs() < 1e-14);
            }
        }
        assert!(mantle > 500 && caps > 100, "{mantle} {caps}");
    }

    #[test]
    fn no_ray_passes_between_mantle_and_cap() {
        let closed = cylinder(true);
        let (u, v) = closed.axis.any_orthonormal_pair();
        for i in 0..2000 {
            let (sin, cos) = f64::from(i).sin_cos();
            let rim = closed.base + closed.radius * (cos * u + sin * v);
            let inside = closed.base + 1.0 * closed.axis + 0.2 * u;
            let ray = Ray {
                origin: inside,
                direction: (rim - inside).normalize(),
            };
            assert!(closed.meet(&ray).is_some());
        }
    }

    #[test]
    fn a_ray_along_the_axis_meets_the_caps_or_nothing() {
        for (capped, expected) in [(true, Some((3.0, LOWER_CAP))), (false, None)] {
            let cylinder = Cylinder {
                base: DVec3::ZERO,
                axis: DVec3::Y,
                radius: 1.0,
                height: 2.0,
                capped,
            };
            let up = |x: f64| {
                cylinder.meet(&Ray {
                    origin: DVec3::new(x, -3.0, 0.0),
                    direction: DVec3::Y,
                })
            };
            assert_eq!(up(0.5), expected);
            assert_eq!(up(1.5), None);
        }
    }

    #[test]
    fn bounds_touch_it() {
        let closed = cylinder(true);
        let [low, high] = closed.bounds();
        let (u, v) = closed.axis.any_orthonormal_pair();
        let rims = [closed.base, closed.base + closed.height * closed.axis];
        let points = rims.into_iter().flat_map(|middle| {
            (0..3600).map(move |i| {
                let (sin, cos) = (TAU * f64::from(i) / 3600.0).sin_cos();
                middle + 0.5 * (cos * u + sin * v)
            })
        });
        let (least, most) = points.fold(
            (DVec3::INFINITY, DVec3::NEG_INFINITY),
            |(least, most), p| (least.min(p), most.max(p)),
        );
        assert!(low.cmple(least).all() && high.cmpge(most).all());
        assert!((least - low).max_element() < 1e-6 && (high - most).max_element() < 1e-6);
    }
}
