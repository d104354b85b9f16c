//! Scenes at random: a second renderer draws the same, and so does the first one by hierarchy or by brute force, with or without
//! what the scene does not need, in other units and far from the origin.

use super::scenes::scene;
use super::{cast, picture, reference, settings, traced};
use glam::DVec3;
use lightwalk::algorithms::prepared_scene::PreparedScene;
use lightwalk::algorithms::visible::{BruteForce, Bvh};
use lightwalk::color::Rgb;
use lightwalk::methods::{Settings, Setup};
use lightwalk::scene::{Light, Needs, Parts, Scene, Shape, View};
use proptest::prelude::*;

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

fn staged(scene: Scene, width: u32, height: u32) -> Setup {
    let view = View::new(&scene.camera.expect("a camera"), width, height);
    Setup::new(PreparedScene::new(scene, view), Settings::default())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(96))]

    #[test]
    fn the_hierarchy_and_brute_force_give_the_same_bits(scene in scene()) {
        let setup = staged(scene, 40, 30);
        prop_assert!(traced(&setup, setup.needs(), BruteForce) == traced(&setup, setup.needs(), Bvh));
        prop_assert!(cast(&setup, setup.needs(), BruteForce) == cast(&setup, setup.needs(), Bvh));
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
        let setup = staged(scene, 40, 30);
        let everything = Needs::of(&setup.prepared.scene).with_forced(Parts::ALL);
        prop_assert!(traced(&setup, setup.needs(), Bvh) == traced(&setup, &everything, Bvh));
        prop_assert!(cast(&setup, setup.needs(), Bvh) == cast(&setup, &everything, Bvh));
    }

    #[test]
    fn a_second_renderer_draws_the_same(scene in scene(), depth in 1_u32..5) {
        let mut scene = scene;
        scene.materials.iter_mut().for_each(|material| material.texture = None);
        let size = [40, 30];
        let setup = Setup::new(staged(scene, size[0], size[1]).prepared, settings(depth, 1));
        let frame = picture(&setup);
        let off = (0..size[1])
            .flat_map(|y| (0..size[0]).map(move |x| (x, y)))
            .filter(|&(x, y)| {
                let expected = reference::pixel(&setup.prepared.scene, size, depth, (x, y));
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
