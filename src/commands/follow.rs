//! `lightwalk follow`: the trace of another program against the steps of a run.

use super::failure::Failure;
use super::files;
use super::progress::named;
use super::radiosity::ToleranceArgument;
use super::steps::{Recorded, Recording, TRUNCATED};
use crate::language::Language;
use crate::methods::Mistake;
use crate::panels::{said, written_formulas};
use crate::picture::plain;
use crate::replay::Run;
use crate::study::follow::{
    Difference, Followed, OtherValue, TraceLine, TraceValue, explained_by, follow, read,
};
use serde_json::{Value as Json, json};
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
        run, setup, focus, ..
    } = arguments.recorded.record(ToleranceArgument::default())?;
    if run.walk().truncated() {
        return Err(Failure::Failed(TRUNCATED.into()));
    }
    let followed = follow(run.walk(), &trace, tolerance);
    let followed = followed.map_err(|unknown| wrong(unknown.to_string()))?;
    let mistakes = named("looking for what explains the difference", || {
        explained_by(&setup, (&run, focus), &trace, (tolerance, &followed))
    });
    let mut out = std::io::stdout();
    let text = match arguments.json {
        true => in_json(&followed, &trace, &mistakes, &run).to_string() + "\n",
        false => in_words(&followed, &trace, &mistakes, &run),
    };
    out.write_all(text.as_bytes())?;
    match followed.difference {
        None => Ok(()),
        Some(_) => Err(Failure::Failed(format!(
            "{place} differs from the run after {} of {} steps",
            followed.agree,
            trace.len()
        ))),
    }
}

/// The channel in which the two values differ the most.
fn channel(other: &OtherValue) -> usize {
    let (TraceValue::Three(theirs), Some(TraceValue::Three(ours))) = (&other.theirs, &other.ours)
    else {
        return 0;
    };
    let difference = |&c: &usize| (theirs[c] - ours[c]).abs();
    (0..3)
        .max_by(|a, b| difference(a).total_cmp(&difference(b)))
        .unwrap_or(0)
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

/// Both values, to as many digits as it takes to tell them apart.
fn written(other: &OtherValue) -> [String; 2] {
    let short = |value: &TraceValue| match value {
        TraceValue::Number(Some(number)) => Language::English.number(*number),
        TraceValue::Number(None) => "not finite".to_owned(),
        TraceValue::Three(three) => {
            let numbers = three.map(|number| Language::English.number(number));
            format!("[{}]", Language::English.list(numbers))
        }
        other => json!(other).to_string(),
    };
    let Some(ours) = &other.ours else {
        return [short(&other.theirs), "none".to_owned()];
    };
    let short_ones = [&other.theirs, ours].map(short);
    match short_ones[0] == short_ones[1] {
        true => [&other.theirs, ours].map(|value| json!(value).to_string()),
        false => short_ones,
    }
}

fn in_words(followed: &Followed, trace: &[TraceLine], mistakes: &[Mistake], run: &Run) -> String {
    let mut lines = vec![format!("{} of {} steps agree", followed.agree, trace.len())];
    match &followed.difference {
        None => {}
        Some(Difference::More { line, kind, count }) => lines.push(format!(
            "line {line}: one more {kind} than the run has, which is {count}"
        )),
        Some(Difference::Value(other)) => {
            let [theirs, ours] = written(other);
            lines.push(format!(
                "line {}, {}: your {field} is {theirs}, and the run has {ours} at step {}",
                other.line,
                other.kind,
                other.step,
                field = other.field
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

fn in_json(followed: &Followed, trace: &[TraceLine], mistakes: &[Mistake], run: &Run) -> Json {
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
