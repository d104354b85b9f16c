//! The values known at a step, in the groups of the steps that recorded them, as they are written.

use super::super::{names, values};
use crate::figure::Cell;
use crate::language::{Language, Message};
use crate::panels::PanelInput;
use crate::picture::{Ink, Style};
use crate::record::{Field, Value};
use crate::replay::{RecordedField, Walk};
use crate::vocabulary::counted;

/// What is known at `step`, each name once, the innermost first.
pub(super) fn known(walk: &dyn Walk, step: usize) -> Vec<RecordedField> {
    let recorded = walk.recorded(step);
    let mut known: Vec<RecordedField> = Vec::new();
    for group in recorded.chunk_by(|a, b| a.step == b.step).rev() {
        for &value in group {
            if known
                .iter()
                .all(|inner| inner.field.name != value.field.name)
            {
                known.push(value);
            }
        }
    }
    known
}

/// A line of the list.
pub(super) enum Line {
    /// The step that recorded the values below it.
    Heading {
        step: usize,
        kind: String,
    },
    Value(Known),
}

/// A value with its name, as they are written.
pub(super) struct Known {
    pub recorded: RecordedField,
    name: String,
    value: String,
}

impl Known {
    fn of(recorded: RecordedField, input: &PanelInput, decimals: usize) -> Self {
        let (walk, language) = (input.run.walk(), input.language);
        let Field { name, value } = recorded.field;
        let quantity = walk.declared(recorded.step).quantity(name);
        let symbol = quantity.map(|quantity| names::quantity(quantity, language));
        let shown = values::shown(counted(name, value), decimals, language);
        let thing = names::of_field(input.run.prepared(), name, value, language);
        Known {
            recorded,
            name: symbol.unwrap_or_else(|| name.to_string()),
            value: thing.map_or(shown.clone(), |thing| format!("{shown} · {thing}")),
        }
    }

    /// Whether the value, its name or its meaning has the text.
    fn says(&self, text: &str, walk: &dyn Walk, language: Language) -> bool {
        let name = self.recorded.field.name;
        let kind = walk.declared(self.recorded.step);
        let meaning = kind.meaning(name, language).unwrap_or_default();
        let said = [name, &self.name, &self.value, &meaning];
        said.iter().any(|said| has(said, text))
    }

    /// Set in text of `size` points; the step's own values stand out.
    pub fn cells(&self, size: f32, is_own: bool) -> [Cell; 2] {
        let (style, ink) = match is_own {
            true => (Style::MonoBold, Ink::This),
            false => (Style::Mono, Ink::Text),
        };
        let swatch = match self.recorded.field.value {
            Value::Rgb(color) => Some(Ink::Rgb(color)),
            _ => None,
        };
        [
            Cell::new(&self.name, Style::Label.size(size).ink(Ink::Muted)),
            Cell::new(&self.value, style.size(size).ink(ink)).swatch(swatch),
        ]
    }
}

/// Whether a text has another, be it in capitals or not.
fn has(text: &str, searched: &str) -> bool {
    text.to_lowercase().contains(&searched.to_lowercase())
}

/// The lines of what is known at `shown`, whose own values need no heading, the groups from the innermost outwards; only those that the
/// search finds.
pub(super) fn lines(
    known: &[RecordedField],
    shown: usize,
    input: &PanelInput,
    decimals: usize,
) -> Vec<Line> {
    let (walk, language) = (input.run.walk(), input.language);
    let search = input.inspector.search.trim();
    let mut lines = Vec::new();
    for group in known.chunk_by(|a, b| a.step == b.step) {
        let step = group[0].step;
        let kind = names::kind(walk.kind(step), language);
        let values = group.iter().map(|&value| Known::of(value, input, decimals));
        let is_found = |value: &Known| has(&kind, search) || value.says(search, walk, language);
        let found: Vec<Line> = values.filter(is_found).map(Line::Value).collect();
        if !found.is_empty() && step != shown {
            lines.push(Line::Heading { step, kind });
        }
        lines.extend(found);
    }
    lines
}

/// A heading: the kind of the step with its number, or its number alone.
pub(super) fn heading(kind: &str, step: usize, input: &PanelInput, size: f32, ink: Ink) -> Cell {
    let set = Style::Bold.size(size).ink(ink);
    let number = step_in_words(step, input.language);
    let long = format!("{kind} · {number}");
    Cell::forms([(long, set), (number, set)])
}

pub(super) fn step_in_words(step: usize, language: Language) -> String {
    Message("inspector-step").format(language, &[("step", &step.to_string())])
}
