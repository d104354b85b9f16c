//! The workflow that publishes a release: it can be run on the forge alone, so what is checked here is that it is YAML of the right shape,
//! and that what it calls is there.

use serde_json::{Map, Value};
use std::fs;
use std::path::PathBuf;

fn root() -> PathBuf {
    env!("CARGO_MANIFEST_DIR").into()
}

/// Reads the part of YAML that workflows need: mappings and sequences by indentation, plain and quoted scalars, `[…]` in one line, and
/// texts of several lines behind `|`. Anything else panics.
struct Yaml<'a> {
    /// Indentation and contents; without comments and empty lines.
    lines: Vec<(usize, &'a str)>,
    next: usize,
}

impl<'a> Yaml<'a> {
    fn read(text: &'a str) -> Value {
        assert!(!text.contains('\t'), "tabs are no indentation");
        let lines = text.lines().map(|line| {
            let contents = line.trim_start();
            (line.len() - contents.len(), contents.trim_end())
        });
        let is_said = |(_, line): &(usize, &str)| !line.is_empty() && !line.starts_with('#');
        let lines = lines.filter(is_said).collect();
        let mut yaml = Yaml { lines, next: 0 };
        let value = yaml.value(0);
        assert_eq!(yaml.next, yaml.lines.len(), "line {:?}", yaml.line());
        value
    }

    fn line(&self) -> Option<(usize, &'a str)> {
        self.lines.get(self.next).copied()
    }

    /// What stands at exactly this indentation.
    fn value(&mut self, indent: usize) -> Value {
        match self.line() {
            Some((_, line)) if line.starts_with("- ") => self.sequence(indent),
            _ => self.mapping(indent),
        }
    }

    fn sequence(&mut self, indent: usize) -> Value {
        let mut items = Vec::new();
        while let Some((at, line)) = self.line().filter(|(at, _)| *at >= indent) {
            assert_eq!(at, indent, "{line}");
            let item = line.strip_prefix("- ").expect("an item");
            // An item is a mapping that begins behind its dash.
            self.lines[self.next] = (indent + 2, item);
            items.push(self.mapping(indent + 2));
        }
        items.into()
    }

    fn mapping(&mut self, indent: usize) -> Value {
        let mut entries = Map::new();
        while let Some((at, line)) = self.line().filter(|(at, _)| *at >= indent) {
            if line.starts_with("- ") {
                break;
            }
            assert_eq!(at, indent, "{line}");
            let (key, rest) = line.split_once(':').expect("a key");
            self.next += 1;
            let rest = rest.trim();
            let value = match (rest, self.line()) {
                ("", Some((deeper, _))) if deeper > indent => self.value(deeper),
                ("", _) => Value::Null,
                ("|", _) => {
                    let mut text = Vec::new();
                    while let Some((_, line)) = self.line().filter(|(at, _)| *at > indent) {
                        text.push(line);
                        self.next += 1;
                    }
                    text.join("\n").into()
                }
                (scalar, _) => scalar_of(scalar),
            };
            let before = entries.insert(key.to_owned(), value);
            assert!(before.is_none(), "{key} is there twice");
        }
        assert!(!entries.is_empty(), "a mapping at {:?}", self.line());
        entries.into()
    }
}

fn scalar_of(text: &str) -> Value {
    if let Some(items) = text
        .strip_prefix('[')
        .and_then(|text| text.strip_suffix(']'))
    {
        return items
            .split(',')
            .map(|item| scalar_of(item.trim()))
            .collect();
    }
    match text {
        "true" => true.into(),
        "false" => false.into(),
        _ => {
            // Such a text would mean something else.
            assert!(
                !text.starts_with(['{', '&', '*', '!', '>', '%', '@', '`']),
                "{text}"
            );
            assert!(!text.contains(": ") && !text.contains(" #"), "{text}");
            text.trim_matches('"').into()
        }
    }
}

/// The commands of all steps of a job, and the actions that it uses.
fn steps(job: &Value) -> (Vec<&str>, Vec<&str>) {
    let steps = job["steps"].as_array().expect("steps");
    let of = |key: &str| steps.iter().filter_map(|step| step[key].as_str()).collect();
    for step in steps {
        let [runs, uses] = ["run", "uses"].map(|key| step[key].is_string());
        assert!(runs != uses, "{step}");
        let known = ["run", "uses", "with", "env"];
        assert!(
            step.as_object()
                .unwrap()
                .keys()
                .all(|key| known.contains(&key.as_str())),
            "{step}"
        );
    }
    (of("run"), of("uses"))
}

#[test]
fn a_tag_publishes_the_page_and_the_program_for_three_systems() {
    let text = fs::read_to_string(root().join(".github/workflows/publish.yml")).unwrap();
    let workflow = Yaml::read(&text);
    assert_eq!(
        workflow["on"],
        serde_json::json!({ "push": { "tags": ["v*"] } })
    );
    assert_eq!(workflow["permissions"]["contents"], "write");
    let jobs = workflow["jobs"].as_object().unwrap();
    let names: Vec<&String> = jobs.keys().collect();
    let mut systems = Vec::new();
    for (name, job) in jobs {
        let needed = job["needs"].as_array().into_iter().flatten();
        assert!(
            needed
                .clone()
                .all(|need| names.iter().any(|name| need == *name))
        );
        match job["runs-on"].as_str().unwrap() {
            "${{ matrix.system }}" => {
                let matrix = job["strategy"]["matrix"]["include"].as_array().unwrap();
                systems.extend(matrix.iter().map(|one| one["system"].as_str().unwrap()));
            }
            system => assert_eq!(system, "ubuntu-latest"),
        }
        let (commands, actions) = steps(job);
        for action in actions {
            let (_, version) = action.split_once('@').expect(action);
            assert!(
                action.starts_with("actions/") && version.starts_with('v'),
                "{action}"
            );
        }
        // What is uploaded was made before.
        let made = commands.join("\n");
        for step in job["steps"].as_array().unwrap() {
            let uploads = step["uses"]
                .as_str()
                .is_some_and(|action| action.contains("upload-"));
            let path = step["with"]["path"].as_str().unwrap_or_default();
            assert!(
                !uploads || made.contains(&format!("tar -czf {path} ")),
                "{name}: {path}"
            );
        }
        let scripts = made
            .split_whitespace()
            .filter(|word| word.starts_with(".ci/"));
        scripts.for_each(is_a_script);
    }
    assert_eq!(systems, ["ubuntu-latest", "macos-latest", "windows-latest"]);
    let (commands, _) = steps(&jobs["program"]);
    assert!(commands.contains(&"cargo build --release --locked"));
    let (commands, _) = steps(&jobs["page"]);
    assert!(commands.contains(&".ci/web site"));
    let release = &jobs["release"];
    assert_eq!(release["needs"], serde_json::json!(["page", "program"]));
}

/// The file is there, and can be started.
fn is_a_script(path: &str) {
    let file = root().join(path);
    let text = fs::read_to_string(&file).unwrap_or_else(|why| panic!("{path}: {why}"));
    assert!(text.starts_with("#!"), "{path}");
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        let mode = fs::metadata(&file).unwrap().permissions().mode();
        assert!(mode & 0o111 != 0, "{path} cannot be started");
    }
}

#[test]
fn the_readme_puts_the_page_on_a_course_page_with_scripts_that_exist() {
    let readme = fs::read_to_string(root().join("README.md")).unwrap();
    let (_, section) = readme
        .split_once("## Put it on your course page\n")
        .expect("the section");
    let section = section.split("\n## ").next().unwrap();
    let lines = section.lines().filter(|line| !line.is_empty()).count();
    assert!((8..=12).contains(&lines), "{lines} lines");
    assert!(section.contains("`.ci/web site`") && section.contains("python3 -m http.server"));
    is_a_script(".ci/web");
    // A link in it leads to a lesson that there is.
    let (_, id) = section.split_once("#lesson=").expect("a link to a step");
    let id = id.split(['&', '`']).next().unwrap();
    assert!(lightwalk::lesson::builtin(id).is_some(), "{id}");
}

#[test]
fn what_is_no_yaml_of_that_kind_is_found() {
    let read = |text: &'static str| std::panic::catch_unwind(|| Yaml::read(text));
    assert_eq!(
        read("a:\n  - b: [x, y]\n    c: |\n      one: 1\n      two\n  - d: true\n").unwrap(),
        serde_json::json!({ "a": [{ "b": ["x", "y"], "c": "one: 1\ntwo" }, { "d": true }] })
    );
    for wrong in [
        "a:\n   b: 1\n  c: 2\n",
        "a: 1\na: 2\n",
        "a: b: c\n",
        "a\n",
        "\ta: 1\n",
    ] {
        assert!(read(wrong).is_err(), "{wrong}");
    }
}
