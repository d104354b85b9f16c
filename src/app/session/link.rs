//! A place in a lesson as the end of an address, which a page opens and the program too:
//! `#lesson=shadows&step=12&language=id&theme=projector&panel=vectors&present`.

use super::{Command, Session};
use crate::language::Language;
use crate::lesson::Lesson;
use crate::panels::Panel;
use crate::picture::Theme;
use std::fmt::{self, Display, Formatter};

/// What an address says; what it does not say stays as it is.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Link {
    /// By its id; the page of all lessons unless given.
    pub lesson: Option<String>,
    pub step: Option<usize>,
    language: Option<Language>,
    theme: Option<Theme>,
    /// The one that was chosen as the large one.
    panel: Option<Panel>,
    presenting: bool,
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
                _ => {
                    return Err(format!(
                        "the address says {key:?}; it takes lesson, step, language, theme, panel and present"
                    ));
                }
            }
        }
        if link.lesson.is_none() && (link.step.is_some() || link.panel.is_some()) {
            return Err("the address says a step or a panel, and no lesson".into());
        }
        Ok(link)
    }

    /// Shows what the link says. Errors: why not; the rest is shown.
    pub fn show(&self, session: &mut Session) -> Result<(), String> {
        if let Some(language) = self.language {
            session.look.language = language;
        }
        let Some(lesson) = &self.lesson else {
            session.look.home = true;
            return Ok(());
        };
        let here = session.lesson().id == *lesson && !session.look.home;
        let told = |session: &Session, result: Result<(), super::Refused>| {
            let language = session.look.language;
            result.map_err(|refused| refused.in_language(language).to_owned())
        };
        if !here {
            let opened = session.update(Command::Open(lesson.clone()));
            told(session, opened)?;
        }
        if let Some(step) = self.step {
            session.start_at(step);
        }
        session.chosen = self.panel;
        if self.presenting != session.look.presenting {
            let changed = session.update(match self.presenting {
                true => Command::Present,
                false => Command::StopPresenting,
            });
            told(session, changed)?;
        }
        if let Some(theme) = self.theme.filter(|_| !self.presenting) {
            session.look.theme = theme;
        }
        Ok(())
    }
}

/// As it follows the `#` of an address.
impl Display for Link {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let mut parts = Vec::new();
        parts.extend(self.lesson.as_ref().map(|id| format!("lesson={id}")));
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

impl Session {
    /// Where it is; of what stands in no list, only how it is shown.
    pub fn link(&self) -> Link {
        let lesson = self.lesson();
        let is_listed = !self.look.home && lesson.number != Lesson::UNNUMBERED;
        Link {
            lesson: is_listed.then(|| lesson.id.clone()),
            step: is_listed.then(|| self.step()),
            language: Some(self.look.language),
            theme: (!self.look.presenting).then_some(self.look.theme),
            panel: self.chosen.filter(|_| is_listed),
            presenting: self.look.presenting && is_listed,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lesson::builtin;

    fn session() -> Session {
        Session::new(builtin("shadows").unwrap().read().unwrap()).unwrap()
    }

    #[test]
    fn a_link_leads_back_to_where_it_was_made() {
        let mut session = session();
        session.update(Command::Seek(17)).unwrap();
        session
            .update(Command::Speak(Language::Indonesian))
            .unwrap();
        session.update(Command::Theme(Theme::Dark)).unwrap();
        session.update(Command::Key(Panel::Vectors)).unwrap();
        let text = session.link().to_string();
        assert_eq!(
            text,
            "lesson=shadows&step=17&language=id&theme=dark&panel=vectors"
        );
        let link = Link::parse(&text).unwrap();
        let mut other = Session::new(builtin("distance").unwrap().read().unwrap()).unwrap();
        link.show(&mut other).unwrap();
        assert_eq!(other.link(), session.link());

        session.update(Command::Present).unwrap();
        let presented = Link::parse(&session.link().to_string()).unwrap();
        presented.show(&mut other).unwrap();
        assert!(other.look.presenting);
        link.show(&mut other).unwrap();
        assert!(!other.look.presenting);
        assert_eq!(other.link(), link);
    }

    #[test]
    fn what_an_address_does_not_say_stays_and_nothing_leads_to_the_list() {
        let mut session = session();
        session.look.theme = Theme::Dark;
        Link::parse("").unwrap().show(&mut session).unwrap();
        assert!(session.look.home && session.look.theme == Theme::Dark);
        let link = Link::parse("lesson=shadows&step=9999999").unwrap();
        link.show(&mut session).unwrap();
        assert_eq!(session.step(), session.last_step());
        let unknown = Link::parse("lesson=shadow").unwrap();
        assert!(unknown.show(&mut session).is_err());
    }

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
        ] {
            let error = Link::parse(text).unwrap_err();
            assert!(error.contains(part), "{text}: {error}");
        }
    }
}
