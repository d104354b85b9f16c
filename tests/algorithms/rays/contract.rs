//! The words of the contract where rounding could speak against them.

use super::{blank, settings};
use crate::common::prepared;
use lightwalk::algorithms::focus::Focus;
use lightwalk::algorithms::frame::Frame;
use lightwalk::algorithms::ray_tracing::{RayTracer, ray_tracing};
use lightwalk::algorithms::visible::{BruteForce, Bvh, Search};
use lightwalk::color::Rgb;
use lightwalk::methods::Setup;
use lightwalk::record::Unrecorded;

const SIZE: u32 = 48;

/// A look from above and aside at a scene whose objects have the materials "lower" (gives off red), "upper" (gives off green) and
/// "chalk".
fn traced(objects: &str, light: &str, search: impl Search) -> Frame {
    let json = format!(
        r#"{{ "schema": 1,
             "camera": {{ "eye": [0.1, 1.5, -6], "target": [0, 0.7, 0], "up": [0, 1, 0], "fov_x_degrees": 42 }},
             "materials": {{ "lower": {{ "emission": [1, 0, 0] }}, "upper": {{ "emission": [0, 1, 0] }}, "chalk": {{ "diffuse": [1, 1, 1] }} }},
             "objects": [ {objects} ], "lights": [ {light} ] }}"#
    );
    let setup = Setup::new(prepared(&json, SIZE, SIZE), settings(5, 1));
    let mut frame = blank(&setup);
    let tracer = RayTracer::new(&setup.prepared, setup.settings.get(), setup.needs(), search);
    ray_tracing(&tracer, Focus::Frame, &mut frame, &mut Unrecorded);
    frame
}

fn pixels(frame: &Frame) -> impl Iterator<Item = Rgb> {
    (0..SIZE * SIZE).map(|pixel| frame.pixel(pixel % SIZE, pixel / SIZE))
}

#[test]
fn of_objects_in_one_plane_across_an_axis_the_lower_is_seen() {
    let wide = r#""polygon": { "vertices": [[-30, -20, 0.1], [31, -20, 0.1], [29, 50, 0.1], [-33, 47, 0.1]] }"#;
    let narrow = r#""polygon": { "vertices": [[-1, 0, 0.1], [-1, 1.7, 0.1], [0.9, 1.9, 0.1], [1.3, 1, 0.1], [1.1, 0.2, 0.1]] }"#;
    let plane = r#""plane": { "point": [5, 7, 0.1], "normal": [0, 0, -1] }"#;
    let far = r#""sphere": { "center": [900, 800, 3000], "radius": 1 }"#;
    for (lower, upper) in [
        (wide, narrow),
        (wide, plane),
        (plane, narrow),
        (plane, wide),
    ] {
        let objects = format!(
            r#"{{ "name": "lower", "material": "lower", {lower} }}, {{ "name": "upper", "material": "upper", {upper} }},
               {{ "name": "far", "material": "chalk", {far} }}"#
        );
        for frame in [traced(&objects, "", Bvh), traced(&objects, "", BruteForce)] {
            assert!(
                pixels(&frame).all(|color| color == Rgb::new(1.0, 0.0, 0.0)),
                "{lower} {upper}"
            );
        }
    }
}

#[test]
fn an_object_at_the_light_does_not_stand_before_it() {
    let ball = r#"{ "name": "ball", "material": "chalk", "sphere": { "center": [-0.4, 0.9, 0.5], "radius": 0.8 } }"#;
    for shade in [
        r#""plane": { "point": [0, 2, 0], "normal": [0, 1, 0] }"#,
        r#""polygon": { "vertices": [[-1, 2, -1], [1, 2, -1], [1, 2, 1], [-1, 2, 1]] }"#,
        r#""sphere": { "center": [0.1, 2.3, -0.1], "radius": 0.3 }"#,
    ] {
        let light = r#"{ "point": { "position": [0.1, 2, -0.1] } }"#;
        let open = format!(
            r#"{ball}, {{ "name": "shade", "material": "lower", "casts_shadow": false, {shade} }}"#
        );
        let shaded = format!(r#"{ball}, {{ "name": "shade", "material": "lower", {shade} }}"#);
        let expected = traced(&open, light, Bvh);
        for frame in [
            traced(&shaded, light, Bvh),
            traced(&shaded, light, BruteForce),
        ] {
            assert!(pixels(&frame).eq(pixels(&expected)), "{shade}");
        }
    }
}
