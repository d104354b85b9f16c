//! A run with every kind of event for the tests of panels.

mod legible;
mod open_room;

// The tests of the window ask what is wrong with many pictures at once.
#[cfg(feature = "gui")]
pub use legible::illegible;
pub use legible::{all_views, assert_legible, assert_steps_are_legible, texts, views_in_turn};
pub use open_room::{
    FLOOR, LAMP, WALLS, crossing, crowded, form_factors, hinge, linked, open_room, solvers,
};

use super::fixture::Fixture;
use super::strings::Language;
use crate::algorithms::focus::Focus;
use crate::algorithms::prepared_scene::PreparedScene;
use crate::algorithms::primary::Settings;
use crate::algorithms::texture::Mapping;
use crate::color::Rgb;
use crate::methods::Setup;
use crate::panels::PanelInput;
use crate::record::RecordingLimit;
use crate::render::Method;
use crate::replay::{Run, Walk};
use crate::scene::{Camera, Highlight, Light, Material, Mesh, Object, Scene, Shape, Texture, View};
use glam::{DVec3, Vec2};
use std::collections::HashMap;
use std::num::NonZeroU32;
use std::sync::Arc;

/// Sizes at which panels are checked: the smallest, as in the window, low and wide, tall, large.
pub const SIZES: [Vec2; 6] = [
    Vec2::new(260.0, 174.0),
    Vec2::new(320.0, 220.0),
    Vec2::new(420.0, 260.0),
    Vec2::new(700.0, 120.0),
    Vec2::new(280.0, 600.0),
    Vec2::new(1400.0, 900.0),
];

impl Fixture {
    pub fn walk(&self) -> &dyn Walk {
        self.run.walk()
    }

    pub fn seek(&mut self, step: usize) -> &mut Self {
        self.run.walk_mut().seek(step);
        self
    }

    pub fn show_in(&self, language: Language) -> PanelInput<'_> {
        PanelInput {
            language,
            ..self.input()
        }
    }

    /// The first step of `kind`.
    pub fn first(&self, kind: &str) -> usize {
        (0..self.walk().len())
            .find(|&step| self.walk().kind(step) == kind)
            .unwrap_or_else(|| panic!("the sample has a {kind}"))
    }

    /// The first three steps of each kind, and every `stride`-th of all.
    pub fn some_steps(&self, stride: usize) -> Vec<usize> {
        let mut seen = HashMap::new();
        (0..self.walk().len())
            .filter(|&step| {
                let count = seen.entry(self.walk().kind(step)).or_insert(0);
                *count += 1;
                *count <= 3 || step % stride == 0
            })
            .collect()
    }
}

fn material(name: &str, color: Rgb, highlight: Highlight) -> Material {
    Material {
        name: name.to_string(),
        ambient: color * 0.1,
        diffuse: color,
        specular: Rgb::splat(0.4),
        shininess: 20.0,
        highlight,
        ..Material::default()
    }
}

/// Light and dark tiles so large.
fn tiles(scale: f64) -> Material {
    Material {
        texture: Some(Texture::Checker {
            colors: [Rgb::WHITE, Rgb::splat(0.3)],
            scale,
        }),
        ..material("tiles", Rgb::new(0.6, 0.5, 0.4), Highlight::Blinn)
    }
}

fn object(name: &str, material: usize, shape: Shape) -> Object {
    Object::new(name, material, shape)
}

fn mesh(positions: &[[f64; 3]], faces: &[[u32; 3]]) -> Shape {
    let positions: Vec<DVec3> = positions.iter().copied().map(DVec3::from).collect();
    Shape::Mesh(Mesh::new(&positions, faces, &[]))
}

fn scene(materials: Vec<Material>, objects: Vec<Object>, lights: Vec<Light>) -> Scene {
    Scene {
        background: Rgb::splat(0.05),
        camera: Some(Camera {
            eye: DVec3::new(0.0, 0.0, 6.0),
            target: DVec3::ZERO,
            up: DVec3::Y,
            fov_x: 40_f64.to_radians(),
        }),
        materials,
        objects,
        lights,
        ..Scene::default()
    }
}

fn lamp(color: Rgb) -> Light {
    Light::Point {
        position: DVec3::new(-2.0, 3.0, 3.0),
        color,
        attenuation: [1.0, 0.02, 0.01],
        radius: 0.0,
    }
}

/// Every kind of event: colours and greys, both highlights, a light in front and one behind, hidden pixels, an edge on no
/// row, normals that cancel out at a vertex and half-way between two, and an edge outside the frame. 28×21, the whole frame.
pub fn fixtures(method: Method) -> Fixture {
    let roof = [
        [-1.2, -1.0, 0.0],
        [0.0, -1.0, 0.5],
        [0.0, 1.0, 0.5],
        [1.2, 0.2, 0.0],
    ];
    let wall = [[-1.6, -1.3, -1.0], [1.9, -1.3, -1.0], [1.5, 1.2, -1.0]];
    let leaf = [[-1.6, 0.5, 0.0], [-1.0, 0.6, 0.0], [-1.3, 1.4, 0.1]];
    let far = [[1.8, 0.9, 0.0], [6.0, 1.0, 0.0], [6.0, 3.0, 0.0]];
    // Three faces that look back turn the normals of its lower corners round.
    let twist = [
        [1.3, 0.3, 0.0],
        [1.3, -0.3, 0.0],
        [1.7, -0.3, 0.0],
        [1.7, 0.3, 0.0],
        [1.5, -0.4, 0.0],
        [1.5, -0.5, 0.0],
        [1.5, -0.6, 0.0],
    ];
    let scene = scene(
        vec![
            material("red", Rgb::new(0.7, 0.2, 0.1), Highlight::Phong),
            material("grey", Rgb::splat(0.6), Highlight::Blinn),
        ],
        vec![
            object("roof", 0, mesh(&roof, &[[0, 1, 2], [1, 3, 2]])),
            object("wall", 1, mesh(&wall, &[[0, 1, 2]])),
            object("leaf", 1, mesh(&leaf, &[[0, 1, 2], [0, 2, 1]])),
            object("far", 0, mesh(&far, &[[0, 1, 2]])),
            object(
                "twist",
                1,
                mesh(
                    &twist,
                    &[[0, 1, 2], [0, 2, 3], [1, 2, 4], [1, 2, 5], [1, 2, 6]],
                ),
            ),
        ],
        vec![
            lamp(Rgb::new(1.0, 0.9, 0.8)),
            Light::Directional {
                toward: DVec3::Z,
                color: Rgb::splat(0.5),
            },
        ],
    );
    Fixture::of(scene, method, Focus::Frame, (28, 21))
}

/// A checkered floor that runs away from the eye, and a red ball on it. 16×12, the whole frame.
pub fn textured(method: Method, mapping: Mapping) -> Fixture {
    textured_under(vec![lamp(Rgb::WHITE)], method, mapping)
}

/// The same under other lights.
pub fn textured_under(lights: Vec<Light>, method: Method, mapping: Mapping) -> Fixture {
    let floor = [
        [-2.0, -1.0, 4.0],
        [2.0, -1.0, 4.0],
        [2.0, -1.0, -6.0],
        [-2.0, -1.0, -6.0],
    ];
    let scene = scene(
        vec![
            material("red", Rgb::new(0.7, 0.2, 0.1), Highlight::Phong),
            tiles(0.25),
        ],
        vec![
            object(
                "floor",
                1,
                Shape::Polygon {
                    vertices: floor.map(DVec3::from).to_vec(),
                },
            ),
            object(
                "ball",
                0,
                Shape::Sphere {
                    center: DVec3::ZERO,
                    radius: 0.8,
                },
            ),
        ],
        lights,
    );
    let camera = scene.camera.expect("it has one");
    let prepared = PreparedScene::new(scene, View::new(&camera, 16, 12));
    Fixture::rendered(Setup::new(prepared, mapping), method, Focus::Frame)
}

/// A checkered floor that reaches behind the eye, and a triangle in front, for Gouraud in the dark; 28×21, the whole frame.
pub fn behind_the_eye(method: Method) -> Fixture {
    let polygon = |vertices: &[[f64; 3]]| Shape::Polygon {
        vertices: vertices.iter().copied().map(DVec3::from).collect(),
    };
    let floor = [
        [-2.0, -1.0, 8.0],
        [2.0, -1.0, 9.0],
        [2.0, -1.0, -6.0],
        [-2.0, -1.0, -6.0],
    ];
    let leaf = [[-1.0, 0.2, 0.0], [0.4, 0.1, 0.3], [0.1, 1.2, 0.0]];
    let lights = match method {
        Method::Gouraud => Vec::new(),
        _ => vec![lamp(Rgb::WHITE)],
    };
    let scene = scene(
        vec![
            material("red", Rgb::new(0.7, 0.2, 0.1), Highlight::Phong),
            tiles(0.25),
        ],
        vec![
            object("floor", 1, polygon(&floor)),
            object("leaf", 0, polygon(&leaf)),
        ],
        lights,
    );
    Fixture::of(scene, method, Focus::Frame, (28, 21))
}

/// Rays among every kind of primitive, with surfaces that touch; 20×15, the whole frame.
pub fn shapes(method: Method) -> Fixture {
    let scene = crate::scene::read(
        include_bytes!("sample/shapes.json"),
        &crate::scene::Limits::default(),
        &mut |_| Ok(Vec::new()),
    );
    let scene = scene.expect("the sample is a scene");
    Fixture::of(scene, method, Focus::Frame, (20, 15))
}

/// Every kind of step of the ray methods: objects met, missed and hidden, a light ball, blocked lights, glass with total
/// internal reflection, a mirror, a texture, branches that end for each reason. 16×12, the whole frame.
pub fn rays(method: Method, samples: u32) -> Fixture {
    let mut glass = material("glass", Rgb::BLACK, Highlight::Blinn);
    (glass.reflection, glass.transmission, glass.ior) = (Rgb::splat(0.1), Rgb::splat(0.9), 1.5);
    let mut mirror = material("mirror", Rgb::new(0.2, 0.2, 0.3), Highlight::Phong);
    mirror.reflection = Rgb::new(0.5, 0.4, 0.3);
    let ball = |center: [f64; 3], radius| Shape::Sphere {
        center: DVec3::from(center),
        radius,
    };
    let ceiling = [[-4.0, 2.5, -3.0], [4.0, 2.5, -3.0], [0.0, 2.5, 2.0]];
    let leaf = [[-2.0, 0.0, 0.5], [-1.0, 0.1, 0.5], [-1.4, 0.9, 0.4]];
    let mut scene = scene(
        vec![
            material("clay", Rgb::new(0.7, 0.2, 0.1), Highlight::Blinn),
            glass,
            mirror,
            tiles(0.7),
        ],
        vec![
            object(
                "floor",
                3,
                Shape::Plane {
                    point: DVec3::new(0.0, -1.0, 0.0),
                    normal: DVec3::Y,
                },
            ),
            object("mirror ball", 2, ball([-0.9, -0.2, -0.6], 0.8)),
            object("glass ball", 1, ball([0.6, -0.1, 0.8], 0.8)),
            object("leaf", 0, mesh(&leaf, &[[0, 1, 2]])),
            object("clay ball", 0, ball([1.7, 0.6, -2.0], 0.6)),
            object("ceiling", 0, mesh(&ceiling, &[[0, 1, 2]])),
        ],
        vec![
            lamp(Rgb::new(1.0, 0.9, 0.8)),
            Light::Point {
                position: DVec3::new(0.9, 1.1, -0.4),
                color: Rgb::splat(0.6),
                attenuation: [1.0, 0.1, 0.0],
                radius: 0.4,
            },
            Light::Directional {
                toward: DVec3::new(0.6, -0.8, 0.0),
                color: Rgb::splat(0.3),
            },
        ],
    );
    scene.objects[4].casts_shadow = false;
    if method == Method::RayCasting {
        // A scene without highlights records less of its lights.
        for material in &mut scene.materials {
            material.specular = Rgb::BLACK;
        }
    }
    scene.path_attenuation = [1.0, 0.05, 0.01];
    let settings = Settings {
        samples: NonZeroU32::new(samples).expect("one sample or more"),
        ..Settings::default()
    };
    Fixture::with_settings(scene, method, Focus::Frame, (16, 12), settings)
}

/// A run with no steps: there is no room to record any.
pub fn nothing() -> Fixture {
    let mut fixture = fixtures(Method::Gouraud);
    let setup = Setup::new(fixture.run.prepared().clone(), Settings::default());
    fixture.run = Run::record(
        Arc::new(setup),
        Method::Gouraud,
        Focus::Frame,
        RecordingLimit(0),
    );
    fixture
}
