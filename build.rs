//! Lists the lessons of `lessons/`, and the meshes and scenes that they may name, for `src/lesson/builtin.rs` to embed.

use std::path::{Path, PathBuf};
use std::{env, fs, io};

fn main() -> io::Result<()> {
    let lessons = folder("CARGO_MANIFEST_DIR")?.join("lessons");
    let mut list = String::from("lessons! {\n");
    for path in files(&lessons, "json")? {
        // 05-gouraud-teapot.json: its number, its id
        let name = stem(&path);
        let id = name.trim_start_matches(|c: char| c.is_ascii_digit() || c == '-');
        let identifier = id.replace('-', "_");
        list += &format!("    {identifier} {id:?} {path:?},\n");
    }
    list += "}\n";

    let mut embedded = String::from("&[\n");
    for (folder, extension) in [("meshes", "obj"), ("scenes", "json")] {
        for path in files(&lessons.join(folder), extension)? {
            let name = format!("{folder}/{}.{extension}", stem(&path));
            embedded += &format!("    ({name:?}, include_bytes!({path:?})),\n");
        }
    }
    embedded += "]\n";

    let out = folder("OUT_DIR")?;
    fs::write(out.join("lessons.rs"), list)?;
    fs::write(out.join("lesson_files.rs"), embedded)
}

fn folder(variable: &str) -> io::Result<PathBuf> {
    env::var(variable)
        .map(PathBuf::from)
        .map_err(io::Error::other)
}

fn stem(path: &Path) -> String {
    path.file_stem()
        .unwrap_or_default()
        .to_string_lossy()
        .into_owned()
}

/// The files of a folder with that extension, by name. Cargo runs this script again when one comes, changes or goes.
fn files(folder: &Path, extension: &str) -> io::Result<Vec<PathBuf>> {
    println!("cargo::rerun-if-changed={}", folder.display());
    let entries = fs::read_dir(folder)?.map(|entry| Ok(entry?.path()));
    let mut files = entries.collect::<io::Result<Vec<_>>>()?;
    files.retain(|path| path.extension().is_some_and(|found| found == extension));
    files.sort();
    Ok(files)
}
