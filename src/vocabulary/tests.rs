use super::*;
use std::collections::HashSet;

#[test]
fn every_value_has_a_symbol_and_every_kind_a_sentence_in_both_languages() {
    for kind in FAMILIES.into_iter().flatten() {
        for quantity in kind.quantities {
            assert!(
                !quantity.symbol.is_empty(),
                "{}: {}",
                kind.name,
                quantity.name
            );
        }
        assert!(!kind.entries.is_empty(), "{} says nothing", kind.name);
        for entry in kind.entries {
            assert!(
                !entry.says.en.is_empty() && !entry.says.id.is_empty(),
                "{}",
                kind.name
            );
        }
    }
}

#[test]
fn a_scope_is_numbered_by_a_value_of_its_own_and_has_a_name() {
    for kind in FAMILIES.into_iter().flatten() {
        if let Some(number) = kind.number {
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
