//! Shading methods by tessellation: how close polygons come to the true curved surface, lit with its true normal at every pixel.
//!
//! The reference casts a ray through every pixel to the true spheres and lights the point that it meets, with no shadows. Compared
//! is where the sphere faces the eye, N·V ≥ 0.6: the silhouette is a matter of the polygons' outline and not of the shading.

use super::pictures::{self, MEMORY};
use super::scenes;
use crate::algorithms::prepared_scene::PreparedScene;
use crate::algorithms::primary::{self, Settings};
use crate::algorithms::ray_casting::RayCaster;
use crate::algorithms::visible::Bvh;
use crate::color::Rgb;
use crate::language::Message;
use crate::record::Unrecorded;
use crate::render::Method;
use crate::scene::primitives::Ray;
use crate::scene::{Camera, Light, Scene, Shape, sphere_mesh};
use crate::study::fit::Law;
use crate::study::form::{Axes, Curve, Reference, Request, Study, Sweep};
use crate::study::label::Label;
use std::num::NonZeroU32;
use std::rc::Rc;
use std::sync::Arc;

pub static STUDY: Study = Study {
    name: "shading",
    title: Message("study-shading"),
    about: Message("study-shading-about"),
    sweeps,
};

const BALL: &str = r#"{ "schema": 1, "background": [0.1, 0.1, 0.1],
  "camera": { "eye": [0, 0, -4], "target": [0, 0, 0], "up": [0, 1, 0], "fov_x_degrees": 40 },
  "materials": { "plastic": { "ambient": [0.1, 0.1, 0.1], "diffuse": [0.6, 0.4, 0.2], "specular": [0.4, 0.4, 0.4], "shininess": 20, "highlight": "phong" } },
  "objects": [{ "name": "ball", "material": "plastic", "sphere": { "center": [0, 0, 0], "radius": 1 } }],
  "lights": [{ "directional": { "toward": [-0.4, -0.5, 1], "color": [1, 1, 1] } }] }"#;

/// Of N·V: seen less steeply than this, a pixel is compared.
const FACING: f64 = 0.6;

fn sweeps(request: &Request) -> Result<Vec<Sweep>, String> {
    let scene = match request.scene {
        Some(scene) => scene.clone(),
        None => scenes::own(BALL),
    };
    let camera = scenes::camera(&scene)?;
    let scene = plain(scene);
    let is_sphere = |shape: &Shape| matches!(shape, Shape::Sphere { .. });
    if !scene.objects.iter().any(|object| is_sphere(&object.shape)) {
        return Err("the scene has no sphere, so no surface whose true normals are known".into());
    }
    let size = request.either([200, 150], [400, 300]);
    let finest = request.either(5, 7);
    let truth = truth(&scene, &camera, size)?;
    // 8, 16, 32 … longitudes, half as many latitudes
    let divided: Vec<(u32, Arc<PreparedScene>)> = (0..finest)
        .map(|step| 8 << step)
        .map(|n| (n, Arc::new(tessellated(&scene, &camera, size, n))))
        .collect();
    let curves = methods().map(|method| {
        let sweep_settings = divided.iter().map(|(n, prepared)| {
            let setting = Label::Plain(format!("{n}×{}", n / 2));
            let size = f64::from(*n);
            pictures::sweep_setting(setting, size, prepared, method, Settings::default())
        });
        Curve::against(&truth, Label::Method(method), sweep_settings.collect())
    });
    Ok(vec![Sweep {
        title: Label::of("part-spheres"),
        axes: Axes::ErrorOverTime,
        size: Message("measure-longitudes-of-a-sphere"),
        quantity: Message("measure-intensity-toward-the-viewer"),
        law: Law::Power,
        reference: Reference {
            what: Label::of("reference-true-sphere"),
            error: 1e-15,
            known_by: Label::of("reference-form-and-rounding"),
        },
        memory: MEMORY,
        curves: curves.collect(),
    }])
}

/// The methods that shade polygons.
fn methods() -> impl Iterator<Item = Method> {
    let shades = |method: &Method| method.converts_polygons() && *method != Method::Wireframe;
    Method::ALL.into_iter().filter(shades)
}

/// The same scene with every sphere as a mesh of so many longitudes, and half as many latitudes.
fn tessellated(scene: &Scene, camera: &Camera, size: [u32; 2], longitudes: u32) -> PreparedScene {
    let mut scene = scene.clone();
    for object in &mut scene.objects {
        if let Shape::Sphere { center, radius } = object.shape {
            object.shape = Shape::Mesh(sphere_mesh(center, radius, [longitudes, longitudes / 2]));
        }
    }
    scenes::prepared(scene, camera, size)
}

/// The picture of the true spheres; NaN in pixels that are not compared. Errors: no pixel is.
fn truth(scene: &Scene, camera: &Camera, size: [u32; 2]) -> Result<Rc<[f64]>, String> {
    let setup = scenes::setup(scene.clone(), camera, size);
    let prepared = &setup.prepared;
    let caster = RayCaster::new(prepared, setup.settings.get(), setup.needs(), Bvh);
    let mut truth = Vec::new();
    for y in 0..size[1] {
        for x in 0..size[0] {
            let mut compared = false;
            let mut look = |ray: &Ray| compared = faces_the_eye(prepared, ray);
            primary::pixel::<primary::Event, _>(
                &prepared.view,
                NonZeroU32::MIN,
                (x, y),
                &mut Unrecorded,
                |ray, _| {
                    look(ray);
                    Rgb::BLACK
                },
            );
            let color = caster.pixel(x, y, &mut Unrecorded).channels();
            truth.extend(color.map(|channel| if compared { channel } else { f64::NAN }));
        }
    }
    match truth.iter().all(|channel| channel.is_nan()) {
        true => Err("no sphere is in sight".into()),
        false => Ok(truth.into()),
    }
}

/// Whether the ray meets a sphere where N·V is large enough.
fn faces_the_eye(prepared: &PreparedScene, ray: &Ray) -> bool {
    let primitives = prepared.primitives();
    primitives.nearest(ray).is_some_and(|hit| {
        let shape = &prepared.scene.objects[hit.object as usize].shape;
        let normal = primitives.surface(ray, &hit).normal;
        matches!(shape, Shape::Sphere { .. }) && -normal.dot(ray.direction) >= FACING
    })
}

/// Without what polygons do not show: infinite planes, textures, emitted light and light balls.
fn plain(mut scene: Scene) -> Scene {
    scene
        .objects
        .retain(|object| !matches!(object.shape, Shape::Plane { .. }));
    for material in &mut scene.materials {
        material.texture = None;
        material.emission = Rgb::BLACK;
    }
    for light in &mut scene.lights {
        if let Light::Point { radius, .. } = light {
            *radius = 0.0;
        }
    }
    scene
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algorithms::illumination::{Event, Lighting, SurfacePoint, illuminate};
    use glam::DVec3;

    /// The reference, by geometry written anew: the ray's nearest point to the centre, and half a chord back from it.
    #[test]
    fn the_reference_is_the_closed_form() {
        let scene = scenes::own(BALL);
        let camera = scenes::camera(&scene).unwrap();
        let size = [40, 30];
        let truth = truth(&scene, &camera, size).unwrap();
        let lighting = Lighting {
            ambient: scene.ambient,
            lights: &scene.lights,
            specular: true,
        };
        let half_width = (0.5 * camera.fov_x).tan();
        let mut compared = 0;
        for (pixel, truth) in truth.chunks(3).enumerate() {
            let (x, y) = ((pixel % 40) as f64 + 0.5, (pixel / 40) as f64 + 0.5);
            // The camera looks along +z, so that its right is −x.
            let right = (x - 20.0) / 20.0 * half_width;
            let up = (15.0 - y) / 20.0 * half_width;
            let direction = DVec3::new(-right, up, 1.0).normalize();
            let middle = camera.eye + 4.0 * direction.z * direction;
            let half_chord = (1.0 - middle.length_squared()).sqrt();
            let normal = (middle - half_chord * direction).normalize();
            if truth[0].is_nan() {
                assert!(half_chord.is_nan() || -normal.dot(direction) < FACING + 1e-9);
                continue;
            }
            let material = &scene.materials[0];
            let point = SurfacePoint {
                position: normal,
                normal,
                to_eye: -direction,
                material,
                diffuse: material.diffuse,
            };
            let lit = illuminate::<Event, _>(&point, &lighting, &mut Unrecorded, |_, _| true);
            for (found, right) in truth.iter().zip(lit.whole.channels()) {
                assert!((found - right).abs() < 1e-13, "{found} {right} at {pixel}");
            }
            compared += 1;
        }
        assert!(compared > 100, "{compared}");
    }

    #[test]
    fn a_scene_without_spheres_says_so() {
        let mut scene = scenes::own(BALL);
        scene.objects.clear();
        let request = Request {
            scene: Some(&scene),
            quick: true,
        };
        let why = sweeps(&request).err().unwrap();
        assert!(why.contains("no sphere"), "{why}");
    }
}
