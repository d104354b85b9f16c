//! A comparison with what the run itself recorded, which stays right when a parameter is moved: `I>0.5*I@Illuminated`.

use super::{check_field, is_name, number_of};
use crate::replay::Walk;
use std::fmt;

/// So many times the number that is known under a name: at the same step, or at the last step of a kind before it.
///
/// A comparison with one that is not known never holds.
#[derive(Clone, PartialEq, Debug)]
pub struct Multiple {
    /// Finite.
    pub factor: f64,
    /// As that of a condition.
    pub field: String,
    pub at: Option<String>,
}

impl Multiple {
    /// A factor, the name of a field, and where it is not that of the same step, the kind of step that has it.
    pub(super) fn parse(word: &str) -> Option<Multiple> {
        let (factor, field) = word.split_once('*')?;
        let (field, at) = match field.split_once('@') {
            Some((field, at)) => (field, Some(Some(at).filter(|at| is_name(at))?.to_owned())),
            None => (field, None),
        };
        let factor: f64 = factor
            .parse()
            .ok()
            .filter(|factor: &f64| factor.is_finite())?;
        check_field(field).ok()?;
        Some(Multiple {
            factor,
            field: field.to_owned(),
            at,
        })
    }

    pub(super) fn value(&self, walk: &dyn Walk, step: usize) -> Option<f64> {
        let step = match &self.at {
            Some(kind) => (0..step).rev().find(|&before| walk.kind(before) == kind)?,
            None => step,
        };
        Some(self.factor * number_of(&walk.fields(step), &self.field)?)
    }
}

/// As it would be typed.
impl fmt::Display for Multiple {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}*{}", self.factor, self.field)?;
        match &self.at {
            Some(kind) => write!(f, "@{kind}"),
            None => Ok(()),
        }
    }
}
