//! What explains a step: a sentence and formulas, where a condition holds.

use super::expression::Equation;
use crate::language::Message;

/// The sentence and the formulas of a step.
#[derive(Debug)]
pub struct Entry {
    pub when: When,
    /// Its arguments are values of the step, by their names.
    pub sentence: Message,
    pub formulas: &'static [Formula],
}

/// A formula as [`Equation::parse`](super::expression::Equation::parse) reads it.
#[derive(Clone, Copy, Debug)]
pub struct Formula {
    pub text: &'static str,
    pub when: When,
    pub note: Option<Message>,
    /// Why the right side is not evaluated, where it is not.
    pub unevaluated: Option<&'static str>,
}

impl Formula {
    pub const fn when(self, when: When) -> Self {
        Formula { when, ..self }
    }

    pub const fn noted(self, note: Message) -> Self {
        Formula {
            note: Some(note),
            ..self
        }
    }

    /// A relation or a definition whose right side has no value at the step.
    pub const fn unevaluated(self, why: &'static str) -> Self {
        Formula {
            unevaluated: Some(why),
            ..self
        }
    }

    pub fn equation(&self) -> &'static Equation {
        Equation::of(self.text)
    }
}

/// Where an entry or a formula holds.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum When {
    Always,
    Recorded(&'static str),
    Unrecorded(&'static str),
    /// The word recorded under the name.
    Is(&'static str, &'static str),
    True(&'static str),
    Negative(&'static str),
    Zero(&'static str),
    NotPositive(&'static str),
    Finite(&'static str),
    /// The whole number recorded under the name.
    Equals(&'static str, i64),
    AtLeast(&'static str, f64),
    /// Two values are the same, each written as a formula refers to it.
    Same(&'static str, &'static str),
    /// What a formula refers to so is known: `{I_4<<edge,y-1}`.
    Known(&'static str),
    Not(&'static When),
    All(&'static [When]),
}

pub const fn is(text: &'static str) -> Formula {
    Formula {
        text,
        when: When::Always,
        note: None,
        unevaluated: None,
    }
}

pub const fn entry(key: &'static str, formulas: &'static [Formula]) -> Entry {
    only(When::Always, key, formulas)
}

pub const fn only(when: When, key: &'static str, formulas: &'static [Formula]) -> Entry {
    Entry {
        when,
        sentence: Message(key),
        formulas,
    }
}
