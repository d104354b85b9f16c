//! Search in the reader's own words: what a step is called, what it is about, and the numbers that it shows.

use super::names;
use crate::algorithms::prepared_scene::PreparedScene;
use crate::language::Language;
use crate::record::{Fields, Value};
use crate::replay::Run;
use std::collections::HashMap;
use std::ops::Range;

/// The first `most` steps of a range that a text is about, ascending: in the name of the step or of its scope's kind, in the name of
/// what is met or lit, in a recorded word, or as a number rounded to as many decimals as are written.
pub fn found(
    run: &Run,
    text: &str,
    language: Language,
    steps: Range<usize>,
    most: usize,
) -> Vec<usize> {
    let wanted = Wanted::new(text);
    let (walk, prepared) = (run.walk(), run.prepared());
    let mut kinds: HashMap<&str, bool> = HashMap::new();
    let mut words: HashMap<&str, bool> = HashMap::new();
    let mut fields = Fields::default();
    let holds = |&step: &usize| {
        let declared = walk.declared(step);
        if *kinds.entry(declared.name).or_insert_with(|| {
            wanted.names(&names::kind(declared.name, language))
                || wanted.names(&names::scope_kind(declared, language))
        }) {
            return true;
        }
        fields.0.clear();
        walk.push_fields(step, &mut fields);
        fields.iter().any(|field| match field.value {
            Value::Word(word) => *words
                .entry(word)
                .or_insert_with(|| wanted.names(&names::word(word, language))),
            value => {
                wanted.is_number(value) || wanted.is_thing(prepared, field.name, value, language)
            }
        })
    };
    steps.filter(holds).take(most).collect()
}

/// What is searched for.
struct Wanted {
    /// In small letters.
    text: String,
    /// The number that it is, and half a unit of its last decimal.
    number: Option<(f64, f64)>,
}

impl Wanted {
    fn new(text: &str) -> Self {
        let text = text.trim().to_lowercase();
        let plain = text.replace('−', "-").replace(',', ".");
        let decimals = plain.split_once('.').map_or(0, |(_, behind)| behind.len());
        let half = 0.5 * 10_f64.powi(-i32::try_from(decimals).unwrap_or(i32::MAX));
        let number = plain
            .parse::<f64>()
            .ok()
            .filter(|number| number.is_finite());
        Wanted {
            number: number.map(|number| (number, half)),
            text,
        }
    }

    fn names(&self, name: &str) -> bool {
        self.number.is_none() && !self.text.is_empty() && name.to_lowercase().contains(&self.text)
    }

    fn is_number(&self, value: Value) -> bool {
        let Some((wanted, half)) = self.number else {
            return false;
        };
        // A value halfway between two decimals may be rounded either way.
        let is = |number: f64| (number - wanted).abs() <= half * (1.0 + 1e-9);
        match value {
            Value::Number(number) => is(number),
            Value::Integer(number) => number as f64 == wanted,
            Value::Rgb(color) => [color.r, color.g, color.b].into_iter().any(is),
            Value::Vector(vector) => vector.to_array().into_iter().any(is),
            _ => false,
        }
    }

    fn is_thing(
        &self,
        prepared: &PreparedScene,
        field: &str,
        value: Value,
        language: Language,
    ) -> bool {
        let thing = names::of_field(prepared, field, value, language);
        thing.is_some_and(|thing| self.names(thing))
    }
}

#[cfg(test)]
mod tests {
    use super::super::fixture::Fixture;
    use super::super::fixtures;
    use super::*;
    use crate::render::Method;

    fn kinds(run: &Run, text: &str, language: Language) -> Vec<&'static str> {
        let steps = found(run, text, language, 0..run.walk().len(), usize::MAX);
        let mut kinds: Vec<_> = steps.iter().map(|&step| run.walk().kind(step)).collect();
        kinds.dedup();
        kinds
    }

    #[test]
    fn a_step_is_found_by_what_it_is_called_in_either_language() {
        let run = Fixture::triangle(Method::Gouraud).run;
        assert!(kinds(&run, "SCAN LINE", Language::English).contains(&"ScanLine"));
        assert!(kinds(&run, "garis scan", Language::Indonesian).contains(&"ScanLine"));
        assert!(kinds(&run, "no such thing", Language::English).is_empty());
        assert!(kinds(&run, "", Language::English).is_empty());
    }

    #[test]
    fn a_step_is_found_by_what_a_ray_meets() {
        let run = fixtures::rays(Method::RayTracing, 1).run;
        let object = run.prepared().scene.objects[0].name.clone();
        let steps = found(
            &run,
            &object.to_uppercase(),
            Language::English,
            0..run.walk().len(),
            9,
        );
        assert!(!steps.is_empty(), "{object}");
        for step in steps {
            let fields = run.walk().own_fields(step);
            let is_it = |name| fields.get(name) == Some(Value::Integer(0));
            assert!(is_it("object") || is_it("blocker"), "step {step}");
        }
    }

    #[test]
    fn a_number_is_found_as_it_is_shown_and_no_other() {
        let run = Fixture::triangle(Method::Gouraud).run;
        let step = (0..run.walk().len()).find(|&step| run.walk().kind(step) == "SpanInterpolated");
        let step = step.expect("a span is filled");
        let Some(Value::Rgb(color)) = run.walk().own_fields(step).get("I_P") else {
            panic!("the step records its intensity");
        };
        for (text, language) in [
            (format!("{:.3}", color.r), Language::English),
            (
                format!("{:.3}", color.r).replace('.', ","),
                Language::Indonesian,
            ),
        ] {
            let steps = found(&run, &text, language, 0..run.walk().len(), usize::MAX);
            assert!(steps.contains(&step), "{text}");
            assert!(steps.len() < run.walk().len() / 10, "{} steps", steps.len());
        }
    }
}
