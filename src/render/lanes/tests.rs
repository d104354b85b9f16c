use super::*;
use crate::render::render;
use crate::scene::{self, Limits, View};
use std::f64::consts::TAU;
use std::num::NonZeroUsize;

/// A torus of 2·`along`·`across` triangles, as a Wavefront OBJ file.
fn torus(along: u32, across: u32) -> String {
    let mut text = String::new();
    for (i, j) in (0..along).flat_map(|i| (0..across).map(move |j| (i, j))) {
        let (sin_i, cos_i) = (TAU * f64::from(i) / f64::from(along)).sin_cos();
        let (sin_j, cos_j) = (TAU * f64::from(j) / f64::from(across)).sin_cos();
        let from_axis = 1.0 + 0.45 * cos_j;
        text += &format!(
            "v {} {} {}\n",
            from_axis * cos_i,
            from_axis * sin_i,
            0.45 * sin_j
        );
    }
    let at = |i: u32, j: u32| (i % along) * across + j % across + 1;
    for (i, j) in (0..along).flat_map(|i| (0..across).map(move |j| (i, j))) {
        let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
        text += &format!("f {a} {b} {c}\nf {a} {c} {d}\n");
    }
    text
}

/// The torus under two lights, before a floor that reaches behind the eye.
fn prepared(material: &str, light: &str) -> PreparedScene {
    let json = format!(
        r#"{{ "schema": 1, "background": [0.1, 0.2, 0.3],
        "camera": {{ "eye": [0.6, -2.2, 2.4], "target": [0, 0, 0], "up": [0, 0, 1], "fov_x_degrees": 50 }},
        "materials": {{ "clay": {{ "ambient": [0.05, 0.06, 0.07], "diffuse": [0.7, 0.5, 0.3] {material} }} }},
        "objects": [ {{ "name": "torus", "material": "clay", "mesh": {{ "file": "torus.obj" }} }},
            {{ "name": "floor", "material": "clay", "polygon": {{ "vertices": [[-9, -9, -1], [9, -9, -1], [0, 9, -1]] }} }} ],
        "lights": [ {{ "directional": {{ "toward": [0.3, 0.8, -0.6], "color": [1, 0.9, 0.8] }} }}, {light} ] }}"#
    );
    let mut files = |_: &str| Ok(torus(32, 16).into_bytes());
    let scene = scene::read(json.as_bytes(), &Limits::default(), &mut files).unwrap();
    let view = View::new(&scene.camera.unwrap(), 203, 151);
    PreparedScene::new(scene, view)
}

const FAR: &str = r#"{ "directional": { "toward": [-1, 0.1, -0.3], "color": [0.1, 0.2, 0.3] } }"#;
const NEAR: &str = r#"{ "point": { "position": [1, 2, 3] } }"#;

const METHODS: [Method; 4] = [
    Method::Flat,
    Method::Gouraud,
    Method::Phong,
    Method::FastPhong,
];

/// Where depths are equal but for rounding, on the outline between two triangles, either may be drawn.
#[test]
fn lanes_draw_the_textbooks_picture_to_the_digits_of_f32() {
    let prepared = prepared("", FAR);
    for method in METHODS {
        let textbook = render(&prepared, method, NonZeroUsize::MIN, &|_, _| {});
        let mut lanes = LaneFrame::new(203, 151);
        LanePainter::new(&prepared, method)
            .unwrap()
            .draw(&mut lanes);
        let mut drawn = 0;
        let mut largest = 0_f64;
        for (x, y) in (0..151).flat_map(|y| (0..203).map(move |x| (x, y))) {
            let exact = textbook.pixel(x, y);
            for (found, exact) in lanes.pixel(x, y).into_iter().zip(exact.channels()) {
                largest = largest.max((f64::from(found) - exact).abs());
            }
            drawn += u32::from(exact != prepared.scene.background);
        }
        assert!(drawn > 15_000);
        assert!(largest < 2e-6, "{}: {largest:e}", method.name());
    }
}

#[test]
fn what_lanes_do_not_know_is_refused() {
    for (material, light) in [
        (r#", "specular": 0.5"#, FAR),
        ("", NEAR),
        (
            r#", "texture": { "checker": { "colors": [[1, 1, 1], [0, 0, 0]], "scale": 1 } }"#,
            FAR,
        ),
    ] {
        assert!(LanePainter::new(&prepared(material, light), Method::Phong).is_none());
    }
    assert!(LanePainter::new(&prepared("", FAR), Method::RayCasting).is_none());
}
