//! Every panel of every narrated step of every lesson, as a display list in text: a file a lesson and panel.

use crate::change::changes;
use crate::delta::{Section, read, write};
use crate::display_list;
use crate::files::{self, golden, updating};
use crate::pictures;
use crate::walk::Walk;
use lightwalk::panels::strings::Language;
use std::fs;

/// How a lesson's panels differ from the golden texts and pictures, in words.
fn differences(lesson: &str) -> Vec<String> {
    let mut walk = Walk::of(lesson);
    let mut differences = Vec::new();
    for panel in walk.panels() {
        let new: Vec<Section> = (0..walk.narrated.len())
            .map(|index| {
                // Both languages have their turn.
                let language = Language::ALL[index % 2];
                let picture = walk.panel(index, panel, language, 1.0);
                assert!(
                    !picture.alt.is_empty(),
                    "{lesson}: {} has no alternative text",
                    panel.name()
                );
                Section {
                    heading: format!("{index:02} {}", language.code()),
                    lines: display_list::lines(&picture),
                }
            })
            .collect();
        let name = format!("lists/{lesson}/{}.txt", panel.name());
        if updating() {
            files::write(&golden(&name), write(&new).as_bytes());
            continue;
        }
        let Ok(text) = fs::read_to_string(golden(&name)) else {
            differences.push(format!("{name}: there is no golden text"));
            continue;
        };
        let old = read(&text);
        if old.len() != new.len() {
            let (new, old) = (new.len(), old.len());
            differences.push(format!("{name}: {new} steps instead of {old}"));
        }
        for (old, new) in old.iter().zip(&new) {
            let changes = changes(&old.lines, &new.lines);
            if !changes.is_empty() {
                let changes = changes.join("\n    ");
                differences.push(format!("{name}, step {}:\n    {changes}", new.heading));
            }
        }
    }
    differences.extend(pictures::differences(lesson, &mut walk));
    differences
}

/// A test a lesson: they run side by side.
macro_rules! lessons {
    ($($name:ident $id:literal $_path:literal,)*) => {
        $(
            #[test]
            fn $name() {
                let differences = differences($id);
                assert!(differences.is_empty(), "{}", differences.join("\n"));
            }
        )*
    };
}
include!(concat!(env!("OUT_DIR"), "/lessons.rs"));
