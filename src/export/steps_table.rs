//! The steps of a run as a table: a line a step, a column a value. Colours and vectors take three columns; what is not known at a step
//! is empty.

use super::making::Making;
use super::steps;
use super::tables::write_line;
use crate::record::{Field, Fields, Value};
use crate::replay::{Run, Walk};
use std::collections::HashMap;

/// The values known at a step, each name once: an inner scope's before an outer one's.
pub fn latest(fields: &Fields) -> impl Iterator<Item = &Field> {
    let all = fields.0.iter().enumerate();
    all.filter_map(|(index, field)| {
        let mut later = fields.0[index + 1..].iter();
        (!later.any(|later| later.name == field.name)).then_some(field)
    })
}

/// The columns and their values, by the ends of their names.
fn cells(value: Value) -> Vec<(&'static str, String)> {
    let three = |ends: [&'static str; 3], numbers: [f64; 3]| {
        let numbers = numbers.map(|number| format!("{number:?}"));
        ends.into_iter().zip(numbers).collect()
    };
    match value {
        Value::Number(number) => vec![("", format!("{number:?}"))],
        Value::Integer(integer) => vec![("", integer.to_string())],
        Value::Truth(truth) => vec![("", truth.to_string())],
        Value::Word(word) => vec![("", word.to_owned())],
        Value::Rgb(color) => three([".r", ".g", ".b"], color.channels()),
        Value::Vector(vector) => three([".x", ".y", ".z"], vector.to_array()),
    }
}

/// The names of the columns, in the order in which the run first knows them, then the steps. The run is read twice: for the names, and
/// for the values.
pub fn steps_in_table(run: Run) -> Making<'static> {
    let mut columns: HashMap<(&str, &str), usize> = HashMap::new();
    let mut names = ["step", "depth", "kind"].map(String::from).to_vec();
    let parts = steps::parts(&run);
    Making::new(2 * parts + 1, move |part, out| {
        if part < parts {
            for step in steps::part(&run, part) {
                for (name, end, _) in known(run.walk(), step) {
                    columns.entry((name, end)).or_insert_with(|| {
                        names.push(format!("{name}{end}"));
                        names.len() - 1
                    });
                }
            }
            return Ok(());
        }
        let Some(part) = part.checked_sub(parts + 1) else {
            return write_line(out, &names);
        };
        steps::part(&run, part).try_for_each(|step| {
            let walk = run.walk();
            let mut line = vec![String::new(); names.len()];
            line[0] = step.to_string();
            line[1] = walk.outline().depth(step).to_string();
            line[2] = walk.kind(step).to_owned();
            for (name, end, text) in known(walk, step) {
                line[columns[&(name, end)]] = text;
            }
            write_line(out, line)
        })
    })
}

/// The values known at a step, by the names of their columns and the ends of those.
fn known(walk: &dyn Walk, step: usize) -> Vec<(&'static str, &'static str, String)> {
    let fields = walk.fields(step);
    let known = latest(&fields).flat_map(|field| {
        let cells = cells(field.value).into_iter();
        cells.map(|(end, text)| (field.name, end, text))
    });
    known.collect()
}
