//! Ray casting and ray tracing against closed forms, against a second renderer, and against themselves: by hierarchy and object by
//! object, with and without what the scene does not need.

#[path = "../common/mod.rs"]
mod common;
mod contract;
mod reference;

use common::{TEAPOT, prepared};
use glam::DVec3;
use lightwalk::algorithms::focus::Focus;
use lightwalk::algorithms::frame::Frame;
use lightwalk::algorithms::prepared_scene::PreparedScene;
use lightwalk::algorithms::primary::Settings;
use lightwalk::algorithms::ray_casting::{RayCaster, ray_casting};
use lightwalk::algorithms::ray_tracing::{RayTracer, ray_tracing};
use lightwalk::algorithms::visible::{BruteForce, Bvh, Search};
use lightwalk::color::Rgb;
use lightwalk::record::{Recording, RecordingLimit, Unrecorded};
use lightwalk::scene::{
    Camera, Highlight, Light, Material, Needs, Object, Parts, Scene, Shape, Texture, View,
};
use proptest::prelude::*;
use std::num::NonZeroU32;

fn blank(prepared: &PreparedScene) -> Frame {
    Frame::new(
        prepared.view.width,
        0..prepared.view.height,
        prepared.scene.background,
    )
}

fn traced(prepared: &PreparedScene, needs: &Needs, search: impl Search) -> Frame {
    let mut frame = blank(prepared);
    let tracer = RayTracer::new(prepared, needs, search);
    ray_tracing(&tracer, Focus::Frame, &mut frame, &mut Unrecorded);
    frame
}

fn cast(prepared: &PreparedScene, needs: &Needs, search: impl Search) -> Frame {
    let mut frame = blank(prepared);
    let caster = RayCaster::new(prepared, needs, search);
    ray_casting(&caster, Focus::Frame, &mut frame, &mut Unrecorded);
    frame
}

fn picture(prepared: &PreparedScene) -> Frame {
    traced(prepared, prepared.needs(), Bvh)
}

fn settings(depth: u32, samples: u32) -> Settings {
    Settings {
        depth: NonZeroU32::new(depth).expect("not 0"),
        samples: NonZeroU32::new(samples).expect("not 0"),
    }
}

/// One pixel, looking along +z from the origin.
fn look(objects: &str, materials: &str, more: &str, depth: u32) -> Rgb {
    let json = format!(
        r#"{{ "schema": 1, {more} "camera": {{ "eye": [0, 0, 0], "target": [0, 0, 1], "up": [0, 1, 0], "fov_x_degrees": 1 }},
             "materials": {{ {materials} }}, "objects": [ {objects} ] }}"#
    );
    let prepared = prepared(&json, 1, 1).with_settings(settings(depth, 1));
    picture(&prepared).pixel(0, 0)
}

#[test]
fn rays_of_the_last_level_are_shaded_and_no_deeper_ones() {
    // Two mirrors face each other; each gives off 1 and reflects 0.5: 1 + 1/2 + 1/4 + … to the last level.
    for depth in [1, 2, 5, 20, 64] {
        let color = look(
            r#"{ "name": "ahead", "material": "mirror", "plane": { "point": [0, 0, 1], "normal": [0, 0, -1] } },
               { "name": "behind", "material": "mirror", "plane": { "point": [0, 0, -1], "normal": [0, 0, 1] } }"#,
            r#""mirror": { "emission": [1, 1, 1], "reflection": 0.5 }"#,
            "",
            depth,
        );
        assert_eq!(
            color,
            Rgb::splat(2.0 - 0.5_f64.powi(depth as i32 - 1)),
            "depth {depth}"
        );
    }
}

#[test]
fn secondary_light_is_divided_by_the_distance_to_the_parent_surface() {
    // From the mirror at 1, the lamp behind the eye is 3 away; the background is left alone.
    let mirror = r#"{ "name": "ahead", "material": "mirror", "plane": { "point": [0, 0, 1], "normal": [0, 0, -1] } }"#;
    let lamp = r#"{ "name": "behind", "material": "lamp", "plane": { "point": [0, 0, -2], "normal": [0, 0, 1] } }"#;
    let materials = r#""mirror": { "reflection": [1, 0.5, 0] }, "lamp": { "emission": [1, 1, 1] }"#;
    let more = r#""background": [0.3, 0.3, 0.3], "path_attenuation": [1, 2, 0.5],"#;
    let color = look(&format!("{mirror}, {lamp}"), materials, more, 5);
    let divided = 1.0 / (1.0 + 2.0 * 3.0 + 0.5 * 9.0);
    for (channel, expected) in color
        .channels()
        .into_iter()
        .zip([divided, 0.5 * divided, 0.0])
    {
        assert!((channel - expected).abs() < 1e-14);
    }
    let open = look(mirror, materials, more, 5);
    assert_eq!(open, Rgb::new(0.3, 0.15, 0.0));
}

#[test]
fn a_visible_light_gives_its_colour_and_stops_no_shadow_ray() {
    let ball = |z: f64| {
        format!(
            r#""lights": [ {{ "point": {{ "position": [0, 0, {z}], "color": [3, 2, 1], "radius": 0.5, "attenuation": [9, 9, 9] }} }} ],"#
        )
    };
    let wall = r#"{ "name": "wall", "material": "white", "plane": { "point": [0, 0, 5], "normal": [0, 0, -1] } }"#;
    let white = r#""white": { "diffuse": [1, 1, 1] }"#;
    assert_eq!(look(wall, white, &ball(3.0), 1), Rgb::new(3.0, 2.0, 1.0));
    // Behind the wall it is hidden. Around the eye it is met from inside.
    assert_eq!(look(wall, white, &ball(7.0), 1), Rgb::BLACK);
    assert_eq!(look(wall, white, &ball(0.0), 1), Rgb::new(3.0, 2.0, 1.0));
}

#[test]
fn glass_of_index_1_is_not_there() {
    let wall = r#"{ "name": "wall", "material": "white", "plane": { "point": [0.3, 0.2, 5], "normal": [0.2, 0.1, -1] } }"#;
    let ball = r#", { "name": "ball", "material": "nothing", "sphere": { "center": [0.2, 0.1, 3], "radius": 0.7 }, "casts_shadow": false }"#;
    let materials = r#""white": { "diffuse": [0.9, 0.8, 0.7], "texture": { "checker": { "colors": [[1, 1, 1], [0.2, 0.2, 0.2]], "scale": 0.1 } } }, "nothing": { "transmission": 1, "ior": 1 }"#;
    let json = |objects: &str| {
        format!(
            r#"{{ "schema": 1, "camera": {{ "eye": [0, 0, 0], "target": [0, 0, 1], "up": [0, 1, 0], "fov_x_degrees": 60 }},
                 "materials": {{ {materials} }}, "objects": [ {objects} ],
                 "lights": [ {{ "point": {{ "position": [1, 2, 0] }} }} ] }}"#
        )
    };
    let without = picture(&prepared(&json(wall), 64, 48));
    let with = picture(&prepared(&json(&format!("{wall}{ball}")), 64, 48));
    let differing = std::iter::zip(&without.color, &with.color)
        .filter(|(a, b)| (**a - **b).channels().iter().any(|d| d.abs() > 1e-12))
        .count();
    assert_eq!(differing, 0);
}

#[test]
fn a_slab_of_glass_shifts_a_ray_sideways() {
    // Through a slab of thickness 1 at 45°, η = 1.5, the ray goes on 0.3291423081773203 beside its line: it meets the wall where a
    // parallel ray that starts so much aside would. The wall's checker tells the place to 1e-9.
    let shift = 0.329_142_308_177_320_3;
    let scene = |edge: f64| {
        // The boundary between black and white, across the direction of the shift
        format!(
            r#"{{ "schema": 1, "camera": {{ "eye": [0, 0, 0], "target": [0, 1, 1], "up": [1, 0, 0], "fov_x_degrees": 1e-9 }},
                 "materials": {{ "glass": {{ "transmission": 1, "ior": 1.5 }}, "lit": {{ "emission": [1, 1, 1] }} }},
                 "objects": [
                   {{ "name": "front", "material": "glass", "mesh": {{ "file": "slab.obj" }} }},
                   {{ "name": "wall", "material": "lit", "polygon": {{ "vertices": [[-9, {edge}, 4], [-9, 99, 4], [9, 99, 4], [9, {edge}, 4]] }} }} ] }}"#
        )
    };
    let slab = "v -9 -9 1\nv 9 -9 1\nv 9 9 1\nv -9 9 1\nv -9 -9 2\nv 9 -9 2\nv 9 9 2\nv -9 9 2\nf 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 4 8 7 3\nf 1 5 8 4\nf 2 3 7 6\n";
    let color = |edge: f64| {
        let mut read = |_: &str| Ok(slab.as_bytes().to_vec());
        let scene = lightwalk::scene::read(scene(edge).as_bytes(), &Default::default(), &mut read)
            .expect("a scene");
        let view = View::new(&scene.camera.expect("a camera"), 1, 1);
        picture(&PreparedScene::new(scene, view)).pixel(0, 0)
    };
    // Without the slab the ray meets y = z = 4. A shift of s across the ray is s·√2 along y.
    let met = 4.0 - shift * std::f64::consts::SQRT_2;
    assert_eq!(color(met - 1e-9), Rgb::WHITE);
    assert_eq!(color(met + 1e-9), Rgb::BLACK);
}

#[test]
fn the_critical_angle_is_kept_to_1e_12() {
    // From inside the glass, on a plane met at the critical angle 41.81…° ± 1e-12 rad. The eye is in no closed object, so the
    // plane is given the other side: air inside the "object" of index 1/1.5.
    let critical = (1.0_f64 / 1.5).asin();
    for (angle, passes) in [(critical - 1e-12, true), (critical + 1e-12, false)] {
        let (sin, cos) = angle.sin_cos();
        let json = format!(
            r#"{{ "schema": 1, "background": [0, 1, 0], "camera": {{ "eye": [0, 0, 0], "target": [{sin:?}, 0, {cos:?}], "up": [0, 1, 0], "fov_x_degrees": 1e-9 }},
                 "materials": {{ "thin": {{ "transmission": 1, "ior": {:?} }}, "lit": {{ "emission": [1, 0, 0] }} }},
                 "objects": [ {{ "name": "border", "material": "thin", "plane": {{ "point": [0, 0, 1], "normal": [0, 0, -1] }} }},
                              {{ "name": "near", "material": "lit", "plane": {{ "point": [0, 0, -1], "normal": [0, 0, 1] }} }} ] }}"#,
            1.0 / 1.5
        );
        let color = picture(&prepared(&json, 1, 1)).pixel(0, 0);
        let expected = if passes {
            [0.0, 1.0, 0.0]
        } else {
            [1.0, 0.0, 0.0]
        };
        assert_eq!(color.channels(), expected, "{angle}");
    }
}

#[test]
fn a_ray_in_a_plane_misses_it() {
    let color = look(
        r#"{ "name": "floor", "material": "lit", "plane": { "point": [0, 0, 0], "normal": [0, 1, 0] } },
           { "name": "sheet", "material": "lit", "polygon": { "vertices": [[-1, 0, 1], [1, 0, 1], [1, 0, 2], [-1, 0, 2]] } }"#,
        r#""lit": { "emission": [1, 1, 1] }"#,
        r#""background": [0.25, 0.5, 0.75],"#,
        5,
    );
    assert_eq!(color, Rgb::new(0.25, 0.5, 0.75));
}

#[test]
fn an_air_bubble_in_glass_turns_light_back_beyond_the_critical_angle() {
    // Concentric: glass of radius 2, air of radius 1. A ray at height h meets the bubble at sin θ = h/(1.5·1) inside the glass, and is
    // refracted into it only where 1.5·sin θ < 1, that is h < 1.
    let json = |h: f64| {
        format!(
            r#"{{ "schema": 1, "background": [0, 0, 0], "camera": {{ "eye": [{h:?}, 0, -9], "target": [{h:?}, 0, 0], "up": [0, 1, 0], "fov_x_degrees": 1e-9 }},
                 "materials": {{ "glass": {{ "transmission": 1, "ior": 1.5 }}, "air": {{ "transmission": 1, "ior": 1, "emission": [1, 1, 1] }} }},
                 "objects": [ {{ "name": "glass", "material": "glass", "sphere": {{ "center": [0, 0, 0], "radius": 2 }} }},
                              {{ "name": "bubble", "material": "air", "sphere": {{ "center": [0, 0, 0], "radius": 1 }} }} ] }}"#
        )
    };
    let sum = |h: f64| picture(&prepared(&json(h), 1, 1)).pixel(0, 0).r;
    // Twice the bubble's light where the ray goes in and out of it, once where it is turned back, none beside it (h > 1.5).
    assert_eq!(sum(0.999_999), 2.0);
    assert_eq!(sum(1.000_001), 1.0);
    assert_eq!(sum(1.499_999), 1.0);
    assert_eq!(sum(1.500_001), 0.0);
}

#[test]
fn an_eye_inside_glass_looks_out_of_it() {
    let json = r#"{ "schema": 1, "background": [0, 1, 0], "camera": { "eye": [0, 0, 0.9], "target": [1, 0, 0.9], "up": [0, 1, 0], "fov_x_degrees": 1 },
      "materials": { "glass": { "transmission": 1, "ior": 1.5, "reflection": 0, "emission": [0.125, 0, 0] } },
      "objects": [ { "name": "glass", "material": "glass", "sphere": { "center": [0, 0, 0], "radius": 1 } } ] }"#;
    // sin θ = 0.9 lies beyond 1/1.5: the light goes around inside for ever, and meets the surface at every level.
    let color = picture(&prepared(json, 1, 1).with_settings(settings(8, 1))).pixel(0, 0);
    assert_eq!(color, Rgb::new(1.0, 0.0, 0.0));
    // Lower, it leaves at once.
    let lower = json.replace("0.9]", "0.6]");
    let color = picture(&prepared(&lower, 1, 1)).pixel(0, 0);
    assert_eq!(color, Rgb::new(0.125, 1.0, 0.0));
}

/// Coordinates multiplied by a power of two: every number of the run keeps its digits.
fn scaled(scene: &Scene, factor: f64) -> Scene {
    let mut scene = scene.clone();
    if let Some(camera) = &mut scene.camera {
        camera.eye *= factor;
        camera.target *= factor;
    }
    for object in &mut scene.objects {
        match &mut object.shape {
            Shape::Sphere { center, radius } => {
                *center *= factor;
                *radius *= factor;
            }
            Shape::Plane { point, .. } => *point *= factor,
            Shape::Polygon { vertices } => vertices.iter_mut().for_each(|v| *v *= factor),
            _ => {}
        }
    }
    for light in &mut scene.lights {
        if let Light::Point {
            position, radius, ..
        } = light
        {
            *position *= factor;
            *radius *= factor;
        }
    }
    scene
}

fn staged(scene: Scene, width: u32, height: u32) -> PreparedScene {
    let view = View::new(&scene.camera.expect("a camera"), width, height);
    PreparedScene::new(scene, view)
}

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

fn scene() -> impl Strategy<Value = Scene> {
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
                        casts_shadow,
                    })
                    .collect(),
                lights,
            },
        )
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(96))]

    #[test]
    fn the_hierarchy_and_brute_force_give_the_same_bits(scene in scene()) {
        let prepared = staged(scene, 40, 30);
        prop_assert!(traced(&prepared, prepared.needs(), BruteForce) == traced(&prepared, prepared.needs(), Bvh));
        prop_assert!(cast(&prepared, prepared.needs(), BruteForce) == cast(&prepared, prepared.needs(), Bvh));
    }

    #[test]
    fn leaving_out_what_is_not_needed_never_changes_a_pixel(scene in scene(), plain in 0_u32..16) {
        // Often without one kind of surface or another, so that much is left out
        let mut scene = scene;
        for material in &mut scene.materials {
            if plain & 1 != 0 { material.reflection = Rgb::BLACK }
            if plain & 2 != 0 { material.transmission = Rgb::BLACK }
            if plain & 4 != 0 { material.specular = Rgb::BLACK }
            if plain & 8 != 0 { material.texture = None }
        }
        let prepared = staged(scene, 40, 30);
        let everything = Needs::of(&prepared.scene).with_forced(Parts::ALL);
        prop_assert!(traced(&prepared, prepared.needs(), Bvh) == traced(&prepared, &everything, Bvh));
        prop_assert!(cast(&prepared, prepared.needs(), Bvh) == cast(&prepared, &everything, Bvh));
    }

    #[test]
    fn a_second_renderer_draws_the_same(scene in scene(), depth in 1_u32..5) {
        let mut scene = scene;
        scene.materials.iter_mut().for_each(|material| material.texture = None);
        let size = [40, 30];
        let prepared = staged(scene, size[0], size[1]).with_settings(settings(depth, 1));
        let frame = picture(&prepared);
        let off = (0..size[1])
            .flat_map(|y| (0..size[0]).map(move |x| (x, y)))
            .filter(|&(x, y)| {
                let expected = reference::pixel(&prepared.scene, size, depth, (x, y));
                let difference = frame.pixel(x, y) - expected;
                let enclosure = 1e-6 * (1.0 + expected.max_channel());
                // A difference that is not a number is one too.
                let within = |d: &f64| d.abs() <= enclosure;
                !difference.channels().iter().all(within)
            })
            .count();
        // A ray that grazes an edge may fall on either side: 5 of 65 536 is one of 13 107.
        prop_assert!(off <= 1, "{off} pixels off");
    }

    #[test]
    fn the_unit_of_length_does_not_matter(mut scene in scene(), exponent in -40_i32..40) {
        scene.materials.iter_mut().for_each(|material| material.texture = None);
        scene.path_attenuation = [1.0, 0.0, 0.0];
        for light in &mut scene.lights {
            if let Light::Point { attenuation, .. } = light {
                *attenuation = [1.0, 0.0, 0.0];
            }
        }
        let other = scaled(&scene, 2.0_f64.powi(exponent));
        let [one, other] = [scene, other].map(|scene| picture(&staged(scene, 32, 24)).color);
        prop_assert!(one == other);
    }

    #[test]
    fn far_from_the_origin_the_picture_stays(mut scene in scene()) {
        scene.materials.iter_mut().for_each(|material| material.texture = None);
        // One below 1 makes light of nothing, and of a rounding as much as one likes.
        scene.path_attenuation = [1.0, 0.0, 0.0];
        let near = picture(&staged(scene.clone(), 32, 24));
        let by = DVec3::new(1e7, -1e7, 1e7);
        if let Some(camera) = &mut scene.camera {
            camera.eye += by;
            camera.target += by;
        }
        for object in &mut scene.objects {
            match &mut object.shape {
                Shape::Sphere { center, .. } => *center += by,
                Shape::Plane { point, .. } => *point += by,
                Shape::Polygon { vertices } => vertices.iter_mut().for_each(|v| *v += by),
                _ => {}
            }
        }
        for light in &mut scene.lights {
            if let Light::Point { position, .. } = light {
                *position += by;
            }
        }
        let far = picture(&staged(scene, 32, 24));
        prop_assert!(far.color.iter().all(|color| color.channels().iter().all(|c| c.is_finite())));
        // Places are known to 2e-9 there; a path that meets several curved surfaces makes more of it, and an edge may move over a pixel's centre.
        let off = std::iter::zip(&near.color, &far.color)
            .filter(|(a, b)| (**a - **b).channels().iter().any(|d| d.abs() > 1e-4))
            .count();
        prop_assert!(off <= 3, "{off} pixels off");
    }
}

#[test]
fn a_mesh_of_glass_is_the_same_by_hierarchy() {
    let glass = TEAPOT.replace(
        "\"specular\": 0.5,",
        "\"specular\": 0.5, \"transmission\": 0.8, \"reflection\": 0.1, \"ior\": 1.4,",
    );
    let prepared = prepared(&glass, 60, 45);
    assert!(prepared.needs().transmission);
    assert!(traced(&prepared, prepared.needs(), BruteForce) == picture(&prepared));
    assert!(
        cast(&prepared, prepared.needs(), BruteForce) == cast(&prepared, prepared.needs(), Bvh)
    );
}

#[test]
fn samples_are_averaged() {
    // Lit from 0.4 of the half width on: one of two columns of samples, one of four, two of eight
    let json = r#"{ "schema": 1, "camera": { "eye": [0, 0, 0], "target": [0, 0, 1], "up": [0, 1, 0], "fov_x_degrees": 90 },
      "materials": { "lit": { "emission": [1, 1, 1] } },
      "objects": [ { "name": "edge", "material": "lit", "polygon": { "vertices": [[0.4, -9, 1], [0.4, 9, 1], [9, 9, 1], [9, -9, 1]] } } ] }"#;
    for (samples, expected) in [(1, 0.0), (2, 0.5), (4, 0.25), (8, 0.25)] {
        let prepared = prepared(json, 1, 1).with_settings(settings(5, samples));
        assert_eq!(
            picture(&prepared).pixel(0, 0),
            Rgb::splat(expected),
            "{samples}"
        );
    }
}

/// Glass balls that reflect and transmit: two rays at every hit.
const TREE: &str = r#"{ "schema": 1, "background": [0.2, 0.3, 0.5],
  "camera": { "eye": [0, 0, -4], "target": [0.1, 0.07, 0], "up": [0, 1, 0], "fov_x_degrees": 30 },
  "materials": { "glass": { "ambient": [0.01, 0.01, 0.01], "reflection": 0.4, "transmission": 0.6, "ior": 1.5 } },
  "objects": [
    { "name": "a", "material": "glass", "sphere": { "center": [0, 0, 0], "radius": 1 } },
    { "name": "room", "material": "glass", "sphere": { "center": [0, 0, 0], "radius": 20 } } ] }"#;

#[test]
fn depth_64_stays_far_from_the_end_of_the_stack() {
    // A closed room of mirrors, and a stack of an eighth of what the program's threads have
    let json = r#"{ "schema": 1, "camera": { "eye": [0, 0, 0], "target": [0.3, 0.2, 1], "up": [0, 1, 0], "fov_x_degrees": 60 },
      "materials": { "mirror": { "emission": [0.01, 0.01, 0.01], "reflection": 0.98 } },
      "objects": [ { "name": "room", "material": "mirror", "sphere": { "center": [0.1, 0, 0], "radius": 3 } } ] }"#;
    let run = || {
        let prepared = prepared(json, 4, 4).with_settings(settings(64, 1));
        let frame = picture(&prepared);
        let mut recorded = blank(&prepared);
        let mut recording = Recording::new(RecordingLimit::default());
        let tracer = RayTracer::new(&prepared, prepared.needs(), BruteForce);
        ray_tracing(&tracer, Focus::Frame, &mut recorded, &mut recording);
        assert!(frame == recorded && !recording.truncated());
        let series: f64 = (0..64).map(|i| 0.01 * 0.98_f64.powi(i)).sum();
        for color in frame.color {
            assert!((color.r - series).abs() < 1e-12);
        }
    };
    let thread = std::thread::Builder::new().stack_size(256 << 10).spawn(run);
    assert!(thread.expect("a thread").join().is_ok());
}

#[test]
fn a_tree_of_a_million_rays_is_recorded_within_its_limit() {
    let prepared = prepared(TREE, 9, 9).with_settings(settings(28, 1));
    let focus = Focus::Pixel { x: 4, y: 4 };
    let tracer = RayTracer::new(&prepared, prepared.needs(), BruteForce);
    let mut expected = blank(&prepared);
    let mut rays = Rays(0);
    ray_tracing(&tracer, focus, &mut expected, &mut rays);
    assert!(rays.0 > 1_000_000, "{} rays", rays.0);

    let limit = RecordingLimit(64 << 20);
    let mut recording = Recording::new(limit);
    let mut frame = blank(&prepared);
    ray_tracing(&tracer, focus, &mut frame, &mut recording);
    assert!(frame == expected);
    assert!(recording.truncated() && recording.len() * 64 <= 64 << 20);
}

/// Counts the rays of a tree.
struct Rays(usize);

impl lightwalk::record::Recorder<lightwalk::algorithms::ray_tracing::Event> for Rays {
    fn step(&mut self, _: impl FnOnce() -> lightwalk::algorithms::ray_tracing::Event) {}
    fn enter(&mut self, event: impl FnOnce() -> lightwalk::algorithms::ray_tracing::Event) {
        self.0 += usize::from(lightwalk::record::Event::kind(&event()) == "Ray");
    }
    fn leave(&mut self, _: impl FnOnce() -> lightwalk::algorithms::ray_tracing::Event) {}
}

#[test]
fn light_without_bounds_stays_a_number() {
    let prepared = prepared(
        &TREE
            .replace("\"reflection\": 0.4", "\"reflection\": [1e300, 0, 1e-300]")
            .replace("[0.2, 0.3, 0.5]", "[1e300, 1e300, 1e300]"),
        8,
        8,
    )
    .with_settings(settings(8, 1));
    for color in picture(&prepared).color {
        assert!(color.channels().iter().all(|c| c.is_finite()), "{color:?}");
    }
}
