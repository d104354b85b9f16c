//! Texture coordinates on one face of an object's mesh, as the object's own chart has them: those that a ray finds which meets
//! the face there.

use super::super::{Mesh, Shape};
use super::plane::Plane;
use super::polygon::Polygon;
use super::{ChartPart, chart, sphere, triangle};
use glam::{DVec2, DVec3};

/// The chart of an object on one face of its mesh.
#[derive(Clone, Debug)]
pub struct FaceChart<'a> {
    chart: Chart<'a>,
    corners: Vec<DVec2>,
}

#[derive(Clone, Debug)]
enum Chart<'a> {
    /// Around its centre.
    Sphere(DVec3),
    Polygon(&'a [DVec3]),
    Plane(Plane),
    /// Those of the face.
    Triangles(Vec<Corners>),
}

impl<'a> FaceChart<'a> {
    /// `mesh` is that of the object.
    pub fn new(shape: &'a Shape, mesh: &Mesh, face: usize) -> Self {
        let places = || mesh.face(face).iter().map(|&vertex| mesh.position(vertex));
        match shape {
            Shape::Sphere { center, .. } => {
                let middle = places().sum::<DVec3>() / mesh.face(face).len() as f64;
                let middle = sphere::uv(*center, middle);
                FaceChart {
                    chart: Chart::Sphere(*center),
                    corners: places()
                        .map(|place| beside(middle, sphere::uv(*center, place)))
                        .collect(),
                }
            }
            Shape::Polygon { vertices } => FaceChart {
                chart: Chart::Polygon(vertices),
                corners: places()
                    .map(|place| chart::polygon_uv(vertices, place))
                    .collect(),
            },
            Shape::Plane { point, normal } => FaceChart {
                chart: Chart::Plane(Plane {
                    point: *point,
                    normal: *normal,
                }),
                corners: Vec::new(),
            },
            Shape::Cylinder { .. } | Shape::Bezier { .. } | Shape::Mesh(_) => {
                FaceChart::of_mesh(mesh, face)
            }
        }
    }

    fn of_mesh(mesh: &Mesh, face: usize) -> Self {
        let (vertices, uvs) = (mesh.face(face), mesh.face_uvs(face));
        if uvs.is_empty() {
            return FaceChart {
                chart: Chart::Triangles(Vec::new()),
                corners: vec![DVec2::ZERO; vertices.len()],
            };
        }
        let triangles = Polygon::of_face(mesh, face).triangles();
        let corners = |triangle: [u32; 3]| {
            let place = triangle.map(|corner| mesh.position(vertices[corner as usize]));
            (place, triangle.map(|corner| uvs[corner as usize]))
        };
        FaceChart {
            chart: Chart::Triangles(triangles.into_iter().map(corners).collect()),
            corners: uvs.to_vec(),
        }
    }

    /// (u, v) at the corners of the face.
    pub fn corners(&self) -> &[DVec2] {
        &self.corners
    }

    /// (u, v) at a point of the face; (0, 0) where the object has none.
    pub fn uv(&self, position: DVec3) -> DVec2 {
        match &self.chart {
            Chart::Sphere(center) => sphere::uv(*center, position),
            Chart::Polygon(vertices) => chart::polygon_uv(vertices, position),
            Chart::Plane(plane) => plane.uv(position),
            Chart::Triangles(triangles) => uv_on_triangles(triangles, position),
        }
    }

    /// What holds at a point of the face; none where the object has no texture coordinates there.
    pub fn part(&self, position: DVec3) -> Option<ChartPart> {
        match &self.chart {
            &Chart::Sphere(center) => Some(ChartPart::Sphere { center }),
            Chart::Polygon(vertices) => chart::polygon_part(vertices),
            Chart::Plane(plane) => Some(plane.chart_part()),
            Chart::Triangles(triangles) => {
                let ((places, uvs), _) = triangle_at(triangles, position)?;
                ChartPart::triangle(*places, *uvs)
            }
        }
    }
}

/// Places and texture coordinates of a triangle's corners.
type Corners = ([DVec3; 3], [DVec2; 3]);

fn uv_on_triangles(triangles: &[Corners], position: DVec3) -> DVec2 {
    let at = triangle_at(triangles, position);
    at.map_or(DVec2::ZERO, |((_, [a, b, c]), [v, w])| {
        *a + v * (*b - *a) + w * (*c - *a)
    })
}

/// The triangle that the point lies in, or is least far outside of, and the weights of its second and third corner there.
fn triangle_at(triangles: &[Corners], position: DVec3) -> Option<(&Corners, [f64; 2])> {
    let inside = |[v, w]: [f64; 2]| v.min(w).min(1.0 - v - w);
    triangles
        .iter()
        .map(|corners| (corners, triangle::weights_at(corners.0, position)))
        .max_by(|(_, a), (_, b)| inside(*a).total_cmp(&inside(*b)))
}

/// The texture coordinates of a corner of a sphere's face on the same turn as the face's middle; a pole, which has every longitude, takes
/// that of the middle.
fn beside(middle: DVec2, corner: DVec2) -> DVec2 {
    if corner.y == 0.0 || corner.y == 1.0 {
        return DVec2::new(middle.x, corner.y);
    }
    DVec2::new(corner.x - (corner.x - middle.x).round(), corner.y)
}

#[cfg(test)]
mod tests {
    use super::super::super::Object;
    use super::super::super::tessellation::mesh_of;
    use super::super::tests::primitives;
    use super::super::{Primitives, Ray};
    use super::*;

    /// For each face the chart's (u, v) at inner points, and those of the ray that meets the divided object there.
    fn assert_as_rays(shape: Shape, within: f64) {
        let mesh = mesh_of(&shape, Object::DIVISIONS);
        let primitives: Primitives = primitives([Shape::Mesh(mesh.clone())]);
        let own = self::primitives([shape.clone()]);
        for face in 0..mesh.face_count() {
            let chart = FaceChart::new(&shape, &mesh, face);
            let corners: Vec<DVec3> = mesh.face(face).iter().map(|&v| mesh.position(v)).collect();
            assert_eq!(chart.corners().len(), corners.len());
            let middle = corners.iter().sum::<DVec3>() / corners.len() as f64;
            for corner in corners {
                let aim = middle.lerp(corner, 0.4);
                let ray = Ray {
                    origin: aim + 2.0 * mesh.normal(face),
                    direction: -mesh.normal(face),
                };
                let met = primitives.meet(0, &ray).expect("the face");
                assert!((met.t - 2.0).abs() < 1e-12);
                let hit = own.meet(0, &ray).expect("the object");
                let found = chart.uv(aim);
                let expected = own.uv(&hit, aim);
                assert!(found.distance(expected) < within, "{found} for {expected}");
            }
        }
    }

    #[test]
    fn a_face_has_the_texture_coordinates_that_a_ray_finds_there() {
        let at = |points: &[[f64; 3]]| points.iter().copied().map(DVec3::from).collect();
        assert_as_rays(
            Shape::Sphere {
                center: DVec3::new(1.0, -2.0, 0.5),
                radius: 1.5,
            },
            1e-12,
        );
        assert_as_rays(
            Shape::Polygon {
                vertices: at(&[[0., 0., 0.], [3., 0., 0.], [2., 2., 0.], [0., 1., 0.]]),
            },
            1e-12,
        );
    }

    #[test]
    fn corners_of_a_sphere_lie_on_one_turn() {
        let shape = Shape::Sphere {
            center: DVec3::ZERO,
            radius: 1.0,
        };
        let mesh = mesh_of(&shape, Object::DIVISIONS);
        for face in 0..mesh.face_count() {
            let chart = FaceChart::new(&shape, &mesh, face);
            let longitudes = || chart.corners().iter().map(|uv| uv.x);
            let width = longitudes().fold(0.0, f64::max) - longitudes().fold(1.0, f64::min);
            assert!(width < 1.0 / 32.0 + 1e-12, "face {face} is {width} wide");
        }
    }
}
