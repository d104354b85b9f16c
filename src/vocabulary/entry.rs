//! What a step says: a sentence and formulas, where a condition holds.

/// A sentence in both languages; `{name}` stands for a value.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Sentence {
    pub en: &'static str,
    pub id: &'static str,
}

pub const fn says(en: &'static str, id: &'static str) -> Sentence {
    Sentence { en, id }
}

/// The sentence and the formulas of a step.
#[derive(Debug)]
pub struct Entry {
    pub when: When,
    pub says: Sentence,
    pub formulas: &'static [Formula],
}

/// `left = right`, a value alone, or a relation.
#[derive(Debug)]
pub struct Formula {
    pub template: &'static str,
    pub when: When,
    pub note: Option<Sentence>,
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

pub const fn noted(template: &'static str, note: Sentence) -> Formula {
    Formula {
        template,
        when: When::Always,
        note: Some(note),
    }
}

pub const fn entry(en: &'static str, id: &'static str, formulas: &'static [Formula]) -> Entry {
    only(When::Always, en, id, formulas)
}

pub const fn only(
    when: When,
    en: &'static str,
    id: &'static str,
    formulas: &'static [Formula],
) -> Entry {
    Entry {
        when,
        says: says(en, id),
        formulas,
    }
}
