//! Numbers in narration: `{I_4}` becomes the value that the run recorded, so that no text can contradict the picture.

use crate::language::{Language, called};
use crate::record::{Fields, Value};

/// A piece of a narration text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Piece<'a> {
    Plain(&'a str),
    /// A field's name and, if given, how many decimals.
    Field(&'a str, Option<usize>),
    /// What the thing is called whose number the field is.
    Name(&'a str),
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
        Some((name, "name")) => return Ok(Piece::Name(name)),
        Some((name, decimals)) => match decimals.parse() {
            Ok(decimals) if decimals <= 12 => (name, Some(decimals)),
            _ => {
                return Err(format!(
                    "found `{{{inside}}}`; behind the colon stands the number of decimals, 0 to 12, or `name`"
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

/// The names of the values that a text shows.
pub fn names(text: &str) -> Vec<String> {
    let pieces = pieces(text).unwrap_or_default().into_iter();
    let names = pieces.filter_map(|piece| match piece {
        Piece::Field(name, _) => Some(name.to_owned()),
        Piece::Plain(_) | Piece::Name(_) => None,
    });
    names.collect()
}

/// Whether a text has numbers of its own, which are not those of the run: digits that are no part of a name.
pub fn types_numbers(text: &str) -> bool {
    let pieces = pieces(text).unwrap_or_default();
    pieces.iter().any(|piece| {
        let Piece::Plain(plain) = piece else {
            return false;
        };
        let mut before = ' ';
        plain.chars().any(|c| {
            let starts = c.is_ascii_digit() && !(before.is_alphanumeric() || before == '_');
            before = c;
            starts
        })
    })
}

/// The text with its values; `called` gives the names of things of the scene by field and value. Errors: what [`pieces`] refuses,
/// fields that were not recorded, and numbers that are of no thing.
pub fn fill<'a>(
    text: &str,
    fields: &Fields,
    called: impl Fn(&str, Value) -> Option<&'a str>,
    language: Language,
) -> Result<String, String> {
    let recorded = |name: &str| {
        fields.get(name).ok_or_else(|| {
            let recorded: Vec<&str> = fields.iter().map(|field| field.name).collect();
            let recorded = recorded.join(", ");
            format!(
                "found `{{{name}}}`, which is not recorded at this step; recorded are {recorded}"
            )
        })
    };
    let filled = pieces(text)?.into_iter().map(|piece| match piece {
        Piece::Plain(plain) => Ok(plain.to_owned()),
        Piece::Field(name, decimals) => Ok(write(recorded(name)?, decimals, language)),
        Piece::Name(name) => {
            let thing = called(name, recorded(name)?).map(str::to_owned);
            thing.ok_or_else(|| format!("found `{{{name}:name}}`, which is no thing of the scene"))
        }
    });
    filled.collect()
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

    fn english(text: &str, fields: &Fields) -> Result<String, String> {
        let called = |field: &str, value| {
            let is_ball = (field, value) == ("object", Value::Integer(2));
            is_ball.then_some("red ball")
        };
        fill(text, fields, called, Language::English)
    }

    #[test]
    fn things_are_called_by_their_names() {
        let mut fields = Fields::default();
        fields.push("object", 2_u32).push("y", 2_u32);
        assert_eq!(
            english("The {object:name}, {object}.", &fields),
            Ok("The red ball, 2.".into())
        );
        assert_eq!(
            english("{y:name}", &fields).unwrap_err(),
            "found `{y:name}`, which is no thing of the scene"
        );
    }

    #[test]
    fn values_are_filled_in() {
        let mut fields = Fields::default();
        fields
            .push("y", 15_u32)
            .push("I_4", Rgb::splat(0.51399))
            .push("I_5", Rgb::new(0.25, 0.5, 1.0));
        assert_eq!(
            english("Line {y}: {I_4:2}, {I_5:2}.", &fields),
            Ok("Line 15: 0.51, (0.25, 0.50, 1.00).".into())
        );
        fields.push("channel", "red");
        assert_eq!(
            fill(
                "Kanal {channel}: {I_4:2}",
                &fields,
                |_, _| None,
                Language::Indonesian
            ),
            Ok("Kanal merah: 0,51".into())
        );
        assert!(
            english("{I_6}", &fields)
                .unwrap_err()
                .contains("recorded are y, I_4, I_5, channel")
        );
        for broken in ["{", "}", "a {y", "{}", "{y:x}", "{y:99}"] {
            assert!(english(broken, &fields).is_err(), "{broken}");
        }
    }
}
