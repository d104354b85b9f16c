//! A text of a lesson, in both languages.

use crate::panels::strings::Language;
use schemars::JsonSchema;
use serde::Deserialize;

/// A text in both languages. `{I_4}` in it stands for the value of that field at the step, `{I_4:3}` for three decimals,
/// `{object:name}` for the name of the thing of that number.
#[derive(Clone, Debug, Deserialize, JsonSchema, PartialEq, Eq)]
#[serde(deny_unknown_fields)]
pub struct Text {
    pub en: String,
    pub id: String,
}

impl Text {
    pub fn in_language(&self, language: Language) -> &str {
        match language {
            Language::English => &self.en,
            Language::Indonesian => &self.id,
            #[cfg(test)]
            Language::Pseudo => &self.en,
        }
    }

    pub fn both(&self) -> [(Language, &str); 2] {
        Language::ALL.map(|language| (language, self.in_language(language)))
    }
}
