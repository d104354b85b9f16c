//! Numbers in lessons come from the run; those that are typed stand in `typed_numbers.txt`, each with its source.

use lightwalk::lesson::builtin;
use lightwalk::record::Value;
use lightwalk::replay::{Query, query};
use std::collections::{BTreeMap, BTreeSet};

/// A line of the list: a lesson, numbers as English writes them, and where they come from.
struct Line {
    lesson: &'static str,
    numbers: Vec<&'static str>,
    source: &'static str,
}

fn list() -> Vec<Line> {
    let lines = include_str!("typed_numbers.txt").lines();
    let lines = lines.filter(|line| !line.starts_with('#'));
    lines
        .map(|line| {
            let (lesson, rest) = line.split_once(": ").expect(line);
            let (numbers, source) = rest.split_once(" | ").expect(line);
            assert!(!source.is_empty(), "{line}");
            Line {
                lesson,
                numbers: numbers.split(' ').collect(),
                source,
            }
        })
        .collect()
}

/// Every text of a lesson file, in both languages, with its templates.
fn texts(value: &serde_json::Value, found: &mut Vec<[String; 2]>) {
    if let (Some(en), Some(id)) = (value["en"].as_str(), value["id"].as_str()) {
        found.push([en.to_string(), id.to_string()]);
    } else if let Some(object) = value.as_object() {
        let texts_of = |(key, _): &(&String, _)| !["names", "scene"].contains(&key.as_str());
        for (_, inner) in object.iter().filter(texts_of) {
            texts(inner, found);
        }
    } else if let Some(array) = value.as_array() {
        for inner in array {
            texts(inner, found);
        }
    }
}

const RAISED: &str = "⁻⁰¹²³⁴⁵⁶⁷⁸⁹";

/// The numbers of two digits and more that are typed in a text, as English writes them without marks of thousands: neither what
/// stands in a template or in code, nor an index.
fn typed(text: &str, comma: char) -> BTreeSet<String> {
    let chars: Vec<char> = text.chars().collect();
    let at = |i: usize| chars.get(i).copied().unwrap_or(' ');
    let digits = |i: usize| {
        (i..chars.len())
            .take_while(|&i| at(i).is_ascii_digit())
            .count()
    };
    let (mut found, mut i) = (BTreeSet::new(), 0);
    while i < chars.len() {
        if let Some(close) = match chars[i] {
            '{' => Some('}'),
            '`' => Some('`'),
            _ => None,
        } {
            i += 1;
            while i < chars.len() && chars[i] != close {
                i += 1;
            }
        }
        let before = if i == 0 { ' ' } else { chars[i - 1] };
        let index = before.is_alphanumeric() || "_^".contains(before) || RAISED.contains(before);
        if !at(i).is_ascii_digit() || index {
            i += 1;
            continue;
        }
        let mut number = String::new();
        loop {
            let run = digits(i);
            number.extend(&chars[i..i + run]);
            i += run;
            let next = digits(i + 1);
            match at(i) {
                '.' if comma == ',' && next == 3 => {}
                ' ' if next == 3 => {}
                '.' | ',' if next > 0 => number.push('.'),
                _ => break,
            }
            i += 1;
        }
        if at(i) == 'e' {
            let sign = usize::from(at(i + 1) == '-');
            let end = i + 1 + sign + digits(i + 1 + sign);
            if end > i + 1 + sign {
                number.extend(&chars[i..end]);
                i = end;
            }
        }
        let power = match chars[i..] {
            ['·', '1', '0', ..] => i + 3,
            _ if number == "10" => i,
            _ => chars.len(),
        };
        if RAISED.contains(at(power)) {
            let end = (power..chars.len()).find(|&i| !RAISED.contains(at(i)));
            let end = end.unwrap_or(chars.len());
            number.extend(&chars[i..end]);
            i = end;
        }
        if number.len() > 1 {
            found.insert(number);
        }
    }
    found
}

#[test]
fn typed_numbers_are_found() {
    let all = |text, comma| typed(text, comma).into_iter().collect::<Vec<_>>();
    assert_eq!(
        all("{I_4:12}, `a 12`, I_10, x^30, 7 and 0.25", '.'),
        ["0.25"]
    );
    assert_eq!(
        all("10 000 by 5.4·10⁻⁵, 1e-6, 10⁻⁸", '.'),
        ["10000", "10⁻⁸", "1e-6", "5.4·10⁻⁵"]
    );
    assert_eq!(all("10.000 dan 0,5; 16.16", ','), ["0.5", "10000", "16.16"]);
}

#[test]
fn every_typed_number_has_a_source() {
    let mut listed: BTreeMap<&str, BTreeSet<String>> = BTreeMap::new();
    for line in list() {
        let of_lesson = listed.entry(line.lesson).or_default();
        for number in line.numbers {
            assert!(
                of_lesson.insert(number.to_string()),
                "{}: {number} twice",
                line.lesson
            );
        }
    }
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/lessons");
    for file in std::fs::read_dir(folder).expect("the folder of lessons") {
        let path = file.expect("a file").path();
        if path.extension().is_none_or(|extension| extension != "json") {
            continue;
        }
        let text = std::fs::read_to_string(&path).expect("a lesson");
        let lesson: serde_json::Value = serde_json::from_str(&text).expect("JSON");
        let id = lesson["id"].as_str().expect("an id");
        let (mut found, mut pairs) = (BTreeSet::new(), Vec::new());
        texts(&lesson, &mut pairs);
        for [en, in_indonesian] in pairs {
            let numbers = typed(&en, '.');
            assert_eq!(
                typed(&in_indonesian, ','),
                numbers,
                "{id}: {en}\n{in_indonesian}"
            );
            found.extend(numbers);
        }
        let listed = listed.get(id).cloned().unwrap_or_default();
        assert_eq!(found, listed, "{id}: in the texts, and in the list");
    }
}

/// As programs write it: `5.4e-5` of `5.4·10⁻⁵`.
fn with_e(number: &str) -> String {
    number
        .replace("·10", "e")
        .chars()
        .map(
            |sign| match RAISED.chars().position(|raised| raised == sign) {
                Some(0) => '-',
                Some(digit) => char::from(b'0' + digit as u8 - 1),
                None => sign,
            },
        )
        .collect()
}

/// Half of the last digit that is typed.
fn half_a_digit(number: &str) -> f64 {
    let (digits, power) = number.split_once('e').unwrap_or((number, "0"));
    let decimals = digits
        .split_once('.')
        .map_or(0, |(_, decimals)| decimals.len() as i32);
    let power: i32 = power.parse().expect(number);
    0.5 * 10_f64.powi(power - decimals)
}

#[test]
fn typed_numbers_of_a_run_are_those_of_the_run() {
    let mut lines: BTreeMap<&str, Vec<Line>> = BTreeMap::new();
    for line in list() {
        lines.entry(line.lesson).or_default().push(line);
    }
    for (id, lines) in lines {
        let from_run = lines.iter().filter_map(|line| {
            let (at, field) = line.source.strip_prefix("run ")?.rsplit_once(": ")?;
            Some((line.numbers[0], at, field))
        });
        let from_run: Vec<_> = from_run.collect();
        if from_run.is_empty() {
            continue;
        }
        let open = builtin(id).expect(id).read().expect(id).open().expect(id);
        let walk = open.run.walk();
        for (number, at, field) in from_run {
            let what = format!("{id}: {number} of {at}: {field}");
            let query: Query = at.parse().expect(&what);
            let step = query::matches(walk, &query, 0..walk.len()).next();
            let value = match walk.fields(step.expect(&what)).get(field) {
                Some(Value::Number(value)) => value,
                Some(Value::Integer(value)) => value as f64,
                Some(Value::Rgb(color)) => color.r,
                _ => panic!("{what}"),
            };
            let number = with_e(number);
            let typed: f64 = number.parse().expect(&what);
            let within = half_a_digit(&number) * (1.0 + 1e-9);
            assert!((value - typed).abs() <= within, "{what} is {value}");
        }
    }
}
