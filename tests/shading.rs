//! Flat, Gouraud and Phong shading and the exact picture, against each other and against rays, also where things get extreme.

mod common;

use common::{TEAPOT, stage};
use lightwalk::algorithms::focus::Focus;
use lightwalk::algorithms::frame::Frame;
use lightwalk::algorithms::stage::Stage;
use lightwalk::algorithms::texture::Mapping;
use lightwalk::color::Rgb;
use lightwalk::record::{RecordingLimit, Value};
use lightwalk::render::{Method, render};
use lightwalk::replay::Run;
use lightwalk::scene::{self, Limits, View};
use std::fmt::Write;
use std::num::NonZeroUsize;
use std::sync::Arc;
use std::time::Instant;

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

fn picture(stage: &Stage, method: Method) -> Frame {
    render(stage, method, NonZeroUsize::MIN, &|_, _| {})
}

fn apart(a: Rgb, b: Rgb) -> f64 {
    (a - b)
        .channels()
        .map(f64::abs)
        .into_iter()
        .fold(0.0, f64::max)
}

/// The largest difference of two pictures, and how many pixels of the first are drawn.
fn difference(stage: &Stage, a: &Frame, b: &Frame) -> (f64, usize) {
    let largest = a.color.iter().zip(&b.color).map(|(&a, &b)| apart(a, b));
    let drawn = |color: &&Rgb| **color != stage.scene.background;
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
    let stage = stage(json, SIZE, SIZE);
    let rays = picture(&stage, Method::RayCasting);
    let mut count = 0;
    for method in [Method::Phong, Method::Exact] {
        let (largest, drawn) = difference(&stage, &picture(&stage, method), &rays);
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
    let stage = stage(&scene(CHALK, &[polygon(&TILTED)], SUN), SIZE, SIZE);
    let flat = picture(&stage, Method::Flat);
    let colors: Vec<Rgb> = flat
        .color
        .iter()
        .copied()
        .filter(|&color| color != stage.scene.background)
        .collect();
    assert!(colors.len() > 100 && colors.iter().all(|&color| color == colors[0]));
    for method in FAMILY {
        let (largest, _) = difference(&stage, &picture(&stage, method), &flat);
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
    let even = stage(&scene(&textured, &[polygon(&TILTED)], SUN), SIZE, SIZE);
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
        let right = stage(&json, SIZE, SIZE);
        let plain = stage(&json, SIZE, SIZE).with_mapping(Mapping::Linear);
        FAMILY.map(|method| {
            let [right, plain] = [&right, &plain].map(|stage| picture(stage, method));
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
fn both_textures_are_told_at_the_pixel() {
    let json = scene(&format!("{CLAY}{CHECKER}"), &[polygon(&TILTED)], LAMP);
    let stage = Arc::new(stage(&json, SIZE, SIZE));
    for method in FAMILY {
        let focus = Focus::Pixel { x: 12, y: 9 };
        let run = Run::record(stage.clone(), method, focus, RecordingLimit::default());
        let walk = run.walk();
        let told = |kind: &str, name: &str| {
            let step = (0..walk.len()).find(|&step| walk.kind(step) == kind)?;
            walk.own_fields(step).get(name)
        };
        assert_eq!(told("TextureTaken", "T"), told("Textured", "texture"));
        let Some(Value::Number(v)) = told("Textured", "v_texture") else {
            panic!("{}", method.name())
        };
        let Some(Value::Number(plain)) = told("TexturedLinearly", "v_linear") else {
            panic!("{}", method.name())
        };
        // The lower half is nearer, and so takes more of the screen: half-way up is not yet the middle of the polygon.
        assert!(v < plain - 0.03, "{v} {plain}");
    }
    let plain = Arc::new(self::stage(TEAPOT, 32, 24));
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
    let stage = stage(
        &scene(&format!("{CLAY}{CHECKER}"), &[ball], LAMP),
        SIZE,
        SIZE,
    );
    let rays = picture(&stage, Method::RayCasting);
    let exact = picture(&stage, Method::Exact);
    let mut seen = 0;
    for (&exact, &rays) in exact.color.iter().zip(&rays.color) {
        if exact != stage.scene.background {
            assert!(apart(exact, rays) < 1e-12, "{exact:?} for {rays:?}");
            seen += 1;
        }
    }
    assert!(seen > 100);
    // Phong's picture is near, Gouraud's less so, flat shading's least.
    let mean = |method| {
        let picture = picture(&stage, method);
        let both = picture.color.iter().zip(&exact.color);
        both.map(|(&a, &b)| apart(a, b)).sum::<f64>() / f64::from(seen)
    };
    let [flat, gouraud, phong, _] = FAMILY.map(mean);
    assert!(
        phong < gouraud && gouraud < flat,
        "{phong} {gouraud} {flat}"
    );
}

#[test]
fn horizontal_edges_and_corners_on_centres_of_pixels_are_no_special_case() {
    let rectangle = [
        [-6.2, -5.0, 0.0],
        [5.7, -5.0, 0.0],
        [5.7, 4.0, 0.0],
        [-6.2, 4.0, 0.0],
    ];
    let drawn = assert_as_rays(
        "rectangle",
        &scene(CLAY, &[polygon(&rectangle)], LAMP),
        1e-13,
    );
    assert_eq!(drawn, 12 * 9);
    // Four triangles around the centre of a pixel: no gap and no seam.
    let (hub, rim) = ([0.5, 0.5, 0.0], rectangle);
    let fan: Vec<String> = (0..4)
        .map(|i| polygon(&[hub, rim[i], rim[(i + 1) % 4]]))
        .collect();
    assert_eq!(
        assert_as_rays("fan", &scene(CLAY, &fan, LAMP), 1e-13),
        12 * 9
    );
}

#[test]
fn a_sliver_a_thousandth_of_a_pixel_wide_is_lit_where_it_is() {
    // Upright, and running away from the eye toward the middle of the picture
    for (scale, depth) in [(1.0, 0.0), (1.5, -6.0)] {
        let [left, right] = [0.4995, 0.5005].map(|x| scale * x);
        let sliver = [
            [0.4995, -5.2, 0.0],
            [0.5005, -5.2, 0.0],
            [right, 5.3, depth],
            [left, 5.3, depth],
        ];
        let json = scene(CLAY, &[polygon(&sliver)], LAMP);
        let stage = stage(&json, SIZE, SIZE);
        let rays = picture(&stage, Method::RayCasting);
        let phong = picture(&stage, Method::Phong);
        let (largest, drawn) = difference(&stage, &phong, &rays);
        assert!(drawn > 0 && largest < 1e-11, "{drawn} pixels, {largest:e}");
    }
}

#[test]
fn edge_on_a_polygon_shows_nothing() {
    let edge_on = [
        [0.5, -5.0, 0.0],
        [0.5, 5.0, 0.0],
        [0.5, 5.0, -4.0],
        [0.5, -5.0, -4.0],
    ];
    let plane = edge_on.map(|[_, y, z]| [0.5 * (12.0 - z) / 12.0, y, z]);
    for vertices in [edge_on, plane] {
        let json = scene(CLAY, &[polygon(&vertices)], LAMP);
        let stage = stage(&json, SIZE, SIZE);
        for method in FAMILY {
            let picture = picture(&stage, method);
            assert!(
                picture
                    .color
                    .iter()
                    .all(|c| c.channels().iter().all(|v| v.is_finite()))
            );
        }
    }
}

#[test]
fn a_polygon_a_million_times_as_large_as_the_screen_is_lit_where_it_is() {
    let far = 24e6;
    let vertices = [
        [-far, -far, 0.0],
        [far, -0.7 * far, 0.0],
        [0.9 * far, far, 0.0],
        [-far, 0.8 * far, 0.0],
    ];
    let drawn = assert_as_rays("huge", &scene(CLAY, &[polygon(&vertices)], LAMP), 1e-9);
    assert_eq!(drawn, (SIZE * SIZE) as usize);
    // Reaching behind the eye as well
    let floor = [
        [-far, -3.0, far],
        [far, -3.0, far],
        [far, -3.0, -far],
        [-far, -3.0, -far],
    ];
    assert!(assert_as_rays("floor", &scene(CLAY, &[polygon(&floor)], LAMP), 1e-9) > 200);
}

#[test]
fn a_light_in_the_surface_lights_nothing_of_it_and_breaks_nothing() {
    let upright = [
        [-9.3, -7.1, 0.0],
        [8.2, -7.1, 0.0],
        [8.2, 8.3, 0.0],
        [-9.3, 8.3, 0.0],
    ];
    // At the very point that pixel (12, 11) shows, where L is a rounding error and may point anywhere
    let inside = r#"{ "point": { "position": [0.5, 0.5, 0], "attenuation": [0, 0, 1] } }"#;
    let stage = stage(&scene(CHALK, &[polygon(&upright)], inside), SIZE, SIZE);
    let ambient = Rgb::new(0.05, 0.06, 0.07);
    for method in FAMILY {
        let picture = picture(&stage, method);
        for (x, y) in (4..19).flat_map(|y| (4..19).map(move |x| (x, y))) {
            let color = picture.pixel(x, y);
            assert!(color.channels().iter().all(|v| v.is_finite()));
            let is_lit = apart(color, ambient) > 1e-14;
            assert!(!is_lit || (x, y) == (12, 11), "({x}, {y}): {color:?}");
        }
    }
}

#[test]
fn a_shininess_of_a_million_makes_a_highlight_of_the_size_of_a_pixel() {
    let upright = [
        [-9.3, -7.1, 0.0],
        [8.2, -7.1, 0.0],
        [8.2, 8.3, 0.0],
        [-9.3, 8.3, 0.0],
    ];
    let glossy = CLAY.replace("\"shininess\": 20", "\"shininess\": 1e6");
    // Mirrored in the point (0.5, 0.5) the lamp stands before the eye.
    let above = r#"{ "point": { "position": [1, 1, 12], "attenuation": [1, 0, 0] } }"#;
    let json = scene(&glossy, &[polygon(&upright)], above);
    // Errors of 1e-16 in N·H are a million times as large in its power.
    assert_as_rays("shininess", &json, 1e-9);
    let phong = picture(&stage(&json, SIZE, SIZE), Method::Phong);
    let at = |x, y| phong.pixel(x, y);
    assert!(apart(at(12, 11), at(13, 11)) > 0.29, "no highlight");
    assert!(apart(at(13, 11), at(14, 11)) < 0.01, "too wide");
}

/// A mesh file beside a scene that shows it as object 0.
fn mesh_stage(obj: &str, material: &str, light: &str, width: u32, height: u32) -> Stage {
    let json = scene(
        material,
        &[r#""mesh": { "file": "m.obj" }"#.to_string()],
        light,
    );
    let mut read = |_: &str| Ok(obj.as_bytes().to_vec());
    let scene = scene::read(json.as_bytes(), &Limits::default(), &mut read).expect("a scene");
    let view = View::new(&scene.camera.expect("a camera"), width, height);
    Stage::new(scene, view)
}

#[test]
fn where_opposite_normals_cancel_out_the_face_stands_in() {
    // Two faces that look back turn the normal of each lower corner round: half-way up the interpolated normal is zero.
    let obj = "v -6 6.5 0\nv -6 -5.5 0\nv 6 -5.5 0\nv 6 6.5 0\nv 0 -7 0\nv 0 -8 0\nv 0 -9 0\n\
               f 1 2 3 4\nf 2 3 5\nf 2 3 6\nf 2 3 7\n";
    let stage = Arc::new(mesh_stage(obj, CLAY, SUN, SIZE, SIZE));
    let run = Run::record(
        stage.clone(),
        Method::Phong,
        Focus::Polygon(0),
        RecordingLimit::default(),
    );
    let walk = run.walk();
    let lost = (0..walk.len()).filter(|&step| walk.kind(step) == "PixelNormalLost");
    // Row 11 has its centres at y = 0.5, half-way between −5.5 and 6.5.
    let rows: Vec<Option<Value>> = lost.map(|step| walk.fields(step).get("y")).collect();
    assert_eq!(rows.len(), 12);
    assert!(rows.iter().all(|&y| y == Some(Value::Integer(11))));
    // Under the sun N and −N, turned toward the eye, are lit alike: as flat shading, which sees the face.
    let (flat, phong) = (
        picture(&stage, Method::Flat),
        picture(&stage, Method::Phong),
    );
    for y in [6, 10, 11, 12, 16] {
        let (flat, phong) = (flat.pixel(11, y), phong.pixel(11, y));
        // The highlight depends on the place; the diffuse light does not.
        assert!(apart(flat, phong) < 0.3, "row {y}: {phong:?} for {flat:?}");
    }
}

#[test]
fn a_mesh_of_a_million_triangles_is_drawn_in_reasonable_time() {
    const N: usize = 708;
    let mut obj = String::new();
    let height = |x: f64, y: f64| (0.4 * x).sin() * (0.3 * y).cos();
    for i in 0..=N {
        for j in 0..=N {
            let [x, y] = [j, i].map(|k| 20.0 * (k as f64 / N as f64 - 0.5));
            writeln!(obj, "v {x} {y} {}", height(x, y)).expect("a string");
        }
    }
    for i in 0..N {
        for j in 0..N {
            let at = |i: usize, j: usize| i * (N + 1) + j + 1;
            let (a, b, c, d) = (at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j));
            writeln!(obj, "f {a} {b} {c}\nf {a} {c} {d}").expect("a string");
        }
    }
    let stage = mesh_stage(&obj, CHALK, SUN, 240, 240);
    assert!(stage.tessellation.polygon_count() > 1_000_000);
    let start = Instant::now();
    let phong = picture(&stage, Method::Phong);
    let seconds = start.elapsed().as_secs_f64();
    assert!(seconds < 20.0, "{seconds} s");
    let toward = glam::DVec3::new(1.0, 2.0, 3.0).normalize();
    let mut drawn = 0;
    for (x, y) in (30..210).flat_map(|y| (30..210).map(move |x| (x, y))) {
        // The point under the pixel, by a few steps of substitution
        let [u, v] = [
            (f64::from(x) + 0.5) / 10.0 - 12.0,
            12.0 - (f64::from(y) + 0.5) / 10.0,
        ];
        let mut z = 0.0;
        for _ in 0..60 {
            z = height(u * (12.0 - z) / 12.0, v * (12.0 - z) / 12.0);
        }
        let [px, py] = [u, v].map(|w| w * (12.0 - z) / 12.0);
        let by_x = 0.4 * (0.4 * px).cos() * (0.3 * py).cos();
        let by_y = -0.3 * (0.4 * px).sin() * (0.3 * py).sin();
        let normal = glam::DVec3::new(-by_x, -by_y, 1.0).normalize();
        let expected = 0.05 + 0.6 * normal.dot(toward).max(0.0);
        let found = phong.pixel(x, y).r;
        // Vertex normals of cells of 0.028 are off by their square times a curvature of 0.2.
        assert!(
            (found - expected).abs() < 1e-3,
            "({x}, {y}): {found} for {expected}"
        );
        drawn += 1;
    }
    assert_eq!(drawn, 180 * 180);
}
