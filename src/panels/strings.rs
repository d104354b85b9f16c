//! The words of panels and window in both languages: one typed table, so that no text can be missing in one of them.

use crate::algorithms::focus::Focus;
pub use crate::language::Language;
use crate::language::Message;

/// A text in both languages.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Words {
    pub en: &'static str,
    pub id: &'static str,
}

impl Words {
    pub const fn new(en: &'static str, id: &'static str) -> Self {
        Words { en, id }
    }

    pub fn in_language(self, language: Language) -> &'static str {
        match language {
            Language::English => self.en,
            Language::Indonesian => self.id,
            #[cfg(test)]
            Language::Pseudo => self.en,
        }
    }
}

/// The part of a run that is looked at.
pub fn focus(focus: Focus, language: Language) -> String {
    let numbered = |key, number: String| Message(key).format(language, &[("number", &number)]);
    match focus {
        Focus::Frame => Message("focus-frame").text(language).to_owned(),
        Focus::Polygon(number) => numbered("focus-polygon", number.to_string()),
        Focus::ScanLine(y) => numbered("focus-line", y.to_string()),
        Focus::Pixel { x, y } => {
            Message("focus-pixel").format(language, &[("x", &x.to_string()), ("y", &y.to_string())])
        }
        Focus::Iterations { start, end } => Message("focus-iterations").format(
            language,
            &[
                ("first", &start.to_string()),
                ("last", &(end - 1).to_string()),
            ],
        ),
        Focus::Patch(number) => numbered("focus-patch", number.to_string()),
        Focus::FormFactor { i, j } => format!("F({i}, {j})"),
    }
}
