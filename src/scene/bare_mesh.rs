//! A scene around a mesh that comes alone: a camera that sees all of it, a light and a material.

use super::{Camera, Light, Limits, ReadFile, Scene, SceneError, Shape, read};
use crate::color::Rgb;
use glam::DVec3;
use std::path::Path;

/// Half of the camera's angle that is sure to lie in a picture of 4 by 3.
const HALF_ANGLE: f64 = 0.26;
const FOV_X: f64 = 0.7;

/// Whether a file of that name is a mesh.
pub fn is_mesh(name: &str) -> bool {
    let ending = Path::new(name)
        .extension()
        .map(|ending| ending.to_ascii_lowercase());
    ending.is_some_and(|ending| ["obj", "gltf", "glb"].iter().any(|mesh| ending == *mesh))
}

/// The scene of the mesh file of that name, which `read_file` reads. Errors: those of a scene with the mesh.
pub fn scene_of_mesh(
    file: &str,
    limits: &Limits,
    read_file: &mut ReadFile,
) -> Result<Scene, SceneError> {
    let name = file.rsplit('/').next().unwrap_or(file);
    let name = name.split('.').next().unwrap_or(name);
    let document = serde_json::json!({
        "schema": 1,
        "materials": { "surface": { "ambient": [0.05, 0.05, 0.05], "diffuse": [0.65, 0.65, 0.6], "specular": 0.3, "shininess": 40 } },
        "objects": [{ "name": name, "material": "surface", "mesh": { "file": file } }],
        "background": [0.75, 0.82, 0.9],
    });
    let mut scene = read(document.to_string().as_bytes(), limits, read_file)?;
    let (center, radius) = around(&scene);
    scene.camera = Some(Camera {
        eye: center + 1.1 * radius / HALF_ANGLE.sin() * DVec3::new(0.4, 0.35, 1.0).normalize(),
        target: center,
        up: DVec3::Y,
        fov_x: FOV_X,
    });
    scene.lights = vec![Light::Point {
        position: center + radius * DVec3::new(-3.0, 5.0, 6.0),
        color: Rgb::WHITE,
        attenuation: [1.0, 0.0, 0.0],
        radius: 0.0,
    }];
    Ok(scene)
}

/// A ball around all vertices.
fn around(scene: &Scene) -> (DVec3, f64) {
    let vertices = || {
        scene.objects.iter().flat_map(|object| {
            let mesh = match &object.shape {
                Shape::Mesh(mesh) => Some(mesh),
                _ => None,
            };
            mesh.into_iter().flat_map(|mesh| {
                (0..mesh.vertex_count() as u32).map(|vertex| mesh.position(vertex))
            })
        })
    };
    let ends = vertices()
        .map(|vertex| [vertex; 2])
        .reduce(|[low, high], [vertex, _]| [low.min(vertex), high.max(vertex)]);
    let [low, high] = ends.unwrap_or([DVec3::ZERO, DVec3::ONE]);
    let center = 0.5 * low + 0.5 * high;
    let radius = vertices().map(|vertex| vertex.distance(center));
    (center, radius.fold(0.0, f64::max).max(f64::MIN_POSITIVE))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::View;

    #[test]
    fn the_camera_sees_every_vertex_of_a_mesh_of_any_size_and_place() {
        for (scale, shift) in [(1.0, 0.0), (1e-3, 5.0), (2e4, -1e5)] {
            let corner = |bit: u32| {
                let side =
                    |axis: u32| f64::from((bit >> axis) & 1) * scale * f64::from(axis + 1) + shift;
                format!("v {} {} {}\n", side(0), side(1), side(2))
            };
            let corners: String = (0..8).map(corner).collect();
            let obj =
                corners + "f 1 2 4 3\nf 5 7 8 6\nf 1 5 6 2\nf 3 4 8 7\nf 1 3 7 5\nf 2 6 8 4\n";
            let scene = scene_of_mesh("box.obj", &Limits::default(), &mut |_| {
                Ok(obj.clone().into_bytes())
            })
            .unwrap();
            assert_eq!(scene.objects[0].name, "box");
            let view = View::new(&scene.camera.unwrap(), 480, 360);
            let Shape::Mesh(mesh) = &scene.objects[0].shape else {
                panic!("a mesh");
            };
            for vertex in 0..mesh.vertex_count() as u32 {
                let camera = view.to_camera(mesh.position(vertex));
                let at = view.to_screen(camera);
                assert!(camera.z > 0.0 && at.x > 0.0 && at.x < 480.0, "{at}");
                assert!(at.y > 0.0 && at.y < 360.0, "{at}");
            }
        }
    }
}
