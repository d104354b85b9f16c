//! Scenes of spheres, planes and polygons at random.

use glam::DVec3;
use lightwalk::color::Rgb;
use lightwalk::scene::{
    Camera, Highlight, Light, Material, Names, Object, Scene, Shape, Texture, VertexNormals,
};
use proptest::prelude::*;

fn rgb(largest: f64) -> impl Strategy<Value = Rgb> {
    prop_oneof![
        Just(Rgb::BLACK),
        prop::array::uniform3(0.0..largest).prop_map(Rgb::from),
    ]
}

fn point(size: f64) -> impl Strategy<Value = DVec3> {
    prop::array::uniform3(-size..size).prop_map(DVec3::from)
}

fn material() -> impl Strategy<Value = Material> {
    let texture = prop::option::weighted(
        0.2,
        (rgb(1.0), 0.1..1.0).prop_map(|(color, scale)| Texture::Checker {
            colors: [Rgb::WHITE, color],
            scale,
        }),
    );
    (
        rgb(0.3),
        rgb(1.0),
        rgb(1.0),
        1.0..50.0,
        any::<bool>(),
        (rgb(0.9), rgb(0.9)),
        0.6..2.0,
        (rgb(0.3), texture),
    )
        .prop_map(
            |(
                ambient,
                diffuse,
                specular,
                shininess,
                phong,
                (reflection, transmission),
                ior,
                (emission, texture),
            )| Material {
                name: String::new(),
                ambient,
                diffuse,
                specular,
                shininess,
                highlight: if phong {
                    Highlight::Phong
                } else {
                    Highlight::Blinn
                },
                reflection,
                transmission,
                ior,
                emission,
                reflectance: Rgb::BLACK,
                texture,
            },
        )
}

fn shape() -> impl Strategy<Value = Shape> {
    prop_oneof![
        4 => (point(2.0), 0.1..1.2).prop_map(|(center, radius)| Shape::Sphere { center, radius }),
        1 => (point(2.0), point(1.0)).prop_map(|(point, normal)| Shape::Plane { point: 2.0 * point, normal: (normal + 0.01).normalize() }),
        2 => (point(2.0), point(1.5), point(1.5)).prop_map(|(a, u, v)| Shape::Polygon { vertices: vec![a, a + u, a + u + v, a + v] }),
        1 => [point(2.0), point(2.0), point(2.0)].prop_map(|v| Shape::Polygon { vertices: v.to_vec() }),
    ]
}

fn light() -> impl Strategy<Value = Light> {
    prop_oneof![
        (
            point(5.0),
            rgb(1.0),
            prop::array::uniform3(0.1..1.0),
            prop_oneof![Just(0.0), 0.1..0.6]
        )
            .prop_map(|(position, color, attenuation, radius)| Light::Point {
                position,
                color,
                attenuation,
                radius
            }),
        (point(1.0), rgb(1.0)).prop_map(|(toward, color)| Light::Directional {
            toward: (toward + 0.01).normalize(),
            color
        }),
    ]
}

pub fn scene() -> impl Strategy<Value = Scene> {
    let object = (shape(), 0_usize..4, prop::bool::weighted(0.8));
    (
        prop::collection::vec(object, 1..9),
        prop::collection::vec(material(), 4),
        prop::collection::vec(light(), 0..4),
        rgb(1.0),
        prop_oneof![Just([1.0, 0.0, 0.0]), prop::array::uniform3(0.1..1.0)],
    )
        .prop_map(
            |(objects, materials, lights, background, path_attenuation)| Scene {
                background,
                ambient: Rgb::new(0.9, 1.0, 0.8),
                path_attenuation,
                names: Names::new(),
                camera: Some(Camera {
                    eye: DVec3::new(0.1, 0.7, -5.0),
                    target: DVec3::new(0.05, 0.1, 0.0),
                    up: DVec3::Y,
                    fov_x: 0.9,
                }),
                materials,
                objects: objects
                    .into_iter()
                    .enumerate()
                    .map(|(i, (shape, material, casts_shadow))| Object {
                        name: format!("object {i}"),
                        material,
                        shape,
                        patches: [1, 1],
                        divisions: Object::DIVISIONS,
                        vertex_normals: VertexNormals::AVERAGED,
                        casts_shadow,
                    })
                    .collect(),
                lights,
                notes: Vec::new(),
            },
        )
}
