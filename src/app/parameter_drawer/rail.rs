//! The rail of a parameter's slider.

use super::by_path;
use crate::app::session::Session;
use crate::app::strings;
use crate::language::Language;
use crate::lesson::{Change, Coefficient, DIVISIONS, Kind, Parameter, PathValue};
use crate::scene::Scene;
use glam::DVec3;
use std::ops::RangeInclusive;

const SHININESS: RangeInclusive<f64> = 1.0..=1000.0;

/// Where a slider's knob is, and between what it moves.
pub(super) struct Rail {
    pub(super) value: f64,
    pub(super) range: RangeInclusive<f64>,
    pub(super) logarithmic: bool,
    pub(super) whole: bool,
    /// Of other numbers there is no unit.
    is_length: bool,
    /// Of a value of the document, where it has one.
    unit: Option<String>,
}

impl Rail {
    pub(super) fn of(session: &Session, parameter: Parameter) -> Option<Self> {
        let opened = &session.lesson().scene;
        let now = session.value(parameter)?;
        let mut of_path = (false, None);
        let (value, range, logarithmic) = match now {
            Change::ByPath { parameter, value } => {
                let PathValue::Number(value) = value else {
                    return None;
                };
                let Kind::Number {
                    range,
                    whole,
                    logarithmic,
                    unit,
                } = &by_path(session, parameter)?.kind
                else {
                    return None;
                };
                let language = session.look.language;
                let unit = unit.as_ref().map(|unit| unit.in_language(language));
                of_path = (*whole, unit.map(str::to_owned));
                (value, range.clone(), *logarithmic)
            }
            Change::Place { of, position } => {
                let at_first = of.position(opened)?;
                let decade = distance(opened, at_first).log10().floor();
                let range = 10_f64.powf(decade - 1.0)..=10_f64.powf(decade + 2.0);
                (distance(opened, position), range, true)
            }
            Change::Coefficient {
                coefficient: Coefficient::Shininess,
                value,
                ..
            } => (value, SHININESS, true),
            Change::Coefficient { value, .. } => (value, 0.0..=1.0, false),
            Change::Divisions { divisions, .. } => {
                let [least, most] = [DIVISIONS.start(), DIVISIONS.end()].map(|&n| f64::from(n));
                (f64::from(divisions), least..=most, true)
            }
        };
        Some(Rail {
            value,
            range,
            logarithmic,
            whole: of_path.0 || matches!(now, Change::Divisions { .. }),
            is_length: matches!(now, Change::Place { .. }),
            unit: of_path.1,
        })
    }

    pub(super) fn in_words(&self, language: Language) -> String {
        let [least, most] = [self.range.start(), self.range.end()].map(|&end| language.number(end));
        let words = match self.is_length {
            true => strings::RANGE_OF_LENGTHS,
            false => strings::RANGE,
        };
        let range = words.format(language, &[("least", &least), ("most", &most)]);
        match &self.unit {
            Some(unit) => strings::RANGE_IN.format(language, &[("range", &range), ("unit", unit)]),
            None => range,
        }
    }
}

/// From what the camera looks at.
pub(super) fn distance(scene: &Scene, position: DVec3) -> f64 {
    let target = scene.camera.map_or(DVec3::ZERO, |camera| camera.target);
    position.distance(target)
}
