//! A question on paper: what can be chosen or put in order, and room for the answer.

use super::html::words;
use crate::language::{Language, Message};
use crate::lesson::{Answer, Question};

/// So many things to choose from are listed.
const MOST_LISTED: usize = 8;

/// What is asked, and what there is to choose from.
pub fn asked(question: &Question, language: Language) -> String {
    let ask = format!("<p>{}</p>\n", words(question.ask(language)));
    let listed = |things: &[[String; 2]], class: &str| {
        let items = things.iter().map(|thing| &thing[language as usize]);
        let items = items.map(|thing| format!("<li>{}</li>\n", words(thing)));
        format!(
            "{ask}<ul class=\"{class}\">\n{}</ul>\n",
            items.collect::<String>()
        )
    };
    match &question.answer {
        Answer::Choice { options, .. } => listed(options, "choice"),
        Answer::Order { items, .. } => listed(items, "order"),
        Answer::Pick { names, .. } if names.len() <= MOST_LISTED => listed(names, "choice"),
        _ => ask,
    }
}

/// Where the answer is written; nothing where it is ticked or numbered.
pub fn room(question: &Question, language: Language) -> String {
    let hint = match &question.answer {
        Answer::Choice { .. } | Answer::Order { .. } => return String::new(),
        Answer::Pick { names, .. } if names.len() <= MOST_LISTED => return String::new(),
        Answer::Arrow { .. } => Message("export-draw-the-arrow"),
        Answer::Pixel { .. } => Message("export-mark-the-pixel"),
        Answer::Number { .. } | Answer::Pick { .. } | Answer::Undecided => Message("export-answer"),
    };
    format!("<p class=\"room\">{}</p>\n", hint.text(language))
}

/// The right answer, and why.
pub fn answered(question: &Question, language: Language) -> String {
    let answer = question.answer.in_words(language);
    format!(
        "<p><strong>{}</strong></p>\n<p>{}</p>\n",
        words(answer.trim()),
        words(question.why(language))
    )
}
