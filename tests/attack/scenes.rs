//! Scenes changed at random, small but hostile: coinciding corners, needles, numbers at the ends of f64, objects given twice. Each is
//! refused, or every method draws it, without a number that is not finite.

use crate::json::{change, change_number};
use crate::kit::{Driver, Outcome, is_clear, pick};
use lightwalk::algorithms::prepared_scene::PreparedScene;
use lightwalk::methods::{Method, Settings, Setup};
use lightwalk::numeric::Random;
use lightwalk::render::render;
use lightwalk::scene::patches::Patches;
use lightwalk::scene::{self, Limits, Scene, View};
use serde_json::{Value, json};
use std::num::NonZeroUsize;

/// More patches than this are not solved for: their time is no longer that of a small file.
const MOST_PATCHES: u64 = 60;

pub const LIMITS: Limits = Limits {
    max_patches: 1000,
    max_triangles: 20_000,
};

/// A room with one of every shape, which gives off light, mirrors and lets it through.
pub fn original() -> Value {
    json!({ "schema": 1, "background": [0.1, 0.2, 0.3], "ambient": [1, 1, 1],
      "camera": { "eye": [0.4, 1.1, 4], "target": [0.1, 0.5, 0], "up": [0, 1, 0], "fov_x_degrees": 50 },
      "materials": {
        "matt": { "ambient": [0.1, 0.1, 0.1], "diffuse": [0.5, 0.4, 0.3], "reflectance": [0.7, 0.5, 0.2] },
        "glass": { "specular": 0.4, "shininess": 40, "reflection": 0.1, "transmission": 0.8, "ior": 1.5 },
        "lamp": { "diffuse": [0.3, 0.3, 0.3], "emission": [4, 3, 2], "texture": { "checker": { "colors": [[1, 1, 1], [0.2, 0.2, 0.2]], "scale": 0.3 } } } },
      "objects": [
        { "name": "floor", "material": "matt", "polygon": { "vertices": [[-1, 0, -1], [-1, 0, 1], [1, 0, 1], [1, 0, -1]] }, "patches": [2, 2] },
        { "name": "wall", "material": "matt", "polygon": { "vertices": [[-1, 0, -1], [1, 0, -1], [1, 2, -1], [-1, 2, -1]] }, "patches": 2 },
        { "name": "lamp", "material": "lamp", "polygon": { "vertices": [[-0.3, 1.9, -0.3], [0.3, 1.9, -0.3], [0.3, 1.9, 0.3], [-0.3, 1.9, 0.3]] } },
        { "name": "shard", "material": "matt", "polygon": { "vertices": [[0.2, 0.3, 0.1], [0.8, 0.5, 0.2], [0.4, 1.1, 0]] } },
        { "name": "arrow", "material": "glass", "polygon": { "vertices": [[-0.9, 0.1, 0.5], [-0.2, 0.1, 0.5], [-0.6, 0.3, 0.5], [-0.5, 0.9, 0.5], [-0.9, 0.8, 0.5]] } },
        { "name": "ball", "material": "glass", "sphere": { "center": [-0.3, 0.4, 0], "radius": 0.4 }, "patches": [4, 2], "divisions": 4 },
        { "name": "rod", "material": "matt", "cylinder": { "base": [0.5, 0, 0.5], "axis": [0, 1, 0], "radius": 0.1, "height": 0.8 } } ],
      "lights": [
        { "point": { "position": [0.5, 1.8, 2], "color": [1, 1, 1], "attenuation": [1, 0.1, 0], "radius": 0.05 } },
        { "directional": { "toward": [-0.3, -1, -0.4], "color": [0.3, 0.3, 0.3] } } ] })
}

/// Changed in one to five places, mostly so that it stays a scene.
pub fn mutate(scene: &mut Value, random: &mut Random) {
    for _ in 0..=pick(random, 4) {
        let objects = scene["objects"].as_array().map_or(0, Vec::len);
        match pick(random, 8) {
            // The same object once more, under another name
            0 => {
                let mut copy = scene["objects"][pick(random, objects)].clone();
                copy["name"] = json!(format!("copy {}", random.bits()));
                let materials = ["matt", "glass", "lamp"];
                copy["material"] = json!(materials[pick(random, 3)]);
                scene["objects"].as_array_mut().expect("objects").push(copy);
            }
            // A corner of one polygon on a corner of another, or of itself
            1 | 2 => {
                let corner = |random: &mut Random| {
                    format!(
                        "/objects/{}/polygon/vertices/{}",
                        pick(random, objects),
                        pick(random, 5)
                    )
                };
                let (from, to) = (corner(random), corner(random));
                if let Some(place) = scene.pointer(&from).cloned()
                    && let Some(corner) = scene.pointer_mut(&to)
                {
                    *corner = place;
                }
            }
            3 if objects > 1 => {
                let gone = pick(random, objects);
                scene["objects"]
                    .as_array_mut()
                    .expect("objects")
                    .remove(gone);
            }
            4 => {
                let object = pick(random, objects);
                scene["objects"][object]["normals"] = json!("face");
            }
            _ => change_number(scene, random),
        }
    }
    // Last, as it may be no scene any more
    if pick(random, 12) == 0 {
        change(scene, random);
    }
}

/// Draws a scene by every method. What is wrong with the pictures, if anything.
pub fn draw(scene: Scene) -> Result<(), String> {
    let Some(camera) = scene.camera else {
        return Ok(());
    };
    let few_patches = Patches::of(&scene, MOST_PATCHES).is_ok();
    let setup = Setup::new(
        PreparedScene::new(scene, View::new(&camera, 9, 7)),
        Settings::default(),
    );
    for method in Method::ALL {
        if method == Method::Radiosity && !(few_patches && setup.check_for(method).is_ok()) {
            continue;
        }
        let frame = render(&setup, method, NonZeroUsize::MIN, &|_, _| {});
        let name = method.name();
        if !frame
            .color
            .iter()
            .all(|color| color.channels().iter().all(|c| c.is_finite()))
        {
            return Err(format!("{name}: a colour that is not finite"));
        }
    }
    Ok(())
}

/// A scene as a text.
pub fn hostile(random: &mut Random) -> String {
    let mut document = original();
    mutate(&mut document, random);
    document.to_string()
}

fn attempt(text: &str) -> Result<Outcome, String> {
    match scene::read(text.as_bytes(), &LIMITS, &mut |_| Err("no file".into())) {
        Ok(scene) => draw(scene).map(|()| Outcome::Done),
        Err(error) => is_clear(&error.to_string()).map(|()| Outcome::Refused),
    }
}

#[test]
fn the_scene_from_which_they_come_is_right() {
    let outcome = attempt(&original().to_string());
    assert!(outcome == Ok(Outcome::Done));
}

#[test]
fn a_hostile_scene_is_refused_or_drawn_by_every_method() {
    let driver = Driver {
        kind: "scenes",
        cases: 8_000,
        done_percent: 60,
        make: hostile,
        attempt,
    };
    driver.attack();
}
