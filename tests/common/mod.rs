//! Scenes that several tests use.

use lightwalk::algorithms::prepared_scene::PreparedScene;
use lightwalk::methods::{Settings, Setup};
use lightwalk::scene::{self, Limits, View};

/// The scene of a JSON text, whose meshes are files of the repository's lessons, in front of its camera.
pub fn prepared(json: &str, width: u32, height: u32) -> PreparedScene {
    let lessons = concat!(env!("CARGO_MANIFEST_DIR"), "/lessons/");
    let mut read_file =
        |name: &str| std::fs::read(format!("{lessons}{name}")).map_err(|error| error.to_string());
    let scene = scene::read(json.as_bytes(), &Limits::default(), &mut read_file)
        .expect("the scene of a test is right");
    let view = View::new(
        &scene.camera.expect("the scene of a test has a camera"),
        width,
        height,
    );
    PreparedScene::new(scene, view)
}

/// As [`prepared`], with the settings that methods have where nothing is said.
pub fn setup(json: &str, width: u32, height: u32) -> Setup {
    Setup::new(prepared(json, width, height), Settings::default())
}

/// The teapot, with a quadrilateral that cuts through it, two lights and a sphere behind the eye.
pub const TEAPOT: &str = r#"{ "schema": 1, "background": [0.1, 0.2, 0.3],
  "camera": { "eye": [14, 20, 44], "target": [0, -0.6, 0], "up": [0, 1, 0], "fov_x_degrees": 42 },
  "materials": {
    "glaze": { "ambient": [0.05, 0.04, 0.03], "diffuse": [0.5, 0.4, 0.3], "specular": 0.5, "shininess": 25, "highlight": "phong" },
    "paper": { "ambient": [0.1, 0.1, 0.1], "diffuse": [0.6, 0.6, 0.7], "specular": 0.1, "shininess": 5 } },
  "objects": [
    { "name": "pot", "material": "glaze", "mesh": { "file": "meshes/teapot.obj" } },
    { "name": "sheet", "material": "paper", "polygon": { "vertices": [[-30, -5, -20], [40, -5, 60], [40, 6, 60], [-30, 6, -20]] } },
    { "name": "moon", "material": "paper", "sphere": { "center": [20, 25, 60], "radius": 4 } } ],
  "lights": [
    { "point": { "position": [-18, 40, 45], "color": [1, 0.9, 0.8], "attenuation": [0.5, 0.01, 0] } },
    { "directional": { "toward": [1, -1, -1], "color": [0.2, 0.2, 0.4] } } ] }"#;
