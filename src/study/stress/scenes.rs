//! Scenes that cases look at.

use crate::algorithms::prepared_scene::PreparedScene;
use crate::algorithms::primary;
use crate::color::Rgb;
use crate::methods::{Method, Setup};
use crate::render::render;
use crate::scene::primitives::Primitives;
use crate::scene::{Light, Limits, Material, Object, Scene, Shape, Tessellation, View, read};
use glam::DVec3;
use std::num::{NonZeroU32, NonZeroUsize};

/// Errors: what the reader of scene files says.
pub fn scene(text: &str) -> Result<Scene, String> {
    let no_mesh = &mut |_: &str| Err("no such file".into());
    read(text.as_bytes(), &Limits::default(), no_mesh).map_err(|error| error.to_string())
}

/// In front of its camera, rays going on for `depth` levels.
pub fn staged(scene: Scene, [width, height]: [u32; 2], depth: u32) -> Result<Setup, String> {
    let camera = scene.camera.ok_or("the scene has no camera")?;
    let depth = NonZeroU32::new(depth).ok_or("there is no level 0")?;
    let prepared = PreparedScene::new(scene, View::new(&camera, width, height));
    let rays = primary::Settings {
        depth,
        samples: NonZeroU32::MIN,
    };
    Ok(Setup::new(prepared, rays))
}

/// Its colours, pixel by pixel.
pub fn picture(setup: &Setup, method: Method) -> Vec<Rgb> {
    render(setup, method, NonZeroUsize::MIN, &|_, _| {}).color
}

/// What the middle pixel of a ray-traced picture sees along +z from the origin.
pub fn look(objects: &str, materials: &str, more: &str, depth: u32) -> Result<Rgb, String> {
    let text = format!(
        r#"{{ "schema": 1, {more} "camera": {{ "eye": [0, 0, 0], "target": [0, 0, 1], "up": [0, 1, 0], "fov_x_degrees": 1 }},
             "materials": {{ {materials} }}, "objects": [ {objects} ] }}"#
    );
    let setup = staged(scene(&text)?, [1, 1], depth)?;
    Ok(picture(&setup, Method::RayTracing)[0])
}

/// One object alone, as rays meet it.
pub fn alone(shape: Shape) -> Primitives {
    let scene = Scene {
        materials: vec![Material::default()],
        objects: vec![Object::new("", 0, shape)],
        ..Scene::default()
    };
    Primitives::of(&scene, &Tessellation::of(&scene))
}

/// The scene with every length multiplied by `factor`, and then everything moved by `by`.
pub fn moved(mut scene: Scene, factor: f64, by: DVec3) -> Scene {
    let place = |point: &mut DVec3| *point = factor * *point + by;
    if let Some(camera) = &mut scene.camera {
        place(&mut camera.eye);
        place(&mut camera.target);
    }
    for object in &mut scene.objects {
        match &mut object.shape {
            Shape::Sphere { center, radius } => {
                place(center);
                *radius *= factor;
            }
            Shape::Plane { point, .. } => place(point),
            Shape::Polygon { vertices } => vertices.iter_mut().for_each(place),
            Shape::Cylinder { .. } | Shape::Bezier { .. } | Shape::Mesh(_) => {}
        }
    }
    for light in &mut scene.lights {
        if let Light::Point {
            position, radius, ..
        } = light
        {
            place(position);
            *radius *= factor;
        }
    }
    scene
}

/// How many colours of two pictures differ by more than `most` in some channel, or are no numbers.
pub fn differing(one: &[Rgb], other: &[Rgb], most: f64) -> usize {
    let differs = |a: &Rgb, b: &Rgb| {
        let within = |d: f64| d.abs() <= most;
        !(*a - *b).channels().into_iter().all(within)
    };
    std::iter::zip(one, other)
        .filter(|(a, b)| differs(a, b))
        .count()
}

/// Balls, a wall and a floor under a lamp and the sun: one ball is of glass, one a mirror.
pub const ROOM: &str = r#"{ "schema": 1, "background": [0.2, 0.3, 0.5],
  "camera": { "eye": [0.1, 1.7, -6], "target": [0.05, 0.7, 0], "up": [0, 1, 0], "fov_x_degrees": 40 },
  "materials": {
    "chalk": { "ambient": [0.1, 0.1, 0.1], "diffuse": [0.7, 0.6, 0.5], "specular": 0.3, "shininess": 30 },
    "mirror": { "diffuse": [0.1, 0.1, 0.1], "reflection": 0.8 },
    "glass": { "reflection": 0.1, "transmission": 0.9, "ior": 1.5 } },
  "objects": [
    { "name": "floor", "material": "chalk", "plane": { "point": [0, 0, 0], "normal": [0, 1, 0] } },
    { "name": "wall", "material": "chalk", "polygon": { "vertices": [[-3, 0, 3], [-3, 3, 3.5], [3, 3, 3.5], [3, 0, 3]] } },
    { "name": "ball", "material": "chalk", "sphere": { "center": [-1.3, 0.8, 0.5], "radius": 0.8 } },
    { "name": "mirror", "material": "mirror", "sphere": { "center": [1.2, 0.9, 1], "radius": 0.9 } },
    { "name": "glass", "material": "glass", "sphere": { "center": [0.2, 0.6, -1.2], "radius": 0.6 } } ],
  "lights": [
    { "point": { "position": [4, 6, -5] } },
    { "directional": { "toward": [1, -2, 1], "color": [0.3, 0.3, 0.2] } } ] }"#;
