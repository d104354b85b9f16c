//! A place in a lesson as the end of an address, which a page opens and the program too:
//! `#lesson=shadows&step=12&language=id&theme=projector&panel=vectors&present`.

use crate::language::Language;
use crate::panels::Panel;
use crate::picture::Theme;
use std::fmt::{self, Display, Formatter};

/// What an address says; what it does not say stays as it is.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Link {
    /// By its id; the page of all lessons unless given.
    pub lesson: Option<String>,
    /// The page of classic mistakes, in place of a lesson.
    pub mistakes: bool,
    pub step: Option<usize>,
    pub language: Option<Language>,
    pub theme: Option<Theme>,
    /// The one that was chosen as the large one.
    pub panel: Option<Panel>,
    pub presenting: bool,
}

impl Link {
    /// Reads what follows the `#` of an address. Errors: what is wrong with it.
    pub fn parse(text: &str) -> Result<Self, String> {
        let mut link = Link::default();
        for part in text.split('&').filter(|part| !part.is_empty()) {
            let (key, value) = part.split_once('=').unwrap_or((part, ""));
            let wrong =
                |allowed: &str| format!("the address says {key}={value:?}; {key} takes {allowed}");
            match key {
                "lesson" if !value.is_empty() => link.lesson = Some(value.to_owned()),
                "lesson" => return Err(wrong("the id of a lesson")),
                "step" => {
                    let step = value.parse();
                    link.step = Some(step.map_err(|_| wrong("a whole number from 0"))?);
                }
                "language" => {
                    let known = Language::ALL.into_iter();
                    let named = known.into_iter().find(|known| known.code() == value);
                    link.language = Some(named.ok_or_else(|| wrong("en or id"))?);
                }
                "theme" => {
                    let theme = Theme::from_name(value);
                    let names = || Theme::ALL.map(Theme::name).join(", ");
                    link.theme = Some(theme.ok_or_else(|| wrong(&names()))?);
                }
                "panel" => {
                    let panel = Panel::called(value);
                    let names = || Panel::ALL.map(Panel::name).join(", ");
                    link.panel = Some(panel.ok_or_else(|| wrong(&names()))?);
                }
                "present" => link.presenting = true,
                "mistakes" => link.mistakes = true,
                _ => {
                    return Err(format!(
                        "the address says {key:?}; it takes lesson, step, language, theme, panel, present and mistakes"
                    ));
                }
            }
        }
        if link.mistakes && link.lesson.is_some() {
            return Err("the address says a lesson and the page of classic mistakes".into());
        }
        if link.lesson.is_none() && (link.step.is_some() || link.panel.is_some()) {
            return Err("the address says a step or a panel, and no lesson".into());
        }
        Ok(link)
    }
}

/// As it follows the `#` of an address.
impl Display for Link {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let mut parts = Vec::new();
        parts.extend(self.lesson.as_ref().map(|id| format!("lesson={id}")));
        parts.extend(self.mistakes.then(|| "mistakes".to_owned()));
        parts.extend(self.step.map(|step| format!("step={step}")));
        let language = self.language.map(Language::code);
        parts.extend(language.map(|code| format!("language={code}")));
        let theme = self.theme.map(Theme::name);
        parts.extend(theme.map(|name| format!("theme={name}")));
        let panel = self.panel.map(Panel::name);
        parts.extend(panel.map(|name| format!("panel={name}")));
        parts.extend(self.presenting.then(|| "present".to_owned()));
        f.write_str(&parts.join("&"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_wrong_address_says_what_would_be_right() {
        for (text, part) in [
            ("lesson=", "the id of a lesson"),
            ("lesson=shadows&step=-1", "a whole number from 0"),
            ("language=fr", "en or id"),
            ("theme=pink", "light, dark, projector"),
            ("lesson=shadows&panel=rayz", "ray-tree"),
            ("lessson=shadows", "it takes lesson, step"),
            ("step=3", "no lesson"),
            ("mistakes&step=3", "no lesson"),
            ("mistakes&lesson=shadows", "a lesson and the page"),
        ] {
            let error = Link::parse(text).unwrap_err();
            assert!(error.contains(part), "{text}: {error}");
        }
    }
}
