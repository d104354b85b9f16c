//! Queries in lesson files:
//! `{ "kind": "EdgeInterpolated", "where": { "y": 15, "I_4": { "above": 0.5 } } }`.
//!
//! Read by hand where serde's untagged forms would lose line, column and path.

use super::{Comparison, Condition, Operand, Query, check_field, is_name};
use serde::de::value::MapAccessDeserializer;
use serde::de::{Deserialize, Deserializer, Error, MapAccess, Visitor};
use std::fmt;

#[derive(serde::Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    kind: Option<Kind>,
    #[serde(default, rename = "where")]
    conditions: Conditions,
}

impl<'de> Deserialize<'de> for Query {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let file = File::deserialize(deserializer)?;
        let query = Query {
            kind: file.kind.map(|kind| kind.0),
            conditions: file.conditions.0,
        };
        if query == Query::default() {
            return Err(Error::custom(
                "a query without `kind` and `where` matches every step: at least one is needed",
            ));
        }
        Ok(query)
    }
}

struct Kind(String);

impl<'de> Deserialize<'de> for Kind {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let name = String::deserialize(deserializer)?;
        if is_name(&name) {
            Ok(Kind(name))
        } else {
            Err(Error::custom(format_args!(
                "expected the name of a kind of event, found `{name}`"
            )))
        }
    }
}

#[derive(Default)]
struct Conditions(Vec<Condition>);

impl<'de> Deserialize<'de> for Conditions {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Fields;

        impl<'de> Visitor<'de> for Fields {
            type Value = Conditions;

            fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
                f.write_str("an object with a key a field, such as { \"y\": 15 }")
            }

            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Conditions, A::Error> {
                let mut conditions: Vec<Condition> = Vec::new();
                while let Some(field) = map.next_key::<String>()? {
                    check_field(&field).map_err(|expected| {
                        A::Error::custom(format_args!("expected {expected}, found `{field}`"))
                    })?;
                    if conditions.iter().any(|condition| condition.field == field) {
                        return Err(A::Error::custom(format_args!("duplicate field `{field}`")));
                    }
                    let comparisons = map.next_value::<Comparisons>()?.0;
                    conditions.extend(comparisons.into_iter().map(|(comparison, value)| {
                        Condition {
                            field: field.clone(),
                            comparison,
                            value,
                        }
                    }));
                }
                Ok(Conditions(conditions))
            }
        }

        deserializer.deserialize_map(Fields)
    }
}

/// What a field must be: plainly a value, or an object of comparisons that must all hold.
struct Comparisons(Vec<(Comparison, Operand)>);

#[derive(serde::Deserialize)]
#[serde(deny_unknown_fields)]
struct Bounds {
    above: Option<f64>,
    at_least: Option<f64>,
    below: Option<f64>,
    at_most: Option<f64>,
    not: Option<Operand>,
}

impl<'de> Deserialize<'de> for Comparisons {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Either;

        impl<'de> Visitor<'de> for Either {
            type Value = Comparisons;

            fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
                f.write_str(
                    "a number, true, false, a string, or an object such as { \"above\": 0.5 }",
                )
            }

            fn visit_bool<E: Error>(self, truth: bool) -> Result<Comparisons, E> {
                equal(Literal.visit_bool(truth))
            }
            fn visit_u64<E: Error>(self, number: u64) -> Result<Comparisons, E> {
                equal(Literal.visit_u64(number))
            }
            fn visit_i64<E: Error>(self, number: i64) -> Result<Comparisons, E> {
                equal(Literal.visit_i64(number))
            }
            fn visit_f64<E: Error>(self, number: f64) -> Result<Comparisons, E> {
                equal(Literal.visit_f64(number))
            }
            fn visit_str<E: Error>(self, word: &str) -> Result<Comparisons, E> {
                equal(Literal.visit_str(word))
            }

            fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<Comparisons, A::Error> {
                let bounds = Bounds::deserialize(MapAccessDeserializer::new(map))?;
                let number = |comparison, bound: Option<f64>| {
                    bound.map(|bound| (comparison, Operand::Number(bound)))
                };
                let comparisons: Vec<_> = [
                    number(Comparison::Above, bounds.above),
                    number(Comparison::AtLeast, bounds.at_least),
                    number(Comparison::Below, bounds.below),
                    number(Comparison::AtMost, bounds.at_most),
                    bounds.not.map(|value| (Comparison::NotEqual, value)),
                ]
                .into_iter()
                .flatten()
                .collect();
                if comparisons.is_empty() {
                    return Err(A::Error::custom(
                        "expected `above`, `at_least`, `below`, `at_most` or `not`",
                    ));
                }
                Ok(Comparisons(comparisons))
            }
        }

        deserializer.deserialize_any(Either)
    }
}

fn equal<E>(value: Result<Operand, E>) -> Result<Comparisons, E> {
    Ok(Comparisons(vec![(Comparison::Equal, value?)]))
}

impl<'de> Deserialize<'de> for Operand {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(Literal)
    }
}

struct Literal;

impl Visitor<'_> for Literal {
    type Value = Operand;

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str("a number, true, false or a string")
    }

    fn visit_bool<E: Error>(self, truth: bool) -> Result<Operand, E> {
        Ok(Operand::Truth(truth))
    }
    fn visit_u64<E: Error>(self, number: u64) -> Result<Operand, E> {
        Ok(Operand::Number(number as f64))
    }
    fn visit_i64<E: Error>(self, number: i64) -> Result<Operand, E> {
        Ok(Operand::Number(number as f64))
    }
    fn visit_f64<E: Error>(self, number: f64) -> Result<Operand, E> {
        Ok(Operand::Number(number))
    }
    fn visit_str<E: Error>(self, word: &str) -> Result<Operand, E> {
        Ok(Operand::Word(word.to_owned()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_says_what_a_user_types() {
        let cases = [
            (
                r#"{ "kind": "EdgeInterpolated", "where": { "y": 15, "I_4": { "above": 0.5 } } }"#,
                "EdgeInterpolated y=15 I_4>0.5",
            ),
            (r#"{ "kind": "PixelWritten" }"#, "PixelWritten"),
            (
                r#"{ "where": { "nearer": false, "why": "no coefficient", "x_P": -2.5 } }"#,
                "nearer=false why=\"no coefficient\" x_P=-2.5",
            ),
            (
                r#"{ "where": { "I.r": { "at_least": 0, "at_most": 1 }, "y": { "not": 3, "below": 9 } } }"#,
                "I.r>=0 I.r<=1 y<9 y!=3",
            ),
        ];
        for (json, text) in cases {
            let query: Query = serde_json::from_str(json).expect(json);
            assert_eq!(Ok(query), text.parse(), "{json}");
        }
    }

    #[test]
    fn a_broken_query_is_refused_with_line_column_and_path() {
        let cases = [
            (
                r#"{ "kind": 3 }"#,
                "at.kind",
                "invalid type: integer `3`, expected a string",
            ),
            (
                r#"{ "kind": "Two words" }"#,
                "at.kind",
                "expected the name of a kind of event, found `Two words`",
            ),
            (
                r#"{ "kin": "A" }"#,
                "at.kin",
                "unknown field `kin`, expected `kind` or `where`",
            ),
            (
                r#"{}"#,
                "at",
                "a query without `kind` and `where` matches every step: at least one is needed",
            ),
            (
                r#"{ "where": 3 }"#,
                "at.where",
                "invalid type: integer `3`, expected an object with a key a field, such as { \"y\": 15 }",
            ),
            (
                r#"{ "where": { "y": [] } }"#,
                "at.where.y",
                "invalid type: sequence, expected a number, true, false, a string, or an object such as { \"above\": 0.5 }",
            ),
            (
                r#"{ "where": { "y": {} } }"#,
                "at.where.y",
                "expected `above`, `at_least`, `below`, `at_most` or `not`",
            ),
            (
                r#"{ "where": { "y": { "over": 1 } } }"#,
                "at.where.y.over",
                "unknown field `over`, expected one of `above`, `at_least`, `below`, `at_most`, `not`",
            ),
            (
                r#"{ "where": { "y": { "above": "a" } } }"#,
                "at.where.y.above",
                "invalid type: string \"a\", expected f64",
            ),
            (
                r#"{ "where": { "y": 1, "y": 2 } }"#,
                "at.where",
                "duplicate field `y`",
            ),
            (
                r#"{ "where": { "N.w": 1 } }"#,
                "at.where",
                "expected .r, .g or .b of a colour, .x, .y or .z of a vector, found `N.w`",
            ),
        ];
        #[derive(serde::Deserialize, Debug)]
        struct Note {
            #[serde(rename = "at")]
            _at: Query,
        }
        for (json, path, message) in cases {
            let json = format!("{{\n\"at\": {json} }}");
            let mut deserializer = serde_json::Deserializer::from_str(&json);
            let error =
                serde_path_to_error::deserialize::<_, Note>(&mut deserializer).expect_err(&json);
            assert!(
                error.path().to_string().starts_with(path),
                "{json}: {}",
                error.path()
            );
            let inner = error.inner();
            assert!(inner.to_string().starts_with(message), "{json}: {inner}");
            assert_eq!(inner.line(), 2, "{json}: {inner}");
        }
    }
}
