//! The scenes that studies bring, and pictures of scenes.

use crate::algorithms::stage::Stage;
use crate::scene::{self, Camera, Limits, Scene, View};

/// A scene that is written in the program itself.
pub fn own(json: &str) -> Scene {
    let no_files = &mut |_: &str| Err("none is needed".to_string());
    scene::read(json.as_bytes(), &Limits::default(), no_files)
        .expect("the scenes of the program are right")
}

/// The camera of a scene. Errors: there is none.
pub fn camera(scene: &Scene) -> Result<Camera, String> {
    scene.camera.ok_or("the scene has no camera".to_string())
}

/// `scene` in front of its own camera.
pub fn stage(scene: Scene, camera: &Camera, [width, height]: [u32; 2]) -> Stage {
    Stage::new(scene, View::new(camera, width, height))
}
