//! The lines of a trace, each a JSON object.

use super::{TraceLine, TraceValue};
use crate::scene::document::ByName;
use crate::scene::what_the_parser_says;
use serde_json::Value as Json;

/// The steps of a trace. Empty lines are passed over, and so is a byte order mark; `step` and `depth` are those of the program that
/// wrote it. Errors: the first line that is none, and what would be right.
pub fn read(text: &str) -> Result<Vec<TraceLine>, String> {
    let text = text.trim_start_matches('\u{feff}');
    let lines = (1..).zip(text.lines());
    let traced = lines.filter(|(_, text)| !text.trim().is_empty());
    let trace: Vec<TraceLine> = traced
        .map(|(line, text)| step(line, text).map_err(|wrong| format!("line {line}{wrong}")))
        .collect::<Result<_, _>>()?;
    match trace.is_empty() {
        true => Err("there is no step in it: one JSON object a line is expected".into()),
        false => Ok(trace),
    }
}

fn step(line: usize, text: &str) -> Result<TraceLine, String> {
    let ByName(keys) = serde_json::from_str(text).map_err(|error| {
        let says = what_the_parser_says(&error, "the line");
        match error.column() {
            0 => format!(": {says}"),
            column => format!(", column {column}: {says}"),
        }
    })?;
    let kind = match keys.iter().find(|(key, _)| key == "kind") {
        Some((_, Json::String(kind))) => kind.clone(),
        Some((_, other)) => {
            return Err(format!(
                ": kind is {other}; it names the step by a text, as in {{\"kind\": \"Diffuse\"}}"
            ));
        }
        None => {
            return Err(
                ": the key `kind` is missing; it names the step, as in {\"kind\": \"Diffuse\"}"
                    .into(),
            );
        }
    };
    let others = keys
        .into_iter()
        .filter(|(key, _)| !["kind", "step", "depth"].contains(&key.as_str()));
    let values = others.map(|(key, value)| match trace_value(&value) {
        Some(value) => Ok((key, value)),
        None => Err(format!(
            ": {key} is {value}; allowed are a number, a list of three numbers, true, false, a word, and null for a number without end"
        )),
    });
    Ok(TraceLine {
        line,
        kind,
        values: values.collect::<Result<_, _>>()?,
    })
}

fn trace_value(value: &Json) -> Option<TraceValue> {
    Some(match value {
        Json::Null => TraceValue::Number(None),
        Json::Bool(truth) => TraceValue::Truth(*truth),
        Json::Number(number) => TraceValue::Number(number.as_f64()),
        Json::String(word) => TraceValue::Word(word.clone()),
        Json::Array(list) => {
            let number = |number: &Json| match number {
                Json::Null => Some(f64::NAN),
                number => number.as_f64(),
            };
            let numbers: Option<Vec<f64>> = list.iter().map(number).collect();
            TraceValue::Three(numbers?.try_into().ok()?)
        }
        Json::Object(_) => return None,
    })
}
