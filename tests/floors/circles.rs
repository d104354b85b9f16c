//! No files of a folder use each other in a circle.

use super::{paths, sources, tree};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

/// The floors in whose folders no files use each other in a circle.
const WITHOUT_CIRCLES: [&str; 4] = ["algorithms", "app", "commands", "lesson"];

/// The path of a file's module, without `crate`.
fn module_of(relative: &Path) -> Vec<String> {
    let without_ending = relative.with_extension("");
    let names = without_ending.iter().map(|name| name.to_str().unwrap());
    let mut path: Vec<String> = names.map(str::to_owned).collect();
    path.pop_if(|name| name == "mod");
    path
}

/// The paths that a module names, without `crate`; comments and tests, which stand at its end, aside.
fn named_by(module: &[String], source: &str) -> Vec<Vec<String>> {
    let source = source
        .split("#[cfg(test)]\nmod tests {")
        .next()
        .unwrap_or_default();
    let lines = source.lines();
    let code: Vec<&str> = lines
        .filter(|line| !line.trim_start().starts_with("//"))
        .collect();
    let source = &code.join("\n");
    let split = |path: String| path.split("::").map(str::to_owned).collect::<Vec<_>>();
    let mut named: Vec<Vec<String>> = paths(source).into_iter().map(split).collect();
    for (at, _) in source.match_indices("super::") {
        if source[..at].ends_with("super::") {
            continue;
        }
        let (mut above, mut rest) = (module, &source[at..]);
        while let Some(behind) = rest.strip_prefix("super::") {
            above = above.split_last().map_or(above, |(_, above)| above);
            rest = behind;
        }
        let mut paths = Vec::new();
        tree(rest, "", &mut paths);
        named.extend(paths.into_iter().map(|path| [above, &split(path)].concat()));
    }
    named
}

/// Which modules of a folder use which others of it.
type Uses = BTreeMap<String, BTreeSet<String>>;

/// What modules, each with its path and source, use of those beside them, by folder.
fn uses(modules: &[(Vec<String>, String)]) -> BTreeMap<Vec<String>, Uses> {
    let parents = |path: &[String]| (1..=path.len()).map(|end| path[..end].to_vec()).collect();
    let known: BTreeSet<Vec<String>> = modules
        .iter()
        .flat_map(|(path, _)| -> Vec<Vec<String>> { parents(path) })
        .collect();
    let mut uses: BTreeMap<Vec<String>, Uses> = BTreeMap::new();
    for (module, source) in modules {
        for named in named_by(module, source) {
            let common = module
                .iter()
                .zip(&named)
                .take_while(|(a, b)| a == b)
                .count();
            let (Some(own), Some(other)) = (module.get(common), named.get(common)) else {
                continue;
            };
            if common > 0 && known.contains(&named[..=common]) {
                let folder = uses.entry(module[..common].to_vec()).or_default();
                folder.entry(own.clone()).or_default().insert(other.clone());
            }
        }
    }
    uses
}

/// What is left without the modules that use none of the others, or that none of the others uses.
fn circles(mut uses: Uses) -> Uses {
    loop {
        let users: BTreeSet<String> = uses.keys().cloned().collect();
        let used: BTreeSet<String> = uses.values().flatten().cloned().collect();
        uses.values_mut()
            .for_each(|others| others.retain(|other| users.contains(other)));
        let count = uses.len();
        uses.retain(|own, others| used.contains(own) && !others.is_empty());
        if uses.len() == count {
            return uses;
        }
    }
}

#[test]
fn no_files_of_a_folder_use_each_other_in_a_circle() {
    let src = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut modules = Vec::new();
    for floor in WITHOUT_CIRCLES {
        for file in sources(&src.join(floor)) {
            let module = module_of(file.strip_prefix(&src).unwrap());
            if module.iter().all(|name| name != "tests") {
                modules.push((module, fs::read_to_string(&file).unwrap()));
            }
        }
    }
    let mut used = 0;
    for (folder, uses) in uses(&modules) {
        used += uses.values().map(BTreeSet::len).sum::<usize>();
        let circles = circles(uses);
        assert!(
            circles.is_empty(),
            "in {} these use each other in a circle: {circles:#?}. Move what they share to a third file",
            folder.join("/")
        );
    }
    assert!(used > 300, "only {used} uses were found");
}

#[test]
fn the_check_of_circles_sees_what_it_should() {
    let module = |path: &str, source: &str| {
        let path = path.split("::").map(str::to_owned).collect();
        (path, source.to_owned())
    };
    let modules = [
        module("app", "mod a; mod b; mod c;"),
        module("app::a", "use super::{b::{self, B}, Session};"),
        module(
            "app::b",
            "use super::c::d::D;\n/// As [`super::e`]\nfn b() {}",
        ),
        module("app::c", "mod d;"),
        module("app::c::d", "use super::super::a::A;"),
        module(
            "app::e",
            "use crate::app::a::A;\nuse crate::lesson::Lesson;",
        ),
        module(
            "app::f",
            "#[cfg(test)]\nmod tests {\n    use super::super::f;",
        ),
    ];
    let found = uses(&modules);
    let folders: Vec<String> = found.keys().map(|folder| folder.join("::")).collect();
    assert_eq!(folders, ["app"]);
    let circles = circles(found.into_values().next().unwrap());
    let names: Vec<&String> = circles.keys().collect();
    assert_eq!(names, ["a", "b", "c"]);
}
