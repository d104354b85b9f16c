//! Searching a run by kind and values: what a user types (`EdgeInterpolated y=15 I_4>0.5`), and what lesson files select their
//! steps by.

mod file;
mod multiple;
mod text;

pub use multiple::Multiple;
pub use text::QueryError;

use super::Walk;
use crate::record::{Fields, Value};
use std::ops::Range;

/// Selects the steps of one kind (of any kind, where none is named) at which all conditions hold.
///
/// Whether a kind or field of such a name exists cannot be known here: a query for one that does not matches nothing.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Query {
    pub kind: Option<String>,
    pub conditions: Vec<Condition>,
}

/// Compares a value known at a step, its own or that of a scope around it, the innermost first.
///
/// Holds for no step at which the field is not known, or is of a type that cannot be compared so.
#[derive(Clone, PartialEq, Debug)]
pub struct Condition {
    /// The name of the field, or of a part: `color.g` of a colour (`r`, `g`, `b`), `N.z` of a vector (`x`, `y`, `z`).
    /// A colour by its plain name compares when all three channels do.
    pub field: String,
    pub comparison: Comparison,
    pub value: Operand,
}

/// `NotEqual` is the opposite of `Equal`. The other four compare numbers only.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Comparison {
    Equal,
    NotEqual,
    Below,
    AtMost,
    Above,
    AtLeast,
}

/// What a field is compared with.
#[derive(Clone, PartialEq, Debug)]
pub enum Operand {
    /// Finite.
    Number(f64),
    Truth(bool),
    Word(String),
    /// Their sum.
    Multiples(Vec<Multiple>),
}

/// Two real numbers are equal within this part of the larger one: a user types fewer digits than a run computes with.
const EQUAL_WITHIN: f64 = 1e-9;

/// The steps of `range` that match, in order; the other way round with `.rev()`.
pub fn matches<'a>(
    walk: &'a dyn Walk,
    query: &'a Query,
    range: Range<usize>,
) -> impl DoubleEndedIterator<Item = usize> + 'a {
    let mut fields = Fields::default();
    range.filter(move |&step| query.matches(walk, step, &mut fields))
}

/// The first step after `from` that matches.
pub fn next(walk: &dyn Walk, query: &Query, from: usize) -> Option<usize> {
    matches(walk, query, from.saturating_add(1)..walk.len()).next()
}

/// The last step before `from` that matches.
pub fn previous(walk: &dyn Walk, query: &Query, from: usize) -> Option<usize> {
    matches(walk, query, 0..from.min(walk.len())).next_back()
}

/// The kinds of event in a run, in the order of their first step, each with the number of its steps.
pub fn kinds(walk: &dyn Walk) -> Vec<(&'static str, usize)> {
    let mut kinds: Vec<(&'static str, usize)> = Vec::new();
    for kind in (0..walk.len()).map(|step| walk.kind(step)) {
        match kinds.iter_mut().find(|(seen, _)| *seen == kind) {
            Some((_, count)) => *count += 1,
            None => kinds.push((kind, 1)),
        }
    }
    kinds
}

/// The number known under `name`, which may name a part of a colour or a vector; a grey colour is one number.
pub fn number_of(fields: &Fields, name: &str) -> Option<f64> {
    let (name, part) = split_part(name);
    let (numbers, _) = numbers(fields.get(name)?, part);
    let first = *numbers.first()?;
    numbers
        .iter()
        .all(|&number| number == first)
        .then_some(first)
}

fn split_part(field: &str) -> (&str, Option<&str>) {
    match field.split_once('.') {
        Some((name, part)) => (name, Some(part)),
        None => (field, None),
    }
}

impl Query {
    /// Compares what is cheapest first: the kind, then the step's own values, then scope by scope outward.
    /// `fields` is memory to work in.
    fn matches(&self, walk: &dyn Walk, step: usize, fields: &mut Fields) -> bool {
        self.kind
            .as_ref()
            .is_none_or(|kind| walk.kind(step) == kind)
            && self.conditions.iter().all(|condition| {
                let (name, part) = split_part(&condition.field);
                let value = known(walk, step, name, fields);
                match &condition.value {
                    Operand::Multiples(multiples) => value.is_some_and(|value| {
                        let numbers = multiples.iter().map(|one| one.value(walk, step));
                        let sum: Option<f64> = numbers.sum();
                        sum.is_some_and(|sum| condition.compares(value, part, sum))
                    }),
                    _ => value.is_some_and(|value| condition.holds(value, part)),
                }
            })
    }
}

/// The value known at `step` under `name`: what `walk.fields(step).get(name)` says, without gathering the rest.
fn known(walk: &dyn Walk, step: usize, name: &str, fields: &mut Fields) -> Option<Value> {
    fields.0.clear();
    walk.push_fields(step, fields);
    fields.get(name).or_else(|| {
        walk.outline().scopes(step).find_map(|scope| {
            fields.0.clear();
            walk.heading(scope, step)
                .for_each(|step| walk.push_fields(step, fields));
            fields.get(name)
        })
    })
}

impl Condition {
    /// Whether the numbers of a value compare so with `operand`.
    fn compares(&self, value: Value, part: Option<&str>, operand: f64) -> bool {
        let (numbers, exact) = numbers(value, part);
        let equal = |&number: &f64| number == operand || !exact && nearly_equal(number, operand);
        !numbers.is_empty()
            && match self.comparison {
                Comparison::Equal => numbers.iter().all(equal),
                Comparison::NotEqual => !numbers.iter().all(equal),
                Comparison::Below => numbers.iter().all(|&number| number < operand),
                Comparison::AtMost => numbers.iter().all(|&number| number <= operand),
                Comparison::Above => numbers.iter().all(|&number| number > operand),
                Comparison::AtLeast => numbers.iter().all(|&number| number >= operand),
            }
    }

    fn holds(&self, value: Value, part: Option<&str>) -> bool {
        match &self.value {
            &Operand::Number(operand) => self.compares(value, part, operand),
            Operand::Truth(operand) => match (value, part) {
                (Value::Truth(truth), None) => self.same(truth == *operand),
                _ => false,
            },
            Operand::Word(operand) => match (value, part) {
                (Value::Word(word), None) => self.same(word == operand),
                _ => false,
            },
            Operand::Multiples(_) => false,
        }
    }

    /// For values that have no order.
    fn same(&self, equal: bool) -> bool {
        match self.comparison {
            Comparison::Equal => equal,
            Comparison::NotEqual => !equal,
            _ => false,
        }
    }
}

/// The numbers in a value or a part of it, and whether they are whole numbers, to be compared exactly.
fn numbers(value: Value, part: Option<&str>) -> (Vec<f64>, bool) {
    let numbers = match (value, part) {
        (Value::Number(number), None) => vec![number],
        (Value::Integer(integer), None) => return (vec![integer as f64], true),
        (Value::Rgb(color), None) => color.channels().to_vec(),
        (Value::Rgb(color), Some("r")) => vec![color.r],
        (Value::Rgb(color), Some("g")) => vec![color.g],
        (Value::Rgb(color), Some("b")) => vec![color.b],
        (Value::Vector(vector), Some("x")) => vec![vector.x],
        (Value::Vector(vector), Some("y")) => vec![vector.y],
        (Value::Vector(vector), Some("z")) => vec![vector.z],
        _ => vec![],
    };
    (numbers, false)
}

fn nearly_equal(a: f64, b: f64) -> bool {
    // Infinity is within no part of infinity.
    (a - b).abs() < EQUAL_WITHIN * a.abs().max(b.abs())
}

/// The parts that a field's name may end in, after a dot.
const PARTS: [&str; 6] = ["r", "g", "b", "x", "y", "z"];

/// Whether `name` can name a field or a part of one; the error says what would.
fn check_field(name: &str) -> Result<(), &'static str> {
    let (name, part) = name.split_once('.').unwrap_or((name, "r"));
    if !is_name(name) {
        Err("the name of a field, such as I_4")
    } else if !PARTS.contains(&part) {
        Err(".r, .g or .b of a colour, .x, .y or .z of a vector")
    } else {
        Ok(())
    }
}

/// Kinds and fields have names of ASCII letters, digits and `_`, with no digit in front.
fn is_name(text: &str) -> bool {
    text.starts_with(|first: char| first.is_ascii_alphabetic() || first == '_')
        && text.chars().all(|c| c.is_ascii_alphanumeric() || c == '_')
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::color::Rgb;
    use crate::replay::generators::{History, trace};
    use crate::replay::{Replay, Timeline};
    use glam::DVec3;
    use proptest::prelude::*;

    fn holds(condition: &str, value: impl Into<Value>) -> bool {
        let query: Query = condition.parse().expect("a condition");
        let (_, part) = split_part(&query.conditions[0].field);
        query.conditions[0].holds(value.into(), part)
    }

    #[test]
    fn numbers_compare_as_typed() {
        assert!(holds("a=0.333333333333", 1.0 / 3.0));
        assert!(!holds("a=0.3333333", 1.0 / 3.0));
        assert!(!holds("a!=0.333333333333", 1.0 / 3.0));
        assert!(holds("a=0", -0.0) && !holds("a=0", 1e-300));
        assert!(holds("a>=15", 15_u32) && !holds("a>15", 15_u32));
        assert!(holds("a<=15", 15_u32) && !holds("a<15", 15_u32));
        assert!(!holds("a=4000000000", 4_000_000_001_f64 as u32));
        assert!(!holds("a<1", f64::NAN) && !holds("a=1", f64::NAN) && holds("a!=1", f64::NAN));
        assert!(!holds("a=1", f64::INFINITY) && holds("a>1", f64::INFINITY));
    }

    #[test]
    fn colours_and_vectors_compare_by_part() {
        let orange = Rgb::new(1.0, 0.5, 0.0);
        assert!(holds("a.g=0.5", orange) && !holds("a.b>0", orange));
        assert!(!holds("a<1", orange) && holds("a<=1", orange));
        assert!(holds("a=0.5", Rgb::splat(0.5)) && !holds("a=0.5", orange));
        assert!(holds("a!=0.5", orange) && !holds("a!=0.5", Rgb::splat(0.5)));
        assert!(holds("a.z<0", DVec3::new(0.0, 1.0, -1.0)));
        assert!(!holds("a.r<0", -DVec3::ONE) && !holds("a<0", -DVec3::ONE));
    }

    #[test]
    fn what_cannot_be_compared_never_holds() {
        assert!(holds("a=true", true) && holds("a!=true", false));
        assert!(holds("a=mirror", "mirror") && holds("a!=mirror", "glass"));
        for condition in ["a=1", "a!=1", "a=mirror", "a!=mirror", "a.x=1"] {
            assert!(!holds(condition, true), "{condition}");
        }
        assert!(!holds("a!=true", 1.0) && !holds("a.x=1", 1.0));
    }

    const QUERIES: [&str; 10] = [
        "Red",
        "Green a=3",
        "b>=10",
        "a=7 b<20",
        "c!=31",
        "Blue c>3 c<25",
        "Grey",
        "d=1",
        "a=true",
        "a.r=3",
    ];

    proptest! {
        #[test]
        fn a_search_finds_what_a_linear_scan_finds(trace in trace(), query in prop::sample::select(&QUERIES)) {
            let query: Query = query.parse().expect("a query");
            let replay = Replay::new(Timeline::new(trace.recording(), History::default()));
            let hits: Vec<usize> = (0..replay.timeline().len())
                .filter(|&step| {
                    let fields = replay.timeline().fields(step);
                    let event = replay.timeline().event(step);
                    query.kind.as_deref().is_none_or(|kind| kind == crate::record::Event::kind(event))
                        && query.conditions.iter().all(|condition| {
                            let (name, part) = split_part(&condition.field);
                            fields.get(name).is_some_and(|value| condition.holds(value, part))
                        })
                })
                .collect();
            for from in 0..replay.timeline().len() + 2 {
                prop_assert_eq!(next(&replay, &query, from), hits.iter().copied().find(|&hit| hit > from));
                prop_assert_eq!(previous(&replay, &query, from), hits.iter().copied().rfind(|&hit| hit < from));
            }
            let all = matches(&replay, &query, 0..replay.timeline().len());
            prop_assert!(all.eq(hits));
        }

        #[test]
        fn a_multiple_is_that_of_the_same_step_or_of_the_last_one_found_before(trace in trace()) {
            let replay = Replay::new(Timeline::new(trace.recording(), History::default()));
            let number = |step: usize, name: &str| number_of(&Walk::fields(&replay, step), name);
            let found = |query: &str| {
                let query: Query = query.parse().expect("a query");
                matches(&replay, &query, 0..replay.timeline().len()).collect::<Vec<usize>>()
            };
            let expected = |other: &dyn Fn(usize) -> Option<f64>| -> Vec<usize> {
                let steps = 0..replay.timeline().len();
                steps
                    .filter(|&step| match (number(step, "b"), other(step)) {
                        (Some(b), Some(other)) => b >= 2.0 * other,
                        _ => false,
                    })
                    .collect()
            };
            prop_assert_eq!(found("b>=2*a"), expected(&|step| number(step, "a")));
            let red = |step: usize| (0..step).rev().find(|&before| replay.kind(before) == "Red");
            prop_assert_eq!(found("b>=2*a@Red"), expected(&|step| number(red(step)?, "a")));
            prop_assert_eq!(
                found("b>=4*a@Red-2*a"),
                expected(&|step| Some(2.0 * number(red(step)?, "a")? - number(step, "a")?))
            );
            let large = |step: usize| (0..step).rev().find(|&before| number(before, "a") > Some(9.0));
            prop_assert_eq!(found("b>=2*a@(a>9)"), expected(&|step| number(large(step)?, "a")));
        }

        #[test]
        fn kinds_count_every_step_once(trace in trace()) {
            let replay = Replay::new(Timeline::new(trace.recording(), History::default()));
            let kinds = kinds(&replay);
            prop_assert_eq!(kinds.iter().map(|(_, count)| count).sum::<usize>(), replay.timeline().len());
            for (kind, steps) in kinds {
                let query = Query { kind: Some(kind.to_owned()), ..Query::default() };
                let found = matches(&replay, &query, 0..replay.timeline().len());
                prop_assert_eq!(found.count(), steps);
            }
        }
    }
}
