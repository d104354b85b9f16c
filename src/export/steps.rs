//! The steps of a run as lines of JSON: one object a step.

use super::making::Making;
use super::steps_table::latest;
use crate::record::Value;
use crate::replay::{Run, Walk};
use serde::ser::{Serialize, SerializeMap, Serializer};
use serde_json::{Value as Json, json};
use std::ops::Range;

/// Steps of one part of the file.
const PART: usize = 1024;

/// Of how many parts a run is.
pub(super) fn parts(run: &Run) -> usize {
    run.walk().len().div_ceil(PART)
}

/// The steps of a part.
pub(super) fn part(run: &Run, number: usize) -> Range<usize> {
    number * PART..run.walk().len().min((number + 1) * PART)
}

pub fn steps_in_lines(run: Run) -> Making<'static> {
    Making::new(parts(&run), move |number, out| {
        let walk = run.walk();
        part(&run, number).try_for_each(|step| {
            serde_json::to_writer(&mut *out, &Line { walk, step })?;
            writeln!(out)
        })
    })
}

/// A step as one JSON object: `step`, `depth`, `kind`, then all values known there, an inner scope's before an outer one's.
struct Line<'a> {
    walk: &'a dyn Walk,
    step: usize,
}

impl Serialize for Line<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut object = serializer.serialize_map(None)?;
        object.serialize_entry("step", &self.step)?;
        object.serialize_entry("depth", &self.walk.outline().depth(self.step))?;
        object.serialize_entry("kind", self.walk.kind(self.step))?;
        for field in latest(&self.walk.fields(self.step)) {
            object.serialize_entry(field.name, &json_of(field.value))?;
        }
        object.end()
    }
}

/// A number that is not finite becomes null: JSON has none.
fn json_of(value: Value) -> Json {
    match value {
        Value::Number(number) => json!(number),
        Value::Integer(integer) => json!(integer),
        Value::Rgb(color) => json!(color.channels()),
        Value::Vector(vector) => json!(vector.to_array()),
        Value::Truth(truth) => json!(truth),
        Value::Word(word) => json!(word),
    }
}
