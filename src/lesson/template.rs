//! Numbers in narration: `{I_4}` becomes the value that the run recorded, so that no text can contradict the picture.

use crate::language::{Language, called};
use crate::record::{Fields, Value};

/// A piece of a narration text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Piece<'a> {
    Plain(&'a str),
    /// A field's name and, if given, how many decimals.
    Field(&'a str, Option<usize>),
}

/// Cuts a text at its braces. Errors: a brace without its partner, an empty name, decimals that are no number up to 12.
pub fn pieces(text: &str) -> Result<Vec<Piece<'_>>, String> {
    let mut pieces = Vec::new();
    let mut rest = text;
    while let Some(open) = rest.find(['{', '}']) {
        if rest[open..].starts_with('}') {
            return Err("found `}` without a `{` before it".into());
        }
        pieces.push(Piece::Plain(&rest[..open]));
        let inside = &rest[open + 1..];
        let close = inside
            .find('}')
            .ok_or("found `{` without a `}` behind it; write `{I_4}` or `{I_4:3}`")?;
        pieces.push(field(&inside[..close])?);
        rest = &inside[close + 1..];
    }
    pieces.push(Piece::Plain(rest));
    Ok(pieces)
}

fn field(inside: &str) -> Result<Piece<'_>, String> {
    let (name, decimals) = match inside.split_once(':') {
        None => (inside, None),
        Some((name, decimals)) => match decimals.parse() {
            Ok(decimals) if decimals <= 12 => (name, Some(decimals)),
            _ => {
                return Err(format!(
                    "found `{{{inside}}}`; behind the colon stands the number of decimals, 0 to 12"
                ));
            }
        },
    };
    if name.is_empty() {
        Err("found `{}`; the name of a value belongs between the braces".into())
    } else {
        Ok(Piece::Field(name, decimals))
    }
}

/// The text with its values. Errors: what [`pieces`] refuses, and names that were not recorded.
pub fn fill(text: &str, fields: &Fields, language: Language) -> Result<String, String> {
    pieces(text)?
        .into_iter()
        .map(|piece| match piece {
            Piece::Plain(plain) => Ok(plain.to_owned()),
            Piece::Field(name, decimals) => match fields.get(name) {
                Some(value) => Ok(write(value, decimals, language)),
                None => {
                    let recorded: Vec<&str> = fields.iter().map(|field| field.name).collect();
                    Err(format!(
                        "found `{{{name}}}`, which is not recorded at this step; recorded are {}",
                        recorded.join(", ")
                    ))
                }
            },
        })
        .collect()
}

/// A value as narration writes it: a grey colour as one number.
pub fn write(value: Value, decimals: Option<usize>, language: Language) -> String {
    let one = |v: f64| {
        decimals.map_or_else(
            || language.number(v),
            |decimals| language.fixed(v, decimals),
        )
    };
    match value {
        Value::Number(v) => one(v),
        Value::Integer(v) => v.to_string(),
        Value::Rgb(color) if color.is_grey() => one(color.r),
        Value::Rgb(color) => format!("({})", language.list(color.channels().map(one))),
        Value::Vector(vector) => format!("({})", language.list(vector.to_array().map(one))),
        Value::Truth(truth) => if truth { "✓" } else { "✗" }.to_owned(),
        Value::Word(word) => called("value", word, language).unwrap_or_else(|| word.to_owned()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::color::Rgb;

    #[test]
    fn values_are_filled_in() {
        let mut fields = Fields::default();
        fields
            .push("y", 15_u32)
            .push("I_4", Rgb::splat(0.51399))
            .push("I_5", Rgb::new(0.25, 0.5, 1.0));
        assert_eq!(
            fill("Line {y}: {I_4:2}, {I_5:2}.", &fields, Language::English),
            Ok("Line 15: 0.51, (0.25, 0.50, 1.00).".into())
        );
        fields.push("channel", "red");
        assert_eq!(
            fill("Kanal {channel}: {I_4:2}", &fields, Language::Indonesian),
            Ok("Kanal merah: 0,51".into())
        );
        assert!(
            fill("{I_6}", &fields, Language::English)
                .unwrap_err()
                .contains("recorded are y, I_4, I_5, channel")
        );
        for broken in ["{", "}", "a {y", "{}", "{y:x}", "{y:99}"] {
            assert!(
                fill(broken, &fields, Language::English).is_err(),
                "{broken}"
            );
        }
    }
}
