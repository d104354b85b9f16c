//! The scenes that studies bring, and pictures of scenes.

use crate::algorithms::prepared_scene::PreparedScene;
use crate::language::{Language, called};
use crate::methods::{Settings, Setup};
use crate::scene::{self, Camera, Limits, Object, Scene, Shape, View};
use glam::DVec3;

/// A scene that is written in the program itself.
pub fn own(json: &str) -> Scene {
    let no_files = &mut |_: &str| Err("none is needed".to_string());
    let mut scene = scene::read(json.as_bytes(), &Limits::default(), no_files)
        .expect("the scenes of the program are right");
    let names = scene.objects.iter().map(|Object { name, .. }| {
        let in_language = |language| called("object", name, language);
        let names = Language::ALL.map(|language| in_language(language).unwrap_or(name.clone()));
        (name.clone(), names)
    });
    scene.names = names.collect();
    scene
}

/// The camera of a scene. Errors: there is none.
pub fn camera(scene: &Scene) -> Result<Camera, String> {
    scene.camera.ok_or("the scene has no camera".to_string())
}

/// `scene` in front of its own camera.
pub fn prepared(scene: Scene, camera: &Camera, [width, height]: [u32; 2]) -> PreparedScene {
    PreparedScene::new(scene, View::new(camera, width, height))
}

/// As [`prepared`], with the settings that methods have where nothing is said.
pub fn setup(scene: Scene, camera: &Camera, size: [u32; 2]) -> Setup {
    Setup::new(prepared(scene, camera, size), Settings::default())
}

/// A ball between two mirrors that face each other: every level of rays brings another image.
pub const MIRRORS: &str = r#"{ "schema": 1, "background": [0.5, 0.6, 0.8],
  "camera": { "eye": [-1.6, 1.2, -3.2], "target": [0.9, 0.9, 1.5], "up": [0, 1, 0], "fov_x_degrees": 60 },
  "materials": {
    "mirror": { "diffuse": [0.05, 0.05, 0.05], "reflection": [0.75, 0.75, 0.75] },
    "floor": { "diffuse": [0.6, 0.6, 0.6], "texture": { "checker": { "colors": [[1, 1, 1], [0.3, 0.3, 0.3]], "scale": 0.7 } } },
    "red": { "ambient": [0.05, 0.02, 0.02], "diffuse": [0.7, 0.2, 0.2], "specular": [0.3, 0.3, 0.3], "shininess": 30 } },
  "objects": [
    { "name": "left", "material": "mirror", "plane": { "point": [-2, 0, 0], "normal": [1, 0, 0] } },
    { "name": "right", "material": "mirror", "plane": { "point": [2, 0, 0], "normal": [-1, 0, 0] } },
    { "name": "floor", "material": "floor", "plane": { "point": [0, 0, 0], "normal": [0, 1, 0] } },
    { "name": "ball", "material": "red", "sphere": { "center": [0.3, 0.7, 1], "radius": 0.7 } }],
  "lights": [{ "point": { "position": [0, 5, -2] } }] }"#;

/// Balls on a chequered floor, one of them of glass; seen from above, so that no far squares crowd into a pixel.
pub const BALLS: &str = r#"{ "schema": 1, "background": [0.5, 0.6, 0.8],
  "camera": { "eye": [0, 4, -5], "target": [0, -0.2, 0], "up": [0, 1, 0], "fov_x_degrees": 45 },
  "materials": {
    "red": { "ambient": [0.05, 0.02, 0.02], "diffuse": [0.7, 0.2, 0.2], "specular": [0.3, 0.3, 0.3], "shininess": 30, "reflection": [0.2, 0.2, 0.2] },
    "glass": { "diffuse": [0.05, 0.05, 0.05], "specular": [0.4, 0.4, 0.4], "shininess": 60, "reflection": [0.1, 0.1, 0.1], "transmission": [0.8, 0.8, 0.8], "ior": 1.5 },
    "floor": { "diffuse": [0.6, 0.6, 0.6], "texture": { "checker": { "colors": [[1, 1, 1], [0.3, 0.3, 0.3]], "scale": 0.7 } } } },
  "objects": [
    { "name": "red ball", "material": "red", "sphere": { "center": [-1, 0, 0.5], "radius": 0.9 } },
    { "name": "glass ball", "material": "glass", "sphere": { "center": [1, 0, -0.6], "radius": 0.8 }, "casts_shadow": false },
    { "name": "floor", "material": "floor", "plane": { "point": [0, -0.9, 0], "normal": [0, 1, 0] } }],
  "lights": [{ "point": { "position": [3, 6, -4] } }] }"#;

/// A closed unit cube whose ceiling gives off light, each wall of n×n patches.
pub fn cube(n: u32) -> Scene {
    let corner = |bits: usize| [0, 1, 2].map(|axis| (bits >> axis & 1) as f64);
    let walls = [
        [0, 1, 3, 2],
        [5, 4, 6, 7],
        [4, 0, 2, 6],
        [1, 5, 7, 3],
        [4, 5, 1, 0],
        [2, 3, 7, 6],
    ];
    let corners = walls.map(|wall| wall.map(corner));
    let mut scene = polygons(&corners);
    for (wall, object) in scene.objects.iter_mut().enumerate() {
        object.patches = [n, n];
        object.material = usize::from(wall == CEILING);
    }
    scene
}

/// Of the walls of the cube.
const CEILING: usize = 5;

/// Quadrilaterals of one patch each, by their corners.
pub fn polygons(corners: &[[[f64; 3]; 4]]) -> Scene {
    let mut scene = own(CUBE);
    scene.objects = corners
        .iter()
        .enumerate()
        .map(|(number, corners)| {
            let vertices = corners.map(DVec3::from).to_vec();
            Object::new(format!("polygon {number}"), 0, Shape::Polygon { vertices })
        })
        .collect();
    scene
}

const CUBE: &str = r#"{ "schema": 1, "objects": [],
  "materials": {
    "a wall": { "reflectance": [0.7, 0.7, 0.7] },
    "lamp": { "reflectance": [0.5, 0.5, 0.5], "emission": [1, 1, 1] } } }"#;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algorithms::enclosure::{self, Enclosure};
    use crate::scene::Parts;

    #[test]
    fn the_scenes_are_right_and_the_cube_is_closed() {
        assert_eq!(own(MIRRORS).objects.len(), 4);
        let balls = own(BALLS);
        assert_eq!(balls.objects.len(), 3);
        assert_eq!(
            balls.called("glass ball", Language::Indonesian),
            "bola kaca"
        );
        let enclosure =
            Enclosure::of(&cube(2), enclosure::Settings::default(), Parts::NONE).unwrap();
        let matrix = enclosure.form_factors().matrix();
        for row in matrix.chunks(24) {
            assert!((row.iter().sum::<f64>() - 1.0).abs() < 1e-6);
        }
        assert_eq!(enclosure.emission.iter().filter(|e| e.r > 0.0).count(), 4);
    }
}
