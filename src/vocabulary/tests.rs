use super::*;
use crate::language::{Language, called};
use std::collections::HashSet;

#[test]
fn every_value_has_a_symbol_and_a_meaning_and_every_kind_a_sentence_in_every_language() {
    for kind in FAMILIES.into_iter().flatten() {
        for quantity in kind.quantities {
            let what = format!("{} of {}", quantity.name, kind.name);
            assert!(!quantity.symbol.is_empty(), "{what} has no symbol");
            for language in Language::ALL {
                let meaning = kind.meaning(quantity.name, language);
                assert!(
                    meaning.is_some_and(|meaning| !meaning.is_empty()),
                    "{what} has no meaning in {language:?}"
                );
            }
        }
        assert!(!kind.entries.is_empty(), "{} says nothing", kind.name);
        let sentences = kind.entries.iter().map(|entry| entry.sentence);
        let notes = kind.entries.iter().flat_map(|entry| entry.formulas);
        let notes = notes.filter_map(|formula| formula.note);
        for message in sentences.chain(notes).chain(kind.scope) {
            for language in Language::ALL {
                let text = message.format_with(language, |_| Some("0".to_string()));
                assert_ne!(text, message.0, "{}", kind.name);
            }
        }
    }
}

#[test]
fn a_scope_is_numbered_by_a_value_of_its_own_and_has_a_name() {
    for kind in FAMILIES.into_iter().flatten() {
        for number in kind.numbers {
            assert!(kind.quantity(number).is_some(), "{}: {number}", kind.name);
            assert!(kind.scope.is_some(), "{} has no name", kind.name);
        }
    }
}

#[test]
fn every_quantity_is_declared_once_and_used() {
    let used: HashSet<&str> = FAMILIES
        .into_iter()
        .flatten()
        .flat_map(|kind| kind.quantities.iter().map(|quantity| quantity.name))
        .collect();
    let mut seen = HashSet::new();
    for (name, ..) in quantity::QUANTITIES {
        assert!(used.contains(name), "no kind has {name}");
        assert!(seen.insert(name), "{name} is declared twice");
    }
}

#[test]
fn every_kind_and_every_symbol_that_is_a_word_has_a_name_in_every_language() {
    let is_word = |symbol: &str| symbol.len() > 2 && symbol.bytes().all(|b| b.is_ascii_lowercase());
    for (kind, language) in FAMILIES
        .into_iter()
        .flatten()
        .flat_map(|kind| Language::ALL.map(|language| (kind, language)))
    {
        assert!(
            called("kind", kind.name, language).is_some(),
            "{} in {language:?}",
            kind.name
        );
        for quantity in kind.quantities {
            assert!(
                !is_word(quantity.symbol) || called("quantity", quantity.name, language).is_some(),
                "{} in {language:?}",
                quantity.name
            );
        }
    }
}
