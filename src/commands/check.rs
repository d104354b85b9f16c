//! `lightwalk check`: are these files right?

use super::arguments::LimitArguments;
use super::failure::Failure;
use super::files::{self, Document};
use super::notes;
use super::progress::named;
use crate::methods;
use crate::scene::{Limits, Note};
use serde_json::{Value as Json, json};
use std::io::Write;
use std::path::{Path, PathBuf};

#[derive(clap::Args)]
pub struct Arguments {
    /// Lesson and scene files
    #[arg(required = true, value_name = "FILE")]
    files: Vec<PathBuf>,
    /// Prints a JSON object a file, with its problems and notes
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    limits: LimitArguments,
}

/// What was found in a file that is right.
struct Found {
    /// What it holds, by kind and count.
    counts: Json,
    summary: String,
    notes: Vec<Note>,
}

/// Every file is checked, also after a wrong one.
pub fn run(arguments: Arguments) -> Result<(), Failure> {
    let limits = arguments.limits.into();
    let mut problems = Vec::new();
    let mut out = std::io::stdout();
    for path in &arguments.files {
        let name = path.display();
        match check(path, &limits) {
            Ok(found) => {
                notes::print(&name, &found.notes);
                if arguments.json {
                    let mut recorded = json!({ "file": name.to_string(), "right": true, "problems": [], "notes": found.notes });
                    if let (Json::Object(recorded), Json::Object(counts)) =
                        (&mut recorded, found.counts)
                    {
                        recorded.extend(counts);
                    }
                    writeln!(out, "{recorded}")?;
                } else {
                    writeln!(out, "{name}: right ({})", found.summary)?;
                }
            }
            Err(failure) => {
                let message = failure.to_string();
                if arguments.json {
                    let lines: Vec<&str> = message.lines().collect();
                    let recorded = json!({ "file": name.to_string(), "right": false, "problems": lines, "notes": [] });
                    writeln!(out, "{recorded}")?;
                }
                problems.push(message);
            }
        }
    }
    if problems.is_empty() {
        Ok(())
    } else {
        Err(Failure::Wrong(problems.join("\n")))
    }
}

fn check(path: &Path, limits: &Limits) -> Result<Found, Failure> {
    match files::document(path, limits)? {
        Document::Scene(scene) => {
            let (objects, lights) = (scene.objects.len(), scene.lights.len());
            Ok(Found {
                counts: json!({ "kind": "scene", "objects": objects, "lights": lights }),
                summary: format!(
                    "scene, {}, {}",
                    counted(objects, "object"),
                    counted(lights, "light")
                ),
                notes: methods::notes_of(&scene, limits.max_patches),
            })
        }
        Document::Lesson(lesson) => {
            let run = || lesson.check_parameters().and_then(|()| lesson.open());
            let open = named(&format!("running {}", path.display()), run)
                .map_err(|error| files::wrong(&path.display(), &error))?;
            let (steps, narrated) = (open.run.walk().len(), open.narrated.len());
            Ok(Found {
                counts: json!({ "kind": "lesson", "steps": steps, "narrated": narrated }),
                summary: format!("lesson, {steps} steps, {narrated} narrated"),
                notes: {
                    let mut notes = open.setup.notes(open.lesson.method);
                    notes.extend(open.lesson.missing);
                    notes
                },
            })
        }
    }
}

/// `1 light`, `2 lights`
fn counted(count: usize, what: &str) -> String {
    let ending = if count == 1 { "" } else { "s" };
    format!("{count} {what}{ending}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_thing_is_no_plural() {
        assert_eq!(counted(1, "light"), "1 light");
        assert_eq!(counted(0, "light"), "0 lights");
    }
}
