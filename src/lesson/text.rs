//! A text of a lesson: in both languages, or in one, which then stands for the other too.

use crate::language::Language;
use crate::scene::document::present;
use schemars::JsonSchema;
use serde::Deserialize;

/// A text in English, in Indonesian, or in both; where one is missing, the other is shown. `{I_4}` in it stands for the value of that
/// field at the step, `{I_4:3}` for three decimals, `{object:name}` for the name of the thing of that number.
#[derive(Clone, Debug, Deserialize, JsonSchema, PartialEq, Eq)]
#[serde(deny_unknown_fields)]
pub struct Text {
    #[serde(default, deserialize_with = "present")]
    en: Option<String>,
    #[serde(default, deserialize_with = "present")]
    id: Option<String>,
}

impl Text {
    /// By language.
    pub fn new([en, id]: [String; 2]) -> Self {
        Text {
            en: Some(en),
            id: Some(id),
        }
    }

    pub fn in_language(&self, language: Language) -> &str {
        let other = self.en.as_ref().or(self.id.as_ref());
        self.own(language).or(other).map_or("", |text| text)
    }

    pub fn both(&self) -> [(Language, &str); 2] {
        Language::ALL.map(|language| (language, self.in_language(language)))
    }

    /// The language whose text is shown in this one.
    pub(super) fn shown_in(&self, language: Language) -> Language {
        let mut others = Language::ALL.into_iter();
        match self.own(language) {
            Some(_) => language,
            None => others
                .find(|&other| self.own(other).is_some())
                .unwrap_or(language),
        }
    }

    pub(super) fn own(&self, language: Language) -> Option<&String> {
        match language {
            Language::English => self.en.as_ref(),
            Language::Indonesian => self.id.as_ref(),
            #[cfg(test)]
            Language::Pseudo => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn text(json: &str) -> Text {
        serde_json::from_str(json).unwrap()
    }

    #[test]
    fn where_a_language_is_missing_the_other_is_shown() {
        let both = text(r#"{ "en": "ray", "id": "sinar" }"#);
        let one = text(r#"{ "id": "sinar" }"#);
        for (language, of_both) in [(Language::English, "ray"), (Language::Indonesian, "sinar")] {
            assert_eq!(both.in_language(language), of_both);
            assert_eq!(both.shown_in(language), language);
            assert_eq!(one.in_language(language), "sinar");
            assert_eq!(one.shown_in(language), Language::Indonesian);
        }
    }
}
