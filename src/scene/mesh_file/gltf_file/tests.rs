use super::*;
use crate::scene::Mesh;
use proptest::prelude::*;
use serde_json::{Value, json};

/// Two triangles of a square in the plane z = 0: four positions, normals and texture coordinates, then six indices.
fn square_bytes() -> Vec<u8> {
    let corners = [[0.0_f32, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    let positions = corners.iter().flat_map(|&[x, y]| [x, y, 0.0]);
    let normals = corners.iter().flat_map(|_| [0.0, 0.0, 2.0]);
    let uvs = corners.iter().flatten().copied();
    let floats = positions.chain(normals).chain(uvs);
    let indices = [0_u16, 1, 2, 0, 2, 3].into_iter();
    floats
        .flat_map(f32::to_le_bytes)
        .chain(indices.flat_map(u16::to_le_bytes))
        .collect()
}

fn square() -> Value {
    json!({
        "asset": { "version": "2.0" },
        "scene": 0,
        "scenes": [{ "nodes": [0] }],
        "nodes": [{ "mesh": 0 }],
        "meshes": [{ "primitives": [{
            "attributes": { "POSITION": 0, "NORMAL": 1, "TEXCOORD_0": 2 }, "indices": 3
        }] }],
        "accessors": [
            { "bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3" },
            { "bufferView": 0, "byteOffset": 48, "componentType": 5126, "count": 4, "type": "VEC3" },
            { "bufferView": 1, "componentType": 5126, "count": 4, "type": "VEC2" },
            { "bufferView": 2, "componentType": 5123, "count": 6, "type": "SCALAR" }
        ],
        "bufferViews": [
            { "buffer": 0, "byteLength": 96 },
            { "buffer": 0, "byteOffset": 96, "byteLength": 32 },
            { "buffer": 0, "byteOffset": 128, "byteLength": 12 }
        ],
        "buffers": [{ "byteLength": 140 }]
    })
}

fn glb(json: &Value, binary: &[u8]) -> Vec<u8> {
    let mut json = json.to_string().into_bytes();
    json.resize(json.len().next_multiple_of(4), b' ');
    let mut binary = binary.to_vec();
    binary.resize(binary.len().next_multiple_of(4), 0);
    let mut file = b"glTF\x02\0\0\0".to_vec();
    let length = 12 + 8 + json.len() + 8 + binary.len();
    file.extend((length as u32).to_le_bytes());
    for (kind, chunk) in [(b"JSON", json), (b"BIN\0", binary)] {
        file.extend((chunk.len() as u32).to_le_bytes());
        file.extend(kind);
        file.extend(chunk);
    }
    file
}

fn base64(bytes: &[u8]) -> String {
    const LETTERS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::new();
    for group in bytes.chunks(3) {
        let mut padded = [0; 4];
        padded[1..=group.len()].copy_from_slice(group);
        let bits = u32::from_be_bytes(padded);
        for place in 0..4 {
            let letter = LETTERS[(bits >> (18 - 6 * place)) as usize % 64];
            text.push(if place > group.len() {
                '='
            } else {
                letter.into()
            });
        }
    }
    text
}

fn mesh(json: &Value) -> Mesh {
    let data = read(&glb(json, &square_bytes()), 1000).unwrap();
    data.mesh(&DAffine3::IDENTITY, true)
}

fn refused(json: &Value) -> String {
    read(&glb(json, &square_bytes()), 1000).unwrap_err()
}

#[test]
fn positions_normals_and_texture_coordinates_are_read() {
    let mesh = mesh(&square());
    assert_eq!((mesh.face_count(), mesh.vertex_count()), (2, 4));
    assert_eq!(mesh.face_normals(1), [DVec3::Z; 3]);
    assert_eq!(mesh.normal(0), DVec3::Z);
    for (&vertex, uv) in mesh.face(1).iter().zip(mesh.face_uvs(1)) {
        assert_eq!(mesh.position(vertex).truncate(), *uv);
    }
}

#[test]
fn a_text_file_with_its_buffer_in_it_holds_the_same() {
    let mut json = square();
    for length in [139, 140] {
        let bytes = &square_bytes()[..length];
        json["buffers"][0]["uri"] =
            format!("data:application/octet-stream;base64,{}", base64(bytes)).into();
        let read = read(json.to_string().as_bytes(), 1000);
        match length {
            140 => assert_eq!(
                read.unwrap().mesh(&DAffine3::IDENTITY, true),
                mesh(&square())
            ),
            _ => assert_eq!(
                read.unwrap_err(),
                "buffers[0] has 139 bytes, not the 140 that it says"
            ),
        }
    }
    json["buffers"][0]["uri"] = "../secret.bin".into();
    let message = read(json.to_string().as_bytes(), 1000).unwrap_err();
    assert!(
        message.contains("\"../secret.bin\"; only buffers within the file"),
        "{message}"
    );
}

#[test]
fn nodes_place_their_meshes_and_mirrors_keep_the_front() {
    let mut json = square();
    json["nodes"] = json!([
        { "children": [1, 2], "translation": [10, 0, 0] },
        { "mesh": 0, "rotation": [0, 0.5, 0, 0.5], "scale": [1, 2, 3] },
        { "mesh": 0, "matrix": [-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 5, 1] }
    ]);
    let mesh = mesh(&json);
    assert_eq!(mesh.face_count(), 4);
    let near = |a: DVec3, b: [f64; 3]| assert!(a.distance(b.into()) < 1e-6, "{a} {b:?}");
    // (1, 1, 0): scaled (1, 2, 0), about y (0, 2, -1), moved (10, 2, -1)
    near(mesh.position(mesh.face(0)[2]), [10.0, 2.0, -1.0]);
    near(mesh.normal(0), [1.0, 0.0, 0.0]);
    near(mesh.face_normals(0)[0], [1.0, 0.0, 0.0]);
    near(mesh.position(mesh.face(2)[0]), [10.0, 0.0, 5.0]);
    near(mesh.normal(2), [0.0, 0.0, 1.0]);
}

#[test]
fn strips_fans_sparse_lists_and_whole_numbers_are_read() {
    let mut json = square();
    let primitive =
        |json: &mut Value, key: &str, value: Value| json["meshes"][0]["primitives"][0][key] = value;
    // 0-1-2 and 1-3-2 of a strip; 0-1-2 and 0-2-3 of a fan, without indices
    primitive(&mut json, "indices", Value::Null);
    for (mode, second) in [(5, [1, 3, 2]), (6, [0, 2, 3])] {
        primitive(&mut json, "mode", mode.into());
        let mesh = mesh(&json);
        let corners: Vec<[f64; 3]> = mesh
            .face(1)
            .iter()
            .map(|&v| mesh.position(v).to_array())
            .collect();
        let expected = second.map(|i: usize| {
            [
                [0.0, 0.0, 0.0],
                [1.0, 0.0, 0.0],
                [1.0, 1.0, 0.0],
                [0.0, 1.0, 0.0],
            ][i]
        });
        assert_eq!(corners, expected);
    }
    // Corner 1 takes the place of position 2, by an index of the third list of the file
    let mut json = square();
    json["accessors"][0]["sparse"] = json!({
        "count": 1,
        "indices": { "bufferView": 2, "byteOffset": 2, "componentType": 5123 },
        "values": { "bufferView": 0, "byteOffset": 24 }
    });
    let sparse = mesh(&json);
    assert_eq!(sparse.face_count(), 1);
    json["accessors"][0]["sparse"]["count"] = 1000.into();
    assert!(refused(&json).contains("accessors[0] leaves its buffer"));
    // Bytes as shares of 255, spread: the high bytes of the first floats
    let mut json = square();
    json["accessors"][2] = json!({ "bufferView": 0, "byteOffset": 2, "componentType": 5121, "normalized": true, "count": 4, "type": "VEC2" });
    json["bufferViews"][0]["byteStride"] = 12.into();
    json["accessors"][1]["byteOffset"] = 48.into();
    let uvs = mesh(&json);
    // 1.0 is 0x3f800000.
    assert_eq!(uvs.face_uvs(0)[1], DVec2::new(128.0 / 255.0, 63.0 / 255.0));
}

#[test]
fn what_is_not_used_is_remarked() {
    let mut json = square();
    json["materials"] =
        json!([{ "name": "Red", "pbrMetallicRoughness": { "baseColorFactor": [0.8, 0, 0, 1] } }]);
    json["meshes"][0]["primitives"][0]["material"] = 7.into();
    json["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"] = 0.into();
    json["meshes"][0]["primitives"][0]["attributes"]["_WEAR"] = 0.into();
    json["animations"] = json!([{ "channels": [], "samplers": [] }]);
    json["cameras"] = json!([{ "type": "none" }]);
    json["extensionsUsed"] = json!(["KHR_materials_unlit"]);
    json["extensionsRequired"] = json!(["KHR_materials_unlit"]);
    let data = read(&glb(&json, &square_bytes()), 1000).unwrap();
    let remarks: Vec<&str> = data.remarks.iter().map(|remark| &*remark.what).collect();
    assert_eq!(
        remarks,
        [
            "1 animation",
            "1 camera",
            "COLOR_0, attributes of other names",
            "materials (\"Red\" of base colour [0.8, 0, 0])",
            "extensions (KHR_materials_unlit)",
        ]
    );
    assert!(
        read(&glb(&square(), &square_bytes()), 1000)
            .unwrap()
            .remarks
            .is_empty()
    );
}

#[test]
fn what_is_wrong_is_said_with_its_place() {
    let with = |change: &dyn Fn(&mut Value)| {
        let mut json = square();
        change(&mut json);
        refused(&json)
    };
    for (found, expected) in [
        (
            with(&|json| json["accessors"][0]["count"] = 9.into()),
            "primitive 0: accessors[0] leaves its buffer",
        ),
        (
            with(&|json| json["accessors"][0]["count"] = u64::MAX.into()),
            "primitive 0: accessors[0] has 18446744073709551615 entries",
        ),
        (
            with(&|json| json["accessors"][3]["byteOffset"] = u64::MAX.into()),
            "primitive 0: accessors[3] leaves its buffer",
        ),
        (
            with(&|json| json["accessors"][3]["type"] = "VEC2".into()),
            "primitive 0: accessors[3] has 2 numbers each, not 1",
        ),
        (
            with(&|json| json["accessors"][3]["count"] = 9000.into()),
            "found 3000 triangles; at most 1000 are allowed (--max-triangles)",
        ),
        (
            with(&|json| json["bufferViews"][0]["byteOffset"] = 100.into()),
            "primitive 0: accessors[0] leaves its buffer",
        ),
        (
            with(&|json| json["meshes"][0]["primitives"][0]["attributes"]["POSITION"] = 4.into()),
            "meshes[0].primitives[0] refers to accessor 4; the file has 4",
        ),
        (
            with(&|json| json["nodes"][0]["mesh"] = 1.into()),
            "nodes[0].mesh: index out of bounds",
        ),
        (
            with(&|json| json["nodes"][0]["children"] = json!([0])),
            "nodes[0] stands in two places",
        ),
        (
            with(&|json| json["nodes"][0]["mesh"] = Value::Null),
            "found no triangles",
        ),
        (
            with(&|json| json["scenes"] = json!([])),
            "scene: index out of bounds",
        ),
        (
            with(&|json| json["extensionsRequired"] = json!(["KHR_draco_mesh_compression"])),
            "the file needs what is not supported: KHR_draco",
        ),
        (
            with(&|json| json["asset"] = Value::Null),
            "found JSON that is no glTF 2.0",
        ),
    ] {
        assert!(found.starts_with(expected), "{found} {expected}");
    }
    assert!(
        read(b"PK\x03\x04", 9)
            .unwrap_err()
            .contains("a zip archive")
    );
    assert!(read(b"glTF\x01\0\0\0", 9).unwrap_err().contains("glTF 1.0"));
    assert!(
        read(b"glTF\x02\0\0\0\x01\0\0\0", 9)
            .unwrap_err()
            .contains("cut off")
    );
    assert!(read(b"v 0 0 0", 9).unwrap_err().contains("no glTF"));
}

#[test]
fn positions_that_are_no_numbers_are_refused_and_normals_dropped() {
    let mut bytes = square_bytes();
    bytes[48..52].copy_from_slice(&f32::NAN.to_le_bytes());
    bytes[60..72].fill(0);
    let data = read(&glb(&square(), &bytes), 1000).unwrap();
    assert_eq!(data.corners_without_normal(), 3);
    assert!(data.remarks[0].what.starts_with("2 normals or texture"));
    bytes[0..4].copy_from_slice(&f32::INFINITY.to_le_bytes());
    let message = read(&glb(&square(), &bytes), 1000).unwrap_err();
    assert!(message.contains("as a position"), "{message}");
}

proptest! {
    #[test]
    fn no_spoilt_file_makes_it_panic(
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 0..6),
        word in prop::sample::select(vec!["null", "-1", "0", "1", "9e99", "18446744073709551615", "[]", "{}", "\"\"", "\"VEC2\"", "5121"]),
        number in any::<prop::sample::Index>(),
        is_binary in any::<bool>(),
    ) {
        // One number of the text replaced, then bytes of the file
        let text = square().to_string();
        let numbers: Vec<(usize, &str)> = text
            .match_indices(|c: char| c.is_ascii_digit())
            .filter(|(at, _)| text.as_bytes()[at - 1] == b':' || text.as_bytes()[at - 1] == b'[')
            .collect();
        let (at, _) = numbers[number.index(numbers.len())];
        let end = at + text[at..].find(|c: char| !c.is_ascii_digit()).unwrap();
        let text = format!("{}{word}{}", &text[..at], &text[end..]);
        let json: Value = serde_json::from_str(&text).unwrap();
        let mut file = if is_binary { glb(&json, &square_bytes()) } else {
            let uri = format!("data:;base64,{}", base64(&square_bytes()));
            text.replace("\"byteLength\":140", &format!("\"byteLength\":140,\"uri\":\"{uri}\"")).into_bytes()
        };
        for (place, byte) in changes {
            let place = place.index(file.len());
            file[place] = byte;
        }
        if let Ok(data) = read(&file, 1000) {
            prop_assert!(data.positions.iter().all(|position| position.is_finite()));
            prop_assert!(data.uvs.iter().all(|uv| uv.is_finite()));
            prop_assert!(data.normals.iter().all(|normal| normal.is_finite()));
            prop_assert!(data.mesh(&DAffine3::IDENTITY, true).face_count() <= data.face_count());
        }
    }
}
