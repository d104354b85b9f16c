//! The steps of a run as a table: a line a step, a column a value. Colours and vectors take three columns; what is not known at a step
//! is empty.

use super::progress::Progress;
use super::tables::write_line;
use crate::record::{Field, Fields, Value};
use crate::replay::Walk;
use std::collections::HashMap;
use std::io::{self, Write};

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

/// Writes the names of the columns, in the order in which the run first knows them, then the steps.
pub fn write(walk: &dyn Walk, out: &mut dyn Write) -> io::Result<()> {
    let progress = Progress::new("writing steps");
    let mut columns: HashMap<(&str, &str), usize> = HashMap::new();
    let mut names = ["step", "depth", "kind"].map(String::from).to_vec();
    let each = |step: usize, cell: &mut dyn FnMut(&'static str, &'static str, String)| {
        for field in latest(&walk.fields(step)) {
            for (end, text) in cells(field.value) {
                cell(field.name, end, text);
            }
        }
    };
    for step in 0..walk.len() {
        each(step, &mut |name, end, _| {
            columns.entry((name, end)).or_insert_with(|| {
                names.push(format!("{name}{end}"));
                names.len() - 1
            });
        });
        progress.show(step, 2 * walk.len());
    }
    write_line(out, &names)?;
    for step in 0..walk.len() {
        let mut line = vec![String::new(); names.len()];
        line[0] = step.to_string();
        line[1] = walk.outline().depth(step).to_string();
        line[2] = walk.kind(step).to_owned();
        each(step, &mut |name, end, text| {
            line[columns[&(name, end)]] = text
        });
        write_line(out, line)?;
        progress.show(walk.len() + step, 2 * walk.len());
    }
    Ok(())
}
