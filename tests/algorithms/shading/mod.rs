//! Flat, Gouraud and Phong shading and the exact picture, against each other and against rays.

mod extremes;

use crate::common::{TEAPOT, prepared};
use lightwalk::algorithms::focus::Focus;
use lightwalk::algorithms::frame::Frame;
use lightwalk::algorithms::prepared_scene::PreparedScene;
use lightwalk::algorithms::texture::Mapping;
use lightwalk::color::Rgb;
use lightwalk::methods::{Settings, Setup};
use lightwalk::record::{RecordingLimit, Value};
use lightwalk::render::{Method, render};
use lightwalk::replay::Run;
use std::num::NonZeroUsize;
use std::sync::Arc;

/// Pixels of both sides. The point (x, y, 0) of the world stands at (12 + x, 12 − y) on the screen.
const SIZE: u32 = 24;

const FAMILY: [Method; 4] = [Method::Flat, Method::Gouraud, Method::Phong, Method::Exact];

const LAMP: &str = r#"{ "point": { "position": [3, 4, 5], "attenuation": [0.5, 0.05, 0.01] } }"#;
const SUN: &str = r#"{ "directional": { "toward": [-1, -2, -3] } }"#;

const CLAY: &str = r#""ambient": [0.05, 0.06, 0.07], "diffuse": [0.6, 0.5, 0.4], "specular": 0.3, "shininess": 20"#;
const CHALK: &str = r#""ambient": [0.05, 0.06, 0.07], "diffuse": [0.6, 0.5, 0.4]"#;
const CHECKER: &str =
    r#", "texture": { "checker": { "colors": [[1, 0.9, 0.8], [0.2, 0.3, 0.1]], "scale": 0.13 } }"#;

fn scene(material: &str, shapes: &[String], light: &str) -> String {
    let objects: Vec<String> = shapes
        .iter()
        .enumerate()
        .map(|(i, shape)| format!(r#"{{ "name": "{i}", "material": "m", {shape} }}"#))
        .collect();
    format!(
        r#"{{ "schema": 1, "background": [9, 9, 9],
          "camera": {{ "eye": [0, 0, 12], "target": [0, 0, 0], "up": [0, 1, 0], "fov_x_degrees": 90 }},
          "materials": {{ "m": {{ {material} }} }}, "objects": [{}], "lights": [{light}] }}"#,
        objects.join(", ")
    )
}

fn polygon(vertices: &[[f64; 3]]) -> String {
    format!(r#""polygon": {{ "vertices": {vertices:?} }}"#)
}

fn picture(prepared: &PreparedScene, method: Method) -> Frame {
    drawn(&Setup::new(prepared.clone(), Settings::default()), method)
}

pub fn drawn(setup: &Setup, method: Method) -> Frame {
    render(setup, method, NonZeroUsize::MIN, &|_, _| {})
}

fn apart(a: Rgb, b: Rgb) -> f64 {
    (a - b)
        .channels()
        .map(f64::abs)
        .into_iter()
        .fold(0.0, f64::max)
}

/// The largest difference of two pictures, and how many pixels of the first are drawn.
fn difference(prepared: &PreparedScene, a: &Frame, b: &Frame) -> (f64, usize) {
    let largest = a.color.iter().zip(&b.color).map(|(&a, &b)| apart(a, b));
    let drawn = |color: &&Rgb| **color != prepared.scene.background;
    assert!(
        a.color
            .iter()
            .all(|c| c.channels().iter().all(|v| v.is_finite()))
    );
    (
        largest.fold(0.0, f64::max),
        a.color.iter().filter(drawn).count(),
    )
}

/// On a polygon, which is its own true surface, Phong shading lights what a ray finds. Returns the number of pixels drawn.
fn assert_as_rays(what: &str, json: &str, within: f64) -> usize {
    let prepared = prepared(json, SIZE, SIZE);
    let rays = picture(&prepared, Method::RayCasting);
    let mut count = 0;
    for method in [Method::Phong, Method::Exact] {
        let (largest, drawn) = difference(&prepared, &picture(&prepared, method), &rays);
        assert!(largest <= within, "{what}, {}: {largest:e}", method.name());
        count = drawn;
    }
    count
}

/// In the plane z = x/8 − 3y/4 − 1: farther away at the top.
const TILTED: [[f64; 3]; 4] = [
    [-8.0, -7.0, 3.25],
    [8.0, -6.0, 4.5],
    [10.0, 8.0, -5.75],
    [-9.0, 7.5, -7.75],
];

#[test]
fn on_a_polygon_that_is_lit_evenly_all_of_the_family_agree() {
    // Without a highlight and under the sun the intensity is the same everywhere.
    let prepared = prepared(&scene(CHALK, &[polygon(&TILTED)], SUN), SIZE, SIZE);
    let flat = picture(&prepared, Method::Flat);
    let colors: Vec<Rgb> = flat
        .color
        .iter()
        .copied()
        .filter(|&color| color != prepared.scene.background)
        .collect();
    assert!(colors.len() > 100 && colors.iter().all(|&color| color == colors[0]));
    for method in FAMILY {
        let (largest, _) = difference(&prepared, &picture(&prepared, method), &flat);
        assert!(largest < 1e-14, "{}: {largest:e}", method.name());
    }
}

#[test]
fn phong_lights_a_tilted_polygon_as_a_ray_finds_it() {
    let drawn = assert_as_rays("tilted", &scene(CLAY, &[polygon(&TILTED)], LAMP), 1e-13);
    assert!(drawn > 200);
}

#[test]
fn a_texture_is_where_rays_find_it() {
    let textured = format!("{CHALK}{CHECKER}");
    // Under the sun without a highlight the intensity is even: flat and Gouraud shading show the same.
    let even = prepared(&scene(&textured, &[polygon(&TILTED)], SUN), SIZE, SIZE);
    let rays = picture(&even, Method::RayCasting);
    for method in FAMILY {
        let (largest, drawn) = difference(&even, &picture(&even, method), &rays);
        assert!(
            largest < 1e-14 && drawn > 200,
            "{}: {largest:e}",
            method.name()
        );
    }
    let shiny = format!("{CLAY}{CHECKER}");
    assert_as_rays("textured", &scene(&shiny, &[polygon(&TILTED)], LAMP), 1e-13);
}

#[test]
fn the_plain_texture_is_right_only_where_the_depth_does_not_change() {
    let textured = format!("{CHALK}{CHECKER}");
    let pictures = |vertices: &[[f64; 3]]| {
        let json = scene(&textured, &[polygon(vertices)], SUN);
        let prepared = Arc::new(prepared(&json, SIZE, SIZE));
        let setups = Mapping::ALL.map(|mapping| Setup::new(prepared.clone(), mapping));
        FAMILY.map(|method| {
            let [right, plain] = setups.each_ref().map(|setup| drawn(setup, method));
            let both = right.color.iter().zip(&plain.color);
            both.filter(|&(&a, &b)| apart(a, b) > 1e-12).count()
        })
    };
    let upright = [
        [-9.3, -7.1, 0.0],
        [8.2, -7.1, 0.0],
        [8.2, 8.3, 0.0],
        [-9.3, 8.3, 0.0],
    ];
    assert_eq!(pictures(&upright), [0; 4]);
    assert!(pictures(&TILTED).iter().all(|&wrong| wrong > 40));
}

#[test]
fn both_textures_are_recorded_at_the_pixel() {
    let json = scene(&format!("{CLAY}{CHECKER}"), &[polygon(&TILTED)], LAMP);
    let setup = Arc::new(crate::common::setup(&json, SIZE, SIZE));
    for method in FAMILY {
        let focus = Focus::Pixel { x: 12, y: 9 };
        let run = Run::record(setup.clone(), method, focus, RecordingLimit::default());
        let walk = run.walk();
        let recorded = |kind: &str, name: &str| {
            let step = (0..walk.len()).find(|&step| walk.kind(step) == kind)?;
            walk.own_fields(step).get(name)
        };
        assert_eq!(
            recorded("TextureTaken", "T"),
            recorded("Textured", "texture")
        );
        let Some(Value::Number(v)) = recorded("Textured", "v_texture") else {
            panic!("{}", method.name())
        };
        let Some(Value::Number(plain)) = recorded("TexturedLinearly", "v_linear") else {
            panic!("{}", method.name())
        };
        // The lower half is nearer, and so takes more of the screen: half-way up is not yet the middle of the polygon.
        assert!(v < plain - 0.03, "{v} {plain}");
    }
    let plain = Arc::new(crate::common::setup(TEAPOT, 32, 24));
    for method in FAMILY {
        let run = Run::record(
            plain.clone(),
            method,
            Focus::Frame,
            RecordingLimit::default(),
        );
        let mut kinds = (0..run.walk().len()).map(|step| run.walk().kind(step));
        assert!(
            kinds.all(|kind| !kind.starts_with("Textur")),
            "{}",
            method.name()
        );
    }
}

#[test]
fn the_exact_picture_of_a_sphere_is_what_rays_show_inside_its_polygons() {
    let ball = r#""sphere": { "center": [0.4, -0.3, 0], "radius": 6 }"#.to_string();
    let prepared = prepared(
        &scene(&format!("{CLAY}{CHECKER}"), &[ball], LAMP),
        SIZE,
        SIZE,
    );
    let rays = picture(&prepared, Method::RayCasting);
    let exact = picture(&prepared, Method::Exact);
    let mut seen = 0;
    for (&exact, &rays) in exact.color.iter().zip(&rays.color) {
        if exact != prepared.scene.background {
            assert!(apart(exact, rays) < 1e-12, "{exact:?} for {rays:?}");
            seen += 1;
        }
    }
    assert!(seen > 100);
    // Phong's picture is near, Gouraud's less so, flat shading's least.
    let mean = |method| {
        let picture = picture(&prepared, method);
        let both = picture.color.iter().zip(&exact.color);
        both.map(|(&a, &b)| apart(a, b)).sum::<f64>() / f64::from(seen)
    };
    let [flat, gouraud, phong, _] = FAMILY.map(mean);
    assert!(
        phong < gouraud && gouraud < flat,
        "{phong} {gouraud} {flat}"
    );
}
