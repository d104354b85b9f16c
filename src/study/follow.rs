//! A trace of another program against the steps of a run: the first step that differs.
//!
//! A trace has a line for each step that it tells: the kind, and those values that the program has. Lines of one kind may come in any
//! order within a scope, and steps may be left out. A line belongs to a step of its kind that has its values, in the earliest scope
//! with one that no line has told yet; where no step has them, the line differs from one of that earliest scope.

use super::mistakes::Mistake;
use crate::algorithms::focus::Focus;
use crate::methods::{Method, Setup};
use crate::record::{RecordingLimit, Value};
use crate::replay::{Run, Walk};
use serde::Serialize;
use std::sync::Arc;

/// A step as another program tells it.
#[derive(Clone, Debug, PartialEq)]
pub struct Told {
    /// In its file, from 1.
    pub line: usize,
    pub kind: String,
    pub values: Vec<(String, ToldValue)>,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub enum ToldValue {
    /// None stands for a number that is not finite.
    Number(Option<f64>),
    Three([f64; 3]),
    Truth(bool),
    Word(String),
}

/// Where a trace and the run part. Lines of the trace count from 1, steps of the run from 0.
#[derive(Clone, Debug, PartialEq)]
pub enum Difference {
    Value(OtherValue),
    /// The trace goes on telling steps of a kind of which the run has no more than `count`.
    More {
        line: usize,
        kind: String,
        count: usize,
    },
}

/// A value of a line is not that of the step, of all here the one with the most equal values.
#[derive(Clone, Debug, PartialEq)]
pub struct OtherValue {
    pub line: usize,
    pub step: usize,
    pub kind: &'static str,
    pub field: String,
    pub theirs: ToldValue,
    /// None where the step has no such value.
    pub ours: Option<ToldValue>,
}

/// How far a trace was followed.
#[derive(Clone, Debug, PartialEq)]
pub struct Followed {
    /// Lines that agree, before the first that does not.
    pub agree: usize,
    pub difference: Option<Difference>,
}

/// Why a line cannot be held against any step.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Unknown {
    #[error("line {line}: the run has no step of the kind {kind:?}; its kinds are {kinds}")]
    Kind {
        line: usize,
        kind: String,
        kinds: String,
    },
    #[error("line {line}: {kind} has no value {field:?}; its values are {fields}")]
    Field {
        line: usize,
        kind: String,
        field: String,
        fields: String,
    },
}

/// Follows a trace through a run. Numbers agree within `tolerance`, relative to what is larger: 1, or the largest component.
/// Errors: the first line of an unknown kind, or with an unknown value.
pub fn follow(walk: &dyn Walk, trace: &[Told], tolerance: f64) -> Result<Followed, Unknown> {
    let mut is_told = vec![false; walk.len()];
    for (agree, told) in trace.iter().enumerate() {
        let of_kind: Vec<usize> = (0..walk.len())
            .filter(|&step| walk.kind(step) == told.kind)
            .collect();
        if of_kind.is_empty() {
            return Err(no_kind(walk, told));
        }
        let steps: Vec<usize> = of_kind
            .iter()
            .copied()
            .filter(|&step| !is_told[step])
            .collect();
        let mut compared = Vec::with_capacity(steps.len());
        if steps.is_empty() {
            let (line, kind, count) = (told.line, told.kind.clone(), of_kind.len());
            let difference = Some(Difference::More { line, kind, count });
            return Ok(Followed { agree, difference });
        }
        for step in steps {
            compared.push((step, first_difference(walk, step, told, tolerance)?));
        }
        let scope = compared
            .first()
            .and_then(|&(step, _)| walk.outline().parent(step));
        let is_there = |step: usize| walk.outline().parent(step) == scope;
        let fits =
            |(_, (_, difference)): &&(usize, (usize, Option<Difference>))| difference.is_none();
        let can_be_told_apart = told.values.iter().any(|(_, value)| value.is_quantity());
        let here = compared.iter().filter(|(step, _)| is_there(*step));
        let found = here.clone().find(fits).or_else(|| {
            let later = compared.iter().filter(|_| can_be_told_apart);
            later.clone().find(fits)
        });
        match found {
            Some(&(step, _)) => is_told[step] = true,
            None => {
                let nearest = here.max_by_key(|(step, (equal, _))| (*equal, usize::MAX - step));
                let difference = nearest.and_then(|(_, (_, difference))| difference.clone());
                return Ok(Followed { agree, difference });
            }
        }
    }
    Ok(Followed {
        agree: trace.len(),
        difference: None,
    })
}

/// How many values of a line agree with those of a step, and the first that does not.
fn first_difference(
    walk: &dyn Walk,
    step: usize,
    told: &Told,
    tolerance: f64,
) -> Result<(usize, Option<Difference>), Unknown> {
    let fields = walk.fields(step);
    let (mut equal, mut difference) = (0, None);
    for (field, theirs) in &told.values {
        let ours = fields.get(field).map(ToldValue::from);
        let kind = walk.declared(step);
        if ours.is_none() && kind.quantity(field).is_none() {
            let names: Vec<&str> = kind
                .quantities
                .iter()
                .map(|quantity| quantity.name)
                .collect();
            return Err(Unknown::Field {
                line: told.line,
                kind: told.kind.clone(),
                field: field.clone(),
                fields: names.join(", "),
            });
        }
        if ours
            .as_ref()
            .is_some_and(|ours| theirs.agrees(ours, tolerance))
        {
            equal += 1;
        } else if difference.is_none() {
            difference = Some(Difference::Value(OtherValue {
                line: told.line,
                step,
                kind: walk.kind(step),
                field: field.clone(),
                theirs: theirs.clone(),
                ours,
            }));
        }
    }
    Ok((equal, difference))
}

fn no_kind(walk: &dyn Walk, told: &Told) -> Unknown {
    let mut kinds: Vec<&str> = (0..walk.len()).map(|step| walk.kind(step)).collect();
    kinds.sort_unstable();
    kinds.dedup();
    Unknown::Kind {
        line: told.line,
        kind: told.kind.clone(),
        kinds: kinds.join(", "),
    }
}

/// The mistakes with which the run agrees with the trace beyond the line that differs, the one that agrees longest first.
pub fn explained_by(
    setup: &Setup,
    method: Method,
    focus: Focus,
    trace: &[Told],
    (tolerance, agree): (f64, usize),
) -> Vec<Mistake> {
    let possible = Mistake::ALL
        .into_iter()
        .filter(|mistake| mistake.concerns(method));
    let mut explain: Vec<(usize, Mistake)> = possible
        .filter_map(|mistake| {
            let wrong = mistake.wrong_input(setup)?;
            let run = Run::record(Arc::new(wrong), method, focus, RecordingLimit::default());
            let followed = follow(run.walk(), trace, tolerance).ok()?;
            (followed.agree > agree).then_some((followed.agree, mistake))
        })
        .collect();
    explain.sort_by_key(|&(agree, _)| usize::MAX - agree);
    explain.into_iter().map(|(_, mistake)| mistake).collect()
}

impl ToldValue {
    /// Whether it is a number or three, of which few steps have the same.
    fn is_quantity(&self) -> bool {
        matches!(self, ToldValue::Number(Some(_)) | ToldValue::Three(_))
    }

    fn agrees(&self, ours: &ToldValue, tolerance: f64) -> bool {
        let near = |a: &[f64], b: &[f64]| {
            let largest = b.iter().fold(1.0_f64, |largest, b| largest.max(b.abs()));
            let off = |(a, b): (&f64, &f64)| (a - b).abs() <= tolerance * largest;
            a.iter().zip(b).all(off)
        };
        match (self, ours) {
            (ToldValue::Number(Some(a)), ToldValue::Number(Some(b))) => near(&[*a], &[*b]),
            (ToldValue::Three(a), ToldValue::Three(b)) => near(a, b),
            _ => self == ours,
        }
    }
}

impl From<Value> for ToldValue {
    fn from(value: Value) -> Self {
        match value {
            Value::Number(number) => ToldValue::Number(number.is_finite().then_some(number)),
            Value::Integer(integer) => ToldValue::Number(Some(integer as f64)),
            Value::Rgb(color) => ToldValue::Three(color.channels()),
            Value::Vector(vector) => ToldValue::Three(vector.to_array()),
            Value::Truth(truth) => ToldValue::Truth(truth),
            Value::Word(word) => ToldValue::Word(word.to_owned()),
        }
    }
}

#[cfg(test)]
mod tests;
