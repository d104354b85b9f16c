//! The smallest mesh in glTF, as JSON and as binary.

use serde_json::{Value, json};

/// A triangle in two places, whose buffer goes into a binary file: three positions, then three indices.
pub fn triangle() -> Value {
    json!({
        "asset": { "version": "2.0" },
        "scene": 0,
        "scenes": [{ "nodes": [0] }],
        "nodes": [{ "mesh": 0, "translation": [0, 1, 0], "children": [1] }, { "mesh": 0, "scale": [2, 1, 1] }],
        "meshes": [{ "primitives": [{ "attributes": { "POSITION": 0 }, "indices": 1 }] }],
        "accessors": [
            { "bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0] },
            { "bufferView": 1, "componentType": 5123, "count": 3, "type": "SCALAR" }
        ],
        "bufferViews": [
            { "buffer": 0, "byteLength": 36 },
            { "buffer": 0, "byteOffset": 36, "byteLength": 6 }
        ],
        "buffers": [{ "byteLength": 42 }]
    })
}

/// The triangle with its buffer in it.
pub fn gltf() -> Value {
    let mut document = triangle();
    // 1 is 00 00 80 3f; what is not said is 0.
    let data = "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAABAAIA";
    document["buffers"][0]["uri"] = json!(format!("data:application/octet-stream;base64,{data}"));
    document
}

/// A binary file of the triangle, or of what became of it.
pub fn glb(json: &Value) -> Vec<u8> {
    let mut binary = Vec::new();
    for position in [[0_f32, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]] {
        binary.extend(position.into_iter().flat_map(f32::to_le_bytes));
    }
    binary.extend([0_u16, 1, 2].into_iter().flat_map(u16::to_le_bytes));
    let mut file = b"glTF\x02\0\0\0\0\0\0\0".to_vec();
    for (kind, mut chunk, fill) in [
        (b"JSON", json.to_string().into_bytes(), b' '),
        (b"BIN\0", binary, 0),
    ] {
        chunk.resize(chunk.len().next_multiple_of(4), fill);
        file.extend((chunk.len() as u32).to_le_bytes());
        file.extend(kind);
        file.extend(chunk);
    }
    let length = file.len() as u32;
    file[8..12].copy_from_slice(&length.to_le_bytes());
    file
}
