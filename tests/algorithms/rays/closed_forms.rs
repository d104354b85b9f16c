//! Light whose amount is known from a formula.

use super::{picture, settings};
use crate::common::{prepared, setup};
use lightwalk::algorithms::prepared_scene::PreparedScene;
use lightwalk::color::Rgb;
use lightwalk::methods::{Settings, Setup};
use lightwalk::scene::View;

/// One pixel, looking along +z from the origin.
fn look(objects: &str, materials: &str, more: &str, depth: u32) -> Rgb {
    let json = format!(
        r#"{{ "schema": 1, {more} "camera": {{ "eye": [0, 0, 0], "target": [0, 0, 1], "up": [0, 1, 0], "fov_x_degrees": 1 }},
             "materials": {{ {materials} }}, "objects": [ {objects} ] }}"#
    );
    let setup = Setup::new(prepared(&json, 1, 1), settings(depth, 1));
    picture(&setup).pixel(0, 0)
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
    let without = picture(&setup(&json(wall), 64, 48));
    let with = picture(&setup(&json(&format!("{wall}{ball}")), 64, 48));
    let differing = std::iter::zip(&without.color, &with.color)
        .filter(|(a, b)| (**a - **b).channels().iter().any(|d| d.abs() > 1e-12))
        .count();
    assert_eq!(differing, 0);
}

#[test]
fn a_slab_of_glass_shifts_a_ray_sideways() {
    // Through a slab of thickness 1 at 45°, η = 1.5, the ray goes on 0.3291423081773203 beside its line: it meets the wall where a
    // parallel ray that starts so much aside would. The edge of the wall finds the place to 1e-9.
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
        picture(&Setup::new(
            PreparedScene::new(scene, view),
            Settings::default(),
        ))
        .pixel(0, 0)
    };
    // Without the slab the ray meets y = z = 4. A shift of s across the ray is s·√2 along y.
    let met = 4.0 - shift * std::f64::consts::SQRT_2;
    assert_eq!(color(met - 1e-9), Rgb::WHITE);
    assert_eq!(color(met + 1e-9), Rgb::BLACK);
}

#[test]
fn the_critical_angle_is_kept_to_1e_12() {
    // From inside a rod of glass, whose end is met at the critical angle 41.81…° ± 1e-12 rad.
    let critical = (1.0_f64 / 1.5).asin();
    for (angle, passes) in [(critical - 1e-12, true), (critical + 1e-12, false)] {
        let (sin, cos) = angle.sin_cos();
        let json = format!(
            r#"{{ "schema": 1, "background": [0, 1, 0], "camera": {{ "eye": [0, 0, 0], "target": [{sin:?}, 0, {cos:?}], "up": [0, 1, 0], "fov_x_degrees": 1e-9 }},
                 "materials": {{ "glass": {{ "transmission": 1, "ior": 1.5 }}, "lit": {{ "emission": [1, 0, 0] }} }},
                 "objects": [ {{ "name": "rod", "material": "glass", "cylinder": {{ "base": [0, 0, -5], "axis": [0, 0, 1], "radius": 10, "height": 6 }} }},
                              {{ "name": "near", "material": "lit", "plane": {{ "point": [0, 0, -1], "normal": [0, 0, 1] }} }} ] }}"#
        );
        let color = picture(&setup(&json, 1, 1)).pixel(0, 0);
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
    let sum = |h: f64| picture(&setup(&json(h), 1, 1)).pixel(0, 0).r;
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
    let color = picture(&Setup::new(prepared(json, 1, 1), settings(8, 1))).pixel(0, 0);
    assert_eq!(color, Rgb::new(1.0, 0.0, 0.0));
    // Lower, it leaves at once.
    let lower = json.replace("0.9]", "0.6]");
    let color = picture(&setup(&lower, 1, 1)).pixel(0, 0);
    assert_eq!(color, Rgb::new(0.125, 1.0, 0.0));
}

#[test]
fn samples_are_averaged() {
    // Lit from 0.4 of the half width on: one of two columns of samples, one of four, two of eight
    let json = r#"{ "schema": 1, "camera": { "eye": [0, 0, 0], "target": [0, 0, 1], "up": [0, 1, 0], "fov_x_degrees": 90 },
      "materials": { "lit": { "emission": [1, 1, 1] } },
      "objects": [ { "name": "edge", "material": "lit", "polygon": { "vertices": [[0.4, -9, 1], [0.4, 9, 1], [9, 9, 1], [9, -9, 1]] } } ] }"#;
    for (samples, expected) in [(1, 0.0), (2, 0.5), (4, 0.25), (8, 0.25)] {
        let setup = Setup::new(prepared(json, 1, 1), settings(5, samples));
        assert_eq!(
            picture(&setup).pixel(0, 0),
            Rgb::splat(expected),
            "{samples}"
        );
    }
}
