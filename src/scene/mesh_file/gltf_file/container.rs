//! The JSON of a glTF file and the bytes of its buffers, which must lie in the file itself.

use super::super::kind::kind_of;
use gltf::json::validation::Validate;
use gltf::json::{Path, Root};
use gltf::{Document, Gltf};
use std::borrow::Cow;

pub(super) struct Container {
    pub json: Root,
    /// The binary part of a .glb file.
    pub blob: Option<Vec<u8>>,
}

pub(super) fn open(bytes: &[u8]) -> Result<Container, String> {
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    let is_binary = bytes.starts_with(b"glTF");
    if let Some(kind) = kind_of(bytes).filter(|_| !is_binary) {
        return Err(format!("found {kind} in place of a glTF file"));
    }
    if is_binary {
        let word = |at: usize| Some(u32::from_le_bytes(*bytes.get(at..at + 4)?.first_chunk()?));
        match word(4) {
            Some(1) => return Err("found glTF 1.0; version 2.0 is read".into()),
            Some(_) => {}
            None => return Err("the file ends in its header".into()),
        }
        // The whole length stands behind the version.
        if word(8).is_none_or(|length| length < 20 || length as usize > bytes.len()) {
            return Err(
                "found a length in its header that is not that of the file; it may be cut off"
                    .into(),
            );
        }
    }
    let gltf = Gltf::from_slice_without_validation(bytes).map_err(|error| match error {
        gltf::Error::Deserialize(error) => format!("found JSON that is no glTF 2.0: {error}"),
        gltf::Error::Binary(error) => format!("found a binary glTF that cannot be read: {error}"),
        _ => "found a file that cannot be read as glTF".into(),
    })?;
    Ok(Container {
        json: gltf.document.into_json(),
        blob: gltf.blob,
    })
}

/// The document, all its indices known to be right.
pub(super) fn checked(json: Root) -> Result<Document, String> {
    // The crate's own check reads the accessors of positions before it has checked their index.
    let accessors = json.accessors.len();
    for (mesh, of) in json.meshes.iter().enumerate() {
        for (primitive, of) in of.primitives.iter().enumerate() {
            let indices = of.attributes.values().chain(&of.indices);
            if let Some(index) = indices
                .map(|index| index.value())
                .find(|&index| index >= accessors)
            {
                return Err(format!(
                    "meshes[{mesh}].primitives[{primitive}] refers to accessor {index}; the file has {accessors}"
                ));
            }
        }
    }
    let mut problem = None;
    json.validate(&json, Path::new, &mut |path, error| {
        let path = path();
        // Bounds of positions are not used.
        let is_bound = [".min", ".max"]
            .iter()
            .any(|end| path.as_str().ends_with(end));
        if !is_bound && problem.is_none() {
            problem = Some(format!("{path}: {}", error.to_string().to_lowercase()));
        }
    });
    match problem {
        Some(problem) => Err(problem),
        None => Ok(Document::from_json_without_validation(json)),
    }
}

/// The bytes of each buffer.
pub(super) fn buffers(
    document: &Document,
    blob: Option<Vec<u8>>,
) -> Result<Vec<Cow<'static, [u8]>>, String> {
    let mut blob = blob;
    let read = |buffer: gltf::Buffer| {
        let place = format!("buffers[{}]", buffer.index());
        let mut bytes = match buffer.source() {
            gltf::buffer::Source::Bin => blob.take().ok_or_else(|| {
                format!("{place} is to be in the binary part of the file, which has none for it")
            })?,
            gltf::buffer::Source::Uri(uri) => embedded(uri).ok_or_else(|| {
                let (start, more) = match uri.char_indices().nth(80) {
                    Some((end, _)) => (&uri[..end], "…"),
                    None => (uri, ""),
                };
                format!(
                    "{place} is in another file, \"{start}{more}\"; only buffers within the file are read: save as .glb, or as .gltf with embedded buffers"
                )
            })?,
        };
        if bytes.len() < buffer.length() {
            return Err(format!(
                "{place} has {} bytes, not the {} that it says",
                bytes.len(),
                buffer.length()
            ));
        }
        bytes.truncate(buffer.length());
        Ok(Cow::Owned(bytes))
    };
    document.buffers().map(read).collect()
}

/// The bytes of a data URI in base 64 (RFC 2397, RFC 4648).
fn embedded(uri: &str) -> Option<Vec<u8>> {
    let (kind, text) = uri.strip_prefix("data:")?.split_once(',')?;
    kind.ends_with(";base64").then_some(())?;
    let text = text.trim_end_matches('=').as_bytes();
    let mut bytes = Vec::with_capacity(text.len() / 4 * 3 + 2);
    for group in text.chunks(4) {
        let mut bits = 0_u32;
        for &letter in group {
            let six = match letter {
                b'A'..=b'Z' => letter - b'A',
                b'a'..=b'z' => letter - b'a' + 26,
                b'0'..=b'9' => letter - b'0' + 52,
                b'+' => 62,
                b'/' => 63,
                _ => return None,
            };
            bits = bits << 6 | u32::from(six);
        }
        bits <<= 6 * (4 - group.len());
        bytes.extend_from_slice(&bits.to_be_bytes()[1..group.len()]);
    }
    Some(bytes)
}
