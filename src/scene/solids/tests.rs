//! Laws of what rays meet: the same bits with the hierarchies and without, at every scale.

use super::*;
use crate::color::Rgb;
use crate::scene::{Material, Mesh, Object};
use proptest::prelude::*;

pub fn scene(shapes: impl IntoIterator<Item = Shape>) -> Scene {
    let object = |shape| Object {
        name: String::new(),
        material: 0,
        shape,
        patches: [1, 1],
        casts_shadow: true,
    };
    Scene {
        background: Rgb::BLACK,
        ambient: Rgb::WHITE,
        path_attenuation: [1.0, 0.0, 0.0],
        camera: None,
        materials: vec![Material {
            name: String::new(),
            ambient: Rgb::BLACK,
            diffuse: Rgb::WHITE,
            specular: Rgb::BLACK,
            shininess: 1.0,
            highlight: crate::scene::Highlight::Blinn,
            reflection: Rgb::BLACK,
            transmission: Rgb::BLACK,
            ior: 1.0,
            emission: Rgb::BLACK,
            reflectance: Rgb::WHITE,
            texture: None,
        }],
        objects: shapes.into_iter().map(object).collect(),
        lights: Vec::new(),
    }
}

pub fn solids(shapes: impl IntoIterator<Item = Shape>) -> Solids {
    let scene = scene(shapes);
    Solids::of(&scene, &Tessellation::of(&scene))
}

impl Solids {
    fn blocked_in_turn(&self, ray: &Ray, distance: f64) -> bool {
        (0..self.solids.len()).any(|object| {
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
        let solids = Solids::of(&scene, &Tessellation::of(&scene));
        for (origin, direction, how, index) in rays {
            let origin = origin * scale + by * scale * moved;
            let far = |distance: f64| origin - distance * scale * direction;
            let mut ray = Ray { origin: match how { 0 => origin, 1 => far(2.0), 2 => far(1e3), _ => far(1e20) }, direction };
            if how == 1 {
                // Straight at a corner
                let object = index.index(scene.objects.len());
                if let Solid::Faces { faces, .. } = &solids.solids[object] && faces.triangle_count() > 0 {
                    let corner = faces.corners(0)[index.index(3)];
                    ray.direction = ((corner - ray.origin) / scale).normalize_or(direction);
                }
            }
            let nearest = solids.nearest(&ray);
            for object in 0..scene.objects.len() {
                prop_assert_eq!(solids.meet(object, &ray), solids.meet_in_turn(object, &ray));
            }
            prop_assert_eq!(nearest, solids.nearest_in_turn(&ray));
            let distance = nearest.filter(|_| distance == 1.0).map_or(distance * scale, |hit| hit.t);
            prop_assert_eq!(solids.blocked(&ray, distance), solids.blocked_in_turn(&ray, distance));
            if let Some(hit) = nearest {
                prop_assert!(hit.t > 0.0 && hit.t.is_finite());
                let surface = solids.surface(&ray, &hit);
                prop_assert!(surface.position.is_finite() && surface.error.is_finite());
                prop_assert!((surface.normal.length() - 1.0).abs() < 1e-12);
                prop_assert!(solids.uv(&hit, surface.position).is_finite());
            }
            prop_assert!(solids.around(ray.origin).len() <= scene.objects.len());
        }
    }
}
