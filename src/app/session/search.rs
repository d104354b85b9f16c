//! A search as the reader writes it, in the names of kinds, values and words that the window shows, turned into the names that
//! queries know. Both may stand in one text.

use crate::language::{Language, Message, called};
use crate::panels::{kind_name, quantity_name};
use crate::record::{Fields, Value};
use crate::replay::{Walk, query};
use crate::vocabulary::FAMILIES;

/// Around an operand of several words.
const QUOTE: char = '\u{22}';

/// The text with the names of the program in place of those of the reader's language; what is none stays as it is.
pub fn in_program_names(text: &str, walk: &dyn Walk, language: Language) -> String {
    let (kind, mut rest) = kind(text, walk, language);
    let mut query = kind;
    while let Some(at) = rest.find(is_sign) {
        let behind = rest[at..].trim_start_matches(is_sign);
        let sign = &rest[at..rest.len() - behind.len()];
        query += &field(&rest[..at], language);
        query += sign;
        let behind = behind.trim_start();
        let end = operand_end(behind);
        query += &operand(&behind[..end], walk, language);
        rest = &behind[end..];
    }
    query + rest
}

/// Whether a condition is written with it.
pub fn is_sign(c: char) -> bool {
    matches!(c, '=' | '!' | '<' | '>')
}

/// What is called so, in small letters, without the marks of subscripts.
fn same(shown: &str, written: &str) -> bool {
    let plain = |text: &str| text.replace(['{', '}'], "").to_lowercase();
    plain(shown) == plain(written)
}

/// The kind that the text begins with, and what follows it: the longest name that is followed by a space or nothing.
fn kind<'a>(text: &'a str, walk: &dyn Walk, language: Language) -> (String, &'a str) {
    let text = text.trim_start();
    let ends = text.char_indices().filter(|(_, c)| c.is_whitespace());
    let ends: Vec<usize> = ends.map(|(at, _)| at).chain([text.len()]).collect();
    let kinds = query::kinds(walk);
    let called_so = |end: usize| {
        let mut kinds = kinds.iter().map(|(kind, _)| *kind);
        let written = &text[..end];
        let kind =
            kinds.find(|&kind| kind == written || same(&kind_name(kind, language), written))?;
        Some((kind.to_string(), &text[end..]))
    };
    let longest = ends.into_iter().rev().find_map(called_so);
    longest.unwrap_or((String::new(), text))
}

/// A condition's field, which may have a part behind a dot.
fn field(written: &str, language: Language) -> String {
    let name = written.trim();
    let (whole, part) = match name.rsplit_once('.') {
        Some((whole, part)) if part.len() == 1 => (whole, &name[whole.len()..]),
        _ => (name, ""),
    };
    let quantities = || {
        FAMILIES
            .into_iter()
            .flatten()
            .flat_map(|kind| kind.quantities)
    };
    if quantities().any(|quantity| quantity.name == whole) {
        return written.to_string();
    }
    match quantities().find(|quantity| same(&quantity_name(quantity, language), whole)) {
        Some(quantity) => written.replace(name, &format!("{}{part}", quantity.name)),
        None => written.to_string(),
    }
}

/// Where the operand ends that the text begins with: behind its word or quotation; the last one may be several words.
fn operand_end(text: &str) -> usize {
    if text.starts_with(QUOTE) {
        return text[1..].find(QUOTE).map_or(text.len(), |end| end + 2);
    }
    let next = text.find(is_sign);
    let before = text[..next.unwrap_or(text.len())].trim_end();
    match next {
        Some(_) => before.find(char::is_whitespace).unwrap_or(before.len()),
        None => before.len(),
    }
}

fn operand(written: &str, walk: &dyn Walk, language: Language) -> String {
    let plain = written.trim_matches(QUOTE);
    for (key, truth) in [("panels-yes", "true"), ("panels-no", "false")] {
        if same(Message(key).text(language), plain) {
            return truth.to_string();
        }
    }
    let number = plain.replace('−', "-").replace(',', ".");
    if number.parse::<f64>().is_ok() {
        return number;
    }
    let mut fields = Fields::default();
    let word = (0..walk.len()).find_map(|step| {
        fields.0.clear();
        walk.push_fields(step, &mut fields);
        fields.iter().find_map(|field| match field.value {
            Value::Word(word) if same(&called("value", word, language)?, plain) => Some(word),
            _ => None,
        })
    });
    word.map_or_else(|| written.to_string(), |word| format!("\"{word}\""))
}
