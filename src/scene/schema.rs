//! JSON Schemas of the files that the program reads, made from the types that read them: editors complete and underline by them.
//!
//! They know keys, types and the program's own names. Which numbers are allowed, and what refers to what, only the checks know.

use super::document::{Keyed, Schema as Version};
use super::values::{ByName, Coefficient, Count, Number, PatchCounts, Triple};
use schemars::generate::SchemaSettings;
use schemars::transform::transform_subschemas;
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde_json::{Value, json};
use std::borrow::Cow;

/// Of a document that is read as `T`, by JSON Schema 2020-12.
pub fn schema_of<T: JsonSchema>() -> Value {
    let settings = SchemaSettings::draft2020_12().for_deserialize();
    let generator = settings.with_transform(as_read).into_generator();
    let mut schema = generator.into_root_schema_for::<T>();
    // A document names its version; a scene in a lesson need not.
    if let Some(Value::Array(required)) = schema.get_mut("required") {
        required.push("schema".into());
    }
    schema.to_value()
}

/// Of a scene file.
pub fn scene_schema() -> Value {
    schema_of::<super::SceneFile>()
}

/// An optional key may be left out, but `null` is no value of it; and a description is one paragraph.
fn as_read(schema: &mut Schema) {
    let null = json!({ "type": "null" });
    for (key, null) in [
        ("type", &"null".into()),
        ("enum", &Value::Null),
        ("anyOf", &null),
    ] {
        if let Some(Value::Array(allowed)) = schema.get_mut(key) {
            allowed.retain(|one| one != null);
            if let ("type" | "anyOf", [one]) = (key, &allowed[..]) {
                let one = one.clone();
                schema.remove(key);
                match one {
                    Value::Object(only) => schema.ensure_object().extend(only),
                    name => drop(schema.insert(key.into(), name)),
                }
            }
        }
    }
    if schema.get("default") == Some(&Value::Null) {
        schema.remove("default");
    }
    if let Some(Value::String(text)) = schema.get_mut("description") {
        *text = text.replace('\n', " ");
    }
    transform_subschemas(&mut as_read, schema);
}

/// Types that are written as something else than their fields.
macro_rules! written_as {
    ($($type:ty: $schema:tt,)*) => {
        $(impl JsonSchema for $type {
            fn inline_schema() -> bool {
                true
            }

            fn schema_name() -> Cow<'static, str> {
                stringify!($type).into()
            }

            fn json_schema(_: &mut SchemaGenerator) -> Schema {
                json_schema!($schema)
            }
        })*
    };
}

written_as! {
    Version: { "const": 1 },
    Number: { "type": "number" },
    Count: { "type": "integer", "minimum": 0 },
    Triple: { "type": "array", "items": { "type": "number" }, "minItems": 3, "maxItems": 3 },
    Coefficient: { "anyOf": [
        { "type": "number" },
        { "type": "array", "items": { "type": "number" }, "minItems": 3, "maxItems": 3 },
    ] },
    PatchCounts: { "anyOf": [
        { "type": "integer", "minimum": 0 },
        { "type": "array", "items": { "type": "integer", "minimum": 0 }, "minItems": 2, "maxItems": 2 },
    ] },
}

impl<T: JsonSchema> JsonSchema for Keyed<T> {
    fn inline_schema() -> bool {
        T::inline_schema()
    }

    fn schema_name() -> Cow<'static, str> {
        T::schema_name()
    }

    fn schema_id() -> Cow<'static, str> {
        T::schema_id()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        T::json_schema(generator)
    }
}

impl<T: JsonSchema> JsonSchema for ByName<T> {
    fn inline_schema() -> bool {
        true
    }

    fn schema_name() -> Cow<'static, str> {
        format!("{}ByName", T::schema_name()).into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        json_schema!({ "type": "object", "additionalProperties": generator.subschema_for::<T>() })
    }
}
