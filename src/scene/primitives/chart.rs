//! Texture coordinates on polygons, in [0, 1]².

use super::{ChartPart, triangle};
use glam::{DVec2, DVec3};

/// (u, v) at a point of a polygon.
///
/// - Three vertices: u along v0→v1, v along v0→v2.
/// - Four: the (u, v) whose bilinear mix of the vertices, u along v0→v1 and v along v0→v3, is the point.
/// - More: shares of the smallest rectangle around it that has a side along v0→v1, u along that side, v across it.
pub(super) fn polygon_uv(vertices: &[DVec3], point: DVec3) -> DVec2 {
    match *vertices {
        [a, b, c] => triangle::weights_at([a, b, c], point).into(),
        [a, b, c, d] => inverse_bilinear([a, b, c, d], point),
        _ => share_of_rectangle(vertices, point),
    }
    .clamp(DVec2::ZERO, DVec2::ONE)
}

/// What [`polygon_uv`] computes; none of a quadrilateral that is not planar, or without area.
pub(super) fn polygon_part(vertices: &[DVec3]) -> Option<ChartPart> {
    match *vertices {
        [a, b, c] => ChartPart::triangle([a, b, c], [DVec2::ZERO, DVec2::X, DVec2::Y]),
        [a, b, c, d] => {
            let [along, across, diagonal] = [b, d, c].map(|corner| corner - a);
            let volume = along.cross(across).dot(diagonal).abs();
            let whole = along.length() * across.length() * diagonal.length();
            let corners = [a, b, c, d];
            (volume < 1e-14 * whole).then_some(ChartPart::Quadrilateral { corners })
        }
        _ => {
            let flat = Flat::of(vertices);
            let [low, high] = flat.bounds(vertices);
            let [along, across] = [flat.along, flat.across].map(|axis| flat.extent * axis);
            Some(ChartPart::Rectangle {
                corner: flat.origin + low.x * along + low.y * across,
                sides: [(high.x - low.x) * along, (high.y - low.y) * across],
            })
        }
    }
}

/// Coordinates in the mean plane of a polygon, from its first vertex, in units of its extent. The first axis runs along v0→v1.
struct Flat {
    origin: DVec3,
    extent: f64,
    /// Unit.
    along: DVec3,
    across: DVec3,
}

impl Flat {
    fn of(vertices: &[DVec3]) -> Flat {
        let origin = vertices[0];
        let extent = vertices
            .iter()
            .map(|&v| (v - origin).abs().max_element())
            .fold(f64::MIN_POSITIVE, f64::max);
        let place = |point: DVec3| (point - origin) / extent;
        let normal: DVec3 = vertices[1..]
            .windows(2)
            .map(|pair| place(pair[0]).cross(place(pair[1])))
            .sum();
        let normal = normal.normalize_or(DVec3::Y);
        let along = vertices[1..]
            .iter()
            .map(|&v| place(v).reject_from_normalized(normal))
            .find(|edge| *edge != DVec3::ZERO)
            .unwrap_or(DVec3::X)
            .normalize_or(DVec3::X);
        Flat {
            origin,
            extent,
            along,
            across: normal.cross(along),
        }
    }

    fn place(&self, point: DVec3) -> DVec2 {
        let place = (point - self.origin) / self.extent;
        DVec2::new(place.dot(self.along), place.dot(self.across))
    }

    /// The lowest and the highest coordinates of vertices.
    fn bounds(&self, vertices: &[DVec3]) -> [DVec2; 2] {
        let places = || vertices.iter().map(|&v| self.place(v));
        [
            places().fold(DVec2::ZERO, DVec2::min),
            places().fold(DVec2::ZERO, DVec2::max),
        ]
    }
}

/// p = h = u·e + v·f + u·v·g with e = b − a, f = d − a, g = a − b + c − d. Without u: (f × g)v² + (f × e − h × g)v… a quadratic in v.
fn inverse_bilinear(vertices: [DVec3; 4], point: DVec3) -> DVec2 {
    let flat = Flat::of(&vertices);
    let [b, c, d] = [vertices[1], vertices[2], vertices[3]].map(|vertex| flat.place(vertex));
    let (e, f, g, h) = (b, d, c - b - d, flat.place(point));
    // h − v·f = u·(e + v·g), so their cross product is 0: (g × f)v² + (e × f + h × g)v + h × e = 0.
    let k_2 = g.perp_dot(f);
    let k_1 = e.perp_dot(f) + h.perp_dot(g);
    let k_0 = h.perp_dot(e);
    let q = -0.5 * (k_1 + (k_1 * k_1 - 4.0 * k_2 * k_0).max(0.0).sqrt().copysign(k_1));
    let outside = |x: f64| (-x).max(x - 1.0).max(0.0);
    [k_0 / q, q / k_2]
        .into_iter()
        .filter(|v| v.is_finite())
        .filter_map(|v| {
            let (along, rest) = (e + v * g, h - v * f);
            let u = if along.x.abs() >= along.y.abs() {
                rest.x / along.x
            } else {
                rest.y / along.y
            };
            u.is_finite().then_some(DVec2::new(u, v))
        })
        .min_by(|a, b| {
            let outside_by = |uv: &DVec2| outside(uv.x).max(outside(uv.y));
            outside_by(a).total_cmp(&outside_by(b))
        })
        .unwrap_or_default()
}

fn share_of_rectangle(vertices: &[DVec3], point: DVec3) -> DVec2 {
    let flat = Flat::of(vertices);
    let [low, high] = flat.bounds(vertices);
    (flat.place(point) - low) / (high - low).max(DVec2::splat(f64::MIN_POSITIVE))
}

#[cfg(test)]
mod tests {
    use super::super::tests::primitives;
    use super::super::{Hit, Primitives};
    use super::*;
    use crate::scene::Shape;

    fn is_near(a: DVec2, b: DVec2) -> bool {
        a.distance(b) < 1e-12
    }

    #[test]
    fn four_vertices_are_undone_bilinearly() {
        let at = |[x, y, z]: [f64; 3]| DVec3::new(x, y, z);
        let quadrilaterals = [
            [[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [0., 1., 0.]],
            [[1., 0., 2.], [5., 0., 2.], [4., 0., -1.], [2., 0., 0.]],
            [[0., 0., 0.], [0., 3., 1.], [0., 3., 3.], [0., 0., 1.]],
            [[1e7, 0., 0.], [1e7, 1., 0.], [1e7, 2., 2.], [1e7, 0., 1.]],
        ];
        for vertices in quadrilaterals {
            let [a, b, c, d] = vertices.map(at);
            for (u, v) in [
                (0.0, 0.0),
                (1.0, 0.0),
                (1.0, 1.0),
                (0.25, 0.75),
                (0.5, 0.0),
                (0.9, 0.1),
            ] {
                let point = a.lerp(b, u).lerp(d.lerp(c, u), v);
                let found = polygon_uv(&[a, b, c, d], point);
                assert!(is_near(found, DVec2::new(u, v)), "{found} for ({u}, {v})");
            }
        }
    }

    #[test]
    fn triangles_by_their_edges_and_others_by_their_rectangle() {
        let triangle = [DVec3::ZERO, DVec3::X * 2.0, DVec3::Z * 4.0];
        assert!(is_near(
            polygon_uv(&triangle, DVec3::new(0.5, 0.0, 1.0)),
            DVec2::new(0.25, 0.25)
        ));
        let house =
            [[0., 0.], [2., 0.], [2., 1.], [1., 2.], [0., 1.]].map(|[x, y]| DVec3::new(x, y, 5.0));
        assert!(is_near(
            polygon_uv(&house, DVec3::new(1.0, 0.5, 5.0)),
            DVec2::new(0.5, 0.25)
        ));
    }

    fn uv(primitives: &Primitives, position: [f64; 3]) -> DVec2 {
        let hit = Hit {
            t: 1.0,
            object: 0,
            triangle: 0,
        };
        primitives.uv(&hit, position.into())
    }

    #[test]
    fn planes_measure_lengths_along_axes() {
        let plane = |normal: DVec3| {
            primitives([Shape::Plane {
                point: DVec3::new(1.0, 2.0, 3.0),
                normal,
            }])
        };
        let place = [2.0, 4.0, 7.0];
        assert_eq!(uv(&plane(DVec3::Y), place), DVec2::new(1.0, 4.0));
        assert_eq!(uv(&plane(DVec3::NEG_Y), place), DVec2::new(1.0, 4.0));
        assert_eq!(uv(&plane(DVec3::Z), place), DVec2::new(1.0, 2.0));
        assert_eq!(uv(&plane(DVec3::X), place), DVec2::new(2.0, 4.0));
        let slope = plane(DVec3::new(0.0, 1.0, 1.0).normalize());
        assert!(is_near(
            uv(&slope, [5.0, 1.0, 4.0]),
            DVec2::new(4.0, 2_f64.sqrt())
        ));
    }

    #[test]
    fn spheres_have_their_poles_on_y_and_longitudes_from_z_toward_x() {
        let sphere = primitives([Shape::Sphere {
            center: DVec3::ZERO,
            radius: 2.0,
        }]);
        assert_eq!(uv(&sphere, [0.0, 0.0, 2.0]), DVec2::new(0.0, 0.5));
        assert_eq!(uv(&sphere, [2.0, 0.0, 0.0]), DVec2::new(0.25, 0.5));
        assert_eq!(uv(&sphere, [-2.0, 0.0, 0.0]), DVec2::new(0.75, 0.5));
        assert_eq!(uv(&sphere, [0.0, 2.0, 0.0]).y, 0.0);
        assert_eq!(uv(&sphere, [0.0, -2.0, 0.0]).y, 1.0);
    }
}
