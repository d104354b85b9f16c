//! What a file is that stands in the place of another, by its first bytes.

use super::lines::{Lines, text_of};

/// The kind of a file that is neither a scene nor an OBJ file, as a noun with its article.
pub(super) fn kind_of(bytes: &[u8]) -> Option<&'static str> {
    const BY_START: [(&[u8], &str); 19] = [
        (b"PK\x03\x04", "a zip archive"),
        (b"\x1f\x8b", "a gzip archive"),
        (b"7z\xbc\xaf\x27\x1c", "a 7z archive"),
        (b"Rar!", "a rar archive"),
        (b"glTF", "a binary glTF file (.glb)"),
        (b"ply\n", "a PLY file"),
        (b"ply\r", "a PLY file"),
        (b"Kaydara FBX", "an FBX file"),
        (b"BLENDER", "a Blender file"),
        (b"solid ", "an STL file"),
        (b"\x89PNG", "a PNG image"),
        (b"\xff\xd8\xff", "a JPEG image"),
        (b"GIF8", "a GIF image"),
        (b"PF\n", "a PFM image"),
        (b"II*\0", "a TIFF image"),
        (b"#?RADIANCE", "a Radiance HDR image"),
        (b"v/1\x01", "an OpenEXR image"),
        (b"%PDF", "a PDF document"),
        (
            b"version https://git-lfs.github.com/spec",
            "a Git LFS pointer (`git lfs pull` gets the file itself)",
        ),
    ];
    let text = text_of(&bytes[..bytes.len().min(4096)]);
    let text = text.trim_ascii_start();
    let starts =
        |start: &[u8]| text.len() >= start.len() && text[..start.len()].eq_ignore_ascii_case(start);
    if let Some((_, kind)) = BY_START.iter().find(|(start, _)| text.starts_with(start)) {
        return Some(kind);
    }
    if starts(b"<!doctype html") || starts(b"<html") || starts(b"<head") {
        return Some("a web page (HTML)");
    }
    if starts(b"<?xml") || starts(b"<collada") || starts(b"<svg") {
        return Some("an XML file");
    }
    None
}

/// Says what a file is that stands where a scene or lesson is wanted, if it is of a known kind.
pub(in crate::scene) fn misplaced(bytes: &[u8]) -> Option<String> {
    if let Some(kind) = kind_of(bytes) {
        return Some(format!(
            "found {kind}; scenes and lessons are JSON files that start with {{ \"schema\": 1"
        ));
    }
    is_obj(bytes).then(|| {
        "found a Wavefront OBJ file; a scene is a JSON file, one of whose objects names it: \"mesh\": { \"file\": \"NAME.obj\" }".into()
    })
}

/// Whether a text has lines `v x y z`.
fn is_obj(bytes: &[u8]) -> bool {
    let text = text_of(&bytes[..bytes.len().min(1 << 16)]);
    !text.trim_ascii_start().starts_with(b"{")
        && Lines::new(&text).any(|(_, line)| {
            let words = line.split(u8::is_ascii_whitespace);
            let mut words = words.filter(|word| !word.is_empty());
            let is_number = |word: &[u8]| {
                std::str::from_utf8(word).is_ok_and(|word| word.parse::<f64>().is_ok())
            };
            words.next() == Some(b"v") && words.clone().count() >= 3 && words.all(is_number)
        })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_no_scene_is_called_by_its_name() {
        let found = |bytes: &[u8]| misplaced(bytes).unwrap_or_default();
        assert!(found(b"# a cube\r\nv 0 0 1\r\n").contains("OBJ file"));
        assert!(found(b"\x89PNG\r\n\x1a\n").contains("PNG image"));
        assert!(found(b"{ \"schema\": 1,\nv 0 0 1").is_empty());
        assert!(found(b"v for victory").is_empty());
    }
}
