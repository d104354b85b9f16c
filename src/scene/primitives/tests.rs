//! Laws of what rays meet: the same bits with the hierarchies and without, at every scale.

use super::*;
use crate::numeric::Random;
use crate::scene::{Material, Mesh, Object, Shape};
use proptest::prelude::*;

pub fn scene(shapes: impl IntoIterator<Item = Shape>) -> Scene {
    let object = |shape| Object::new("", 0, shape);
    Scene {
        materials: vec![Material::default()],
        objects: shapes.into_iter().map(object).collect(),
        ..Scene::default()
    }
}

pub fn primitives(shapes: impl IntoIterator<Item = Shape>) -> Primitives {
    let scene = scene(shapes);
    Primitives::of(&scene, &Tessellation::of(&scene))
}

impl Primitives {
    fn blocked_by_brute_force(&self, ray: &Ray, distance: f64) -> bool {
        (0..self.primitives.len()).any(|object| {
            self.casts_shadow[object] && self.meet(object, ray).is_some_and(|hit| hit.t < distance)
        })
    }
}

/// Coordinates on a coarse grid now and then, so that places, edges and axes coincide.
fn coordinate() -> impl Strategy<Value = f64> {
    prop_oneof![
        (-3..=3_i32).prop_map(|i| f64::from(i) / 2.0),
        -1.5..1.5_f64,
        Just(-0.0)
    ]
}

fn point() -> impl Strategy<Value = DVec3> {
    [coordinate(), coordinate(), coordinate()].prop_map(DVec3::from)
}

fn shape() -> impl Strategy<Value = Shape> {
    let mesh = (
        prop::collection::vec(point(), 3..12),
        prop::collection::vec([0..12_u32, 0..12, 0..12], 1..40),
    )
        .prop_map(|(points, faces)| {
            let count = points.len() as u32;
            let faces = faces.iter().map(|face| face.map(|corner| corner % count));
            Shape::Mesh(Mesh::new(&points, faces, &[]))
        });
    prop_oneof![
        (point(), prop_oneof![Just(0.5), 1e-3..1.0_f64])
            .prop_map(|(center, radius)| Shape::Sphere { center, radius }),
        (point(), point()).prop_map(|(point, normal)| Shape::Plane {
            point,
            normal: normal.normalize_or(DVec3::Y)
        }),
        prop::collection::vec(point(), 3..8).prop_map(|vertices| Shape::Polygon { vertices }),
        (point(), point(), any::<bool>()).prop_map(|(base, axis, capped)| Shape::Cylinder {
            base,
            axis: axis.normalize_or(DVec3::Y),
            radius: 0.25,
            height: 1.0,
            capped
        }),
        mesh,
    ]
}

fn scaled(shape: &Shape, scale: f64, by: DVec3) -> Shape {
    let place = |point: DVec3| point * scale + by;
    match shape {
        &Shape::Sphere { center, radius } => Shape::Sphere {
            center: place(center),
            radius: radius * scale,
        },
        &Shape::Plane { point, normal } => Shape::Plane {
            point: place(point),
            normal,
        },
        Shape::Polygon { vertices } => Shape::Polygon {
            vertices: vertices.iter().map(|&vertex| place(vertex)).collect(),
        },
        &Shape::Cylinder {
            base,
            axis,
            radius,
            height,
            capped,
        } => Shape::Cylinder {
            base: place(base),
            axis,
            radius: radius * scale,
            height: height * scale,
            capped,
        },
        Shape::Mesh(mesh) => {
            let points: Vec<DVec3> = (0..mesh.vertex_count() as u32)
                .map(|vertex| place(mesh.position(vertex)))
                .collect();
            let faces = (0..mesh.face_count()).map(|face| mesh.face(face));
            Shape::Mesh(Mesh::new(&points, faces, &[]))
        }
        other => other.clone(),
    }
}

/// Along an axis, along a diagonal, or anywhere.
fn direction() -> impl Strategy<Value = DVec3> {
    prop_oneof![
        prop::sample::select(DVec3::AXES.to_vec()),
        prop::sample::select(vec![DVec3::NEG_X, DVec3::NEG_Y, DVec3::NEG_Z]),
        point().prop_map(|toward| toward.normalize_or(DVec3::X)),
        (point(), 1e-18..1e-6_f64)
            .prop_map(|(aside, slope)| (DVec3::Y + slope * aside).normalize()),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(if cfg!(debug_assertions) { 600 } else { 20_000 }))]
    #[test]
    fn hierarchies_give_the_same_bits(
        shapes in prop::collection::vec(shape(), 1..12),
        again in prop::collection::vec(any::<prop::sample::Index>(), 0..4),
        rays in prop::collection::vec((point(), direction(), 0..4_usize, any::<prop::sample::Index>()), 32),
        scale in prop::sample::select(vec![1.0, 1e-7, 1e7, 1e-60, 1e74]),
        by in prop::sample::select(vec![0.0, 0.0, 1.0, 1e7, -1e20]),
        moved in point(),
        distance in prop::sample::select(vec![f64::INFINITY, 0.5, 1.0, 2.0]),
        shadows in any::<u16>(),
    ) {
        let mut shapes: Vec<Shape> =
            shapes.iter().map(|shape| scaled(shape, scale, by * scale * moved)).collect();
        for index in again {
            shapes.push(shapes[index.index(shapes.len())].clone());
        }
        let mut scene = scene(shapes);
        for (i, object) in scene.objects.iter_mut().enumerate() {
            object.casts_shadow = shadows >> i & 1 == 1;
        }
        let primitives = Primitives::of(&scene, &Tessellation::of(&scene));
        for (origin, direction, how, index) in rays {
            let origin = origin * scale + by * scale * moved;
            let far = |distance: f64| origin - distance * scale * direction;
            let mut ray = Ray { origin: match how { 0 => origin, 1 => far(2.0), 2 => far(1e3), _ => far(1e20) }, direction };
            if how == 1 {
                // Straight at a corner
                let object = index.index(scene.objects.len());
                if let Solid::Faces { faces, .. } = &primitives.primitives[object] && faces.triangle_count() > 0 {
                    let corner = faces.corners(0)[index.index(3)];
                    ray.direction = ((corner - ray.origin) / scale).normalize_or(direction);
                }
            }
            let nearest = primitives.nearest(&ray);
            for object in 0..scene.objects.len() {
                prop_assert_eq!(primitives.meet(object, &ray), primitives.meet_by_brute_force(object, &ray));
            }
            prop_assert_eq!(nearest, primitives.nearest_by_brute_force(&ray));
            let distance = nearest.filter(|_| distance == 1.0).map_or(distance * scale, |hit| hit.t);
            prop_assert_eq!(primitives.blocked(&ray, distance), primitives.blocked_by_brute_force(&ray, distance));
            if let Some(hit) = nearest {
                prop_assert!(hit.t > 0.0 && hit.t.is_finite());
                let surface = primitives.surface(&ray, &hit);
                prop_assert!(surface.position.is_finite() && surface.error.is_finite());
                prop_assert!((surface.normal.length() - 1.0).abs() < 1e-12);
                prop_assert!(primitives.uv(&hit, surface.position).is_finite());
            }
            prop_assert!(primitives.around(ray.origin).len() <= scene.objects.len());
        }
    }
}

/// The sides of this polygon cross in a point that rounding puts above the others, and a ray from far away is moved near it.
#[test]
fn a_polygon_as_thin_as_the_rounding_of_its_coordinates_is_met() {
    let height = 1.094_536_230_521_690_4e27;
    let at = |x: f64, z: f64| DVec3::new(x * 1e7, height, z * 1e7);
    let polygon = Shape::Polygon {
        vertices: vec![
            at(-1.062_435_430_015_392_9, -0.328_888_727_114_880_65),
            at(-1.0, 0.774_149_972_894_277_2),
            at(-0.581_654_735_901_973_6, -1.040_568_558_244_471_5),
            at(1.5, 0.0),
            at(1.055_504_877_428_429, 0.276_856_145_651_442_73),
        ],
    };
    let cylinder = Shape::Cylinder {
        base: at(0.0, 0.0),
        axis: DVec3::Y,
        radius: 2.5e6,
        height: 1e7,
        capped: false,
    };
    let primitives = primitives([polygon, cylinder]);
    let direction = DVec3::new(0.0, -0.287_151_136_120_031_07, -0.957_885_288_030_344_1);
    let ray = Ray {
        origin: at(0.0, 0.0) - 1e27 * direction,
        direction,
    };
    let nearest = primitives.nearest(&ray);
    assert!(nearest.is_some_and(|hit| hit.object == 0), "{nearest:?}");
    assert_eq!(nearest, primitives.nearest_by_brute_force(&ray));
}

/// Directions to either side of a surface: anywhere, mirrored, straight on, and grazing down to a slope of 10⁻¹⁷.
fn departures(random: &mut Random, surface: &Surface, incoming: DVec3) -> [DVec3; 8] {
    let n = surface.normal;
    let tangent = n.cross(random.direction()).normalize_or(DVec3::X);
    let slope = 10_f64.powf(-17.0 * random.number().abs());
    let mirrored = incoming - 2.0 * incoming.dot(n) * n;
    let grazing = (tangent + slope * n).normalize();
    let anywhere = random.direction();
    [
        anywhere,
        -anywhere,
        mirrored,
        incoming,
        grazing,
        (tangent - slope * n).normalize(),
        n,
        -n,
    ]
}

#[test]
fn no_ray_meets_the_surface_that_it_leaves_at_any_scale() {
    let count = if cfg!(debug_assertions) { 300 } else { 20_000 };
    let mut random = Random(7);
    for scale in [1e-70, 1e-7, 1.0, 1e7, 1e70] {
        for away in [0.0, 1.0, 1e3, 1e7] {
            for i in 0..count {
                let center = away * scale * random.point();
                let shape = match i % 3 {
                    0 => Shape::Sphere {
                        center,
                        radius: scale * 10_f64.powf(random.number()),
                    },
                    1 => Shape::Plane {
                        point: center,
                        normal: if i % 2 == 0 {
                            random.direction()
                        } else {
                            DVec3::Y
                        },
                    },
                    _ => {
                        let mut corner = || center + scale * random.point();
                        Shape::Polygon {
                            vertices: vec![corner(), corner(), corner()],
                        }
                    }
                };
                let is_sphere = matches!(shape, Shape::Sphere { .. });
                let primitives = primitives([shape]);
                let target = match &primitives.primitives[0] {
                    Solid::Faces { faces, .. } => {
                        let [a, b, c] = faces.corners(0);
                        let (u, v) = (random.number().abs(), random.number().abs());
                        a + u * (1.0 - v) * (b - a) + u * v * (c - a)
                    }
                    _ => center + 0.5 * scale * random.point(),
                };
                let origin = center + 3.0 * scale * random.point();
                let ray = Ray {
                    origin,
                    direction: ((target - origin) / scale).normalize(),
                };
                let Some(hit) = primitives.meet(0, &ray) else {
                    continue;
                };
                let surface = primitives.surface(&ray, &hit);
                for direction in departures(&mut random, &surface, ray.direction) {
                    let leaving = leaving(&surface, direction);
                    let again = primitives.meet(0, &leaving);
                    let is_inward = is_sphere && direction.dot(surface.normal) < 0.0;
                    let Some(again) = again else {
                        continue;
                    };
                    // A chord through the sphere is as long as its direction is steep
                    let Solid::Sphere { radius, .. } = primitives.primitives[0] else {
                        panic!(
                            "{:?} met again at {again:?} toward {direction}",
                            primitives.primitives[0]
                        );
                    };
                    let chord = -2.0 * radius * direction.dot(surface.normal);
                    assert!(is_inward, "left outward, met at {again:?}");
                    assert!(again.t > 0.25 * chord, "{again:?} on a chord of {chord:e}");
                }
            }
        }
    }
}

#[test]
fn ties_go_to_the_lower_object_then_triangle() {
    let sphere = Shape::Sphere {
        center: DVec3::ZERO,
        radius: 1.0,
    };
    let square = [[-1., -1.], [1., -1.], [1., 1.], [-1., 1.]].map(|[x, y]| DVec3::new(x, y, 1.0));
    let wall = Shape::Plane {
        point: DVec3::Z,
        normal: DVec3::Z,
    };
    let primitives = primitives([
        Shape::Polygon {
            vertices: square.to_vec(),
        },
        sphere.clone(),
        wall,
        sphere,
        Shape::Polygon {
            vertices: square.to_vec(),
        },
    ]);
    let ray = Ray {
        origin: DVec3::new(0.0, 0.0, 3.0),
        direction: DVec3::NEG_Z,
    };
    let hit = Hit {
        t: 2.0,
        object: 0,
        triangle: 0,
    };
    assert_eq!(primitives.nearest(&ray), Some(hit));
    for object in 1..5 {
        assert_eq!(
            primitives.meet(object, &ray),
            Some(Hit {
                object: object as u32,
                ..hit
            })
        );
    }
    assert!(!primitives.blocked(&ray, 2.0));
    assert!(primitives.blocked(&ray, 2.0_f64.next_up()));
}

#[test]
fn an_empty_scene_is_met_nowhere() {
    let primitives = primitives([]);
    let ray = Ray {
        origin: DVec3::ZERO,
        direction: DVec3::X,
    };
    assert_eq!(primitives.nearest(&ray), None);
    assert!(!primitives.blocked(&ray, f64::INFINITY));
    assert!(primitives.around(DVec3::ZERO).is_empty());
}
