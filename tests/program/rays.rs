//! The commands that follow rays.

use crate::{lightwalk, refused, succeeded, text};
use serde_json::Value;
use std::fs;

/// A glass ball and a red one on a floor, under a lamp that can be seen and one that cannot.
const SCENE: &str = r#"{ "schema": 1, "background": [0.5, 0.7, 0.9],
  "camera": { "eye": [0, 1.6, -6], "target": [0, 0.8, 0], "up": [0, 1, 0], "fov_x_degrees": 40 },
  "materials": {
    "floor": { "ambient": [0.1, 0.1, 0.1], "diffuse": [0.7, 0.7, 0.7] },
    "red": { "diffuse": [0.6, 0.1, 0.1], "reflection": 0.15 },
    "glass": { "reflection": 0.1, "transmission": 0.9, "ior": 1.5 } },
  "objects": [
    { "name": "floor", "material": "floor", "plane": { "point": [0, 0, 0], "normal": [0, 1, 0] } },
    { "name": "red ball", "material": "red", "sphere": { "center": [-1.2, 0.8, 0.8], "radius": 0.8 } },
    { "name": "glass ball", "material": "glass", "sphere": { "center": [0.7, 0.7, -0.6], "radius": 0.7 } } ],
  "lights": [
    { "point": { "position": [3, 5, -4], "radius": 0.2 } },
    { "directional": { "toward": [0, 1, 0] } } ] }"#;

fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("scene.json"), SCENE).unwrap();
    folder
}

/// Standard output of a command that must succeed.
fn output(folder: &tempfile::TempDir, arguments: &str) -> String {
    let output = succeeded(folder.path(), arguments);
    let messages = text(&output.stderr);
    // Work that takes longer than a second reports its progress.
    assert!(
        messages.lines().all(|line| line.contains(" %")),
        "{arguments}: {messages}"
    );
    text(&output.stdout)
}

#[test]
fn statistics_count_rays_and_say_what_was_left_out() {
    let folder = folder();
    let stats = |options: &str| -> Value {
        let render = "render scene.json --out a.pfm --size 48x36 --stats";
        serde_json::from_str(&output(&folder, &format!("{render} {options}"))).unwrap()
    };
    let all = stats("--method ray-tracing");
    assert_eq!(all["rays"]["primary"], 48 * 36);
    for kind in ["shadow", "reflected", "transmitted"] {
        assert!(all["rays"][kind].as_u64().unwrap() > 0, "{kind}: {all}");
    }
    assert_eq!(all["left_out"][0]["what"], "texture_coordinates");
    assert_eq!(all["left_out"][0]["place"], "materials");

    let first = stats("--method ray-tracing --depth 1 --samples 2");
    assert_eq!(first["rays"]["primary"], 4 * 48 * 36);
    assert_eq!(first["rays"]["reflected"], 0);

    let cast = stats("--method ray-casting");
    assert_eq!(cast["rays"]["primary"], 48 * 36);
    assert_eq!(cast["rays"]["shadow"], 0);

    // A scan-line method follows no ray, and says that the infinite floor is not drawn.
    let render = "render scene.json --out a.pfm --size 48x36 --stats --method gouraud";
    let shaded = succeeded(folder.path(), render);
    assert!(text(&shaded.stderr).contains("leaves out the infinite plane \"floor\""));
    let shaded: Value = serde_json::from_str(&text(&shaded.stdout)).unwrap();
    assert_eq!(shaded["rays"]["primary"], 0);
}

#[test]
fn counting_does_not_change_the_picture() {
    let folder = folder();
    let render = "render scene.json --method ray-tracing --size 48x36";
    output(&folder, &format!("{render} --out plain.pfm --threads 1"));
    output(
        &folder,
        &format!("{render} --out counted.pfm --threads 3 --stats"),
    );
    let [plain, counted] =
        ["plain.pfm", "counted.pfm"].map(|name| fs::read(folder.path().join(name)).unwrap());
    assert!(plain == counted);
}

#[test]
fn the_steps_of_a_pixel_are_its_tree() {
    let folder = folder();
    let steps = output(
        &folder,
        "steps scene.json --method ray-tracing --size 64x48 --pixel 21,26",
    );
    let steps: Vec<Value> = steps
        .lines()
        .map(|line| serde_json::from_str(line).unwrap())
        .collect();
    let of_kind = |kind: &str| steps.iter().filter(|step| step["kind"] == kind).count();
    let rays = of_kind("Ray");
    assert!(rays > 3, "{rays} rays");
    assert_eq!(of_kind("Returned"), rays);
    // Every object is tested for every ray.
    assert_eq!(of_kind("ObjectTested"), 3 * rays);
    let pixel = steps
        .iter()
        .find(|step| step["kind"] == "PixelColored")
        .unwrap();
    let root = steps
        .iter()
        .rfind(|step| step["kind"] == "Returned")
        .unwrap();
    assert_eq!(pixel["color"], root["I"]);
    // What was tested on the way is no value of what comes of it.
    for step in steps.iter().filter(|step| step["kind"] == "Found") {
        assert_eq!(
            step["met"] == "object",
            step.get("object").is_some(),
            "{step}"
        );
        assert!(step.get("t").is_none(), "{step}");
    }
    assert!(steps.iter().enumerate().all(|(i, step)| step["step"] == i));
}

#[test]
fn needs_says_what_is_left_out_and_why() {
    let folder = folder();
    let recorded = output(&folder, "needs scene.json");
    for line in [
        "ray-tracing of scene.json",
        "  needed    reflected_rays",
        "  needed    transmitted_rays",
        "  left out  texture_coordinates: materials: no surface has a `texture`",
        "  left out  highlights: materials: no surface has a `specular` other than 0",
        "  needed    light_balls",
        "  left out  path_attenuation: path_attenuation: secondary rays lose nothing on their way: [1, 0, 0]",
    ] {
        assert!(
            recorded.lines().any(|one| one == line),
            "{line} in {recorded}"
        );
    }
    for part in ["highlights ", "path_attenuation ", "all of these "] {
        let measured = |line: &&str| line.starts_with(part) && line.ends_with("bit by bit");
        assert!(
            recorded.lines().any(|line| measured(&line)),
            "{part} in {recorded}"
        );
    }
}

#[test]
fn needs_says_the_same_in_json() {
    let folder = folder();
    let json: Value = serde_json::from_str(&output(&folder, "needs scene.json --json")).unwrap();
    assert_eq!(json["left_out"][0]["what"], "texture_coordinates");
    assert_eq!(json["saved"]["done"][0]["part"], "texture_coordinates");
    assert_eq!(json["saved"]["done"][0]["same_bits"], true);
}

#[test]
fn needs_differ_from_method_to_method() {
    let folder = folder();
    let cast = output(&folder, "needs scene.json --method ray-casting");
    assert!(
        !cast.contains("reflected_rays") && cast.contains("highlights"),
        "{cast}"
    );
    let flat = lightwalk(folder.path(), "needs scene.json --method flat");
    let flat = text(&flat.stdout);
    assert!(
        flat.contains("object \"floor\": an infinite plane has no polygons"),
        "{flat}"
    );
}

#[test]
fn rays_take_what_they_understand_and_refuse_the_rest() {
    let folder = folder();
    for (option, wrong) in [
        ("--depth", ["0", "65", "-1", "many"].as_slice()),
        ("--samples", &["0", "65"]),
    ] {
        for value in wrong {
            let render = "render scene.json --method ray-tracing --out a.png";
            let output = lightwalk(folder.path(), &format!("{render} {option} {value}"));
            let message = refused(&output, option);
            assert!(message.contains(option), "{message}");
            assert!(!folder.path().join("a.png").exists());
        }
    }
    for (focus, said) in [
        (
            "ray-tracing --polygon 0",
            "pixel by pixel; choose --pixel or --scan-line",
        ),
        (
            "ray-casting --pixel 640,0",
            "--pixel 640: there are 640 columns",
        ),
    ] {
        let steps = format!("steps scene.json --method {focus}");
        let message = refused(&lightwalk(folder.path(), &steps), focus);
        assert!(message.contains(said), "{message}");
    }
}
