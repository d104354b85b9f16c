//! What the JSON parser finds wrong, in the words of a user who does not know it.

use crate::language::suggestion;

/// Messages that are said otherwise as a whole.
const WHOLE: [(&str, &str); 4] = [
    (
        "number out of range",
        "found a number that is not finite; allowed are numbers up to 1.7e308 in magnitude",
    ),
    (
        "expected value",
        "expected a value: a number, text in double quotes, true, false, a list or an object (NaN and Infinity are none)",
    ),
    (
        "trailing characters",
        "found more text after the end of the document; a file holds one object",
    ),
    (
        "recursion limit exceeded",
        "lists or objects are nested too deeply; at most 127 levels are allowed",
    ),
];

/// What the parser expects, by the names of its types.
const TYPES: [(&str, &str); 7] = [
    ("u32", "a whole number of 0 or more"),
    ("u64", "a whole number of 0 or more"),
    ("usize", "a whole number of 0 or more"),
    ("f64", "a number"),
    ("a boolean", "true or false"),
    ("a string", "a text in double quotes"),
    ("a sequence", "a list"),
];

/// What is wrong with a text, without line and column. `whole` is what the text is: "the file".
pub fn what_the_parser_says(error: &serde_json::Error, whole: &str) -> String {
    if error.is_eof() {
        return format!("{whole} ends here, while a text, a list or an object is still open");
    }
    let text = error.to_string();
    let place = text.rsplit_once(" at line ");
    in_plain_words(place.map_or(&*text, |(message, _)| message))
}

/// Says a message of the parser, without line and column, in plain words; what is plain already stays.
fn in_plain_words(message: &str) -> String {
    if let Some((_, words)) = WHOLE.iter().find(|(whole, _)| *whole == message) {
        return (*words).to_owned();
    }
    let behind = |start: &str| message.strip_prefix(start);
    if let Some(rest) = behind("missing field ") {
        return missing(&[rest.trim_matches('`')]);
    }
    if let Some(rest) = behind("duplicate field ") {
        return format!("the key {rest} is given twice; each may stand once");
    }
    if let Some(rest) = behind("unknown field ") {
        return unknown("unknown key", rest);
    }
    if let Some(rest) = behind("unknown variant ") {
        return unknown("unknown choice", rest);
    }
    let wrong = behind("invalid type: ").or_else(|| behind("invalid value: "));
    if let Some((found, expected)) = wrong.and_then(|rest| rest.rsplit_once(", expected ")) {
        return format!("found {}; expected {}", thing(found), plain(expected));
    }
    if let Some((length, expected)) =
        behind("invalid length ").and_then(|rest| rest.split_once(", expected "))
    {
        let elements = if length == "1" { "element" } else { "elements" };
        return format!("found {length} {elements}; expected {}", plain(expected));
    }
    message.to_owned()
}

/// What is said where these keys, one or more, should be and are not.
pub(super) fn missing(keys: &[&str]) -> String {
    let quoted = keys.iter().map(|key| format!("`{key}`"));
    let quoted = quoted.collect::<Vec<_>>().join(", ");
    match keys.len() {
        1 => format!("the key {quoted} is missing"),
        _ => format!("the keys {quoted} are missing"),
    }
}

/// "`x`, expected one of `a`, `b`": with the name that was probably meant.
fn unknown(what: &str, rest: &str) -> String {
    let (found, known) = rest.split_once(", ").unwrap_or((rest, ""));
    let name = |quoted: &str| quoted.trim_matches('`').to_owned();
    let known: Vec<String> = known
        .split('`')
        .skip(1)
        .step_by(2)
        .map(str::to_owned)
        .collect();
    let meant = suggestion(&name(found), known.iter().map(String::as_str));
    match known.is_empty() {
        true => format!("{what} {found}; none is allowed here"),
        false => format!("{what} {found}{meant}; allowed are {}", known.join(", ")),
    }
}

fn thing(found: &str) -> String {
    let quoted = |kind: &str| {
        found
            .strip_prefix(kind)
            .map(|rest| rest.trim_matches('`').to_owned())
    };
    let number = ["integer ", "floating point ", "boolean "]
        .into_iter()
        .find_map(quoted);
    let text = || {
        found
            .strip_prefix("string ")
            .map(|text| format!("the text {text}"))
    };
    let other = || match found {
        "sequence" => "a list".to_owned(),
        "map" => "an object".to_owned(),
        other => other.to_owned(),
    };
    number.or_else(text).unwrap_or_else(other)
}

fn plain(expected: &str) -> String {
    if let Some((_, words)) = TYPES.iter().find(|(name, _)| *name == expected) {
        return (*words).to_owned();
    }
    // "an array of length 2", "struct Text"
    if let Some(length) = expected.strip_prefix("an array of length ") {
        return format!("a list of {length}");
    }
    match expected.starts_with("struct ") {
        true => "an object { … }".to_owned(),
        false => expected.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_the_parser_says_is_said_in_plain_words() {
        for (message, words) in [
            (
                "invalid type: string \"much\", expected u32",
                "found the text \"much\"; expected a whole number of 0 or more",
            ),
            (
                "invalid type: floating point `0.5`, expected a list of three numbers",
                "found 0.5; expected a list of three numbers",
            ),
            (
                "invalid type: sequence, expected an object { … }",
                "found a list; expected an object { … }",
            ),
            (
                "invalid type: null, expected a string",
                "found null; expected a text in double quotes",
            ),
            (
                "invalid value: integer `2`, expected 1, the schema that this version reads",
                "found 2; expected 1, the schema that this version reads",
            ),
            (
                "invalid length 1, expected an array of length 2",
                "found 1 element; expected a list of 2",
            ),
            ("missing field `en`", "the key `en` is missing"),
            (
                "duplicate field `radius`",
                "the key `radius` is given twice; each may stand once",
            ),
            (
                "unknown field `stpes`, expected one of `schema`, `id`, `steps`",
                "unknown key `stpes` (did you mean steps?); allowed are schema, id, steps",
            ),
            (
                "unknown field `fov`, expected `eye` or `up`",
                "unknown key `fov`; allowed are eye, up",
            ),
            (
                "unknown variant `pixle`, expected one of `frame`, `pixel`",
                "unknown choice `pixle` (did you mean pixel?); allowed are frame, pixel",
            ),
            ("trailing comma", "trailing comma"),
        ] {
            assert_eq!(in_plain_words(message), words);
        }
    }
}
