//! Broken scene files: each is refused with a message that says where and why, and none makes the reader panic or hang.

use crate::broken::{BROKEN, GOOD, POT};
use lightwalk::scene::{self, Limits, Scene, SceneError};
use proptest::prelude::*;

fn read_with(text: &[u8], mesh: &str) -> Result<Scene, SceneError> {
    scene::read(text, &Limits::default(), &mut |path| match path {
        "meshes/pot.obj" => Ok(mesh.as_bytes().to_vec()),
        _ => Err("no such file".into()),
    })
}

fn message(text: &[u8], mesh: &str) -> String {
    match read_with(text, mesh) {
        Err(error) => error.to_string(),
        Ok(_) => "taken for good".into(),
    }
}

#[test]
fn the_unbroken_scene_is_taken() {
    assert_eq!(read_with(GOOD.as_bytes(), POT).unwrap().objects.len(), 6);
}

#[test]
fn every_broken_scene_is_refused_with_its_place_and_reason() {
    let mut wrong = Vec::new();
    for (good, broken, expected) in BROKEN {
        assert!(GOOD.contains(good), "{good} is not in the good scene");
        let message = message(GOOD.replacen(good, broken, 1).as_bytes(), POT);
        let says_all = expected.iter().all(|part| message.contains(part));
        if !says_all || message.contains('\n') {
            wrong.push(format!(
                "{broken}\n  expected {expected:?}\n  found {message}"
            ));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn texts_that_are_no_scene_are_refused() {
    let deep = "[".repeat(100_000);
    let deep_inside = format!("{{\"schema\": 1, \"objects\": {deep}");
    let cases: [(&[u8], &str); 11] = [
        (b"", "the file is empty"),
        (b" \n\t", "the file is empty"),
        (b"\xef\xbb\xbf", "the file is empty"),
        (b"[]", "expected an object"),
        (b"null", "expected an object"),
        (b"{'schema': 1}", "line 1, column 2: key must be a string"),
        (b"{\"schema\": 1,}", "trailing comma"),
        (
            b"{\"schema\": 1, \"objects\": [], \"materials\": {}} {}",
            "more text after the end",
        ),
        (
            b"{\"schema\": 1, \"materials\": \xc3\x28}",
            "line 1, column 28: found the byte 0xc3, which is not UTF-8",
        ),
        (deep.as_bytes(), "expected an object"),
        (
            deep_inside.as_bytes(),
            "objects[0]: found a list; expected an object",
        ),
    ];
    for (text, expected) in cases {
        let message = message(text, POT);
        assert!(message.contains(expected), "{message}");
    }
    let cut = message(&GOOD.as_bytes()[..GOOD.len() / 2], POT);
    assert!(
        cut.contains("objects[") && cut.contains("the file ends here"),
        "{cut}"
    );
    let large = message(&vec![b' '; (64 << 20) + 1], POT);
    assert!(large.contains("the file has 67108865 bytes; at most 67108864 are allowed"));
}

#[test]
fn broken_meshes_are_refused_with_file_and_line() {
    for (mesh, expected) in [
        ("", "no faces"),
        ("v 0 0 0\nf 1 1 1", "three corners at different places"),
        ("v 0 0 0\nf 1 2 3", "line 2: a face refers to `v` number 3"),
        ("v 0 0 inf", "line 1: found inf"),
        (
            "v 9e75 0 0\nv 0 1 0\nv 1 0 0\nf 1 2 3",
            "line 1: found a vertex of a face too far away",
        ),
    ] {
        let message = message(GOOD.as_bytes(), mesh);
        let (place, message) = message.split_once(": ").unwrap();
        assert!(place.starts_with("line "), "{place}");
        assert!(message.starts_with("objects[3].mesh.file: "), "{message}");
        assert!(message.contains("\"meshes/pot.obj\""), "{message}");
        assert!(message.contains(expected), "{message}");
    }
}

#[test]
fn all_problems_of_values_and_references_are_reported_in_one_go() {
    let text = GOOD
        .replace("\"radius\": 0.8", "\"radius\": -1")
        .replace("\"ior\": 1.5", "\"ior\": -1")
        .replace("meshes/pot.obj", "../pot.obj")
        .replace("\"blue\", \"bezier\"", "\"green\", \"bezier\"");
    let error = read_with(text.as_bytes(), POT).unwrap_err();
    let places: Vec<&str> = error.problems.iter().map(|p| p.place.as_str()).collect();
    assert_eq!(
        places,
        [
            "materials.red.ior",
            "objects[0].sphere.radius",
            "objects[3].mesh.file",
            "objects[5].material"
        ]
    );
    assert_eq!(error.to_string().lines().count(), 4);
    for problem in &error.problems {
        let (line, column) = (problem.line.unwrap(), problem.column.unwrap());
        let (name, value) = match problem.place.as_str() {
            "materials.red.ior" => ("\"ior\": ", "-1"),
            "objects[0].sphere.radius" => ("\"radius\": ", "-1"),
            "objects[3].mesh.file" => ("\"file\": ", "\"../pot.obj\""),
            _ => ("\"material\": ", "\"green\""),
        };
        let line = text.lines().nth(line - 1).unwrap();
        assert!(line[..column - 1].ends_with(name), "{problem}");
        assert!(line[column - 1..].starts_with(value), "{problem}");
    }
}

#[test]
fn limits_hold_for_the_whole_scene() {
    let object = |i: usize| {
        format!(
            "{{\"name\": \"{i}\", \"material\": \"m\", \"mesh\": {{\"file\": \"meshes/pot.obj\"}}, \"patches\": 2}}"
        )
    };
    let objects: Vec<String> = (0..3).map(object).collect();
    let text = format!(
        "{{\"schema\": 1, \"materials\": {{\"m\": {{}}}}, \"objects\": [{}]}}",
        objects.join(",")
    );
    // Two triangles a mesh, each divided in 2²: 6 triangles, 24 patches.
    let read = |max_patches, max_triangles| {
        let limits = Limits {
            max_patches,
            max_triangles,
        };
        scene::read(text.as_bytes(), &limits, &mut |_| Ok(POT.into()))
    };
    assert!(read(24, 6).is_ok());
    let patches = read(23, 6).unwrap_err().to_string();
    assert!(patches.contains(": objects[2].patches: "), "{patches}");
    let triangles = read(24, 5).unwrap_err().to_string();
    assert!(
        triangles
            .contains(": objects[2].mesh.file: found 2 triangles here and 6 so far; at most 5")
    );
}

#[test]
fn many_problems_take_little_time() {
    let materials: Vec<String> = (0..20_000).map(|i| format!("\"m{i}\": {{}}")).collect();
    let object =
        "{\"name\": \"n\", \"material\": \"x\", \"sphere\": {\"center\": [0,0,0], \"radius\": -1}}";
    let text = format!(
        "{{\"schema\": 1, \"materials\": {{{}}}, \"objects\": [{}]}}",
        materials.join(","),
        vec![object; 20_000].join(",")
    );
    let error = read_with(text.as_bytes(), POT).unwrap_err();
    // The material and the radius of each, and every name but the first.
    assert_eq!(error.problems.len(), 1001);
    assert!(error.to_string().ends_with("\nand 58999 more problems"));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    #[test]
    fn no_bytes_make_it_panic(bytes in prop::collection::vec(any::<u8>(), 0..300)) {
        prop_assert!(read_with(&bytes, POT).is_err());
    }

    #[test]
    fn no_cut_or_flipped_byte_makes_it_panic(
        end in 0..=GOOD.len(),
        flips in prop::collection::vec((0..GOOD.len(), any::<u8>()), 0..4),
    ) {
        let mut bytes = GOOD.as_bytes().to_vec();
        for (at, byte) in flips {
            bytes[at] = byte;
        }
        bytes.truncate(end);
        if let Err(error) = read_with(&bytes, POT) {
            prop_assert!(!error.problems.is_empty());
            prop_assert_eq!(error.to_string().lines().count(), error.problems.len());
        }
    }

    #[test]
    fn no_exchanged_token_makes_it_panic(
        exchanges in prop::collection::vec((any::<prop::sample::Index>(), token()), 1..4),
    ) {
        let mut tokens = tokens(GOOD);
        for (at, token) in exchanges {
            *at.get_mut(&mut tokens) = token;
        }
        if let Ok(scene) = read_with(tokens.concat().as_bytes(), POT) {
            let polygons = scene::Tessellation::of(&scene).polygon_count();
            prop_assert!(polygons <= 5_100_000);
        }
    }
}

/// The text in pieces: marks, words and numbers.
fn tokens(text: &str) -> Vec<String> {
    let mut tokens: Vec<String> = Vec::new();
    let mut last_is_word = false;
    for character in text.chars() {
        let is_word = character.is_alphanumeric() || "_.-".contains(character);
        match tokens.last_mut() {
            Some(word) if is_word && last_is_word => word.push(character),
            _ => tokens.push(character.into()),
        }
        last_is_word = is_word;
    }
    tokens
}

fn token() -> impl Strategy<Value = String> {
    prop_oneof![
        prop::sample::select(vec![
            "0",
            "-1",
            "1e75",
            "-1e75",
            "1e-300",
            "1e308",
            "5e-324",
            "1e400",
            "3000000000",
            "[]",
            "[0,0,0]",
            "{}",
            "null",
            "true",
            "\"\"",
            ",",
            ":",
            "[",
            "]",
            "{",
            "}",
            "\"",
            "\\u0000",
            "",
        ])
        .prop_map(String::from),
        any::<f64>().prop_map(|number| format!("{number:e}")),
        any::<i64>().prop_map(|number| number.to_string()),
    ]
}
