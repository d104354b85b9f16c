//! Surfaces that touch: no ray is lost between them, and the list of media is right, in whatever order they stand in the file.

use super::{cast, picture, settings};
use crate::common::setup;
use crate::shading::drawn;
use glam::DVec3;
use lightwalk::algorithms::focus::Focus;
use lightwalk::algorithms::ray_tracing::{Event, RayTracer, ray_tracing};
use lightwalk::algorithms::visible::{BruteForce, Bvh, Search};
use lightwalk::algorithms::{ray_tree, surface};
use lightwalk::color::Rgb;
use lightwalk::methods::{Method, Setup};
use lightwalk::record::{Recording, RecordingLimit};

/// A box between two corners as OBJ, outward.
fn cuboid([x0, y0, z0]: [f64; 3], [x1, y1, z1]: [f64; 3]) -> String {
    let corner = |i: usize| [[x0, x1][i & 1], [y0, y1][i >> 1 & 1], [z0, z1][i >> 2]];
    let vertices: String = (0..8)
        .map(corner)
        .map(|[x, y, z]| format!("v {x:?} {y:?} {z:?}\n"))
        .collect();
    vertices + "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n"
}

/// What a ray from z = 5 along −z meets: object by object, with η_i and η_r where it is refracted.
fn path(objects: &[String], meshes: &[(&str, String)]) -> Vec<(usize, Option<[f64; 2]>)> {
    let json = format!(
        r#"{{ "schema": 1, "background": [0, 0, 1], "camera": {{ "eye": [0.11, 0.07, 5], "target": [0.11, 0.07, 0], "up": [0, 1, 0], "fov_x_degrees": 1 }},
             "materials": {{ "glass": {{ "transmission": 1, "ior": 1.5 }}, "water": {{ "transmission": 1, "ior": 1.33 }}, "wall": {{ "diffuse": [1, 1, 1] }} }},
             "objects": [ {} ] }}"#,
        objects.join(", ")
    );
    let mut read = |name: &str| {
        let mesh = meshes.iter().find(|(file, _)| *file == name);
        Ok(mesh.expect("a mesh").1.clone().into_bytes())
    };
    let scene = lightwalk::scene::read(json.as_bytes(), &Default::default(), &mut read).unwrap();
    let view = lightwalk::scene::View::new(&scene.camera.unwrap(), 1, 1);
    let prepared = lightwalk::algorithms::prepared_scene::PreparedScene::new(scene, view);
    let setup = Setup::new(prepared, settings(12, 1));
    let by_bvh = path_by(Bvh, &setup);
    assert_eq!(path_by(BruteForce, &setup), by_bvh);
    by_bvh
}

fn path_by(search: impl Search, setup: &Setup) -> Vec<(usize, Option<[f64; 2]>)> {
    let mut recording = Recording::new(RecordingLimit::default());
    let tracer = RayTracer::new(&setup.prepared, setup.settings.get(), setup.needs(), search);
    let mut frame = setup.prepared.empty_frame();
    ray_tracing(&tracer, Focus::Frame, &mut frame, &mut recording);
    let mut path = Vec::new();
    for event in recording.events() {
        match *event {
            Event::Surface(surface::Event::SurfaceMet { object, .. }) => {
                path.push((object as usize, None));
            }
            Event::Tree(ray_tree::Event::Refraction { eta_i, eta_r, .. }) => {
                path.last_mut().expect("a surface").1 = Some([eta_i, eta_r]);
            }
            _ => {}
        }
    }
    path
}

fn object(name: &str, material: &str, shape: &str) -> String {
    format!(r#"{{ "name": "{name}", "material": "{material}", {shape} }}"#)
}

fn mesh(name: &str, material: &str) -> String {
    let file = format!(r#""mesh": {{ "file": "{name}.obj" }}"#);
    object(name, material, &file)
}

const WALL: &str = r#""plane": { "point": [0, 0, -3], "normal": [0, 0, 1] }"#;

const WATER: [f64; 2] = [1.0, 1.33];
const GLASS: [f64; 2] = [1.0, 1.5];

fn out([from, to]: [f64; 2]) -> Option<[f64; 2]> {
    Some([to, from])
}

#[test]
fn of_bodies_that_share_a_face_the_ray_leaves_one_and_enters_the_other() {
    let meshes = [
        ("near.obj", cuboid([-1.0, -1.0, 0.3], [1.0, 1.0, 1.3])),
        ("far.obj", cuboid([-1.0, -1.0, -0.9], [1.0, 1.0, 0.3])),
    ];
    let (near, far) = (mesh("near", "glass"), mesh("far", "water"));
    let wall = object("wall", "wall", WALL);
    for (objects, near, far) in [([near.clone(), far.clone()], 0, 1), ([far, near], 1, 0)] {
        let objects = [&objects[..], std::slice::from_ref(&wall)].concat();
        let expected = [
            (near, Some(GLASS)),
            (near, out(GLASS)),
            (far, Some(WATER)),
            (far, out(WATER)),
            (2, None),
        ];
        assert_eq!(path(&objects, &meshes), expected);
    }
}

/// Boxes as one mesh: the vertices of each after those of the one before.
fn in_one_mesh(boxes: &[String]) -> String {
    let mut text = String::new();
    for (number, cuboid) in boxes.iter().enumerate() {
        for line in cuboid.lines() {
            let words = line.split(' ').map(|word| match word.parse::<usize>() {
                Ok(vertex) if line.starts_with('f') => (vertex + 8 * number).to_string(),
                _ => word.to_owned(),
            });
            text += &(words.collect::<Vec<_>>().join(" ") + "\n");
        }
    }
    text
}

#[test]
fn bodies_of_one_mesh_that_share_a_face_are_left_and_entered_as_two_objects_are() {
    let near = cuboid([-1.0, -1.0, 0.3], [1.0, 1.0, 1.3]);
    let far = cuboid([-1.0, -1.0, -0.9], [1.0, 1.0, 0.3]);
    // Their faces divided along the other diagonal, or larger, so that no corner is shared.
    let divided = far
        .replace("f 5 6 8 7", "f 6 8 5\nf 8 7 5")
        .replace("f 2 4 8 6", "f 2 4 8\nf 2 8 6");
    let larger = cuboid([-1.5, -2.0, -0.9], [1.0, 1.7, 0.3]);
    let wall = object("wall", "wall", WALL);
    for far in [far, divided, larger] {
        for boxes in [[near.clone(), far.clone()], [far, near.clone()]] {
            let meshes = [("both.obj", in_one_mesh(&boxes))];
            let expected = [
                (0, Some(GLASS)),
                (0, out(GLASS)),
                (0, Some(GLASS)),
                (0, out(GLASS)),
                (1, None),
            ];
            assert_eq!(
                path(&[mesh("both", "glass"), wall.clone()], &meshes),
                expected
            );
        }
    }
}

#[test]
fn an_opaque_surface_that_touches_a_body_is_met_from_outside_or_inside_by_their_order() {
    let meshes = [("box.obj", cuboid([-1.0, -1.0, -3.0], [1.0, 1.0, 1.0]))];
    let (body, wall) = (mesh("box", "glass"), object("wall", "wall", WALL));
    let first = [(0, Some(GLASS)), (0, out(GLASS)), (1, None)];
    assert_eq!(path(&[body.clone(), wall.clone()], &meshes), first);
    // The wall is in front of the end of the glass.
    assert_eq!(path(&[wall, body], &meshes), [(1, Some(GLASS)), (0, None)]);
}

#[test]
fn bodies_in_the_same_place_are_entered_and_left_one_by_one() {
    let ball = r#""sphere": { "center": [0, 0, 0], "radius": 0.9 }"#;
    let [glass, water] = ["glass", "water"].map(|material| object(material, material, ball));
    let wall = object("wall", "wall", WALL);
    let expected = [
        (0, Some(GLASS)),
        (1, Some([1.5, 1.33])),
        (0, Some([1.33, 1.33])),
        (1, out(WATER)),
        (2, None),
    ];
    assert_eq!(path(&[glass, water, wall], &[]), expected);
}

#[test]
fn a_surface_that_is_not_closed_is_a_thin_pane() {
    let pane = r#""polygon": { "vertices": [[-1, -1, 1], [1, -1, 1], [1, 1, 1], [-1, 1, 1]] }"#;
    let turned = r#""polygon": { "vertices": [[-1, 1, 1], [1, 1, 1], [1, -1, 1], [-1, -1, 1]] }"#;
    let tube = r#""cylinder": { "base": [0, -2, 0], "axis": [0, 1, 0], "radius": 1, "height": 4, "capped": false }"#;
    let plane = r#""plane": { "point": [0, 0, 1], "normal": [0, 0, 1] }"#;
    let ball = object(
        "ball",
        "glass",
        r#""sphere": { "center": [0, 0, -1.5], "radius": 0.5 }"#,
    );
    let wall = object("wall", "wall", WALL);
    let straight = Some([1.0, 1.0]);
    for (shape, times) in [(pane, 1), (turned, 1), (plane, 1), (tube, 2)] {
        let objects = [object("sheet", "glass", shape), ball.clone(), wall.clone()];
        let mut expected = vec![(0, straight); times];
        expected.extend([(1, Some(GLASS)), (1, out(GLASS)), (2, None)]);
        assert_eq!(path(&objects, &[]), expected, "{shape}");
    }
}

#[test]
fn bodies_wound_inward_or_mixed_are_turned() {
    let outward = cuboid([-1.0, -1.0, -1.0], [1.0, 1.0, 1.0]);
    let turn = |line: &str| {
        let corners: Vec<&str> = line.split(' ').skip(1).collect();
        let turned: Vec<&str> = corners.into_iter().rev().collect();
        format!("f {}", turned.join(" "))
    };
    let turned = |which: &dyn Fn(usize) -> bool| -> String {
        let lines = outward
            .lines()
            .enumerate()
            .map(|(number, line)| match line {
                line if line.starts_with('f') && which(number) => turn(line) + "\n",
                line => format!("{line}\n"),
            });
        lines.collect()
    };
    for mesh_text in [
        outward.clone(),
        turned(&|_| true),
        turned(&|number| number % 2 == 0),
        turned(&|number| number == 9),
    ] {
        let objects = [mesh("box", "glass"), object("wall", "wall", WALL)];
        let expected = [(0, Some(GLASS)), (0, out(GLASS)), (1, None)];
        assert_eq!(path(&objects, &[("box.obj", mesh_text)]), expected);
    }
}

/// Decals on a floor, both turned by any angles: the first in the file is in front, in every pixel of every method.
#[test]
fn of_coplanar_surfaces_aslant_the_first_is_in_front_in_every_method() {
    let mut random = 1.0_f64;
    for _ in 0..6 {
        let mut angle = || {
            random = (random * 997.0 + 0.123).fract();
            std::f64::consts::TAU * random
        };
        let turn = glam::DMat3::from_euler(glam::EulerRot::XYZ, angle(), angle(), angle());
        let at = 1e3 * turn.x_axis;
        let place = |x: f64, y: f64, z: f64| (turn * DVec3::new(x, y, z) + at).to_array();
        let quad = |half: f64| {
            let corners = [[-half, -half], [half, -half], [half, half], [-half, half]];
            let corners = corners.map(|[x, y]| place(x, y, 0.0));
            format!(r#""polygon": {{ "vertices": {corners:?} }}"#)
        };
        let json = |objects: [String; 2]| {
            format!(
                r#"{{ "schema": 1, "camera": {{ "eye": {:?}, "target": {:?}, "up": {:?}, "fov_x_degrees": 50 }},
                     "materials": {{ "red": {{ "ambient": [1, 0, 0] }}, "green": {{ "ambient": [0, 1, 0] }} }},
                     "objects": [ {} ] }}"#,
                place(2.0, -3.0, 1.5),
                place(0.0, 0.0, 0.0),
                (turn.z_axis).to_array(),
                objects.join(", ")
            )
        };
        let (decal, floor) = (
            object("decal", "red", &quad(1.0)),
            object("floor", "green", &quad(4.0)),
        );
        let red = |objects: [String; 2]| -> Vec<usize> {
            let setup = setup(&json(objects), 64, 48);
            let mut frames = vec![picture(&setup), cast(&setup, setup.needs(), BruteForce)];
            frames.push(cast(&setup, setup.needs(), Bvh));
            let scan_line = [
                Method::Flat,
                Method::Gouraud,
                Method::Phong,
                Method::FastPhong,
                Method::Exact,
            ];
            frames.extend(scan_line.map(|method| drawn(&setup, method)));
            let is_red = |color: &&Rgb| color.r > 0.5 && color.g < 0.5;
            let count = frames
                .iter()
                .map(|frame| frame.color.iter().filter(is_red).count());
            count.collect()
        };
        let in_front = red([decal.clone(), floor.clone()]);
        assert!(in_front[0] > 100, "{in_front:?}");
        assert!(
            in_front.iter().all(|&count| count == in_front[0]),
            "{in_front:?}"
        );
        assert_eq!(red([floor, decal]), vec![0; in_front.len()]);
    }
}

#[test]
fn what_lies_in_front_of_a_surface_casts_its_shadow_there() {
    // A pane on a wall, lit from the front: the wall is in its shadow where the pane is the first of the two.
    let json = |objects: [&str; 2], casts: bool| {
        let pane = format!(
            r#"{{ "name": "pane", "material": "clear", "casts_shadow": {casts}, "polygon": {{ "vertices": [[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]] }} }}"#
        );
        let wall = r#"{ "name": "wall", "material": "white", "polygon": { "vertices": [[-2, -2, 0], [2, -2, 0], [2, 2, 0], [-2, 2, 0]] } }"#;
        let objects = objects.map(|name| if name == "pane" { &pane } else { wall });
        format!(
            r#"{{ "schema": 1, "camera": {{ "eye": [0.1, 0.1, 5], "target": [0.1, 0.1, 0], "up": [0, 1, 0], "fov_x_degrees": 1 }},
                 "materials": {{ "clear": {{ "transmission": 0.5 }}, "white": {{ "diffuse": [1, 1, 1] }} }},
                 "objects": [ {}, {} ], "lights": [ {{ "directional": {{ "toward": [0, 0, -1] }} }} ] }}"#,
            objects[0], objects[1]
        )
    };
    let seen =
        |objects: [&str; 2], casts| picture(&setup(&json(objects, casts), 1, 1)).pixel(0, 0).r;
    assert_eq!(seen(["pane", "wall"], true), 0.0);
    assert_eq!(seen(["pane", "wall"], false), 0.5);
    assert_eq!(seen(["wall", "pane"], true), 1.0);
}
