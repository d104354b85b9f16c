//! Rows of numbers that another program wrote: JSON, a text with a row a line, or the `.npy` of NumPy.

mod npy;

use crate::scene::what_the_parser_says;
use serde_json::Value as Json;

/// The rows of a list of lists or of a list of numbers; of an object those under `key`. A text has a row a line, its numbers separated by
/// commas, semicolons or spaces; where its first line names columns, only those count that are called `key`, or `key` and a dot and more.
/// Errors: what is wrong, with its row, counted from 0.
pub fn rows(bytes: &[u8], key: &str) -> Result<Vec<Vec<f64>>, String> {
    if npy::is_npy(bytes) {
        return finite(npy::rows(bytes)?);
    }
    let text = std::str::from_utf8(bytes);
    let text = text.map_err(|_| "it is neither a text in UTF-8 nor an .npy file".to_owned())?;
    let text = text.trim_start_matches('\u{feff}');
    finite(match text.trim_start().starts_with(['[', '{']) {
        true => of_json(text, key)?,
        false => of_lines(text, key)?,
    })
}

fn finite(rows: Vec<Vec<f64>>) -> Result<Vec<Vec<f64>>, String> {
    let is_wrong = |row: &Vec<f64>| row.iter().any(|number| !number.is_finite());
    match rows.iter().position(is_wrong) {
        Some(row) => Err(format!("row {row}: a number is not finite")),
        None => Ok(rows),
    }
}

fn of_json(text: &str, key: &str) -> Result<Vec<Vec<f64>>, String> {
    let json: Json = serde_json::from_str(text).map_err(|error| {
        let (line, column) = (error.line(), error.column());
        let says = what_the_parser_says(&error, "the file");
        format!("line {line}, column {column}: {says}")
    })?;
    let missing = format!("it has no \"{key}\"; that is a list of rows, each a list of numbers");
    let rows = match &json {
        Json::Array(rows) => rows.iter().collect(),
        json => match json.get(key) {
            Some(Json::Array(rows)) => rows.iter().collect(),
            _ => of_surfaces(json, key).ok_or(missing)?,
        },
    };
    let number = |row: usize, json: &Json| match json {
        Json::Number(number) => Ok(number.as_f64().unwrap_or(f64::NAN)),
        other => Err(format!("row {row}: {other} is not a number")),
    };
    let row = |(row, json): (usize, &Json)| match json {
        Json::Array(numbers) => numbers.iter().map(|json| number(row, json)).collect(),
        json => Ok(vec![number(row, json)?]),
    };
    rows.into_iter().enumerate().map(row).collect()
}

/// What the patches of `lightwalk radiosity` have under the key.
fn of_surfaces<'a>(json: &'a Json, key: &str) -> Option<Vec<&'a Json>> {
    let surfaces = json.get("surfaces")?.as_array()?;
    let patches = surfaces
        .iter()
        .map(|surface| surface.get("patches")?.as_array());
    let patches: Vec<&Vec<Json>> = patches.collect::<Option<_>>()?;
    patches
        .into_iter()
        .flatten()
        .map(|patch| patch.get(key))
        .collect()
}

fn of_lines(text: &str, key: &str) -> Result<Vec<Vec<f64>>, String> {
    let mut lines = text
        .lines()
        .filter(|line| !line.trim().is_empty())
        .peekable();
    let named = lines.peek().and_then(|first| columns(&cells(first), key));
    if named.is_some() {
        lines.next();
    }
    let row = |(row, line): (usize, &str)| {
        let cells = cells(line);
        let wanted: Vec<&String> = match &named {
            None => cells.iter().collect(),
            Some(columns) => columns.iter().filter_map(|&at| cells.get(at)).collect(),
        };
        let numbers = wanted.into_iter().map(|cell| {
            let number = cell.parse::<f64>();
            number.map_err(|_| format!("row {row}: {cell:?} is not a number"))
        });
        numbers.collect::<Result<Vec<f64>, String>>()
    };
    lines.enumerate().map(row).collect()
}

/// Which columns a first line calls by the key; none where it names no such column.
fn columns(names: &[String], key: &str) -> Option<Vec<usize>> {
    let is_it = |name: &str| name == key || name.starts_with(&format!("{key}."));
    let found = (0..names.len()).filter(|&at| is_it(&names[at]));
    let found: Vec<usize> = found.collect();
    (!found.is_empty()).then_some(found)
}

/// The cells of a line, between commas, semicolons or tabs, or else between spaces; a cell in quotes may have such a sign in it.
fn cells(line: &str) -> Vec<String> {
    let by_signs = line.contains([',', ';', '\t']);
    let ends = |c: char| match by_signs {
        true => matches!(c, ',' | ';' | '\t'),
        false => c.is_whitespace(),
    };
    let (mut cells, mut cell, mut quoted) = (Vec::new(), String::new(), false);
    for c in line.trim().chars() {
        match c {
            '"' => quoted = !quoted,
            c if ends(c) && !quoted => cells.push(std::mem::take(&mut cell)),
            c => cell.push(c),
        }
    }
    cells.push(cell);
    cells.retain(|cell| by_signs || !cell.is_empty());
    cells.iter().map(|cell| cell.trim().to_owned()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    const F: [[f64; 2]; 2] = [[0.0, 0.4], [0.1, 0.2]];

    fn read(text: &str) -> Result<Vec<Vec<f64>>, String> {
        rows(text.as_bytes(), "matrix")
    }

    #[test]
    fn rows_are_read_from_json_and_from_lines() {
        for text in [
            "[[0, 0.4], [0.1, 0.2]]",
            "{\"matrix\": [[0, 0.4], [0.1, 0.2]], \"method\": 1}",
            "0, 0.4\n0.1, 0.2\n",
            "\u{feff}0, 0.4\n0.1, 0.2\n",
            "0;0.4\r\n\n0.1;0.2",
            "  0   0.4 \n0.1\t0.2",
            "\"object, i\",matrix.1,matrix.2\n\"a, b\",0,0.4\n\"c\",0.1,0.2\n",
        ] {
            assert_eq!(read(text), Ok(F.map(|row| row.to_vec()).to_vec()), "{text}");
        }
        assert_eq!(read("[0.5, 1]"), Ok(vec![vec![0.5], vec![1.0]]));
        let light = r#"{"surfaces": [{"patches": [{"radiosity": [1, 2, 3]}]}, {"patches": [{"radiosity": [4, 5, 6]}]}]}"#;
        let light = rows(light.as_bytes(), "radiosity");
        assert_eq!(light, Ok(vec![vec![1.0, 2.0, 3.0], vec![4.0, 5.0, 6.0]]));
    }

    #[test]
    fn what_is_no_number_is_reported_with_its_row() {
        for (text, expected) in [
            ("0 0.4\n0.1 x", "row 1: \"x\" is not a number"),
            ("1,,3", "row 0: \"\" is not a number"),
            ("0 0.4\n0.1 inf", "row 1: a number is not finite"),
            ("0 0.4\nNaN 1", "row 1: a number is not finite"),
            ("[[0, 1], [\"x\", 2]]", "row 1: \"x\" is not a number"),
            ("[[0, null]]", "row 0: null is not a number"),
            (
                "{\"rows\": 1}",
                "it has no \"matrix\"; that is a list of rows, each a list of numbers",
            ),
            (
                "[[0, NaN], [0, 0]]",
                "line 1, column 6: expected a value: a number, text in double quotes, true, false, a list or an object (NaN and Infinity are none)",
            ),
        ] {
            assert_eq!(read(text), Err(expected.to_owned()));
        }
        assert!(
            read("[[0, 0.4], [0.1, 0.2]")
                .unwrap_err()
                .contains("the file ends here")
        );
        let binary = rows(&[0xff, 0xfe, 0x00], "matrix").unwrap_err();
        assert_eq!(binary, "it is neither a text in UTF-8 nor an .npy file");
    }
}
