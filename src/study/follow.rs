//! A trace of another program against the steps of a run: the first step that differs.
//!
//! A trace has a line for each step that it records: the kind, and those values that the program has. Lines of one kind may come in any
//! order within a scope, and so may scopes; steps may be left out. A line belongs to a step of its kind that has its values, first of all
//! in the scope that is nearest to the line before, of those with one that no line has matched yet; where no step has them, the line differs
//! from one of that nearest scope.

mod read;
mod slips;

use crate::algorithms::focus::Focus;
use crate::language::suggestion;
use crate::methods::{Mistake, Setup};
use crate::record::{RecordingLimit, Value};
use crate::replay::{Run, Walk};
use crate::vocabulary::FAMILIES;
pub use read::read;
use serde::Serialize;
use std::sync::Arc;

/// A step as another program records it.
#[derive(Clone, Debug, PartialEq)]
pub struct TraceLine {
    /// In its file, from 1.
    pub line: usize,
    pub kind: String,
    pub values: Vec<(String, TraceValue)>,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub enum TraceValue {
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
    /// The trace goes on with steps of a kind of which the run has no more than `count`, which may be none.
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
    pub theirs: TraceValue,
    /// None where the step has no such value.
    pub ours: Option<TraceValue>,
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
    #[error(
        "line {line}: there is no step of the kind {kind:?}{meant}; the kinds of this run are {kinds}"
    )]
    Kind {
        line: usize,
        kind: String,
        /// "(did you mean …?)", or nothing.
        meant: String,
        kinds: String,
    },
    #[error("line {line}: {kind} has no value {field:?}{meant}; its values are {fields}")]
    Field {
        line: usize,
        kind: String,
        field: String,
        meant: String,
        fields: String,
    },
    #[error("line {line}: {field} is {found}; of {kind} it is {expected}")]
    Type {
        line: usize,
        kind: String,
        field: String,
        found: &'static str,
        expected: &'static str,
    },
}

/// Follows a trace through a run. Numbers agree within `tolerance`, relative to what is larger: 1, or the largest component.
/// Errors: the first line of an unknown kind, or with an unknown value or one of another type.
pub fn follow(walk: &dyn Walk, trace: &[TraceLine], tolerance: f64) -> Result<Followed, Unknown> {
    let mut is_told = vec![false; walk.len()];
    let mut last = None;
    for (agree, traced) in trace.iter().enumerate() {
        let of_kind = (0..walk.len()).filter(|&step| walk.kind(step) == traced.kind);
        let (done, left): (Vec<usize>, Vec<usize>) = of_kind.partition(|&step| is_told[step]);
        let Some(scope) = nearest_scope(walk, &left, last) else {
            let count = done.len();
            if count == 0
                && !FAMILIES
                    .into_iter()
                    .flatten()
                    .any(|kind| kind.name == traced.kind)
            {
                return Err(no_kind(walk, traced));
            }
            let (line, kind) = (traced.line, traced.kind.clone());
            let difference = Some(Difference::More { line, kind, count });
            return Ok(Followed { agree, difference });
        };
        let (here, elsewhere): (Vec<usize>, Vec<usize>) = left
            .into_iter()
            .partition(|&step| walk.outline().parent(step) == scope);
        let compared = here
            .into_iter()
            .map(|step| compare(walk, step, traced, tolerance));
        let compared: Vec<Compared> = compared.collect::<Result<_, _>>()?;
        let most_alike = |compared: &&Compared| (compared.equal, usize::MAX - compared.step);
        let fits = |compared: &&Compared| compared.difference.is_none();
        let nearest = compared.iter().find(fits);
        let Some(nearest) = nearest.or_else(|| compared.iter().max_by_key(most_alike)) else {
            continue;
        };
        let mut step = nearest.step;
        if let Some(difference) = &nearest.difference {
            let mut elsewhere = elsewhere.into_iter().filter(|_| nearest.may_be_another);
            let fitting = elsewhere.find_map(|step| {
                let compared = compare(walk, step, traced, tolerance).ok()?;
                fits(&&compared).then_some(step)
            });
            let Some(fitting) = fitting else {
                let difference = Some(Difference::Value(difference.clone()));
                return Ok(Followed { agree, difference });
            };
            step = fitting;
        }
        is_told[step] = true;
        last = Some(step);
    }
    Ok(Followed {
        agree: trace.len(),
        difference: None,
    })
}

/// The scope of one of the steps: the one that has the innermost scope in common with the step matched last, of several the earliest. None
/// without steps.
fn nearest_scope(walk: &dyn Walk, steps: &[usize], last: Option<usize>) -> Option<Option<usize>> {
    let outline = walk.outline();
    let around: Vec<usize> = last
        .into_iter()
        .flat_map(|last| std::iter::once(last).chain(outline.scopes(last)))
        .collect();
    let common = |step: usize| {
        let mut scopes = outline.scopes(step);
        scopes
            .find(|scope| around.contains(scope))
            .map(|scope| outline.depth(scope))
    };
    let nearest = steps
        .iter()
        .copied()
        .max_by_key(|&step| (common(step), usize::MAX - step));
    nearest.map(|step| outline.parent(step))
}

/// A line beside a step.
struct Compared {
    step: usize,
    /// How many values agree.
    equal: usize,
    /// The first value that does not.
    difference: Option<OtherValue>,
    /// Whether a value differs by which steps are told apart: then the line may well belong to another step.
    may_be_another: bool,
}

fn compare(
    walk: &dyn Walk,
    step: usize,
    traced: &TraceLine,
    tolerance: f64,
) -> Result<Compared, Unknown> {
    let (fields, kind) = (walk.fields(step), walk.declared(step));
    let mut compared = Compared {
        step,
        equal: 0,
        difference: None,
        may_be_another: false,
    };
    for (field, theirs) in &traced.values {
        let (line, kind_name, field) = (traced.line, traced.kind.clone(), field.clone());
        let ours = fields.get(&field).map(TraceValue::from);
        if ours.is_none() && kind.quantity(&field).is_none() {
            let names = || kind.quantities.iter().map(|quantity| quantity.name);
            // Every letter is like every other.
            let alike = names().filter(|_| field.len() > 1);
            return Err(Unknown::Field {
                line,
                kind: kind_name,
                meant: suggestion(&field, alike),
                field,
                fields: names().collect::<Vec<_>>().join(", "),
            });
        }
        let expected = ours.as_ref().map_or(theirs.kind(), TraceValue::kind);
        if theirs.kind() != expected {
            return Err(Unknown::Type {
                line,
                kind: kind_name,
                field,
                found: theirs.kind(),
                expected,
            });
        }
        if ours
            .as_ref()
            .is_some_and(|ours| theirs.agrees(ours, tolerance))
        {
            compared.equal += 1;
            continue;
        }
        compared.may_be_another |= theirs.distinguishes();
        if compared.difference.is_none() {
            compared.difference = Some(OtherValue {
                line,
                step,
                kind: walk.kind(step),
                field,
                theirs: theirs.clone(),
                ours,
            });
        }
    }
    Ok(compared)
}

fn no_kind(walk: &dyn Walk, traced: &TraceLine) -> Unknown {
    let mut kinds: Vec<&str> = (0..walk.len()).map(|step| walk.kind(step)).collect();
    kinds.sort_unstable();
    kinds.dedup();
    Unknown::Kind {
        line: traced.line,
        kind: traced.kind.clone(),
        meant: suggestion(&traced.kind, kinds.iter().copied()),
        kinds: kinds.join(", "),
    }
}

/// The mistakes that would give their value: first those with which another run agrees with the trace beyond the line that differs, the one
/// that agrees longest before the others, then those that make a formula of the step itself come out so.
pub fn explained_by(
    setup: &Setup,
    (run, focus): (&Run, Focus),
    trace: &[TraceLine],
    (tolerance, followed): (f64, &Followed),
) -> Vec<Mistake> {
    let Some(difference) = &followed.difference else {
        return Vec::new();
    };
    let method = run.method();
    let possible = Mistake::ALL
        .into_iter()
        .filter(|mistake| mistake.concerns(method));
    let mut explain: Vec<(usize, Mistake)> = possible
        .filter_map(|mistake| {
            let wrong = mistake.wrong_input(setup)?;
            let run = Run::record(Arc::new(wrong), method, focus, RecordingLimit::default());
            let agree = follow(run.walk(), trace, tolerance).ok()?.agree;
            (agree > followed.agree).then_some((agree, mistake))
        })
        .collect();
    explain.sort_by_key(|&(agree, _)| usize::MAX - agree);
    let mut explain: Vec<Mistake> = explain.into_iter().map(|(_, mistake)| mistake).collect();
    if let Difference::Value(other) = difference {
        for mistake in slips::slips(run, other, tolerance) {
            if mistake.concerns(method) && !explain.contains(&mistake) {
                explain.push(mistake);
            }
        }
    }
    explain
}

impl TraceValue {
    /// Whether few steps have the same: not so of a truth, a word, black and white.
    fn distinguishes(&self) -> bool {
        match self {
            TraceValue::Number(number) => number.is_some(),
            TraceValue::Three(three) => three.iter().any(|part| part.fract() != 0.0),
            TraceValue::Truth(_) | TraceValue::Word(_) => false,
        }
    }

    /// What it is, in words.
    fn kind(&self) -> &'static str {
        match self {
            TraceValue::Number(_) => "a number",
            TraceValue::Three(_) => "a list of three numbers",
            TraceValue::Truth(_) => "true or false",
            TraceValue::Word(_) => "a word",
        }
    }

    fn agrees(&self, ours: &TraceValue, tolerance: f64) -> bool {
        let near = |a: &[f64], b: &[f64]| {
            let largest = b.iter().fold(1.0_f64, |largest, b| largest.max(b.abs()));
            let is_near = |(a, b): (&f64, &f64)| {
                let are_endless = !a.is_finite() && !b.is_finite();
                are_endless || (a - b).abs() <= tolerance * largest
            };
            a.iter().zip(b).all(is_near)
        };
        match (self, ours) {
            (TraceValue::Number(Some(a)), TraceValue::Number(Some(b))) => near(&[*a], &[*b]),
            (TraceValue::Three(a), TraceValue::Three(b)) => near(a, b),
            _ => self == ours,
        }
    }
}

impl From<Value> for TraceValue {
    fn from(value: Value) -> Self {
        match value {
            Value::Number(number) => TraceValue::Number(number.is_finite().then_some(number)),
            Value::Integer(integer) => TraceValue::Number(Some(integer as f64)),
            Value::Rgb(color) => TraceValue::Three(color.channels()),
            Value::Vector(vector) => TraceValue::Three(vector.to_array()),
            Value::Truth(truth) => TraceValue::Truth(truth),
            Value::Word(word) => TraceValue::Word(word.to_owned()),
        }
    }
}

#[cfg(test)]
mod tests;
