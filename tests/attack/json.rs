//! Documents changed at random.

use crate::kit::{one_of, pick};
use lightwalk::numeric::Random;
use serde_json::{Map, Value, json};

/// The paths of all values that fit.
pub fn paths(value: &Value, fits: fn(&Value) -> bool) -> Vec<String> {
    fn find(value: &Value, path: &str, fits: fn(&Value) -> bool, found: &mut Vec<String>) {
        if fits(value) {
            found.push(path.to_owned());
        }
        match value {
            Value::Array(items) => {
                (0..items.len()).for_each(|i| find(&items[i], &format!("{path}/{i}"), fits, found))
            }
            Value::Object(map) => map
                .iter()
                .for_each(|(key, item)| find(item, &format!("{path}/{key}"), fits, found)),
            _ => {}
        }
    }
    let mut found = Vec::new();
    find(value, "", fits, &mut found);
    found
}

/// A number at the ends of what f64 holds, or near another one.
pub fn hostile_number(random: &mut Random, old: f64, other: f64) -> f64 {
    const ENDS: [f64; 14] = [
        0.0, -0.0, 1.0, -1.0, 1e-44, 1e-8, -1e-8, 1e-300, 1e8, -1e8, 1e15, 1e150, 1e300, 0.5,
    ];
    match pick(random, 8) {
        0 | 1 => one_of(random, &ENDS),
        2 | 3 => other,
        4 => old * (1.0 + 1e-8 * random.number()),
        5 => old + 1e-15 * random.number(),
        6 => old * 10_f64.powf(8.0 * random.number()),
        _ => old + random.number(),
    }
}

/// Exchanges one of the document's numbers for a hostile one.
pub fn change_number(document: &mut Value, random: &mut Random) {
    let paths = paths(document, Value::is_number);
    if paths.is_empty() {
        return;
    }
    let [at, other] = [0; 2].map(|_| &paths[pick(random, paths.len())]);
    let value = |path: &str| {
        document
            .pointer(path)
            .and_then(Value::as_f64)
            .unwrap_or(0.0)
    };
    let mut new = json!(hostile_number(random, value(at), value(other)));
    // What is counted stays a whole number, so that it is more than a wrong type.
    if document.pointer(at).is_some_and(|old| !old.is_f64()) && pick(random, 4) > 0 {
        new = json!(one_of(
            random,
            &[0, 1, 2, 3, 7, 64, 1000, u64::from(u32::MAX), u64::MAX]
        ));
    }
    set(document, at, new);
}

/// Changes the document anywhere: a value, a key, what a list holds.
pub fn change(document: &mut Value, random: &mut Random) {
    let everything = paths(document, |_| true);
    let [at, other] = [0; 2].map(|_| &everything[pick(random, everything.len())]);
    let copy = document.pointer(other).cloned().unwrap_or_default();
    match pick(random, 6) {
        0 => set(document, at, strange(random)),
        1 => set(document, at, copy),
        _ => match document.pointer_mut(at) {
            Some(Value::Array(items)) if !items.is_empty() => change_list(items, copy, random),
            Some(Value::Object(map)) if !map.is_empty() => change_keys(map, copy, random),
            Some(Value::String(text)) => change_text(text, copy, random),
            _ => change_number(document, random),
        },
    }
}

fn set(document: &mut Value, path: &str, new: Value) {
    if let Some(place) = document.pointer_mut(path) {
        *place = new;
    }
}

fn strange(random: &mut Random) -> Value {
    let deep = (0..200).fold(json!(1), |inner, _| json!([inner]));
    match pick(random, 9) {
        0 => Value::Null,
        1 => json!(true),
        2 => json!(""),
        3 => json!([]),
        4 => json!({}),
        5 => json!("é\u{0}\u{202e}{x}}{ $F_{ij}$ ".repeat(1 + pick(random, 20))),
        6 => json!([0, 0, 0]),
        7 => json!(-1),
        _ => deep,
    }
}

fn change_list(items: &mut Vec<Value>, copy: Value, random: &mut Random) {
    let [a, b] = [0; 2].map(|_| pick(random, items.len()));
    match pick(random, 4) {
        0 => items.swap(a, b),
        1 => drop(items.remove(a)),
        2 => items.insert(b, items[a].clone()),
        _ => items[a] = copy,
    }
}

fn change_keys(map: &mut Map<String, Value>, copy: Value, random: &mut Random) {
    let keys: Vec<String> = map.keys().cloned().collect();
    let [a, b] = [0; 2].map(|_| &keys[pick(random, keys.len())]);
    match pick(random, 4) {
        0 => drop(map.remove(a)),
        1 => drop(map.insert(format!("{a}x"), copy)),
        2 => drop(map.insert(a.clone(), copy)),
        _ => {
            let [one, two] = [a, b].map(|key| map[key].clone());
            map.insert(a.clone(), two);
            map.insert(b.clone(), one);
        }
    }
}

/// Another text of the document, or a part of its own, with signs that mean something in it.
fn change_text(text: &mut String, copy: Value, random: &mut Random) {
    if let (Value::String(copy), 0) = (&copy, pick(random, 2)) {
        *text = copy.clone();
        return;
    }
    let mut signs: Vec<char> = text.chars().collect();
    let at = pick(random, signs.len() + 1);
    match pick(random, 3) {
        0 => signs.truncate(at),
        1 => signs.insert(
            at,
            one_of(
                random,
                &[
                    '{', '}', '$', '\\', '_', '^', '*', ' ', '=', '<', '"', '-', '9', 'é', '\n',
                ],
            ),
        ),
        _ if at < signs.len() => drop(signs.remove(at)),
        _ => {}
    }
    *text = signs.into_iter().collect();
}
