//! Where things get extreme: slivers, edges that hit centres of pixels, polygons edge-on or far larger than the screen, normals
//! that cancel out, lights in the surface, and a million triangles.

use super::{
    CHALK, CLAY, FAMILY, LAMP, SIZE, SUN, apart, assert_as_rays, difference, picture, polygon,
    scene,
};
use crate::common::prepared;
use lightwalk::algorithms::focus::Focus;
use lightwalk::algorithms::prepared_scene::PreparedScene;
use lightwalk::color::Rgb;
use lightwalk::methods::{Settings, Setup};
use lightwalk::record::{RecordingLimit, Value};
use lightwalk::render::Method;
use lightwalk::replay::Run;
use lightwalk::scene::{self, Limits, View};
use std::fmt::Write;
use std::sync::Arc;
use std::time::Instant;

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
        let prepared = prepared(&json, SIZE, SIZE);
        let rays = picture(&prepared, Method::RayCasting);
        let phong = picture(&prepared, Method::Phong);
        let (largest, drawn) = difference(&prepared, &phong, &rays);
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
        let prepared = prepared(&json, SIZE, SIZE);
        for method in FAMILY {
            let picture = picture(&prepared, method);
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
    let prepared = prepared(&scene(CHALK, &[polygon(&upright)], inside), SIZE, SIZE);
    let ambient = Rgb::new(0.05, 0.06, 0.07);
    for method in FAMILY {
        let picture = picture(&prepared, method);
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
    let phong = picture(&prepared(&json, SIZE, SIZE), Method::Phong);
    let at = |x, y| phong.pixel(x, y);
    assert!(apart(at(12, 11), at(13, 11)) > 0.29, "no highlight");
    assert!(apart(at(13, 11), at(14, 11)) < 0.01, "too wide");
}

/// A mesh file beside a scene that shows it as object 0.
fn mesh_stage(obj: &str, material: &str, light: &str, width: u32, height: u32) -> PreparedScene {
    let json = scene(
        material,
        &[r#""mesh": { "file": "m.obj" }"#.to_string()],
        light,
    );
    let mut read = |_: &str| Ok(obj.as_bytes().to_vec());
    let scene = scene::read(json.as_bytes(), &Limits::default(), &mut read).expect("a scene");
    let view = View::new(&scene.camera.expect("a camera"), width, height);
    PreparedScene::new(scene, view)
}

#[test]
fn where_opposite_normals_cancel_out_the_face_stands_in() {
    // Two faces that look back turn the normal of each lower corner round: half-way up the interpolated normal is zero.
    let obj = "v -6 6.5 0\nv -6 -5.5 0\nv 6 -5.5 0\nv 6 6.5 0\nv 0 -7 0\nv 0 -8 0\nv 0 -9 0\n\
               f 1 2 3 4\nf 2 3 5\nf 2 3 6\nf 2 3 7\n";
    let prepared = mesh_stage(obj, CLAY, SUN, SIZE, SIZE);
    let setup = Setup::new(prepared.clone(), Settings::default());
    let run = Run::record(
        Arc::new(setup),
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
        picture(&prepared, Method::Flat),
        picture(&prepared, Method::Phong),
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
    let prepared = mesh_stage(&obj, CHALK, SUN, 240, 240);
    assert!(prepared.tessellation.polygon_count() > 1_000_000);
    let start = Instant::now();
    let phong = picture(&prepared, Method::Phong);
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
