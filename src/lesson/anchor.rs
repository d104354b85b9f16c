//! Anchors for lessons that are written in the window: a selector for a step, made of its kind and values, and what a selector means.

use crate::record::Value;
use crate::replay::{Comparison, Condition, Operand, Query, Walk, query};

/// What a selector means in a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Meaning {
    /// The first step of those that it may mean; none where there is none.
    pub step: Option<usize>,
    /// How many steps of those that it may mean are like this.
    pub ahead: usize,
    /// How many steps of the whole run are like this.
    pub steps: usize,
}

impl Meaning {
    /// What `query` means where it may mean the step `from` and those behind it.
    pub fn of(walk: &dyn Walk, query: &Query, from: usize) -> Self {
        let mut meaning = Meaning {
            step: None,
            ahead: 0,
            steps: 0,
        };
        for step in query::matches(walk, query, 0..walk.len()) {
            meaning.steps += 1;
            if step >= from {
                meaning.ahead += 1;
                meaning.step = meaning.step.or(Some(step));
            }
        }
        meaning
    }
}

/// A selector of the kind of `step` and as few of its whole numbers and words as distinguish it from all others, or from as many as
/// they can. What the step itself says comes before what its scopes say, and where it is before what came out.
pub fn selector(walk: &dyn Walk, step: usize) -> Query {
    let mut chosen = Query {
        kind: Some(walk.kind(step).to_owned()),
        conditions: Vec::new(),
    };
    let mut like: Vec<usize> = query::matches(walk, &chosen, 0..walk.len()).collect();
    for condition in conditions(walk, step) {
        if like.len() == 1 {
            break;
        }
        let fewer = with(walk, &like, &condition);
        if fewer.len() < like.len() {
            like = fewer;
            chosen.conditions.push(condition);
        }
    }
    // What was chosen later may make what was chosen before needless.
    for index in (0..chosen.conditions.len()).rev() {
        let mut without = chosen.clone();
        without.conditions.remove(index);
        if query::matches(walk, &without, 0..walk.len()).count() == like.len() {
            chosen = without;
        }
    }
    chosen
}

/// The steps at which the condition holds.
fn with(walk: &dyn Walk, steps: &[usize], condition: &Condition) -> Vec<usize> {
    let one = Query {
        kind: None,
        conditions: vec![condition.clone()],
    };
    let holds = |&step: &usize| query::matches(walk, &one, step..step + 1).next().is_some();
    steps.iter().copied().filter(holds).collect()
}

/// The whole numbers known at a step, its own before those of its scopes, then its words and truths.
fn conditions(walk: &dyn Walk, step: usize) -> Vec<Condition> {
    let own = walk.own_fields(step);
    let known = walk.fields(step);
    let of_scopes = || known.iter().filter(|field| own.get(field.name).is_none());
    let all = || own.iter().chain(of_scopes());
    let condition = |name: &str, value| Condition {
        field: name.to_owned(),
        comparison: Comparison::Equal,
        value,
    };
    let numbers = all().filter_map(|field| match field.value {
        Value::Integer(number) => Some(condition(field.name, Operand::Number(number as f64))),
        _ => None,
    });
    let others = all().filter_map(|field| match field.value {
        Value::Word(word) => Some(condition(field.name, Operand::Word(word.to_owned()))),
        Value::Truth(truth) => Some(condition(field.name, Operand::Truth(truth))),
        _ => None,
    });
    numbers.chain(others).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lesson::builtin;

    /// A proposal is what a lesson file can say, means its own step first of all that are like it, and is unique where any
    /// selector of this form is.
    #[test]
    fn a_selector_means_its_step_and_says_no_more_than_it_must() {
        for id in ["shadows", "gouraud-triangle", "shooting"] {
            let run = builtin(id).unwrap().read().unwrap().open().unwrap().run;
            let walk = run.walk();
            let mut unique = 0;
            for step in (0..walk.len()).step_by(walk.len().div_ceil(60)) {
                let chosen = selector(walk, step);
                let text = chosen.to_string();
                assert_eq!(text.parse(), Ok(chosen.clone()), "{id}: {text}");
                let meaning = Meaning::of(walk, &chosen, step);
                assert_eq!(meaning.step, Some(step), "{id}: {text}");
                unique += usize::from(meaning.steps == 1);
                for index in 0..chosen.conditions.len() {
                    let mut less = chosen.clone();
                    less.conditions.remove(index);
                    let more = Meaning::of(walk, &less, 0).steps;
                    assert!(more > meaning.steps, "{id}: {text}");
                }
            }
            assert!(unique > 40, "{id}: {unique} of about 60");
        }
    }

    #[test]
    fn a_meaning_counts_what_is_ahead_apart() {
        let run = builtin("shadows")
            .unwrap()
            .read()
            .unwrap()
            .open()
            .unwrap()
            .run;
        let walk = run.walk();
        let query: Query = "Shadow".parse().unwrap();
        let all: Vec<usize> = query::matches(walk, &query, 0..walk.len()).collect();
        let [first, .., last] = all[..] else {
            panic!("two shadow rays or more")
        };
        let of = |from| Meaning::of(walk, &query, from);
        assert_eq!((of(0).step, of(0).ahead), (Some(first), all.len()));
        let behind = of(first + 1);
        assert_eq!((behind.ahead, behind.steps), (all.len() - 1, all.len()));
        assert_eq!((of(last + 1).step, of(last + 1).ahead), (None, 0));
    }
}
