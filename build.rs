//! Lists the lessons of `lessons/`, and the meshes and scenes that they may name, for `src/lesson/builtin.rs` to embed; and the
//! panels of `src/panels/`, for its `mod.rs`.

use std::path::{Path, PathBuf};
use std::{env, fs, io};

fn main() -> io::Result<()> {
    let root = folder("CARGO_MANIFEST_DIR")?;
    list_lessons(&root.join("lessons"))?;
    list_panels(&root.join("src/panels"))
}

/// Each file but `mod.rs` is a panel of that name: `ray_tree.rs` is `RayTree: ray_tree "ray-tree"`.
fn list_panels(folder: &Path) -> io::Result<()> {
    let mut modules = String::new();
    let mut list = String::new();
    let panels = files(folder, "rs")?;
    let panels = panels.iter().map(|path| stem(path));
    for module in panels.filter(|name| name != "mod") {
        let words: String = module.split('_').map(capitalized).collect();
        modules += &format!("    pub mod {module};\n");
        list += &format!("    {words}: {module} {:?},\n", module.replace('_', "-"));
    }
    let text = format!(
        "#[path = {folder:?}]\nmod list {{\n    use super::*;\n\n{modules}}}\n\npanels! {{\n{list}}}\n"
    );
    fs::write(out()?.join("panels.rs"), text)
}

fn capitalized(word: &str) -> String {
    let (first, rest) = word.split_at(word.len().min(1));
    first.to_uppercase() + rest
}

fn list_lessons(lessons: &Path) -> io::Result<()> {
    let mut list = String::from("lessons! {\n");
    for path in files(lessons, "json")? {
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

    fs::write(out()?.join("lessons.rs"), list)?;
    fs::write(out()?.join("lesson_files.rs"), embedded)
}

fn out() -> io::Result<PathBuf> {
    folder("OUT_DIR")
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
