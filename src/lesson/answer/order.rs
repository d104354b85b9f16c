//! Things that happen one after the other in the run, to be put in order.

use super::Answer;
use crate::language::{Language, Message};
use crate::lesson::file::ItemFile;
use crate::replay::{Run, query};

const IN_PLACE: Message = Message("hint-in-place");
/// How many things can be put in order at a glance.
const COUNTS: std::ops::RangeInclusive<usize> = 3..=5;

/// The items, shuffled in a way that is always the same, and the order of their first steps behind `asked_at`.
pub(in crate::lesson) fn read(
    run: &Run,
    asked_at: usize,
    items: &[ItemFile],
) -> Result<Answer, String> {
    if !COUNTS.contains(&items.len()) {
        let (least, most) = COUNTS.into_inner();
        let count = items.len();
        return Err(format!(
            "found {count} items to put in order; allowed are {least} to {most}"
        ));
    }
    let walk = run.walk();
    let mut steps = Vec::new();
    for (number, item) in items.iter().enumerate() {
        let step = query::matches(walk, &item.at, asked_at + 1..walk.len()).next();
        let step = step.ok_or_else(|| {
            format!(
                "order[{number}]: no step behind the question is like {}",
                item.at
            )
        })?;
        if let Some(same) = steps.iter().position(|&other| other == step) {
            return Err(format!(
                "order[{same}] and order[{number}] both first happen at step {step}; which comes first must be clear"
            ));
        }
        steps.push(step);
    }
    let mut shown: Vec<usize> = (0..items.len()).collect();
    shown.sort_by_key(|&item| scattered(items[item].text.in_language(Language::English)));
    if shown.is_sorted_by_key(|&item| steps[item]) {
        shown.rotate_left(1);
    }
    let mut right: Vec<usize> = (0..items.len()).collect();
    right.sort_by_key(|&place| steps[shown[place]]);
    let text = |&item: &usize| items[item].text.both().map(|(_, text)| text.to_owned());
    Ok(Answer::Order {
        items: shown.iter().map(text).collect(),
        right,
    })
}

/// A number that says nothing about a text: its FNV-1a hash (Fowler, Noll and Vo, 1991).
fn scattered(text: &str) -> u64 {
    text.bytes().fold(0xcbf2_9ce4_8422_2325, |hash, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
    })
}

/// Whether a guess has each of `count` items once.
pub(super) fn is_whole(guess: &[usize], count: usize) -> bool {
    guess.len() == count && (0..count).all(|item| guess.contains(&item))
}

/// A numbered list, an item a line.
pub(super) fn in_words(items: &[[String; 2]], order: &[usize], language: Language) -> String {
    let names = order.iter().filter_map(|&item| items.get(item));
    let line = |(place, name): (usize, &[String; 2])| {
        let name = &name[language as usize];
        format!("{}. {name}", place + 1)
    };
    let lines: Vec<String> = names.enumerate().map(line).collect();
    lines.join("\n")
}

/// How many items of the guess stand where they should.
pub(super) fn hint(right: &[usize], guess: &[usize], language: Language) -> String {
    let places = right.iter().zip(guess);
    let count = places.filter(|(right, guess)| right == guess).count();
    let [count, all] = [count, right.len()].map(|number| number.to_string());
    IN_PLACE.format(language, &[("count", &count), ("all", &all)])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lesson::{Guess, NoAnswer, builtin};
    use serde_json::json;

    fn answer(selectors: &[&str]) -> Result<Answer, String> {
        let lesson = builtin("gouraud-triangle").unwrap().read().unwrap();
        let run = lesson.open().unwrap().run;
        let item = |at: &&str| json!({ "text": { "en": at, "id": at }, "at": at });
        let items: Vec<_> = selectors.iter().map(item).collect();
        read(
            &run,
            0,
            &serde_json::from_value::<Vec<_>>(json!(items)).unwrap(),
        )
    }

    #[test]
    fn the_run_says_what_comes_first_and_the_card_shows_another_order() {
        let selectors = ["ScanLine", "VertexLit", "FrameDone", "EdgeTableBuilt"];
        let right = "1. VertexLit\n2. EdgeTableBuilt\n3. ScanLine\n4. FrameDone";
        // In whichever order the file gives them.
        for turn in 0..selectors.len() {
            let mut selectors = selectors;
            selectors.rotate_left(turn);
            let answer = answer(&selectors).unwrap();
            assert_eq!(answer.in_words(Language::English), right);
            let shown = Guess::Order(vec![0, 1, 2, 3]);
            assert_eq!(answer.judge(&shown), Ok(false));
            let Answer::Order { right, .. } = &answer else {
                panic!("an order")
            };
            assert_eq!(answer.judge(&Guess::Order(right.clone())), Ok(true));
            let twice = Guess::Order(vec![0, 1, 1, 3]);
            assert_eq!(answer.judge(&twice), Err(NoAnswer::OtherKind));
        }
    }

    #[test]
    fn a_hint_counts_what_is_in_place() {
        let hint = |guess: &[usize]| hint(&[2, 0, 1], guess, Language::English);
        assert_eq!(hint(&[2, 1, 0]), "Of the 3, in the right place: 1.");
    }

    #[test]
    fn items_that_have_no_order_are_refused() {
        assert_eq!(
            answer(&["ScanLine", "FrameDone"]).unwrap_err(),
            "found 2 items to put in order; allowed are 3 to 5"
        );
        assert_eq!(
            answer(&["ScanLine", "Shadow", "FrameDone"]).unwrap_err(),
            "order[1]: no step behind the question is like Shadow"
        );
        let same = answer(&["FrameDone", "ScanLine", "ScanLine y>0"]).unwrap_err();
        assert!(same.starts_with("order[1] and order[2] both first happen at step "));
    }
}
