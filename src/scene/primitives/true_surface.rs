//! The true surface that a face of a divided object stands for: where the ray through a point of the face meets the sphere,
//! cylinder or Bézier patch itself.
//!
//! Of the two meetings with a sphere or cylinder the nearer one is taken where the ray meets the front of the face, else the
//! farther. A ray that meets none takes the nearest point of the surface; on a Bézier patch, that with the parameters which the
//! point has in its cell. Cylinders are taken without their ends: the mantle goes on beyond them.

use super::super::tessellation::{bernstein, grid_weights, patch_point};
use super::super::{Mesh, Shape};
use super::{chart, sphere};
use crate::numeric::sphere_roots;
use glam::{DVec2, DVec3};

/// A point of a true surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TruePoint {
    pub position: DVec3,
    /// Unit, toward the front.
    pub normal: DVec3,
}

/// What is seen from `eye` through `seen`, a point of a face of the object's mesh. None where the object is what it is divided
/// into (polygons and meshes), and where a Bézier patch has no normal.
pub fn true_point(
    shape: &Shape,
    mesh: &Mesh,
    face: usize,
    eye: DVec3,
    seen: DVec3,
) -> Option<TruePoint> {
    let direction = (seen - eye).try_normalize()?;
    let front = direction.dot(mesh.normal(face)) < 0.0;
    match *shape {
        Shape::Sphere { center, radius } => {
            let t = meet_round(eye - center, direction, radius, front);
            let near = t.map_or(seen, |t| eye + t * direction);
            let surface = sphere::surface(center, radius, near);
            Some(TruePoint {
                position: surface.position,
                normal: surface.normal,
            })
        }
        Shape::Cylinder {
            base, axis, radius, ..
        } => {
            // An end is flat: its face is itself.
            if is_end(axis, mesh.normal(face)) {
                return Some(TruePoint {
                    position: seen,
                    normal: axis * mesh.normal(face).dot(axis).signum(),
                });
            }
            let across = |v: DVec3| v - v.dot(axis) * axis;
            let t = meet_round(across(eye - base), across(direction), radius, front);
            let near = t.map_or(seen, |t| eye + t * direction);
            let normal = across(near - base).try_normalize()?;
            let level = base + (near - base).dot(axis) * axis;
            Some(TruePoint {
                position: level + radius * normal,
                normal,
            })
        }
        Shape::Bezier {
            ref patches,
            divisions,
        } => {
            let (patch, start) = cell(patches, divisions, mesh, face, seen)?;
            let cell = 1.0 / f64::from(divisions);
            meet_patch(patch, eye, direction, start, cell)
                .unwrap_or_else(|| Derivatives::of(patch, start))
                .point()
        }
        Shape::Plane { .. } | Shape::Polygon { .. } | Shape::Mesh(_) => None,
    }
}

/// Whether a face of a cylinder with that axis is one of its ends. Both directions are unit vectors.
pub fn is_end(axis: DVec3, face_normal: DVec3) -> bool {
    face_normal.dot(axis).abs() > 0.5
}

/// The t > 0 at which a ray meets a circle or sphere about the origin; `direction` need not be unit.
fn meet_round(from_center: DVec3, direction: DVec3, radius: f64, nearer: bool) -> Option<f64> {
    let length = direction.length();
    let unit = direction.try_normalize()?;
    let [near, far] = sphere_roots(from_center.to_array(), unit.to_array(), radius)?;
    Some(if nearer { near } else { far } / length).filter(|&t| t > 0.0)
}

/// The patch that a face belongs to, and the parameters of a point of it. Faces without extent were dropped, so a patch may stand
/// later than the number of the face says.
fn cell<'a>(
    patches: &'a [[DVec3; 16]],
    divisions: u32,
    mesh: &Mesh,
    face: usize,
    seen: DVec3,
) -> Option<(&'a [DVec3; 16], DVec2)> {
    let corner = mesh.position(mesh.face(face)[0]);
    let uvs = mesh.face_uvs(face);
    let at = (uvs.first()? * f64::from(divisions)).round();
    let [along, across] = [at.x, at.y].map(|i| grid_weights(i as u32, divisions));
    let first = face / (divisions * divisions) as usize;
    let patch = patches
        .get(first..)?
        .iter()
        .find(|points| patch_point(points, &along, &across) == corner)?;
    let corners: Vec<DVec3> = mesh.face(face).iter().map(|&v| mesh.position(v)).collect();
    let share = chart::polygon_uv(&corners, seen);
    let uv = match *uvs {
        [a, b, c] => a + share.x * (b - a) + share.y * (c - a),
        [a, b, c, d] => a.lerp(b, share.x).lerp(d.lerp(c, share.x), share.y),
        _ => return None,
    };
    Some((patch, uv))
}

/// A point of a patch, with its derivatives by u and v.
struct Derivatives {
    position: DVec3,
    by_u: DVec3,
    by_v: DVec3,
}

impl Derivatives {
    fn of(points: &[DVec3; 16], uv: DVec2) -> Self {
        let (u, du) = (weights(uv.x), slopes(uv.x));
        let (v, dv) = (weights(uv.y), slopes(uv.y));
        Derivatives {
            position: patch_point(points, &u, &v),
            by_u: patch_point(points, &du, &v),
            by_v: patch_point(points, &u, &dv),
        }
    }

    fn point(self) -> Option<TruePoint> {
        Some(TruePoint {
            position: self.position,
            normal: self.by_u.cross(self.by_v).try_normalize()?,
        })
    }
}

/// Newton's iteration for the (u, v) at which the patch meets a ray, from `start` on, no further than one `cell` away.
fn meet_patch(
    points: &[DVec3; 16],
    eye: DVec3,
    direction: DVec3,
    start: DVec2,
    cell: f64,
) -> Option<Derivatives> {
    const MOST: usize = 16;
    // The ray is where two planes meet.
    let (a, b) = direction.any_orthonormal_pair();
    let across_ray = |v: DVec3| DVec2::new(v.dot(a), v.dot(b));
    let mut uv = start;
    for _ in 0..MOST {
        let at = Derivatives::of(points, uv);
        let (from_ray, by_u, by_v) = (
            across_ray(at.position - eye),
            across_ray(at.by_u),
            across_ray(at.by_v),
        );
        let determinant = by_u.perp_dot(by_v);
        let change = DVec2::new(from_ray.perp_dot(by_v), by_u.perp_dot(from_ray)) / determinant;
        if !change.is_finite() || (uv - start).abs().max_element() > cell {
            return None;
        }
        if change.abs().max_element() < 4.0 * f64::EPSILON {
            return Some(at);
        }
        uv -= change;
    }
    // A step of a rounding error or two may repeat for ever.
    let at = Derivatives::of(points, uv);
    let scale = at.position.distance(eye);
    (across_ray(at.position - eye).length() < 1e-12 * scale).then_some(at)
}

/// The cubic Bernstein polynomials at t.
fn weights(t: f64) -> [f64; 4] {
    bernstein(t, 1.0 - t)
}

/// Their derivatives.
fn slopes(t: f64) -> [f64; 4] {
    let s = 1.0 - t;
    [
        -3.0 * s * s,
        3.0 * s * (s - 2.0 * t),
        3.0 * t * (2.0 * s - t),
        3.0 * t * t,
    ]
}

#[cfg(test)]
mod tests {
    use super::super::super::Object;
    use super::super::super::tessellation::mesh_of;
    use super::*;

    /// Looks from `eye` through inner points of every face, and shows `check` each true point with the ray's direction.
    fn for_each_point(shape: &Shape, eye: DVec3, mut check: impl FnMut(DVec3, TruePoint)) -> usize {
        let mesh = mesh_of(shape, Object::DIVISIONS);
        let mut count = 0;
        for face in 0..mesh.face_count() {
            let corners: Vec<DVec3> = mesh.face(face).iter().map(|&v| mesh.position(v)).collect();
            let middle = corners.iter().sum::<DVec3>() / corners.len() as f64;
            for corner in corners {
                let seen = middle.lerp(corner, 0.7);
                if let Some(point) = true_point(shape, &mesh, face, eye, seen) {
                    assert!((point.normal.length() - 1.0).abs() < 1e-14);
                    check((seen - eye).normalize(), point);
                    count += 1;
                }
            }
        }
        count
    }

    fn is_on_ray(eye: DVec3, direction: DVec3, point: DVec3) -> bool {
        (point - eye).reject_from_normalized(direction).length() < 1e-12
    }

    #[test]
    fn a_sphere_and_a_cylinder_are_met_where_they_are() {
        let center = DVec3::new(0.3, -0.2, 0.1);
        let sphere = Shape::Sphere {
            center,
            radius: 0.7,
        };
        for eye in [DVec3::new(2.0, 1.0, 3.0), center] {
            let count = for_each_point(&sphere, eye, |direction, point| {
                assert!((point.position.distance(center) - 0.7).abs() < 1e-14);
                assert!(point.normal.distance((point.position - center) / 0.7) < 1e-14);
                assert!(is_on_ray(eye, direction, point.position));
            });
            // 448 quadrilaterals and 64 triangles
            assert_eq!(count, 4 * 448 + 3 * 64);
        }
        let axis = DVec3::new(1.0, 2.0, 2.0) / 3.0;
        let cylinder = Shape::Cylinder {
            base: center,
            axis,
            radius: 0.5,
            height: 2.0,
            capped: true,
        };
        let eye = DVec3::new(-3.0, 4.0, 1.0);
        for_each_point(&cylinder, eye, |direction, point| {
            assert!(is_on_ray(eye, direction, point.position));
            let from = point.position - center;
            let radial = from.reject_from_normalized(axis);
            if point.normal.dot(axis).abs() > 0.5 {
                assert!(from.dot(axis).abs().min((from.dot(axis) - 2.0).abs()) < 1e-14);
            } else {
                assert!((radial.length() - 0.5).abs() < 1e-14);
                assert!(point.normal.distance(radial / 0.5) < 1e-13);
            }
        });
    }

    #[test]
    fn a_bezier_patch_is_met_where_it_is_a_graph() {
        // Control points over an even grid make x = 3u and y = 3v; z is the polynomial of their heights.
        let heights = [
            0.0, 0.3, -0.2, 0.1, 0.4, 0.9, 0.5, 0.0, 0.1, 0.7, 1.1, 0.3, 0.0, -0.1, 0.2, 0.2,
        ];
        let points: [DVec3; 16] =
            std::array::from_fn(|i| DVec3::new((i % 4) as f64, (i / 4) as f64, heights[i]));
        let shape = Shape::Bezier {
            patches: vec![points],
            divisions: 6,
        };
        let eye = DVec3::new(1.2, 1.7, 9.0);
        let mut met = 0;
        let count = for_each_point(&shape, eye, |direction, point| {
            let uv = point.position.truncate() / 3.0;
            let (u, v) = (weights(uv.x), weights(uv.y));
            let height: f64 = (0..16).map(|i| heights[i] * u[i % 4] * v[i / 4]).sum();
            assert!((point.position.z - height).abs() < 1e-13);
            let slope = |uv: DVec2| {
                let (u, v) = (weights(uv.x), weights(uv.y));
                (0..16)
                    .map(|i| heights[i] * u[i % 4] * v[i / 4])
                    .sum::<f64>()
            };
            let h = 1e-5;
            let by_x = (slope(uv + DVec2::X * h) - slope(uv - DVec2::X * h)) / (6.0 * h);
            let by_y = (slope(uv + DVec2::Y * h) - slope(uv - DVec2::Y * h)) / (6.0 * h);
            // Differences at ±h are off by h²/6 of the third derivative, up to 20 here, and by rounding over h.
            let normal = DVec3::new(-by_x, -by_y, 1.0).normalize();
            assert!(point.normal.distance(normal) < 1e-9);
            met += usize::from(is_on_ray(eye, direction, point.position));
        });
        assert_eq!((count, met), (4 * 36, 4 * 36));
    }
}
