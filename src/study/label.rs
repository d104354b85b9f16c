//! What the parts, curves and settings of a study are called.

use crate::algorithms::radiosity::Solver;
use crate::figure::Series;
use crate::language::{Language, Message, called};
use crate::methods::Method;

/// A text in every language.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Label {
    /// The same in all of them: `8×8`.
    Plain(String),
    Method(Method),
    Solver(Solver),
    /// Something else with a name of the program's own, by its name.
    Value(&'static str),
    /// A message with its arguments.
    Message(Message, Vec<(&'static str, String)>),
}

impl Label {
    pub const fn of(key: &'static str) -> Self {
        Label::Message(Message(key), Vec::new())
    }

    /// Of a message with one argument.
    pub fn with(key: &'static str, name: &'static str, value: impl ToString) -> Self {
        Label::Message(Message(key), vec![(name, value.to_string())])
    }

    /// As people read it.
    pub fn text(&self, language: Language) -> String {
        match self {
            Label::Plain(text) => text.clone(),
            Label::Method(method) => named("method", method.name(), language),
            Label::Solver(solver) => named("value", solver.name(), language),
            Label::Value(name) => named("value", name, language),
            Label::Message(message, arguments) => {
                let arguments: Vec<(&str, String)> = arguments
                    .iter()
                    .map(|(name, value)| (*name, decimal(value, language)))
                    .collect();
                let arguments: Vec<(&str, &str)> = arguments
                    .iter()
                    .map(|(name, value)| (*name, value.as_str()))
                    .collect();
                message.format(language, &arguments)
            }
        }
    }

    /// As files of the study have it: the program's own name, or in English.
    pub fn name(&self) -> String {
        match self {
            Label::Method(method) => method.name().to_owned(),
            Label::Solver(solver) => solver.name().to_owned(),
            Label::Value(name) => (*name).to_owned(),
            Label::Plain(_) | Label::Message(..) => self.text(Language::English),
        }
    }

    /// What has one look in all plots has it here too.
    pub fn series(&self) -> Option<Series> {
        match self {
            Label::Method(method) => Some(method.series()),
            Label::Solver(solver) => Some(solver.series()),
            _ => None,
        }
    }
}

/// A name of the program's own in a space of the catalogues.
fn named(space: &str, name: &str, language: Language) -> String {
    called(space, name, language).unwrap_or_else(|| name.to_owned())
}

/// A decimal number with the sign of the language; anything else as it is.
fn decimal(value: &str, language: Language) -> String {
    match value.contains('.') && value.parse::<f64>().is_ok() {
        true => language.typeset(value),
        false => value.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn people_read_their_language_and_files_keep_the_programs_names() {
        let method = Label::Method(Method::Flat);
        assert_eq!(method.text(Language::Indonesian), "datar");
        assert_eq!(method.name(), "flat");
        let shots = Label::with("setting-shots", "count", 12);
        assert_eq!(shots.text(Language::Indonesian), "12 tembakan");
        assert_eq!(shots.name(), "12 shots");
        let exact = Label::with("reference-closed-form", "f", "0.25");
        assert_eq!(
            exact.text(Language::Indonesian),
            "F = 0,25, bentuk tertutup"
        );
    }
}
