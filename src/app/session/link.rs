//! Where the session is, as a link, and where a link leads.

use super::{Command, Session};
use crate::lesson::{Lesson, Link};

impl Session {
    /// Shows what the link says. Errors: why not; the rest is shown.
    pub fn show_link(&mut self, link: &Link) -> Result<(), String> {
        if let Some(language) = link.language {
            self.look.language = language;
        }
        let Some(lesson) = &link.lesson else {
            self.look.mistakes = link.mistakes;
            self.look.home = !link.mistakes;
            return Ok(());
        };
        let here = self.lesson().id == *lesson && !self.look.home && !self.look.mistakes;
        let told = |session: &Session, result: Result<(), super::Refused>| {
            let language = session.look.language;
            result.map_err(|refused| refused.in_language(language).to_owned())
        };
        if !here {
            let opened = self.update(Command::Open(lesson.clone()));
            told(self, opened)?;
        }
        if let Some(step) = link.step {
            self.start_at(step);
        }
        self.chosen = link.panel;
        if link.presenting != self.look.presenting {
            let changed = self.update(match link.presenting {
                true => Command::Present,
                false => Command::StopPresenting,
            });
            told(self, changed)?;
        }
        if let Some(theme) = link.theme.filter(|_| !link.presenting) {
            self.look.theme = theme;
        }
        Ok(())
    }
    /// Where it is; of what stands in no list, only how it is shown.
    pub fn link(&self) -> Link {
        let lesson = self.lesson();
        let on_page = self.look.home || self.look.mistakes;
        let is_listed = !on_page && lesson.number != Lesson::UNNUMBERED;
        Link {
            mistakes: self.look.mistakes,
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
    use crate::language::Language;
    use crate::lesson::builtin;
    use crate::panels::Panel;
    use crate::picture::Theme;

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
        other.show_link(&link).unwrap();
        assert_eq!(other.link(), session.link());

        session.update(Command::Present).unwrap();
        let presented = Link::parse(&session.link().to_string()).unwrap();
        other.show_link(&presented).unwrap();
        assert!(other.look.presenting);
        other.show_link(&link).unwrap();
        assert!(!other.look.presenting);
        assert_eq!(other.link(), link);
    }

    #[test]
    fn what_an_address_does_not_say_stays_and_nothing_leads_to_the_list() {
        let mut session = session();
        session.look.theme = Theme::Dark;
        session.show_link(&Link::parse("").unwrap()).unwrap();
        assert!(session.look.home && session.look.theme == Theme::Dark);
        let link = Link::parse("lesson=shadows&step=9999999").unwrap();
        session.show_link(&link).unwrap();
        assert_eq!(session.step(), session.last_step());
        let page = Link::parse("mistakes").unwrap();
        session.show_link(&page).unwrap();
        assert!(session.look.mistakes && !session.look.home);
        let text = session.link().to_string();
        assert_eq!(text, "mistakes&language=en&theme=dark");
        session.show_link(&link).unwrap();
        assert!(!session.look.mistakes && session.lesson().id == "shadows");
        let unknown = Link::parse("lesson=shadow").unwrap();
        assert!(session.show_link(&unknown).is_err());
    }
}
