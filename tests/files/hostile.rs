//! Scenes changed at random, small but hostile: coinciding corners, needles, numbers at the ends of f64, objects given twice. Each is
//! refused, or every method draws it: no panic, no number that is not finite, and an end within ten seconds.
//!
//! A case is its seed; a failure names it and shows the scene.

use lightwalk::algorithms::prepared_scene::PreparedScene;
use lightwalk::methods::{Method, Settings, Setup};
use lightwalk::numeric::Random;
use lightwalk::render::render;
use lightwalk::scene::patches::Patches;
use lightwalk::scene::{self, Limits, Scene, View};
use serde_json::{Value, json};
use std::num::NonZeroUsize;
use std::ops::Range;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::{Duration, Instant};

const LONGEST: Duration = Duration::from_secs(10);

/// More patches than this are not solved for: their time is no longer that of a small file.
const MOST_PATCHES: u64 = 60;

const LIMITS: Limits = Limits {
    max_patches: 1000,
    max_triangles: 20_000,
};

/// A room with one of every shape, which gives off light, mirrors and lets it through.
fn original() -> Value {
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

/// One of `count`.
fn pick(random: &mut Random, count: usize) -> usize {
    (random.bits() % count as u64) as usize
}

/// Every number of a document, by its path.
fn numbers(value: &Value, path: &str, found: &mut Vec<String>) {
    match value {
        Value::Number(_) => found.push(path.to_owned()),
        Value::Array(items) => {
            (0..items.len()).for_each(|i| numbers(&items[i], &format!("{path}/{i}"), found))
        }
        Value::Object(map) => map
            .iter()
            .for_each(|(key, item)| numbers(item, &format!("{path}/{key}"), found)),
        _ => {}
    }
}

fn changed_number(random: &mut Random, old: f64, other: f64) -> f64 {
    const ENDS: [f64; 14] = [
        0.0, -0.0, 1.0, -1.0, 1e-44, 1e-8, -1e-8, 1e-300, 1e8, -1e8, 1e15, 1e150, 1e300, 0.5,
    ];
    match pick(random, 8) {
        0 | 1 => ENDS[pick(random, ENDS.len())],
        2 | 3 => other,
        4 => old * (1.0 + 1e-8 * random.number()),
        5 => old + 1e-15 * random.number(),
        6 => old * 10_f64.powf(8.0 * random.number()),
        _ => old + random.number(),
    }
}

fn mutate(scene: &mut Value, random: &mut Random) {
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
            _ => {
                let mut paths = Vec::new();
                numbers(scene, "", &mut paths);
                let [at, other] = [0; 2].map(|_| paths[pick(random, paths.len())].clone());
                let value = |path: &str| scene.pointer(path).and_then(Value::as_f64).unwrap_or(0.0);
                let new = changed_number(random, value(&at), value(&other));
                if let Some(number) = scene.pointer_mut(&at) {
                    *number = json!(new);
                }
            }
        }
    }
}

/// Draws a scene by every method. What is wrong with the pictures, if anything.
fn draw(scene: Scene) -> Result<(), String> {
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
        let start = Instant::now();
        let frame = render(&setup, method, NonZeroUsize::MIN, &|_, _| {});
        let name = method.name();
        if !frame
            .color
            .iter()
            .all(|color| color.channels().iter().all(|c| c.is_finite()))
        {
            return Err(format!("{name}: a colour that is not finite"));
        }
        if start.elapsed() > LONGEST {
            return Err(format!("{name}: {:?}", start.elapsed()));
        }
    }
    Ok(())
}

/// How many of the cases are drawn; the others are refused.
fn run(seeds: Range<u64>) -> usize {
    let mut drawn = 0;
    for seed in seeds {
        let mut document = original();
        mutate(&mut document, &mut Random(seed));
        let text = document.to_string();
        let outcome = catch_unwind(AssertUnwindSafe(|| {
            let read = scene::read(text.as_bytes(), &LIMITS, &mut |_| Err("no file".into()));
            read.ok().map(draw)
        }));
        match outcome {
            Ok(None) => {}
            Ok(Some(Ok(()))) => drawn += 1,
            Ok(Some(Err(what))) => panic!("seed {seed}: {what}\n{text}"),
            Err(_) => panic!("seed {seed} panics\n{text}"),
        }
    }
    drawn
}

#[test]
fn the_scene_from_which_they_come_is_right() {
    let text = original().to_string();
    let read = scene::read(text.as_bytes(), &LIMITS, &mut |_| Err("no file".into()));
    let scene = read.unwrap_or_else(|error| panic!("{error}"));
    draw(scene).expect("it can be drawn");
}

#[test]
fn a_hostile_scene_is_refused_or_drawn_by_every_method() {
    assert!(run(0..20_000) > 7_000);
}

/// By hand: `cargo test --release --test files hostile -- --ignored`.
#[test]
#[ignore = "takes hours"]
fn many_hostile_scenes_are_refused_or_drawn() {
    assert!(run(1_000_000..2_000_000) > 100_000);
}
