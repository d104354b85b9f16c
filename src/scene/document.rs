//! Reading a JSON document so that every problem has a place: its path in the document, and where it can, line and column.
//!
//! Lesson files are read through the same door. A type that is read here has `#[serde(deny_unknown_fields)]` and a field
//! `#[serde(default, deserialize_with = "present")] schema: Option<Schema>`. It avoids `flatten`, `untagged` and internally
//! tagged enums, which lose line, column and path.

use super::mesh_file::misplaced;
use super::parser_words::{missing, what_the_parser_says};
use super::schema::schema_of;
pub use super::values::ByName;
use schemars::JsonSchema;
use serde::Deserialize;
use serde::de::value::MapAccessDeserializer;
use serde::de::{DeserializeOwned, Deserializer, Error, IgnoredAny, MapAccess, Visitor};
use serde_path_to_error::Segment;
use std::fmt;
use std::marker::PhantomData;

/// The largest document that is read, in bytes. Meshes, which can be large, are files of their own.
pub const MAX_BYTES: usize = 64 << 20;

/// What is wrong with a file, and where.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Problem {
    /// The path in the document, such as `objects[2].material`; empty for the document as a whole.
    pub place: String,
    /// Counted from 1; of a mistake in a value or reference, where that is in the text.
    pub line: Option<usize>,
    /// In bytes, counted from 1.
    pub column: Option<usize>,
    /// What was found, and what is allowed.
    pub message: String,
}

impl fmt::Display for Problem {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        if let (Some(line), Some(column)) = (self.line, self.column) {
            write!(f, "line {line}, column {column}: ")?;
        }
        if !self.place.is_empty() {
            write!(f, "{}: ", OneLine(&self.place))?;
        }
        write!(f, "{}", OneLine(&self.message))
    }
}

/// Problems as they are shown: one a line.
pub fn one_a_line(problems: &[Problem]) -> String {
    let lines: Vec<String> = problems.iter().map(Problem::to_string).collect();
    lines.join("\n")
}

/// Text that may quote a file: on one line, of bounded length, without control characters.
pub(super) struct OneLine<'a>(pub &'a str);

impl fmt::Display for OneLine<'_> {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        const LONGEST: usize = 600;
        for character in self.0.chars().take(LONGEST) {
            if character.is_control() {
                write!(f, "{}", character.escape_default())?;
            } else {
                write!(f, "{character}")?;
            }
        }
        f.write_str(if self.0.chars().nth(LONGEST).is_some() {
            " …"
        } else {
            ""
        })
    }
}

/// A place in a document, written only when a problem is found there.
#[derive(Clone, Copy, Debug)]
pub enum Place<'a> {
    /// The path of the outermost value; empty for a whole file.
    Root(&'a str),
    Key(&'a Place<'a>, &'a str),
    Index(&'a Place<'a>, usize),
}

impl<'a> Place<'a> {
    pub fn key(&'a self, key: &'a str) -> Place<'a> {
        Place::Key(self, key)
    }

    pub fn index(&'a self, index: usize) -> Place<'a> {
        Place::Index(self, index)
    }
}

impl fmt::Display for Place<'_> {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Place::Root(path) => f.write_str(path),
            Place::Key(Place::Root(""), key) => f.write_str(key),
            Place::Key(parent, key) => write!(f, "{parent}.{key}"),
            Place::Index(parent, index) => write!(f, "{parent}[{index}]"),
        }
    }
}

/// Reads a whole document, whose outermost object says `"schema": 1`. A byte order mark at its start is passed over.
///
/// Errors: the first problem of size, encoding, schema, syntax, keys or types, with line and column; of keys of the outermost object that
/// are missing, all.
pub fn parse<T: DeserializeOwned + JsonSchema>(bytes: &[u8]) -> Result<T, Problem> {
    let text = text_of(bytes)?;
    // The schema decides which keys there are, so it is judged before them, wherever it stands.
    let outline = read::<OnlySchema>(text);
    match &outline {
        Err(problem) if problem.place == "schema" => return Err(problem.clone()),
        _ => (),
    }
    let value = read(text).map_err(|problem| with_all_missing::<T>(problem, text))?;
    match outline?.schema {
        Some(Schema) => Ok(value),
        None => Err(Problem {
            line: Some(1),
            column: Some(1),
            ..whole_file(
                "the key `schema` is missing; the document starts with \"schema\": 1".into(),
            )
        }),
    }
}

/// The problem, which where it is that a key of the outermost object is missing names all that are.
fn with_all_missing<T: JsonSchema>(problem: Problem, text: &str) -> Problem {
    let Ok(ByName(keys)) = serde_json::from_str::<ByName<IgnoredAny>>(text) else {
        return problem;
    };
    let schema = schema_of::<T>();
    let required = schema["required"].as_array().into_iter().flatten();
    let required = required.filter_map(|key| key.as_str());
    let lacking: Vec<&str> = required
        .filter(|required| keys.iter().all(|(key, _)| key != required))
        .collect();
    let is_of_one =
        problem.place.is_empty() && lacking.iter().any(|key| problem.message == missing(&[key]));
    match is_of_one {
        true => Problem {
            message: missing(&lacking),
            ..problem
        },
        false => problem,
    }
}

fn whole_file(message: String) -> Problem {
    Problem {
        place: String::new(),
        line: None,
        column: None,
        message,
    }
}

fn text_of(bytes: &[u8]) -> Result<&str, Problem> {
    if bytes.len() > MAX_BYTES {
        return Err(whole_file(format!(
            "the file has {} bytes; at most {MAX_BYTES} are allowed",
            bytes.len()
        )));
    }
    if let Some(message) = misplaced(bytes) {
        return Err(whole_file(message));
    }
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    let text = std::str::from_utf8(bytes).map_err(|error| {
        let good = &bytes[..error.valid_up_to()];
        let line_start = good.iter().rposition(|&b| b == b'\n').map_or(0, |i| i + 1);
        Problem {
            line: Some(1 + good.iter().filter(|&&b| b == b'\n').count()),
            column: Some(1 + good.len() - line_start),
            ..whole_file(format!(
                "found the byte 0x{:02x}, which is not UTF-8 here; save the file as UTF-8",
                bytes[good.len()]
            ))
        }
    })?;
    if text.trim().is_empty() {
        return Err(whole_file(
            "the file is empty; it needs a JSON object with \"schema\": 1".into(),
        ));
    }
    Ok(text)
}

fn read<T: DeserializeOwned>(text: &str) -> Result<T, Problem> {
    let mut json = serde_json::Deserializer::from_str(text);
    let Keyed(value) = serde_path_to_error::deserialize(&mut json)
        .map_err(|error| described(place_of(error.path()), error.inner()))?;
    json.end()
        .map_err(|error| described(String::new(), &error))?;
    Ok(value)
}

/// A path written like a [`Place`].
fn place_of(path: &serde_path_to_error::Path) -> String {
    let mut place = String::new();
    for segment in path {
        match segment {
            Segment::Seq { index } => place += &format!("[{index}]"),
            Segment::Map { key: name } | Segment::Enum { variant: name } => {
                if !place.is_empty() {
                    place.push('.');
                }
                place += name;
            }
            Segment::Unknown => (),
        }
    }
    place
}

/// A problem in the words of a user who does not know serde.
fn described(place: String, error: &serde_json::Error) -> Problem {
    let message = what_the_parser_says(error, "the file");
    Problem {
        place,
        line: Some(error.line()),
        column: Some(error.column()),
        message,
    }
}

/// The value of the key `schema`, which is 1.
#[derive(Clone, Copy, Debug)]
pub struct Schema;

impl<'de> Deserialize<'de> for Schema {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct One;
        impl Visitor<'_> for One {
            type Value = Schema;

            fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
                f.write_str("1, the schema that this version reads")
            }

            fn visit_u64<E: Error>(self, found: u64) -> Result<Schema, E> {
                match found {
                    1 => Ok(Schema),
                    _ => Err(E::invalid_value(
                        serde::de::Unexpected::Unsigned(found),
                        &self,
                    )),
                }
            }
        }
        deserializer.deserialize_any(One)
    }
}

#[derive(Deserialize)]
struct OnlySchema {
    #[serde(default, deserialize_with = "present")]
    schema: Option<Schema>,
}

/// For an optional key: it may be left out, but `null` is no value of it.
pub fn present<'de, T: Deserialize<'de>, D: Deserializer<'de>>(
    deserializer: D,
) -> Result<Option<T>, D::Error> {
    T::deserialize(deserializer).map(Some)
}

/// A struct that is written as an object and in no other way: serde by itself takes a list of the values, too.
#[derive(Clone, Debug)]
pub struct Keyed<T>(pub T);

impl<'de, T: Deserialize<'de>> Deserialize<'de> for Keyed<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Object<T>(PhantomData<T>);
        impl<'de, T: Deserialize<'de>> Visitor<'de> for Object<T> {
            type Value = Keyed<T>;

            fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
                f.write_str("an object { … }")
            }

            fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<Keyed<T>, A::Error> {
                T::deserialize(MapAccessDeserializer::new(map)).map(Keyed)
            }
        }
        deserializer.deserialize_map(Object(PhantomData))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[derive(Debug, Deserialize, JsonSchema)]
    #[serde(deny_unknown_fields)]
    struct Lamp {
        #[serde(default, deserialize_with = "present")]
        #[expect(dead_code, reason = "only `parse` reads it")]
        schema: Option<Schema>,
        watts: Vec<u32>,
        #[expect(dead_code, reason = "only `parse` reads it")]
        volts: u32,
    }

    fn problem(text: &str) -> String {
        parse::<Lamp>(text.as_bytes()).unwrap_err().to_string()
    }

    #[test]
    fn a_problem_says_line_column_and_path() {
        assert_eq!(
            problem("{ \"schema\": 1,\n  \"watts\": [40, \"much\"] }"),
            "line 2, column 22: watts[1]: found the text \"much\"; expected a whole number of 0 or more"
        );
        assert!(problem("{\"schema\": 1, \"watts\": [1").contains("ends here"));
        assert!(
            problem("{\"schema\": 1, \"watts\": [], \"volts\": 2} x").contains("after the end")
        );
    }

    #[test]
    fn all_missing_keys_are_named_at_once() {
        let all = "line 1, column 2: the keys `watts`, `volts`, `schema` are missing";
        assert_eq!(problem("{}"), all);
        assert!(problem("{ \"schema\": 1, \"volts\": 2 }").contains("the key `watts` is missing"));
        assert!(problem("{ \"schema\": 1, \"amps\": 2 }").contains("unknown key `amps`"));
    }

    #[test]
    fn the_schema_is_judged_before_the_keys() {
        assert!(problem("{\"amps\": 1, \"schema\": 2}").contains("schema: found 2; expected 1"));
        assert!(problem("{\"watts\": [], \"volts\": 2}").contains("`schema` is missing"));
        assert!(problem("{\"schema\": null, \"watts\": []}").contains("expected 1"));
    }

    #[test]
    fn a_byte_order_mark_is_passed_over_and_a_list_is_no_object() {
        let lamp: Lamp =
            parse(b"\xef\xbb\xbf{\"schema\": 1, \"watts\": [60], \"volts\": 230}").unwrap();
        assert_eq!(lamp.watts, [60]);
        assert!(problem("[1, [60]]").contains("expected an object"));
    }

    #[test]
    fn bytes_that_are_not_utf_8_have_a_line_and_a_column() {
        let problem = parse::<Lamp>(b"{\n \"\xff\"").unwrap_err();
        assert_eq!((problem.line, problem.column), (Some(2), Some(3)));
        assert!(problem.message.contains("0xff"));
    }

    #[test]
    fn a_message_stays_on_one_line() {
        let message = problem("{\"schema\": 1, \"a\\nb\\u001b[0m\": 0}");
        assert!(message.contains("a\\nb\\u{1b}[0m"), "{message}");
    }
}
