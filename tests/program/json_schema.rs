//! Whether a JSON document is one that a JSON Schema describes: the part of draft 2020-12 that our schemas use, and no more.

use serde_json::{Map, Value};

/// Keywords that describe and forbid nothing.
const ANNOTATIONS: [&str; 6] = [
    "$schema",
    "$defs",
    "title",
    "description",
    "format",
    "default",
];

/// Why the schema does not describe the document: the first reason, with its path. None where it does.
pub fn fault(schema: &Value, document: &Value) -> Option<String> {
    Schema { root: schema }.fault(schema, document, "")
}

struct Schema<'a> {
    root: &'a Value,
}

impl Schema<'_> {
    fn fault(&self, schema: &Value, value: &Value, place: &str) -> Option<String> {
        let keywords = match schema {
            Value::Bool(true) => return None,
            Value::Object(keywords) => keywords,
            other => panic!("{place}: {other} is no schema"),
        };
        let mut faults = keywords
            .iter()
            .filter_map(|(keyword, says)| self.against(keyword, says, keywords, value, place));
        faults.next()
    }

    /// What a keyword finds wrong.
    fn against(
        &self,
        keyword: &str,
        says: &Value,
        beside: &Map<String, Value>,
        value: &Value,
        place: &str,
    ) -> Option<String> {
        let fits = |schema: &&Value| self.fault(schema, value, place).is_none();
        let schemas = || says.as_array().expect("a list of schemas").iter();
        let length = |value: &Value| value.as_array().map(|list| list.len() as u64);
        let bound = || says.as_u64().expect("a whole number");
        let right = match keyword {
            "$ref" => {
                let path = says.as_str().expect("a reference").strip_prefix('#');
                let found = path.and_then(|path| self.root.pointer(path));
                let schema = found.unwrap_or_else(|| panic!("{says} leads nowhere"));
                return self.fault(schema, value, place);
            }
            "type" => match says {
                Value::Array(names) => names.iter().any(|name| is_of_type(value, name)),
                name => is_of_type(value, name),
            },
            "const" => value == says,
            "enum" => schemas().any(|one| one == value),
            "anyOf" => schemas().any(|one| fits(&one)),
            "oneOf" => schemas().filter(fits).count() == 1,
            "minimum" => value
                .as_f64()
                .is_none_or(|x| x >= says.as_f64().expect("a number")),
            "minItems" => length(value).is_none_or(|length| length >= bound()),
            "maxItems" => length(value).is_none_or(|length| length <= bound()),
            "items" => {
                let items = value.as_array().into_iter().flatten().enumerate();
                return items
                    .filter_map(|(index, item)| {
                        self.fault(says, item, &format!("{place}[{index}]"))
                    })
                    .next();
            }
            "required" => {
                let missing = value.as_object().and_then(|object| {
                    schemas().find(|key| !object.contains_key(key.as_str().expect("a key")))
                });
                return missing.map(|key| format!("{place}: lacks {key}"));
            }
            "properties" | "additionalProperties" => {
                let known = beside.get("properties").and_then(Value::as_object);
                let entries = value.as_object().into_iter().flatten();
                let faults = entries.filter_map(|(key, value)| {
                    let own = known.and_then(|known| known.get(key));
                    let place = format!("{place}.{key}");
                    match (keyword, own) {
                        ("properties", Some(schema)) => self.fault(schema, value, &place),
                        ("additionalProperties", None) => match says {
                            Value::Bool(false) => Some(format!("{place}: is no key here")),
                            schema => self.fault(schema, value, &place),
                        },
                        _ => None,
                    }
                });
                return { faults }.next();
            }
            _ if ANNOTATIONS.contains(&keyword) => true,
            _ => panic!("{place}: the keyword {keyword} is not known here"),
        };
        (!right).then(|| format!("{place}: {value} against {keyword} {says}"))
    }
}

fn is_of_type(value: &Value, name: &Value) -> bool {
    match name.as_str().expect("the name of a type") {
        "null" => value.is_null(),
        "boolean" => value.is_boolean(),
        "string" => value.is_string(),
        "number" => value.is_number(),
        "integer" => value.is_i64() || value.is_u64(),
        "array" => value.is_array(),
        "object" => value.is_object(),
        name => panic!("{name} is no type"),
    }
}
