//! What explains a step: a sentence and formulas, where a condition holds.

use crate::language::Message;

/// The sentence and the formulas of a step.
#[derive(Debug)]
pub struct Entry {
    pub when: When,
    /// Its arguments are values of the step, by their names.
    pub sentence: Message,
    pub formulas: &'static [Formula],
}

/// `left = right`, a value alone, or a relation.
#[derive(Debug)]
pub struct Formula {
    pub template: &'static str,
    pub when: When,
    pub note: Option<Message>,
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
    NotPositive(&'static str),
    Finite(&'static str),
}

pub const fn is(template: &'static str) -> Formula {
    Formula {
        template,
        when: When::Always,
        note: None,
    }
}

pub const fn if_recorded(name: &'static str, template: &'static str) -> Formula {
    Formula {
        template,
        when: When::Recorded(name),
        note: None,
    }
}

pub const fn if_finite(name: &'static str, template: &'static str) -> Formula {
    Formula {
        template,
        when: When::Finite(name),
        note: None,
    }
}

pub const fn noted(template: &'static str, note: Message) -> Formula {
    Formula {
        template,
        when: When::Always,
        note: Some(note),
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
