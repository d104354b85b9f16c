//! Comparisons with what the run itself recorded, which stay right when a parameter is moved: `I>0.5*I@Illuminated`.

use super::{Query, check_field, is_name, matches, number_of};
use crate::replay::Walk;
use std::fmt;

/// So many times the number that is known under a name: at the same step, or at the last step before it that a query finds.
///
/// A comparison with one that is not known never holds.
#[derive(Clone, PartialEq, Debug)]
pub struct Multiple {
    /// Finite.
    pub factor: f64,
    /// As that of a condition.
    pub field: String,
    pub at: Option<Query>,
}

impl Multiple {
    /// Multiples to be added, such as `2*I_4-1*I_4@SpanEnds`; none where the text is something else.
    pub(super) fn parse_sum(text: &str) -> Option<Vec<Multiple>> {
        let mut multiples = Vec::new();
        let mut rest = text;
        while !rest.is_empty() {
            let (factor, behind) = rest.split_once('*')?;
            let is_signed = factor.starts_with(['+', '-']);
            let factor: f64 = factor.parse().ok()?;
            let end = behind.find(['@', '+', '-']).unwrap_or(behind.len());
            let (field, behind) = behind.split_at(end);
            check_field(field).ok()?;
            let (at, behind) = match behind.strip_prefix('@') {
                Some(behind) => parse_place(behind).map(|(at, behind)| (Some(at), behind))?,
                None => (None, behind),
            };
            if !factor.is_finite() || !(is_signed || multiples.is_empty()) {
                return None;
            }
            multiples.push(Multiple {
                factor,
                field: field.to_owned(),
                at,
            });
            rest = behind;
        }
        Some(multiples)
    }

    pub(super) fn value(&self, walk: &dyn Walk, step: usize) -> Option<f64> {
        let step = match &self.at {
            Some(query) => matches(walk, query, 0..step).next_back()?,
            None => step,
        };
        Some(self.factor * number_of(&walk.fields(step), &self.field)?)
    }
}

/// A kind of event, or a query in parentheses, in which there are no others; and what stands behind it.
fn parse_place(text: &str) -> Option<(Query, &str)> {
    if let Some(text) = text.strip_prefix('(') {
        let (inside, behind) = text.split_once(')')?;
        let query = (!inside.contains('(')).then(|| inside.parse().ok())?;
        return Some((query?, behind));
    }
    let end = text.find(['+', '-']).unwrap_or(text.len());
    let (kind, behind) = text.split_at(end);
    let query = Query {
        kind: Some(kind.to_owned()),
        conditions: Vec::new(),
    };
    is_name(kind).then_some((query, behind))
}

/// As it would be typed.
impl fmt::Display for Multiple {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}*{}", self.factor, self.field)?;
        match &self.at {
            Some(Query {
                kind: Some(kind),
                conditions,
            }) if conditions.is_empty() => write!(f, "@{kind}"),
            Some(query) => write!(f, "@({query})"),
            None => Ok(()),
        }
    }
}
