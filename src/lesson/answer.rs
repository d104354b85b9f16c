//! The kinds of answers: what is right, what a guess is, how it is judged, and what helps after a first wrong one. A kind has its
//! file here, and one beside the card that asks (`app::question_card`).

pub(super) mod arrow;
mod choice;
mod number;
pub(super) mod order;
pub(super) mod pick;
mod pixel;

use crate::language::Language;
use crate::panels::Panel;
use crate::replay::VectorPlane;
pub use arrow::START as ARROW_START;
use glam::DVec3;
pub use number::{read_number, rounded};
pub use pick::Thing;
use serde::{Deserialize, Serialize};

/// The right answer, as it was read from the run.
#[derive(Clone, Debug, PartialEq)]
pub enum Answer {
    Number {
        value: f64,
        tolerance: f64,
    },
    /// Options by language, and the index of the right one.
    Choice {
        options: Vec<[String; 2]>,
        right: usize,
    },
    Pixel {
        x: u32,
        y: u32,
        tolerance: u32,
    },
    /// One of the things that the run has, by number; their names by language.
    Pick {
        thing: Thing,
        names: Vec<[String; 2]>,
        right: usize,
    },
    /// Items by language as they are shown, and their indices in the right order.
    Order {
        items: Vec<[String; 2]>,
        right: Vec<usize>,
    },
    /// A direction at a point, as it is seen in the plane of the vectors there.
    Arrow {
        /// As the run names it.
        name: &'static str,
        plane: VectorPlane,
        /// Unit.
        direction: DVec3,
        /// In degrees.
        tolerance: f64,
    },
    /// After a change the run has no answer: what is asked about does not happen, or no option holds, or several do.
    Undecided,
}

/// An answer that was given.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Guess {
    /// As it was typed.
    Number(String),
    /// An index into the options.
    Choice(usize),
    Pixel {
        x: u32,
        y: u32,
    },
    /// The number of a thing.
    Pick(usize),
    /// The indices of the items, from the first to the last.
    Order(Vec<usize>),
    /// By how many degrees the arrow is turned clockwise from the normal.
    Arrow(f64),
}

/// Why a guess cannot be judged.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoAnswer {
    /// What was typed is no number.
    NotANumber,
    /// Something else is asked.
    OtherKind,
}

impl Answer {
    /// Whether a guess is right.
    pub fn judge(&self, guess: &Guess) -> Result<bool, NoAnswer> {
        match (self, guess) {
            (&Answer::Number { value, tolerance }, Guess::Number(text)) => {
                let number = read_number(text).ok_or(NoAnswer::NotANumber)?;
                Ok((number - value).abs() <= tolerance)
            }
            (Answer::Choice { right, options }, Guess::Choice(choice)) => {
                match *choice < options.len() {
                    true => Ok(choice == right),
                    false => Err(NoAnswer::OtherKind),
                }
            }
            (&Answer::Pixel { x, y, tolerance }, &Guess::Pixel { x: at_x, y: at_y }) => {
                Ok(x.abs_diff(at_x) <= tolerance && y.abs_diff(at_y) <= tolerance)
            }
            (Answer::Pick { right, names, .. }, Guess::Pick(number)) => {
                match *number < names.len() {
                    true => Ok(number == right),
                    false => Err(NoAnswer::OtherKind),
                }
            }
            (Answer::Order { items, right }, Guess::Order(order)) => {
                match order::is_whole(order, items.len()) {
                    true => Ok(order == right),
                    false => Err(NoAnswer::OtherKind),
                }
            }
            (
                &Answer::Arrow {
                    plane,
                    direction,
                    tolerance,
                    ..
                },
                &Guess::Arrow(degrees),
            ) => {
                let apart = arrow::turn(degrees, plane.degrees(direction)).abs();
                Ok(apart <= tolerance)
            }
            _ => Err(NoAnswer::OtherKind),
        }
    }

    /// How many guesses there are before the verdict. Of two options the second try would be no question.
    pub fn tries(&self) -> usize {
        match self {
            Answer::Choice { options: all, .. } | Answer::Pick { names: all, .. }
                if all.len() < 3 =>
            {
                1
            }
            _ => 2,
        }
    }

    /// What may be said about the right one after a wrong guess; a hint of the lesson's own follows.
    pub fn hint(&self, guess: &Guess, language: Language) -> String {
        match (self, guess) {
            (&Answer::Number { value, .. }, Guess::Number(text)) => {
                number::hint(value, text, language)
            }
            (&Answer::Pixel { x, y, .. }, &Guess::Pixel { x: at_x, y: at_y }) => {
                pixel::hint([x, y], [at_x, at_y], language)
            }
            (Answer::Order { right, .. }, Guess::Order(order)) => {
                order::hint(right, order, language)
            }
            (
                Answer::Arrow {
                    plane, direction, ..
                },
                &Guess::Arrow(degrees),
            ) => arrow::hint(plane.degrees(*direction), degrees, language),
            _ => choice::hint(language),
        }
    }

    /// The panels in which it can be given, the best first; none where it is given in the question's card.
    pub fn panels(&self) -> &'static [Panel] {
        match self {
            Answer::Pixel { .. } => &[Panel::Image, Panel::Comparison, Panel::Difference],
            Answer::Pick {
                thing: Thing::Object,
                ..
            } => &[Panel::Image],
            Answer::Pick {
                thing: Thing::Patch,
                ..
            } => &[Panel::Radiosity],
            Answer::Arrow { .. } => &[Panel::Vectors],
            Answer::Number { .. }
            | Answer::Choice { .. }
            | Answer::Order { .. }
            | Answer::Undecided => &[],
        }
    }

    /// The right answer in words.
    pub fn in_words(&self, language: Language) -> String {
        match self {
            &Answer::Number { value, tolerance } => language.number(rounded(value, tolerance)),
            Answer::Choice { right, .. } => self.guess_in_words(&Guess::Choice(*right), language),
            &Answer::Pixel { x, y, .. } => pixel::in_words(x, y),
            Answer::Pick { right, .. } => self.guess_in_words(&Guess::Pick(*right), language),
            Answer::Order { items, right } => order::in_words(items, right, language),
            Answer::Arrow {
                plane, direction, ..
            } => arrow::in_words(plane.degrees(*direction), language),
            Answer::Undecided => String::new(),
        }
    }

    /// A guess in words, as the language writes it.
    pub fn guess_in_words(&self, guess: &Guess, language: Language) -> String {
        match (self, guess) {
            (_, Guess::Number(text)) => {
                read_number(text).map_or_else(|| text.clone(), |number| language.number(number))
            }
            (Answer::Choice { options, .. }, &Guess::Choice(choice)) => {
                let option = options.get(choice);
                option.map_or_else(String::new, |option| option[language as usize].clone())
            }
            (Answer::Pick { names, .. }, &Guess::Pick(number)) => {
                let name = names.get(number);
                name.map_or_else(String::new, |name| name[language as usize].clone())
            }
            (Answer::Order { items, .. }, Guess::Order(order)) => {
                order::in_words(items, order, language)
            }
            (_, &Guess::Pixel { x, y }) => pixel::in_words(x, y),
            (_, &Guess::Arrow(degrees)) => arrow::in_words(degrees, language),
            _ => String::new(),
        }
    }
}
