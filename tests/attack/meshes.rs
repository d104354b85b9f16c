//! Mesh files made and changed at random, as text and as bytes. Each is refused with a clear error, or every method draws it.

use crate::glb::{glb, gltf, triangle};
use crate::json::change;
use crate::kit::{Driver, Outcome, is_clear, one_of, pick};
use crate::scenes::{LIMITS, draw};
use lightwalk::numeric::Random;
use lightwalk::scene::scene_of_mesh;

/// The name of a file, and under it its bytes, each as the character of its number.
fn make(random: &mut Random) -> String {
    let (name, bytes) = match pick(random, 4) {
        0 => ("mesh.gltf", changed_gltf(random).into_bytes()),
        1 => ("mesh.glb", changed_glb(random)),
        _ => ("mesh.obj", changed_bytes(obj(random).into_bytes(), random)),
    };
    let bytes: String = bytes.into_iter().map(char::from).collect();
    format!("{name}\n{bytes}")
}

fn changed_gltf(random: &mut Random) -> String {
    let mut document = gltf();
    for _ in 0..pick(random, 4) {
        change(&mut document, random);
    }
    document.to_string()
}

fn changed_glb(random: &mut Random) -> Vec<u8> {
    let mut document = triangle();
    for _ in 0..pick(random, 3) {
        change(&mut document, random);
    }
    changed_bytes(glb(&document), random)
}

/// Sometimes with a few other bytes, or without its end.
fn changed_bytes(mut bytes: Vec<u8>, random: &mut Random) -> Vec<u8> {
    match pick(random, 6) {
        0 => bytes.truncate(pick(random, bytes.len())),
        1 => {
            for _ in 0..=pick(random, 3) {
                let at = pick(random, bytes.len());
                bytes[at] = one_of(
                    random,
                    &[0, b'\r', b'\n', b'\\', b'/', b'#', b'-', b'9', 0xff, 0xef],
                );
            }
        }
        _ => {}
    }
    bytes
}

/// Some vertices, and lines of every kind.
fn obj(random: &mut Random) -> String {
    let mut lines: Vec<String> = (0..4 + pick(random, 5)).map(|_| vertex(random)).collect();
    lines.extend((0..1 + pick(random, 8)).map(|_| line(random)));
    lines.join(one_of(random, &["\n", "\n", "\r\n", "\r", " \\\n"]))
}

fn vertex(random: &mut Random) -> String {
    // On a grid places coincide, and faces are flat.
    let numbers = [0; 3].map(|_| match pick(random, 12) {
        0 => one_of(
            random,
            &["1e300", "-1e75", "1e-300", "nan", "inf", "", "0x1", "1e999"],
        )
        .to_owned(),
        1 => random.number().to_string(),
        _ => pick(random, 3).to_string(),
    });
    format!("v {}", numbers.join(" "))
}

fn line(random: &mut Random) -> String {
    let corner = |random: &mut Random| {
        let index = match pick(random, 12) {
            0 => one_of(random, &[0, -1, -9, 99, i64::MAX, i64::MIN]),
            _ => 1 + pick(random, 6) as i64,
        };
        match pick(random, 6) {
            0 => format!("{index}/1/1"),
            1 => format!("{index}//2"),
            2 => format!("{index}/1"),
            _ => index.to_string(),
        }
    };
    match pick(random, 10) {
        0 => vertex(random),
        1 => format!(
            "vn {} {} {}",
            random.number(),
            pick(random, 2),
            random.number()
        ),
        2 => format!("vt {} {}", random.number(), random.number()),
        3 => one_of(
            random,
            &[
                "o a",
                "g a b",
                "s 1",
                "usemtl x",
                "mtllib y.mtl",
                "l 1 2",
                "#",
                "curv 0 1 1 2",
                "?",
            ],
        )
        .to_owned(),
        _ => {
            let corners = 1 + pick(random, 7);
            let corners: Vec<String> = (0..corners).map(|_| corner(random)).collect();
            format!("f {}", corners.join(" "))
        }
    }
}

fn attempt(case: &str) -> Result<Outcome, String> {
    let (name, bytes) = case.split_once('\n').ok_or("a case has a name")?;
    let bytes: Vec<u8> = bytes.chars().map(|c| c as u8).collect();
    let mut read_file = |wanted: &str| match wanted == name {
        true => Ok(bytes.clone()),
        false => Err("no such file".into()),
    };
    match scene_of_mesh(name, &LIMITS, &mut read_file) {
        Ok(scene) => draw(scene).map(|()| Outcome::Done),
        Err(error) => is_clear(&error.to_string()).map(|()| Outcome::Refused),
    }
}

#[test]
fn a_mesh_file_is_refused_or_drawn_by_every_method() {
    let driver = Driver {
        kind: "meshes",
        cases: 20_000,
        done_percent: 15,
        make,
        attempt,
    };
    driver.attack();
}
