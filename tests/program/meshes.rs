//! Mesh files as people have them.

use crate::{lightwalk, succeeded, text};
use std::fs;
use tempfile::TempDir;

const SCENE: &str = r#"{ "schema": 1, "background": [0.2, 0.3, 0.5],
  "camera": { "eye": [2.5, 2, 4], "target": [0, 0, 0], "up": [0, 1, 0], "fov_x_degrees": 45 },
  "materials": { "m": { "ambient": [0.1, 0.1, 0.1], "diffuse": [0.6, 0.5, 0.4] } },
  "objects": [{ "name": "o", "material": "m", "mesh": { "file": "mesh.obj" } }],
  "lights": [{ "point": { "position": [3, 5, 6] } }] }"#;

const TRIANGLE: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

fn folder_with(mesh: &[u8]) -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("scene.json"), SCENE).unwrap();
    fs::write(folder.path().join("mesh.obj"), mesh).unwrap();
    folder
}

#[test]
fn what_a_mesh_file_says_without_effect_is_noted_with_its_count() {
    let mesh = format!("{TRIANGLE}usemtl red\nf 1 2 3\nf 1 2\nf 2 3\n");
    let folder = folder_with(mesh.as_bytes());
    let output = succeeded(
        folder.path(),
        "render scene.json --method flat --size 16x12 --out a.png",
    );
    let notes = text(&output.stderr);
    for note in [
        "objects[0].mesh.file: 2 faces of fewer than three corners, the first in line 6",
        "objects[0].mesh.file: 1 line of materials",
    ] {
        assert!(notes.contains(note), "{notes}");
    }
}

#[test]
fn a_file_of_another_kind_is_called_by_its_name() {
    let page = folder_with(b"<!DOCTYPE html>\n<html><body>404</body></html>\n");
    let output = lightwalk(page.path(), "check scene.json");
    assert_eq!(output.status.code(), Some(2));
    let message = text(&output.stderr);
    assert!(
        message.contains("in \"mesh.obj\": found a web page (HTML)"),
        "{message}"
    );

    let folder = folder_with(TRIANGLE.as_bytes());
    let output = lightwalk(folder.path(), "render mesh.obj --method flat --out a.png");
    assert_eq!(output.status.code(), Some(2));
    let message = text(&output.stderr);
    assert!(
        message.contains("mesh.obj: found a Wavefront OBJ file"),
        "{message}"
    );
}

/// A triangle in three positions of 12 bytes.
const GLTF: &str = r#"{ "asset": { "version": "2.0" }, "scene": 0, "scenes": [{ "nodes": [0] }], "nodes": [{ "mesh": 0 }],
  "meshes": [{ "primitives": [{ "attributes": { "POSITION": 0 } }] }],
  "accessors": [{ "bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3" }],
  "bufferViews": [{ "buffer": 0, "byteLength": 36 }],
  "materials": [{ "pbrMetallicRoughness": { "baseColorFactor": [0.5, 0.25, 0.125, 1] } }],
  "buffers": [{ "byteLength": 36, "uri": "BUFFER" }] }"#;

#[test]
fn a_gltf_file_holds_its_buffers_itself() {
    // (0, 0, 0), (1, 0, 0), (0, 1, 0): 1.0 is 0x3f800000.
    let embedded =
        "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA";
    let folder = folder_with(b"");
    let check = |buffer: &str| {
        let scene = SCENE.replace("mesh.obj", "mesh.gltf");
        fs::write(folder.path().join("scene.json"), scene).unwrap();
        fs::write(
            folder.path().join("mesh.gltf"),
            GLTF.replace("BUFFER", buffer),
        )
        .unwrap();
        fs::write(folder.path().join("mesh.bin"), [0; 36]).unwrap();
        lightwalk(folder.path(), "check scene.json")
    };
    let whole = check(embedded);
    assert_eq!(whole.status.code(), Some(0), "{}", text(&whole.stderr));
    let base_color = "materials (0 of base colour [0.5, 0.25, 0.125])";
    assert!(text(&whole.stderr).contains(base_color));
    let apart = check("mesh.bin");
    assert_eq!(apart.status.code(), Some(2));
    let message = text(&apart.stderr);
    assert!(
        message.contains("buffers[0] is in another file, \"mesh.bin\""),
        "{message}"
    );
}

/// The pixels of a picture that are not of the background's colour.
fn drawn(folder: &TempDir, scene: &str, method: &str) -> Vec<bool> {
    let render = format!("render {scene} --method {method} --size 80x60 --out a.pfm");
    succeeded(folder.path(), &render);
    let file = fs::read(folder.path().join("a.pfm")).unwrap();
    let colors = file[file.len() - 80 * 60 * 12..].chunks_exact(12);
    let background: [f32; 3] = match method {
        "radiosity" => [0.0; 3],
        _ => [0.2, 0.3, 0.5],
    };
    let background: Vec<u8> = background.iter().flat_map(|x| x.to_le_bytes()).collect();
    colors.map(|color| color != background).collect()
}

/// Faces that are not planar, seen aslant, and faces that cross themselves: in a mesh and as a polygon.
#[test]
fn every_method_draws_the_same_pixels_of_any_face() {
    let hexagon: [[f64; 3]; 6] = std::array::from_fn(|i| {
        let (sin, cos) = (1.0 + i as f64 * std::f64::consts::FRAC_PI_3).sin_cos();
        [cos, sin, if i % 2 == 0 { 0.5 } else { -0.5 }]
    });
    let pentagram: [[f64; 3]; 5] = std::array::from_fn(|i| {
        let (sin, cos) = (0.1 + 2.0 * i as f64 * std::f64::consts::TAU / 5.0).sin_cos();
        [cos, sin, 0.2 * sin]
    });
    let bow_tie = [
        [-1.0, 0.95, 0.0],
        [1.0, -1.0, 0.1],
        [1.0, 1.0, 0.1],
        [-1.0, -0.9, 0.0],
    ];
    let bent = [
        [-1.0, -1.0, 0.0],
        [1.0, -1.0, 1.5],
        [1.0, 1.0, 0.0],
        [-1.0, 1.0, 1.5],
    ];
    let material =
        r#""m": { "ambient": [0.1, 0.1, 0.1], "diffuse": [0.6, 0.5, 0.4], "emission": [1, 1, 1] }"#;
    for face in [&hexagon[..], &pentagram, &bow_tie, &bent] {
        let lines: String = face
            .iter()
            .map(|[x, y, z]| format!("v {x} {y} {z}\n"))
            .collect();
        let indices: String = (1..=face.len()).map(|i| format!(" {i}")).collect();
        let folder = folder_with(format!("{lines}f{indices}\n").as_bytes());
        let polygon = format!("\"polygon\": {{ \"vertices\": {face:?} }}");
        let mesh = "\"mesh\": { \"file\": \"mesh.obj\" }";
        for (name, shape) in [("mesh.json", mesh), ("polygon.json", &polygon)] {
            let scene = SCENE
                .replace(mesh, shape)
                .replace("[2.5, 2, 4]", "[2.5, 0.5, 2.3]");
            let material_at =
                scene.find("\"m\":").unwrap()..scene.find(" },\n  \"objects\"").unwrap();
            let scene = scene.replace(&scene[material_at], material);
            fs::write(folder.path().join(name), scene).unwrap();
        }
        let expected = drawn(&folder, "mesh.json", "flat");
        let area = expected.iter().filter(|&&is_drawn| is_drawn).count();
        assert!(area > 200, "{area}");
        for method in [
            "gouraud",
            "phong",
            "fast-phong",
            "exact",
            "ray-casting",
            "ray-tracing",
            "radiosity",
        ] {
            for scene in ["mesh.json", "polygon.json"] {
                let found = drawn(&folder, scene, method);
                let off = found.iter().zip(&expected).filter(|(a, b)| a != b).count();
                assert_eq!(off, 0, "{method} of {scene} {face:?}");
            }
        }
    }
}

/// The diagonals of this bow-tie pass through pixel centres, which rounding puts on either side of them. It is seen from its front.
#[test]
fn of_a_bow_tie_whose_edges_meet_pixel_centres_methods_differ_on_those_edges_alone() {
    let folder = folder_with(b"v 0 0 0\nv 2 2 0\nv 2 0 0\nv 0 2 0\nf 1 2 3 4\n");
    let scene = r#"{ "schema": 1, "background": [0.2, 0.3, 0.5],
  "camera": { "eye": [1, 1, -10], "target": [1, 1, 0], "up": [0, 1, 0], "fov_x_degrees": 14.81382425699046 },
  "materials": { "m": { "ambient": [0.1, 0.1, 0.1], "emission": [1, 1, 1] } },
  "objects": [{ "name": "q", "material": "m", SHAPE }] }"#;
    let mesh = r#""mesh": { "file": "mesh.obj" }"#;
    let polygon = r#""polygon": { "vertices": [[0, 0, 0], [2, 2, 0], [2, 0, 0], [0, 2, 0]] }"#;
    // 2 of the 2.6 units that the width of the picture shows, in pixels from its middle.
    let half = 0.5 * 80.0 * 2.0 / 2.6;
    let mut inside = 0;
    for (name, shape) in [("mesh.json", mesh), ("polygon.json", polygon)] {
        fs::write(folder.path().join(name), scene.replace("SHAPE", shape)).unwrap();
        for method in [
            "flat",
            "gouraud",
            "phong",
            "fast-phong",
            "exact",
            "ray-casting",
            "ray-tracing",
            "radiosity",
        ] {
            let found = drawn(&folder, name, method);
            for (pixel, &is_drawn) in found.iter().enumerate() {
                let [x, y] = [(pixel % 80) as f64 - 39.5, (pixel / 80) as f64 - 29.5];
                let (x, y) = (x.abs(), y.abs());
                // Left and right of where the diagonals cross.
                if (x - y).abs() > 0.5 {
                    assert_eq!(is_drawn, y < x && x < half, "{method} of {name}: {x} {y}");
                    inside += u32::from(is_drawn);
                }
            }
        }
    }
    assert!(inside > 16 * 1000, "{inside}");
}

/// A cube whose file gives every face its own normal.
const CUBE: &str =
    "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1
vn 0 0 1\nvn 0 0 -1\nvn 1 0 0\nvn -1 0 0\nvn 0 1 0\nvn 0 -1 0
f 5//1 6//1 7//1 8//1\nf 1//2 4//2 3//2 2//2\nf 2//3 3//3 7//3 6//3
f 1//4 5//4 8//4 4//4\nf 4//5 8//5 7//5 3//5\nf 1//6 2//6 6//6 5//6\n";

#[test]
fn the_front_of_a_cube_with_hard_edges_is_lit_evenly() {
    // Light from (1, 1, 2)/√6: N·L = 2/√6 on the front.
    let expected = 2.0 / 6_f32.sqrt();
    let scene = r#"{ "schema": 1,
  "camera": { "eye": [0, 0, 6], "target": [0, 0, 0], "up": [0, 1, 0], "fov_x_degrees": 30 },
  "materials": { "m": { "diffuse": [1, 1, 1] } },
  "objects": [{ "name": "c", "material": "m", "mesh": { "file": "mesh.obj" } NORMALS }],
  "lights": [{ "directional": { "toward": [-0.5, -0.5, -1] } }] }"#;
    let folder = folder_with(CUBE.as_bytes());
    let front = |normals: &str, method: &str| {
        fs::write(
            folder.path().join("cube.json"),
            scene.replace("NORMALS", normals),
        )
        .unwrap();
        let render = format!("render cube.json --method {method} --size 40x40 --out a.pfm");
        let notes = text(&succeeded(folder.path(), &render).stderr);
        let file = fs::read(folder.path().join("a.pfm")).unwrap();
        let reds = file[file.len() - 40 * 40 * 12..].chunks_exact(12);
        let reds: Vec<f32> = reds
            .map(|color| f32::from_le_bytes([color[0], color[1], color[2], color[3]]))
            .filter(|&red| red > 0.0)
            .collect();
        let low = reds.iter().copied().fold(f32::INFINITY, f32::min);
        let high = reds.iter().copied().fold(0.0, f32::max);
        (low, high, notes)
    };
    for method in ["gouraud", "phong", "fast-phong", "exact"] {
        for normals in [
            r#", "normals": "file""#,
            r#", "normals": "face""#,
            r#", "crease_degrees": 60"#,
            r#", "normals": "averaged", "crease_degrees": 89.9"#,
        ] {
            let (low, high, _) = front(normals, method);
            assert!((low - expected).abs() < 1e-6, "{method} {normals}: {low}");
            assert!((high - expected).abs() < 1e-6, "{method} {normals}: {high}");
        }
        for normals in ["", r#", "crease_degrees": 90"#] {
            let (low, high, notes) = front(normals, method);
            assert!(low < 0.1 && high > 0.9, "{method} {normals}: {low} {high}");
            assert!(notes.contains("normals of the file: not used"), "{notes}");
        }
    }
    let (.., notes) = front(r#", "normals": "file", "crease_degrees": 30"#, "gouraud");
    assert!(
        notes.contains("objects[0].crease_degrees: a crease angle with normals \"file\""),
        "{notes}"
    );
    fs::write(
        folder.path().join("mesh.obj"),
        CUBE.replace("vn 0 0 1\n", "vn 0 0 nan\n"),
    )
    .unwrap();
    let (.., notes) = front(r#", "normals": "file""#, "gouraud");
    assert!(
        notes.contains("objects[0].normals: 4 of 24 corners without a normal in the file"),
        "{notes}"
    );
}
