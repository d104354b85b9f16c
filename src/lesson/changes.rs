//! A lesson with other values of its parameters.

use super::error::{LessonError, problem};
use super::parameters::{ByPath, Change, Kind, NotAllowed, Parameter, PathValue, Source};
use super::resolve::Lesson;
use crate::language::Language;
use crate::methods::Settings;
use crate::scene::Scene;
use glam::DVec3;

impl Lesson {
    /// The value that a parameter has after the changes.
    pub fn value(&self, parameter: Parameter, changes: &[Change]) -> Option<Change> {
        let mut changes = changes.iter().copied();
        let changed = changes.rfind(|change| change.parameter() == parameter);
        changed.or_else(|| match parameter {
            Parameter::ByPath(parameter) => Some(Change::ByPath {
                parameter,
                value: self.by_path.get(parameter)?.value,
            }),
            _ => parameter.value(&self.scene),
        })
    }

    /// The change of a parameter to the value that is written with these numbers. None where they are no value for it.
    pub fn change(&self, parameter: Parameter, numbers: &[f64]) -> Option<Change> {
        let number = || match numbers {
            &[number] => Some(number),
            _ => None,
        };
        let whole = || {
            let is_index = |number: &f64| (0.0..=f64::from(u32::MAX)).contains(number);
            let number = number().filter(|number| is_index(number) && number.fract() == 0.0);
            number.map(|number| number as u32)
        };
        let mut change = self.value(parameter, &[])?;
        match &mut change {
            Change::Place { position, .. } => {
                *position = DVec3::from_array(numbers.try_into().ok()?);
            }
            Change::Coefficient { value, .. } => *value = number()?,
            Change::Divisions { divisions, .. } => *divisions = whole()?,
            Change::ByPath { parameter, value } => {
                *value = match &self.by_path.get(*parameter)?.kind {
                    Kind::Number { range, .. } => {
                        PathValue::Number(number().filter(|number| range.contains(number))?)
                    }
                    Kind::Choice(options) => {
                        let option = whole()? as usize;
                        options.get(option)?;
                        PathValue::Option(option)
                    }
                }
            }
        }
        Some(change)
    }

    /// Scene and settings after the changes, of which there is at most one a parameter. Errors: why a value cannot be had.
    pub fn changed(&self, changes: &[Change]) -> Result<(Scene, Settings), NotAllowed> {
        let by_path = changes.iter().filter_map(|change| match *change {
            Change::ByPath { parameter, value } => Some((self.by_path.get(parameter)?, value)),
            _ => None,
        });
        let mut by_path = by_path.peekable();
        let source = self.source.as_ref().filter(|_| by_path.peek().is_some());
        let (opened, settings) = match source {
            None => (self.scene.clone(), self.settings.clone()),
            Some(source) => {
                let read = read_with(source, by_path);
                let read = read.map_err(|error| NotAllowed::Refused(error.to_string()))?;
                (read.scene, read.settings)
            }
        };
        let mut scene = opened.clone();
        for change in changes {
            change.make(&mut scene, &opened)?;
        }
        Ok((scene, settings))
    }

    /// The first of the values of its parameters, tried all over their ranges, with which the lesson would be refused.
    pub fn check_parameters(&self) -> Result<(), LessonError> {
        let Some(source) = &self.source else {
            return Ok(());
        };
        for parameter in &self.by_path {
            for value in parameter.sampled() {
                let read = read_with(source, [(parameter, value)].into_iter());
                read.map_err(|error| {
                    let value = match value {
                        PathValue::Number(number) => number.to_string(),
                        PathValue::Option(index) => format!("option {index}"),
                    };
                    let name = parameter.name.in_language(Language::English);
                    let message = format!("with {value} for “{name}”: {error}");
                    let error = LessonError::from(problem("parameters", message));
                    error.located(self.text.as_deref().unwrap_or_default())
                })?;
            }
        }
        Ok(())
    }
}

/// The lesson of a document with other values. Errors: what the file would be refused for.
fn read_with<'a>(
    source: &Source,
    values: impl Iterator<Item = (&'a ByPath, PathValue)>,
) -> Result<Lesson, LessonError> {
    let bytes = source.with(values)?;
    Lesson::read(&bytes, &source.limits, &mut |path| source.file(path))
}
