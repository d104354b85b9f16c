//! Whether a file that was written is whole, and all its numbers are finite.

use crate::kit::not_finite;
use lightwalk::color::read_image;
use serde_json::Value;
use std::fs;
use std::path::Path;

pub fn check_file(path: &Path) -> Result<(), String> {
    let bytes = fs::read(path).map_err(|error| error.to_string())?;
    let ending = path.extension().and_then(|ending| ending.to_str());
    let text = || String::from_utf8(bytes.clone()).map_err(|_| "it is no text");
    match ending.unwrap_or_default() {
        "png" => match bytes.ends_with(b"IEND\xaeB`\x82") {
            true => image(&bytes),
            false => Err("it has no end".into()),
        },
        "pfm" => image(&bytes),
        "gif" => match bytes.starts_with(b"GIF89a") && bytes.ends_with(b";") {
            true => Ok(()),
            false => Err("it has no end".into()),
        },
        "npy" => numbers(&bytes),
        "json" | "" => json(&text()?),
        "jsonl" => text()?.lines().try_for_each(json),
        "csv" => table(&text()?),
        "svg" => marked_up(&text()?, "</svg>"),
        "html" => marked_up(&text()?, ">"),
        ending => Err(format!("a file that ends in {ending} is not known here")),
    }
}

fn image(bytes: &[u8]) -> Result<(), String> {
    let image = read_image(bytes)?;
    let mut channels = image.pixels.iter().flatten();
    match channels.all(|channel| channel.is_finite()) {
        true => Ok(()),
        false => Err("a colour that is not finite".into()),
    }
}

/// NumPy's: the length of the header stands behind the version, and f64 behind the header.
fn numbers(bytes: &[u8]) -> Result<(), String> {
    let length = bytes.get(8..10).ok_or("it has no header")?;
    let start = 10 + usize::from(u16::from_le_bytes([length[0], length[1]]));
    let (numbers, rest) = bytes
        .get(start..)
        .ok_or("it has no numbers")?
        .as_chunks::<8>();
    match rest.is_empty()
        && numbers
            .iter()
            .all(|&number| f64::from_le_bytes(number).is_finite())
    {
        true => Ok(()),
        false => Err("a number that is not finite, or half of one".into()),
    }
}

fn json(text: &str) -> Result<(), String> {
    let value: Value = serde_json::from_str(text).map_err(|error| error.to_string())?;
    match missing(&value, "") {
        None => Ok(()),
        Some(path) => Err(format!("{path} is null in {text:.300}")),
    }
}

/// What may be infinite in a step: a light can be as far away, and where nothing was met yet, so is the nearest; a ray that misses meets at t = ∞.
const INFINITE: [&str; 4] = ["d", "t", "nearest", "NearestT"];

/// The path of a null, as which a number that is not finite is written.
fn missing(value: &Value, path: &str) -> Option<String> {
    match value {
        Value::Null => Some(path.to_owned()),
        Value::Array(items) => items
            .iter()
            .enumerate()
            .find_map(|(i, item)| missing(item, &format!("{path}/{i}"))),
        Value::Object(map) => {
            let mut known = map
                .iter()
                .filter(|(key, _)| !INFINITE.contains(&key.as_str()));
            known.find_map(|(key, item)| missing(item, &format!("{path}/{key}")))
        }
        _ => None,
    }
}

fn table(text: &str) -> Result<(), String> {
    let mut lines = text.lines().map(|line| line.split(',').collect::<Vec<_>>());
    let names = lines.next().ok_or("it has no line")?;
    if !text.ends_with('\n') {
        return Err("it ends within a line".into());
    }
    for line in lines {
        if line.len() != names.len() {
            return Err(format!(
                "a line has {} columns and not {}",
                line.len(),
                names.len()
            ));
        }
        for (name, cell) in names.iter().zip(line) {
            if not_finite(cell).is_some() && !INFINITE.contains(name) {
                return Err(format!("{name} is {cell}"));
            }
        }
    }
    Ok(())
}

fn marked_up(text: &str, end: &str) -> Result<(), String> {
    match text.trim_end().ends_with(end) && not_finite(text).is_none() {
        true => Ok(()),
        false => Err("it has no end, or a number that is not finite".into()),
    }
}
