//! The formulas of a step with the values of both sides.

use super::known::Known;
use super::{entry, formulas, holds};
use crate::record::Value;
use crate::replay::Run;
use crate::vocabulary::expression::{Equation, Expression, Relation, Rounded, Term, evaluate};
use crate::vocabulary::{Entry, Formula, When};

/// What rounding may make of one operation, relative to its result. Algorithms order their operations otherwise than the
/// formulas that explain them, so this is far above one rounding of an f64.
const ROUNDING: f64 = 1e-12;

/// A formula of a step, evaluated from the values that are shown.
pub struct Evaluated {
    pub formula: &'static Formula,
    pub left: Option<Term>,
    /// None where a value is not known at the step.
    pub right: Option<Term>,
}

/// The formulas with two sides at a step of the run.
pub fn evaluated(run: &Run, step: usize) -> Vec<Evaluated> {
    let mut known = Known::at(run, step);
    match entry(run.walk().declared(step), &known) {
        Some(entry) => of_entry(entry, &mut known),
        None => Vec::new(),
    }
}

pub(super) fn of_entry(entry: &'static Entry, known: &mut Known) -> Vec<Evaluated> {
    let formulas = formulas(entry, known).into_iter();
    let value = |side: &Expression| evaluate(side, &|reference| known.terms(reference));
    let evaluated = |formula: &'static Formula| {
        let equation = formula.equation();
        let (_, right) = equation.right.as_ref()?;
        Some(Evaluated {
            formula,
            left: value(&equation.left),
            right: value(right),
        })
    };
    formulas.filter_map(evaluated).collect()
}

/// A formula that is computed by mistake in place of one of a step's own, behind those that define names for it.
pub struct Slip {
    pub when: When,
    pub formulas: &'static [&'static str],
}

/// The name of the value that comes out otherwise at the step, and what it is then. None where the slip cannot be made.
pub fn slipped(run: &Run, step: usize, slip: &Slip) -> Option<(&'static str, Value)> {
    let mut known = Known::at(run, step);
    if !holds(slip.when, &known) {
        return None;
    }
    for text in slip.formulas {
        let equation = Equation::of(text);
        let (name, (relation, right)) = (equation.subject()?.name, equation.right.as_ref()?);
        let term = evaluate(right, &|reference| known.terms(reference))?;
        match relation {
            Relation::Defined => known.define(name, term),
            _ => return Some((name, term.value())),
        }
    }
    None
}

impl Evaluated {
    /// Whether the sides relate as the formula says. None where a side has no value.
    pub fn holds(&self) -> Option<bool> {
        let (relation, _) = self.formula.equation().right.as_ref()?;
        Some(agree(*relation, self.left?, self.right?))
    }
}

/// Whether both sides relate so, but for rounding: of every operation, and of the recorded value. Of vectors that is relative
/// to the whole, since a point is moved onto its surface along the normal.
pub(super) fn agree(relation: Relation, left: Term, right: Term) -> bool {
    let same_kind = std::mem::discriminant(&left) == std::mem::discriminant(&right);
    let pairs = || left.components().iter().zip(right.components());
    let slack_of = |(a, b): (&Rounded, &Rounded)| ROUNDING * (a.error + a.value.abs() + b.error);
    let largest = pairs().map(slack_of).fold(0.0, f64::max);
    let agree = pairs().all(|(a, b)| {
        let slack = match left {
            Term::Vector(_) => largest,
            _ => slack_of((a, b)),
        };
        match relation {
            Relation::Equal | Relation::Defined => {
                a.value == b.value || (a.value - b.value).abs() <= slack
            }
            Relation::Less => a.value < b.value || a.value - b.value <= slack,
            Relation::AtLeast => a.value >= b.value || b.value - a.value <= slack,
        }
    });
    same_kind && agree
}
