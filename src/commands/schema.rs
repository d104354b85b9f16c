//! `lightwalk schema`: JSON Schemas of scene files, of lesson files, and of the lines that `steps` prints.

use super::failure::Failure;
use crate::language::Language;
use crate::lesson::lesson_schema;
use crate::scene::scene_schema;
use crate::vocabulary::FAMILIES;
use serde_json::{Map, Value, json};
use std::collections::{BTreeMap, BTreeSet};
use std::io::Write;

#[derive(clap::Args)]
pub struct Arguments {
    /// Scene files, lesson files, or the lines that `steps` prints
    of: Described,
}

#[derive(Clone, Copy, clap::ValueEnum)]
enum Described {
    Scene,
    Lesson,
    Steps,
}

pub fn run(arguments: Arguments) -> Result<(), Failure> {
    let schema = match arguments.of {
        Described::Scene => scene_schema(),
        Described::Lesson => lesson_schema(),
        Described::Steps => steps_schema(),
    };
    Ok(writeln!(std::io::stdout(), "{schema:#}")?)
}

/// Of a step as one line, from the vocabulary of all kinds of events.
fn steps_schema() -> Value {
    let mut values: BTreeMap<&str, BTreeSet<&str>> = BTreeMap::new();
    let mut meanings: BTreeMap<&str, BTreeSet<String>> = BTreeMap::new();
    for kind in FAMILIES.into_iter().flatten() {
        let of_kind = values.entry(kind.name).or_default();
        for quantity in kind.quantities {
            of_kind.insert(quantity.name);
            let meaning = kind.meaning(quantity.name, Language::English);
            meanings.entry(quantity.name).or_default().extend(meaning);
        }
    }
    let described = values.into_iter().map(|(kind, values)| {
        let values: Vec<&str> = values.into_iter().collect();
        let description = match values.is_empty() {
            true => "It has no values of its own.".to_owned(),
            false => format!("Its own values: {}.", values.join(", ")),
        };
        json!({ "const": kind, "description": description })
    });
    let whole = |what: &str| json!({ "type": "integer", "minimum": 0, "description": what });
    let mut properties = Map::new();
    properties.insert("step".into(), whole("The number of the step, from 0."));
    properties.insert(
        "depth".into(),
        whole("How many scopes lie around the step."),
    );
    properties.insert(
        "kind".into(),
        json!({ "oneOf": described.collect::<Vec<_>>() }),
    );
    for (name, meanings) in meanings {
        let meanings: Vec<String> = meanings.into_iter().collect();
        let value = json!({ "$ref": "#/$defs/Value", "description": meanings.join("; or ") });
        properties.insert(name.into(), value);
    }
    json!({
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "Lightwalk step",
        "description": "A line of `lightwalk steps`: an event, and the values that are known there, its own and those of the scopes around it.",
        "type": "object",
        "properties": properties,
        "required": ["step", "depth", "kind"],
        "additionalProperties": false,
        "$defs": { "Value": {
            "description": "A number (null where it is not finite), true or false, a word, or the three channels of a colour or coordinates of a vector.",
            "anyOf": [
                { "type": ["number", "null", "boolean", "string"] },
                { "type": "array", "items": { "type": ["number", "null"] }, "minItems": 3, "maxItems": 3 },
            ],
        } },
    })
}
