//! A lesson with other values of its parameters.

use super::error::{LessonError, problem};
use super::parameters::{ByPath, Change, NotAllowed, Parameter, PathValue, Source};
use super::resolve::Lesson;
use crate::language::Language;
use crate::methods::Settings;
use crate::scene::Scene;

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
