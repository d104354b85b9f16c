//! The languages of the program. All text that people read stands in one catalogue a language (`en.ftl`, `id.ftl`, in the
//! format of Project Fluent), as data; the code names a message of the catalogues by its key. Numbers are written here too.

mod catalogue;
mod number;
mod spelling;

pub use number::power_of_ten;
pub use spelling::suggestion;

/// A language of the window, the panels and the lessons.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub enum Language {
    #[default]
    English,
    Indonesian,
    /// English between `[!!` and `!!]`: what a panel shows outside of these marks comes from no catalogue.
    #[cfg(test)]
    Pseudo,
}

impl Language {
    pub const ALL: [Language; 2] = [Language::English, Language::Indonesian];

    /// ISO 639-1.
    pub fn code(self) -> &'static str {
        match self {
            Language::English => "en",
            Language::Indonesian => "id",
            #[cfg(test)]
            Language::Pseudo => "qps",
        }
    }

    /// The language of a tag such as `id` or `id-ID`, where it is one of the program's.
    pub fn of_tag(tag: &str) -> Option<Language> {
        let code = tag.split(['-', '_']).next()?;
        let is_it = |language: &Language| language.code().eq_ignore_ascii_case(code);
        Language::ALL.into_iter().find(is_it)
    }
}

/// What something with a name of its own in the program is called: the message whose key is `space`, a hyphen, and the name in
/// small letters with hyphens: `kind-edge-interpolated` for `EdgeInterpolated`. None where the catalogue has no such message.
pub fn called(space: &str, name: &str, language: Language) -> Option<String> {
    called_with(space, name, &[], language)
}

/// The same of a message with arguments.
pub fn called_with(
    space: &str,
    name: &str,
    arguments: &[(&'static str, &str)],
    language: Language,
) -> Option<String> {
    let mut key = format!("{space}-");
    let mut follows_small = false;
    for c in name.chars() {
        if c.is_ascii_uppercase() && follows_small || !c.is_ascii_alphanumeric() {
            key.push('-');
        }
        if c.is_ascii_alphanumeric() {
            key.push(c.to_ascii_lowercase());
        }
        follows_small = c.is_ascii_lowercase() || c.is_ascii_digit();
    }
    catalogue::of(language).format(&key, arguments)
}

/// The message without arguments under a key that is put together at run time; none where the catalogue has none.
pub fn named(key: &str, language: Language) -> Option<String> {
    catalogue::of(language).format(key, &[])
}

/// A message of the catalogues, by its key.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Message(pub &'static str);

impl Message {
    /// The message without arguments. A key that the catalogue lacks stands for itself.
    pub fn text(self, language: Language) -> &'static str {
        catalogue::of(language).text(self.0).unwrap_or(self.0)
    }

    /// The message with its arguments put in, by name. Numbers come as text, already written as the language writes them;
    /// a whole number without separators also selects the message's plural form.
    pub fn format(self, language: Language, arguments: &[(&'static str, &str)]) -> String {
        catalogue::of(language)
            .format(self.0, arguments)
            .unwrap_or_else(|| self.0.to_string())
    }

    /// The message with the arguments that it has in this language, each looked up by its name; what `value` does not know
    /// stays as `{$name}`.
    pub fn format_with(self, language: Language, value: impl Fn(&str) -> Option<String>) -> String {
        catalogue::of(language)
            .format_with(self.0, value)
            .unwrap_or_else(|| self.0.to_string())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const FOCUS: Message = Message("focus-polygon");

    #[test]
    fn a_message_is_read_in_each_language() {
        assert_eq!(
            FOCUS.format(Language::English, &[("number", "3")]),
            "polygon 3"
        );
        assert_eq!(
            FOCUS.format(Language::Indonesian, &[("number", "3")]),
            "poligon 3"
        );
        assert_eq!(
            Message("focus-frame").text(Language::Indonesian),
            "seluruh gambar"
        );
    }

    #[test]
    fn the_pseudo_language_marks_the_text_and_keeps_the_arguments_outside() {
        assert_eq!(
            FOCUS.format(Language::Pseudo, &[("number", "3")]),
            "[!!polygon !!]3"
        );
        assert_eq!(
            Message("focus-frame").text(Language::Pseudo),
            "[!!the whole picture!!]"
        );
    }
}
