//! `lightwalk follow`: the trace of another program against the steps of a run.

use super::failure::Failure;
use super::files;
use super::radiosity::ToleranceArgument;
use super::steps::{Recorded, Recording};
use crate::language::Language;
use crate::panels::{said, written_formulas};
use crate::picture::plain;
use crate::replay::Run;
use crate::study::follow::{
    Difference, Followed, OtherValue, Told, ToldValue, explained_by, follow,
};
use crate::study::mistakes::Mistake;
use serde_json::{Map, Value as Json, json};
use std::io::Write;
use std::path::PathBuf;

#[derive(clap::Args)]
pub struct Arguments {
    #[command(flatten)]
    recorded: Recorded,
    /// Your trace: lines as those of `steps`, each with `kind` and the values that your program has
    #[arg(long, value_name = "STEPS.jsonl")]
    with: PathBuf,
    /// How far a number may be off, relative to the largest of a value and 1
    #[arg(
        long,
        value_name = "T",
        default_value_t = 1e-5,
        allow_negative_numbers = true
    )]
    tolerance: f64,
    /// Prints one JSON object
    #[arg(long)]
    json: bool,
}

pub fn run(arguments: Arguments) -> Result<(), Failure> {
    let tolerance = arguments.tolerance;
    if !(0.0..=1.0).contains(&tolerance) {
        return Err(Failure::Wrong(format!(
            "--tolerance {tolerance}: allowed are numbers from 0 to 1"
        )));
    }
    let place = arguments.with.display();
    let wrong = |error: String| files::wrong(&place, &error);
    let trace = read(&files::text(&arguments.with)?).map_err(wrong)?;
    let Recording {
        run,
        setup,
        method,
        focus,
    } = arguments.recorded.record(ToleranceArgument::default())?;
    let followed = follow(run.walk(), &trace, tolerance);
    let followed = followed.map_err(|unknown| wrong(unknown.to_string()))?;
    let mistakes = match followed.difference {
        None => Vec::new(),
        Some(_) => explained_by(&setup, method, focus, &trace, (tolerance, followed.agree)),
    };
    let mut out = std::io::stdout();
    let told = match arguments.json {
        true => in_json(&followed, &trace, &mistakes, &run).to_string() + "\n",
        false => in_words(&followed, &trace, &mistakes, &run),
    };
    out.write_all(told.as_bytes())?;
    match followed.difference {
        None => Ok(()),
        Some(_) => Err(Failure::Failed(format!(
            "{place} parts from the run after {} of {} steps",
            followed.agree,
            trace.len()
        ))),
    }
}

/// The steps of a trace. Empty lines are passed over; `step` and `depth` are those of the program that wrote it.
fn read(text: &str) -> Result<Vec<Told>, String> {
    let mut trace = Vec::new();
    for (line, text) in (1..).zip(text.lines()) {
        if text.trim().is_empty() {
            continue;
        }
        let object: Map<String, Json> =
            serde_json::from_str(text).map_err(|error| format!("line {line}: {error}"))?;
        let Some(kind) = object.get("kind").and_then(Json::as_str) else {
            return Err(format!(
                "line {line}: the key `kind` is missing; it names the step, as in {{\"kind\": \"Diffuse\"}}"
            ));
        };
        let others = object
            .iter()
            .filter(|(key, _)| !["kind", "step", "depth"].contains(&key.as_str()));
        let values = others
            .map(|(key, value)| match told(value) {
                Some(value) => Ok((key.clone(), value)),
                None => Err(format!(
                    "line {line}: {key} is {value}; allowed are a number, a list of three numbers, true, false, a word, and null for a number without end"
                )),
            })
            .collect::<Result<_, _>>()?;
        trace.push(Told {
            line,
            kind: kind.to_owned(),
            values,
        });
    }
    match trace.is_empty() {
        true => Err("there is no step in it: one JSON object a line is expected".into()),
        false => Ok(trace),
    }
}

fn told(value: &Json) -> Option<ToldValue> {
    Some(match value {
        Json::Null => ToldValue::Number(None),
        Json::Bool(truth) => ToldValue::Truth(*truth),
        Json::Number(number) => ToldValue::Number(number.as_f64()),
        Json::String(word) => ToldValue::Word(word.clone()),
        Json::Array(list) => {
            let numbers: Option<Vec<f64>> = list.iter().map(Json::as_f64).collect();
            ToldValue::Three(numbers?.try_into().ok()?)
        }
        Json::Object(_) => return None,
    })
}

/// The channel in which the two values differ the most.
fn channel(other: &OtherValue) -> usize {
    let (ToldValue::Three(theirs), Some(ToldValue::Three(ours))) = (&other.theirs, &other.ours)
    else {
        return 0;
    };
    let off = |&c: &usize| (theirs[c] - ours[c]).abs();
    (0..3).max_by(|a, b| off(a).total_cmp(&off(b))).unwrap_or(0)
}

/// What the step does, and its formulas with our numbers.
fn explained(run: &Run, other: &OtherValue) -> Vec<String> {
    let sentence = said(run, other.step, Language::English);
    let formulas = written_formulas(run, other.step, channel(other), Language::English);
    std::iter::once(sentence)
        .filter(|said| !said.is_empty())
        .chain(formulas)
        .collect()
}

fn in_words(followed: &Followed, trace: &[Told], mistakes: &[Mistake], run: &Run) -> String {
    let mut lines = vec![format!("{} of {} steps agree", followed.agree, trace.len())];
    match &followed.difference {
        None => {}
        Some(Difference::More { line, kind, count }) => lines.push(format!(
            "line {line}: one more {kind}, of which the run has {count}"
        )),
        Some(Difference::Value(other)) => {
            let step = other.step;
            let reference = match &other.ours {
                Some(ours) => format!("{} at step {step} of the run", json!(ours)),
                None => format!("step {step} of the run has none"),
            };
            lines.push(format!(
                "line {}, {}: {} is {}, and {reference}",
                other.line,
                other.kind,
                other.field,
                json!(other.theirs)
            ));
            let explained = explained(run, other);
            lines.extend(explained.iter().map(|line| format!("  {line}")));
        }
    }
    for mistake in mistakes {
        let words = plain(&mistake.in_words(Language::English));
        lines.push(format!("{}: {words} would give yours", mistake.name()));
    }
    lines.join("\n") + "\n"
}

fn in_json(followed: &Followed, trace: &[Told], mistakes: &[Mistake], run: &Run) -> Json {
    let names: Vec<&str> = mistakes.iter().map(|mistake| mistake.name()).collect();
    let difference = match &followed.difference {
        None => Json::Null,
        Some(Difference::More { line, kind, count }) => {
            json!({ "line": line, "kind": kind, "count": count })
        }
        Some(Difference::Value(other)) => json!({
            "line": other.line, "step": other.step, "kind": other.kind, "field": other.field,
            "mine": other.theirs, "reference": other.ours, "explained": explained(run, other),
        }),
    };
    json!({ "agree": followed.agree, "of": trace.len(), "difference": difference, "mistakes": names })
}
