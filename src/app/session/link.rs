//! Where the session is, as a link, and where a link leads.

use super::super::strings;
use super::{Command, Refused, Session};
use crate::lesson::{Change, Lesson, Link};

impl Session {
    /// Shows what the link says. Errors: why not; the rest is shown.
    pub fn show_link(&mut self, link: &Link) -> Result<(), String> {
        if let Some(language) = link.language {
            self.look.language = language;
        }
        match (&link.lesson, &link.scene) {
            (None, None) => {
                self.look.mistakes = link.mistakes;
                self.look.home = !link.mistakes;
                return Ok(());
            }
            (Some(lesson), _) => self.show_lesson_of_link(lesson)?,
            (None, Some(scene)) => self.show_scene_of_link(scene, link)?,
        }
        let changed = self.values_of_link(link)?;
        if changed != self.changes.now() {
            let shown = self.show_changes(changed);
            self.in_words(shown)?;
        }
        let focused = self.focus_on(link.focus.unwrap_or(self.lesson().focus));
        self.in_words(focused)?;
        if let Some(step) = link.step {
            self.start_at(step);
        }
        self.chosen = link.panel;
        self.look.stop_presenting();
        if link.presenting {
            let presented = self.update(Command::Present);
            self.in_words(presented)?;
        } else if let Some(theme) = link.theme {
            self.look.theme = theme;
        }
        Ok(())
    }

    fn show_lesson_of_link(&mut self, id: &str) -> Result<(), String> {
        let is_here = self.lesson().id == id && !self.look.home && !self.look.mistakes;
        if is_here {
            return Ok(());
        }
        let opened = self.update(Command::Open(id.to_owned()));
        self.in_words(opened)
    }

    fn show_scene_of_link(&mut self, packed: &str, link: &Link) -> Result<(), String> {
        let is_here = self.lesson().packed.as_deref() == Some(packed) && !self.is_on_page();
        if !is_here {
            let lesson = Lesson::of_packed_scene(self.localize(strings::SHARED_SCENE), packed)?;
            self.open_document(lesson, None)?;
        }
        let method = link.method.filter(|&method| method != self.lesson().method);
        let chosen = method.map_or(Ok(()), |method| self.update(Command::Method(method)));
        self.in_words(chosen)
    }

    /// The changes that the link says. Errors: which is none of what may be changed.
    fn values_of_link(&self, link: &Link) -> Result<Vec<Change>, String> {
        let change = |(place, numbers): &(usize, Vec<f64>)| {
            let lesson = self.lesson();
            let parameter = lesson.parameters.get(*place);
            let change = parameter.and_then(|&parameter| lesson.change(parameter, numbers));
            change.ok_or_else(|| {
                let place = place.to_string();
                strings::NO_SUCH_CHANGE.format(self.look.language, &[("place", &place)])
            })
        };
        link.changes.iter().map(change).collect()
    }

    fn in_words(&self, result: Result<(), Refused>) -> Result<(), String> {
        result.map_err(|refused| refused.in_language(self.look.language).to_owned())
    }

    /// Where it is; of what no address can say, only how it is shown.
    pub fn link(&self) -> Link {
        let lesson = self.lesson();
        let look = Link {
            mistakes: self.look.mistakes,
            language: Some(self.look.language),
            theme: (!self.look.presenting).then_some(self.look.theme),
            ..Link::default()
        };
        let is_listed = lesson.number != Lesson::UNNUMBERED;
        let scene = lesson.packed.clone().filter(|_| lesson.is_free_walk());
        if self.is_on_page() || !(is_listed || scene.is_some()) {
            return look;
        }
        Link {
            lesson: is_listed.then(|| lesson.id.clone()),
            method: scene.is_some().then_some(lesson.method),
            scene,
            changes: self.linked_changes().collect(),
            focus: Some(self.focus()).filter(|_| !self.follows_lesson()),
            step: Some(self.step()),
            panel: self.chosen,
            presenting: self.look.presenting,
            ..look
        }
    }

    /// Of those parameters that the lesson lists.
    fn linked_changes(&self) -> impl Iterator<Item = (usize, Vec<f64>)> {
        self.changes.now().iter().filter_map(|change| {
            let mut listed = self.lesson().parameters.iter();
            let place = listed.position(|&parameter| parameter == change.parameter())?;
            Some((place, change.numbers()))
        })
    }

    /// Whether the link leads back to what is shown.
    pub fn has_link(&self) -> bool {
        let link = self.link();
        // A lesson of one's own stands in no list of others.
        let is_walk = link.lesson.is_some() && self.file.is_none() || link.scene.is_some();
        is_walk
            && link.changes.len() == self.changes.now().len()
            && self.setup().forced().is_empty()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::language::Language;
    use crate::lesson::builtin;
    use crate::panels::Panel;
    use crate::picture::Theme;
    use crate::scene::ReadFile;

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

    #[test]
    fn changed_values_and_another_part_of_the_picture_are_shared() {
        for (id, changes) in [
            ("shadows", "change=0:1.5,4,2.5"),
            ("gathering", "change=0:0.25"),
        ] {
            let mut session = Session::new(builtin(id).unwrap().read().unwrap()).unwrap();
            let own = session.link();
            let link = format!("lesson={id}&{changes}&step=3");
            session.show_link(&Link::parse(&link).unwrap()).unwrap();
            assert!(session.is_changed() && session.has_link());
            let text = session.link().to_string();
            assert!(text.contains(changes), "{text}");
            session.update(Command::Share).unwrap();
            assert_eq!(session.shared, Some(format!("lightwalk open '#{text}'")));

            let mut other = Session::new(builtin(id).unwrap().read().unwrap()).unwrap();
            other.show_link(&Link::parse(&text).unwrap()).unwrap();
            assert_eq!(other.link(), session.link());
            assert_eq!(other.walk().len(), session.walk().len());
            // What a link does not change has the lesson's value.
            other.show_link(&own).unwrap();
            assert!(!other.is_changed());
        }
        let mut session = session();
        let pixel = crate::algorithms::focus::Focus::Pixel { x: 3, y: 4 };
        session.update(Command::Focus(pixel)).unwrap();
        session.update(Command::Forward(2)).unwrap();
        let text = session.link().to_string();
        assert!(text.starts_with("lesson=shadows&pixel=3,4&step="), "{text}");
        let mut other = Session::new(builtin("gathering").unwrap().read().unwrap()).unwrap();
        other.show_link(&Link::parse(&text).unwrap()).unwrap();
        assert_eq!((other.focus(), other.link()), (pixel, session.link()));
    }

    #[test]
    fn a_scene_is_shared_with_its_method_and_what_was_moved() {
        let text = include_str!("../../../lessons/scenes/one-mirror.json");
        let nothing: &mut ReadFile = &mut |_| Err("nothing".into());
        let walk = Lesson::of_file("mine.json", text.as_bytes(), nothing).unwrap();
        let mut session = session();
        session
            .open_document(walk, Some("mine.json".into()))
            .unwrap();
        session
            .update(Command::Method(crate::render::Method::Gouraud))
            .unwrap();
        let light = session.lesson().parameters[0];
        let moved = session.lesson().change(light, &[1.0, 4.5, 3.0]).unwrap();
        session.update(Command::Change(moved)).unwrap();
        session.update(Command::Seek(20)).unwrap();
        session.update(Command::Share).unwrap();
        let command = session.shared.clone().unwrap();
        let address = command
            .strip_prefix("lightwalk open '#")
            .and_then(|rest| rest.strip_suffix('\''));
        let link = Link::parse(address.unwrap()).unwrap();

        let mut other = self::session();
        other.show_link(&link).unwrap();
        assert_eq!(other.link(), session.link());
        assert_eq!(other.lesson().method, crate::render::Method::Gouraud);
        assert_eq!(other.setup().prepared.scene, session.setup().prepared.scene);
        assert_eq!(
            (other.step(), other.walk().len()),
            (20, session.walk().len())
        );
    }

    #[test]
    fn a_link_to_what_cannot_be_says_why() {
        for (link, why) in [
            ("lesson=shadows&change=99:1", "changes parameter 99"),
            ("lesson=shadows&change=0:1", "changes parameter 0"),
            ("lesson=shadows&pixel=9999,1", "outside"),
            ("lesson=shadows&iterations=0,1", "outside"),
            ("scene=aGk", "not whole"),
            ("scene=abc", "not whole"),
        ] {
            let link = Link::parse(link).unwrap();
            let message = session().show_link(&link).unwrap_err();
            assert!(message.contains(why), "{link}: {message}");
        }
    }
}
