//! A pixel of the picture.

use crate::language::{Language, Message};

const ONE_WAY: Message = Message("hint-one-way");
const TWO_WAYS: Message = Message("hint-two-ways");

pub(super) fn in_words(x: u32, y: u32) -> String {
    format!("({x}, {y})")
}

/// In which directions the right pixel lies from the guess.
pub(super) fn hint(right: [u32; 2], guess: [u32; 2], language: Language) -> String {
    let ways = [
        ["hint-way-left", "hint-way-right"],
        ["hint-way-up", "hint-way-down"],
    ];
    let mut found = Vec::new();
    for axis in 0..2 {
        if right[axis] != guess[axis] {
            let way = ways[axis][usize::from(right[axis] > guess[axis])];
            found.push(Message(way).text(language));
        }
    }
    match found[..] {
        [across, along] => TWO_WAYS.format(language, &[("across", across), ("along", along)]),
        [way] => ONE_WAY.format(language, &[("way", way)]),
        _ => String::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_hint_points_from_the_guess_to_the_right_pixel() {
        let hint = |guess| hint([20, 15], guess, Language::English);
        assert_eq!(hint([25, 15]), "The pixel lies further to the left.");
        assert_eq!(
            hint([2, 30]),
            "The pixel lies further to the right and further up."
        );
    }
}
