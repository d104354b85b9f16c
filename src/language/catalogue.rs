//! A language's catalogue, parsed once.

use super::Language;
use fluent_bundle::concurrent::FluentBundle;
use fluent_bundle::resolver::ResolverError;
use fluent_bundle::resolver::errors::ReferenceKind;
use fluent_bundle::{FluentArgs, FluentError, FluentResource, FluentValue};
use std::collections::HashMap;
use std::sync::{OnceLock, RwLock};

const ENGLISH: &str = include_str!("en.ftl");
const INDONESIAN: &str = include_str!("id.ftl");

pub(super) struct Catalogue {
    bundle: FluentBundle<FluentResource>,
    /// Messages without arguments that were asked for before.
    plain: RwLock<HashMap<&'static str, &'static str>>,
}

/// The catalogue of `language`.
pub(super) fn of(language: Language) -> &'static Catalogue {
    static ENGLISH_ONCE: OnceLock<Catalogue> = OnceLock::new();
    static INDONESIAN_ONCE: OnceLock<Catalogue> = OnceLock::new();
    match language {
        Language::English => ENGLISH_ONCE.get_or_init(|| Catalogue::parse(language, ENGLISH)),
        Language::Indonesian => {
            INDONESIAN_ONCE.get_or_init(|| Catalogue::parse(language, INDONESIAN))
        }
        #[cfg(test)]
        Language::Pseudo => {
            static PSEUDO_ONCE: OnceLock<Catalogue> = OnceLock::new();
            PSEUDO_ONCE.get_or_init(|| {
                let mut catalogue = Catalogue::parse(Language::English, ENGLISH);
                catalogue.bundle.set_transform(Some(marked));
                catalogue
            })
        }
    }
}

impl Catalogue {
    /// # Panics
    /// Where the catalogue is no valid Fluent, or has a key twice: it is compiled in, and a test reads it.
    fn parse(language: Language, source: &'static str) -> Self {
        let resource = FluentResource::try_new(source.to_string())
            .unwrap_or_else(|(_, errors)| panic!("{}.ftl: {errors:?}", language.code()));
        let tag = language.code().parse().expect("a language's code is a tag");
        let mut bundle = FluentBundle::new_concurrent(vec![tag]);
        // Marks around arguments, for text of mixed direction: neither of our languages needs them, and our font lacks them.
        bundle.set_use_isolating(false);
        if let Err(errors) = bundle.add_resource(resource) {
            panic!("{}.ftl: {errors:?}", language.code());
        }
        Self {
            bundle,
            plain: RwLock::default(),
        }
    }

    /// A message without arguments.
    pub fn text(&self, key: &'static str) -> Option<&'static str> {
        if let Some(&text) = self.plain.read().expect("no reader panics").get(key) {
            return Some(text);
        }
        let text = self.format(key, &[])?;
        let mut plain = self.plain.write().expect("no writer panics");
        // Leaked once a key: as long-lived as the catalogue itself.
        Some(*plain.entry(key).or_insert_with(|| text.leak()))
    }

    pub fn format_with(&self, key: &str, value: impl Fn(&str) -> Option<String>) -> Option<String> {
        let pattern = self.bundle.get_message(key)?.value()?;
        let mut errors = Vec::new();
        let text = self.bundle.format_pattern(pattern, None, &mut errors);
        if errors.is_empty() {
            return Some(text.into_owned());
        }
        let mut arguments = FluentArgs::new();
        for name in errors.into_iter().filter_map(missing) {
            if let Some(text) = value(&name) {
                arguments.set(name, argument(&text).into_owned());
            }
        }
        let pattern = self
            .bundle
            .format_pattern(pattern, Some(&arguments), &mut Vec::new());
        Some(pattern.into_owned())
    }

    pub fn format(&self, key: &str, arguments: &[(&'static str, &str)]) -> Option<String> {
        let pattern = self.bundle.get_message(key)?.value()?;
        let arguments: FluentArgs = arguments
            .iter()
            .map(|&(name, text)| (name, argument(text)))
            .collect();
        let mut errors = Vec::new();
        let text = self
            .bundle
            .format_pattern(pattern, Some(&arguments), &mut errors);
        debug_assert!(errors.is_empty(), "{key}: {errors:?}");
        Some(text.into_owned())
    }
}

/// The argument that a message has but was not given.
fn missing(error: FluentError) -> Option<String> {
    match error {
        FluentError::ResolverError(ResolverError::Reference(ReferenceKind::Variable { id })) => {
            Some(id)
        }
        _ => None,
    }
}

/// A whole number is given as a number, since plural forms are selected by numbers; it is written as it came.
fn argument(text: &str) -> FluentValue<'_> {
    let whole = text.len() < 10 && (text == "0" || !text.starts_with('0'));
    match text.parse::<u32>() {
        Ok(number) if whole && !text.starts_with('+') => FluentValue::from(number),
        _ => FluentValue::from(text),
    }
}

#[cfg(test)]
fn marked(text: &str) -> std::borrow::Cow<'_, str> {
    use std::borrow::Cow;
    if text.contains(char::is_alphabetic) {
        Cow::Owned(format!("[!!{text}!!]"))
    } else {
        Cow::Borrowed(text)
    }
}
