//! Which mesh paths a scene file may name: those that stay in its own folder.

/// Whether a path, as written in a scene file, is relative and stays in the folder of that file, on any system.
///
/// This reads the path alone. Who opens the file also follows symbolic links and compares again.
///
/// Errors: what was found and what is allowed, as a sentence.
pub fn mesh_path_is_inside(path: &str) -> Result<(), String> {
    let refused = |reason: &str| {
        Err(format!(
            "found {path:?}, {reason}; allowed is a path relative to the scene file and inside its folder, such as \"meshes/teapot.obj\""
        ))
    };
    if path.is_empty() {
        return refused("which is empty");
    }
    if path.starts_with('/') {
        return refused("an absolute path");
    }
    if path.contains('\\') {
        return refused("which has a backslash (folders are separated by `/`)");
    }
    if path.contains(':') {
        return refused("which names a drive or a protocol");
    }
    if path.contains(char::is_control) {
        return refused("which has a control character");
    }
    let mut depth = 0_usize;
    for part in path.split('/') {
        match part {
            "" | "." => (),
            ".." if depth == 0 => return refused("which leaves the folder"),
            ".." => depth -= 1,
            _ => depth += 1,
        }
    }
    match path.rsplit('/').next() {
        Some("" | "." | "..") => refused("which is a folder"),
        _ => Ok(()),
    }
}

/// How a mesh file is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::scene) enum Format {
    Obj,
    /// Binary, or JSON.
    Gltf,
}

/// The format of a mesh file, by the ending of its name.
pub(in crate::scene) fn mesh_format(path: &str) -> Result<Format, String> {
    let ending = path.rsplit_once('.').map_or("", |(_, ending)| ending);
    match ending.to_ascii_lowercase().as_str() {
        "obj" => Ok(Format::Obj),
        "gltf" | "glb" => Ok(Format::Gltf),
        _ => Err(format!(
            "found {path:?}; mesh files are Wavefront OBJ (.obj) and glTF (.glb, .gltf)"
        )),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_inside_the_folder_are_taken_and_others_refused() {
        for path in [
            "a.obj",
            "meshes/a.obj",
            "./a.obj",
            "b/../a.obj",
            "a b.obj",
            "..a.obj",
        ] {
            assert_eq!(mesh_path_is_inside(path), Ok(()), "{path}");
        }
        for (path, reason) in [
            ("", "empty"),
            ("/etc/passwd", "absolute"),
            ("../a.obj", "leaves the folder"),
            ("meshes/../../a.obj", "leaves the folder"),
            ("meshes\\a.obj", "backslash"),
            ("C:/a.obj", "drive"),
            ("a\0.obj", "control"),
            ("meshes/", "folder"),
            ("meshes/..", "folder"),
        ] {
            let message = mesh_path_is_inside(path).unwrap_err();
            assert!(message.contains(reason), "{path}: {message}");
        }
    }

    #[test]
    fn the_ending_says_the_format() {
        assert_eq!(mesh_format("a/Pot.OBJ"), Ok(Format::Obj));
        assert_eq!(mesh_format("a.glb"), Ok(Format::Gltf));
        assert_eq!(mesh_format("a.b/c.gltf"), Ok(Format::Gltf));
        assert!(mesh_format("a.stl").unwrap_err().contains(".glb"));
        assert!(mesh_format("obj").is_err());
    }
}
