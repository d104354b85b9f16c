//! Changes of a scene's text by path: what is not changed keeps its order, its spaces and its digits.

use super::locate::{Entry, entry};
use serde_json::Value;

/// One change of a document. Places are paths such as `objects[2].sphere`; empty for the whole.
#[derive(Clone, Debug, PartialEq)]
pub enum Edit {
    Set(String, Value),
    /// A key of an object that has no such key yet.
    Insert(String, String, Value),
    /// Behind the last element of a list.
    Push(String, Value),
    /// Before an element of a list.
    Before(String, Value),
    /// Puts two elements of a list, the earlier one first, each in the other's place.
    Swap(String, String),
    Remove(String),
}

impl Edit {
    /// The text with the change; none where the place is not there.
    pub fn of(&self, text: &str) -> Option<String> {
        let at = |place: &str| match place {
            "" => whole(text),
            _ => entry(text.as_bytes(), place),
        };
        match self {
            Edit::Set(place, value) => {
                let range = at(place)?.value;
                Some(format!(
                    "{}{}{}",
                    &text[..range.start],
                    written(value),
                    &text[range.end..]
                ))
            }
            Edit::Insert(place, key, value) => {
                let key = Value::String(key.clone());
                added(text, &at(place)?, &format!("{key}: {}", written(value)))
            }
            Edit::Push(place, value) => added(text, &at(place)?, &written(value)),
            Edit::Before(place, value) => {
                let (before, after) = text.split_at(at(place)?.start);
                let space = &before[before.trim_end().len()..];
                let space = if space.is_empty() { " " } else { space };
                Some(format!("{before}{},{space}{after}", written(value)))
            }
            Edit::Swap(first, second) => {
                let (first, second) = (at(first)?.value, at(second)?.value);
                let between = text.get(first.end..second.start)?;
                Some(format!(
                    "{}{}{between}{}{}",
                    &text[..first.start],
                    &text[second.clone()],
                    &text[first],
                    &text[second.end..]
                ))
            }
            Edit::Remove(place) => {
                let Entry { start, value } = at(place)?;
                let (before, after) = (&text[..start], &text[value.end..]);
                Some(match after.trim_start().strip_prefix(',') {
                    Some(rest) => format!("{before}{}", rest.trim_start()),
                    None => {
                        let before = before.trim_end();
                        format!("{}{after}", before.strip_suffix(',').unwrap_or(before))
                    }
                })
            }
        }
    }
}

fn whole(text: &str) -> Option<Entry> {
    let start = text.find('{')?;
    let end = text.rfind('}')? + 1;
    (start < end).then_some(Entry {
        start,
        value: start..end,
    })
}

/// `what` behind the last entry between brackets, spaced as the first one is.
fn added(text: &str, container: &Entry, what: &str) -> Option<String> {
    let (start, end) = (container.value.start + 1, container.value.end - 1);
    let inside = text.get(start..end)?;
    let filled = inside.trim_end();
    if filled.is_empty() {
        return Some(format!("{} {what} {}", &text[..start], &text[end..]));
    }
    let space = &inside[..inside.len() - inside.trim_start().len()];
    let space = if space.is_empty() { " " } else { space };
    let last = start + filled.len();
    Some(format!("{},{space}{what}{}", &text[..last], &text[last..]))
}

/// JSON on one line, with a space behind commas and colons, and whole numbers without a point.
pub fn written(value: &Value) -> String {
    match value {
        Value::Array(list) => {
            let list: Vec<String> = list.iter().map(written).collect();
            format!("[{}]", list.join(", "))
        }
        Value::Object(members) if members.is_empty() => "{}".into(),
        Value::Object(members) => {
            let member = |(key, value): (&String, &Value)| {
                format!("{}: {}", Value::String(key.clone()), written(value))
            };
            let members: Vec<String> = members.iter().map(member).collect();
            format!("{{ {} }}", members.join(", "))
        }
        Value::Number(number) => match number.as_f64() {
            Some(whole) if whole.fract() == 0.0 && whole.abs() < 1e15 => format!("{whole:.0}"),
            _ => number.to_string(),
        },
        other => other.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    const TEXT: &str =
        "{ \"schema\": 1,\n  \"objects\": [\n    { \"a\": 1.50 },\n    { \"b\": [] } ] }";

    fn edited(edit: Edit) -> String {
        let text = edit.of(TEXT).expect("a place");
        serde_json::from_str::<Value>(&text).expect("JSON");
        text
    }

    #[test]
    fn only_the_value_changes() {
        let set = Edit::Set("objects[1].b".into(), json!([1.0, -0.25, { "x": "y" }]));
        let expected = TEXT.replace("[]", "[1, -0.25, { \"x\": \"y\" }]");
        assert_eq!(edited(set), expected);
        assert_eq!(Edit::Set("objects[2]".into(), json!(1)).of(TEXT), None);
    }

    #[test]
    fn an_addition_is_spaced_as_the_first_entry_is() {
        let push = edited(Edit::Push("objects".into(), json!({ "c": 2 })));
        let expected = TEXT.replace("{ \"b\": [] } ]", "{ \"b\": [] },\n    { \"c\": 2 } ]");
        assert_eq!(push, expected);
        let insert = Edit::Insert("objects[0]".into(), "d\"".into(), json!(true));
        assert_eq!(
            edited(insert),
            TEXT.replace("1.50 }", "1.50, \"d\\\"\": true }")
        );
        let first = edited(Edit::Push("objects[1].b".into(), json!(3)));
        assert_eq!(first, TEXT.replace("[]", "[ 3 ]"));
        let outermost = edited(Edit::Insert(String::new(), "lights".into(), json!([])));
        assert_eq!(
            outermost,
            TEXT.replace("] } ] }", "] } ], \"lights\": [] }")
        );
    }

    #[test]
    fn elements_of_a_list_are_put_before_others_and_change_places() {
        let [a, b] = ["{ \"a\": 1.50 }", "{ \"b\": [] }"];
        let before = edited(Edit::Before("objects[1]".into(), json!(7)));
        assert_eq!(before, TEXT.replace(b, &format!("7,\n    {b}")));
        let first = edited(Edit::Before("objects[0]".into(), json!(7)));
        assert_eq!(first, TEXT.replace(a, &format!("7,\n    {a}")));
        let swap = |a: &str, b: &str| Edit::Swap(format!("objects[{a}]"), format!("objects[{b}]"));
        let swapped = edited(swap("0", "1"));
        let expected = TEXT.replace(a, "@").replace(b, a).replace('@', b);
        assert_eq!(swapped, expected);
        assert_eq!(swap("1", "0").of(TEXT), None);
        assert_eq!(swap("0", "2").of(TEXT), None);
    }

    #[test]
    fn what_is_removed_takes_its_key_and_one_comma_along() {
        for (place, was, is) in [
            ("schema", "\"schema\": 1,\n  ", ""),
            ("objects[0]", "{ \"a\": 1.50 },\n    ", ""),
            ("objects[1]", ",\n    { \"b\": [] }", ""),
            ("objects[0].a", "{ \"a\": 1.50 }", "{ }"),
        ] {
            assert_eq!(edited(Edit::Remove(place.into())), TEXT.replace(was, is));
        }
    }
}
