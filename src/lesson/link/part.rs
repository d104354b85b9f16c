//! The parts of an address that have numbers: which part of a picture is meant, and the values of parameters.

use crate::algorithms::focus::Focus;
use std::fmt::Display;
use std::str::FromStr;

/// How many numbers a part of the picture or of the exchange of that name has; none where it is no such name.
pub(super) fn counts(name: &str) -> Option<usize> {
    match name {
        "frame" => Some(0),
        "polygon" | "scan-line" | "patch" => Some(1),
        "pixel" | "iterations" | "form-factor" => Some(2),
        _ => None,
    }
}

/// None where the numbers are not those of such a part.
pub(super) fn focus(name: &str, numbers: &str) -> Option<Focus> {
    let numbers: Vec<u32> = list(numbers)?;
    Some(match (name, &*numbers) {
        ("frame", []) => Focus::Frame,
        ("polygon", &[number]) => Focus::Polygon(number as usize),
        ("scan-line", &[y]) => Focus::ScanLine(y),
        ("pixel", &[x, y]) => Focus::Pixel { x, y },
        ("iterations", &[start, end]) => Focus::Iterations { start, end },
        ("patch", &[number]) => Focus::Patch(number),
        ("form-factor", &[i, j]) => Focus::FormFactor { i, j },
        _ => return None,
    })
}

pub(super) fn of_focus(focus: Focus) -> String {
    match focus {
        Focus::Frame => "frame".into(),
        Focus::Polygon(number) => format!("polygon={number}"),
        Focus::ScanLine(y) => format!("scan-line={y}"),
        Focus::Pixel { x, y } => format!("pixel={x},{y}"),
        Focus::Iterations { start, end } => format!("iterations={start},{end}"),
        Focus::Patch(number) => format!("patch={number}"),
        Focus::FormFactor { i, j } => format!("form-factor={i},{j}"),
    }
}

/// The place of a parameter and its numbers. None where that is not what is written.
pub(super) fn change(text: &str) -> Option<(usize, Vec<f64>)> {
    let (place, numbers) = text.split_once(':')?;
    let numbers: Vec<f64> = list(numbers)?;
    let all = !numbers.is_empty() && numbers.iter().all(|number| number.is_finite());
    all.then_some((place.parse().ok()?, numbers))
}

pub(super) fn of_change((place, numbers): &(usize, Vec<f64>)) -> String {
    format!("change={place}:{}", joined(numbers))
}

fn list<T: FromStr>(text: &str) -> Option<Vec<T>> {
    let numbers = text.split(',').filter(|_| !text.is_empty());
    numbers.map(|number| number.parse().ok()).collect()
}

/// As short as they are read back the same.
fn joined<T: Display>(numbers: &[T]) -> String {
    let numbers: Vec<String> = numbers.iter().map(T::to_string).collect();
    numbers.join(",")
}
