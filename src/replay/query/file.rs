//! Queries in lesson files: as a user types them, `"EdgeInterpolated y=15 I_4>0.5"`, or as the object
//! `{ "kind": "EdgeInterpolated", "where": { "y": 15, "I_4": { "above": 0.5 } } }`, which stands for that text.

use super::Query;
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::value::MapAccessDeserializer;
use serde::de::{Deserialize, Deserializer, Error, MapAccess, Visitor};
use serde_json::Value;
use std::borrow::Cow;
use std::collections::BTreeMap;
use std::fmt;

impl<'de> Deserialize<'de> for Query {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Either;

        impl<'de> Visitor<'de> for Either {
            type Value = String;

            fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
                f.write_str("a query, such as \"EdgeInterpolated y=15\"")
            }

            fn visit_str<E: Error>(self, text: &str) -> Result<String, E> {
                Ok(text.to_owned())
            }

            fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<String, A::Error> {
                Object::deserialize(MapAccessDeserializer::new(map))?.text()
            }
        }

        let text = deserializer.deserialize_any(Either)?;
        let query = text.parse();
        query.map_err(|error| D::Error::custom(format_args!("in the query `{text}`, {error}")))
    }
}

impl JsonSchema for Query {
    fn schema_name() -> Cow<'static, str> {
        "Query".into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let object = generator.subschema_for::<Object>();
        json_schema!({
            "description": "The kind of an event and conditions, as in \"EdgeInterpolated y=15\"",
            "anyOf": [{ "type": "string" }, object],
        })
    }
}

/// The kind of an event and conditions, as an object.
#[derive(serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(inline)]
struct Object {
    /// The kind of event.
    #[serde(default)]
    kind: String,
    /// Fields, each with its value or with `above`, `at_least`, `below`, `at_most` or `not` a value.
    #[serde(default, rename = "where")]
    conditions: BTreeMap<String, Value>,
}

impl Object {
    fn text<E: Error>(self) -> Result<String, E> {
        let mut text = self.kind;
        let mut push = |field: &str, sign: &str, value: &Value| {
            text += &match value {
                Value::String(word) => format!(" {field}{sign}\"{word}\""),
                // No word either.
                Value::Null => format!(" {field}{sign}"),
                _ => format!(" {field}{sign}{value}"),
            };
        };
        for (field, value) in &self.conditions {
            let Value::Object(bounds) = value else {
                push(field, "=", value);
                continue;
            };
            for (bound, value) in bounds {
                let sign = match bound.as_str() {
                    "above" => ">",
                    "at_least" => ">=",
                    "below" => "<",
                    "at_most" => "<=",
                    "not" => "!=",
                    _ => {
                        const BOUNDS: &[&str] = &["above", "at_least", "below", "at_most", "not"];
                        return Err(E::unknown_field(bound, BOUNDS));
                    }
                };
                push(field, sign, value);
            }
        }
        Ok(text)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_may_say_what_a_user_types_as_text_or_as_an_object() {
        let cases = [
            (r#""EdgeInterpolated y=15""#, "EdgeInterpolated y=15"),
            (
                r#"{ "kind": "EdgeInterpolated", "where": { "y": 15, "I_4": { "above": 0.5 } } }"#,
                "EdgeInterpolated I_4>0.5 y=15",
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
    fn a_broken_query_is_refused_with_line_and_path() {
        #[derive(serde::Deserialize, Debug)]
        struct Note {
            #[serde(rename = "at")]
            _at: Query,
        }
        for (json, message) in [
            (
                "3",
                "invalid type: integer `3`, expected a query, such as \"EdgeInterpolated y=15\"",
            ),
            (
                r#""Ray y 15""#,
                "in the query `Ray y 15`, column 7: expected a comparison",
            ),
            ("{}", "in the query ``, column 1: expected a kind of event"),
            (r#"{ "kin": "A" }"#, "unknown field `kin`, expected `kind`"),
            (
                r#"{ "kind": "Two words" }"#,
                "in the query `Two words`, column 10: expected a comparison",
            ),
            (
                r#"{ "where": { "y": [] } }"#,
                "in the query ` y=[]`, column 4: expected a number, true, false or a word",
            ),
            (
                r#"{ "where": { "y": null } }"#,
                "in the query ` y=`, column 4: expected a number, true, false or a word",
            ),
            (
                r#"{ "where": { "y": { "over": 1 } } }"#,
                "unknown field `over`, expected one of `above`",
            ),
            (
                r#"{ "where": { "y": { "above": "a" } } }"#,
                "in the query ` y>\"a\"`, column 4: expected a number after",
            ),
            (
                r#"{ "where": { "N.w": 1 } }"#,
                "in the query ` N.w=1`, column 2: expected .r, .g or .b of a colour",
            ),
        ] {
            let json = format!("{{\n\"at\": {json} }}");
            let mut deserializer = serde_json::Deserializer::from_str(&json);
            let error =
                serde_path_to_error::deserialize::<_, Note>(&mut deserializer).expect_err(&json);
            assert!(error.path().to_string().starts_with("at"), "{json}");
            let inner = error.inner();
            assert!(inner.to_string().starts_with(message), "{json}: {inner}");
            assert_eq!(inner.line(), 2, "{json}: {inner}");
        }
    }
}
