//! What the session calls itself: the lesson, its place, and the command that leads there.

use super::Session;
use crate::app::strings;
use crate::language::Message;
use crate::lesson::Lesson;
use crate::picture::plain;

impl Session {
    /// The lesson's number, where it has one, and title.
    pub fn title(&self) -> String {
        let lesson = self.lesson();
        let title = plain(lesson.title.in_language(self.look.language));
        match lesson.number {
            Lesson::UNNUMBERED => title,
            number => format!("{number} · {title}"),
        }
    }

    /// Whether a page is shown in place of a lesson: that of all lessons, of mistakes, or of studies.
    pub fn is_on_page(&self) -> bool {
        self.look.home || self.look.mistakes || self.studying.is_open
    }

    /// As it stands on the frame of the window, for people and for scripts. Steps are counted from 0.
    pub fn window_title(&self) -> String {
        if self.look.home {
            return format!("Lightwalk – {}", self.localize(strings::LESSONS));
        }
        if self.look.mistakes {
            return format!("Lightwalk – {}", self.localize(strings::MISTAKES));
        }
        let title = plain(self.lesson().title.in_language(self.look.language));
        format!("Lightwalk – {title} – {}", self.place())
    }

    /// The step of how many, in words.
    pub fn place(&self) -> String {
        let [step, last] = [self.step(), self.last_step()].map(|step| step.to_string());
        strings::STEP_OF.format(self.look.language, &[("step", &step), ("last", &last)])
    }

    /// What the lesson says here, or else what the step does, without mathematical signs; nothing where a page is shown.
    #[cfg(target_arch = "wasm32")]
    pub fn said_here(&self) -> String {
        if self.is_on_page() {
            return String::new();
        }
        let language = self.look.language;
        match self.narration_here() {
            Some(narrated) => plain(narrated.text(language)),
            None => plain(&crate::panels::said(
                self.panel_input().run,
                self.step(),
                language,
            )),
        }
    }

    /// The command that opens what is shown. Errors: why there is none.
    pub fn command_line(&self) -> Result<String, Message> {
        let lesson = self.lesson();
        let is_own = self.file.is_some() && !lesson.is_free_walk();
        let is_plain = self.follows_lesson() && !self.is_changed();
        if !self.setup().forced().is_empty() {
            return Err(strings::SHARE_AS_LEFT_OUT_ONLY);
        }
        let what = match &self.file {
            Some(file) if is_own && is_plain => in_quotes(&file.to_string_lossy()),
            Some(_) if is_own && self.is_changed() => return Err(strings::SHARE_UNCHANGED_ONLY),
            Some(_) if is_own => return Err(strings::SHARE_LESSON_ONLY),
            _ if lesson.is_free_walk() && lesson.packed.is_none() => {
                return Err(strings::SHARE_THE_FILES);
            }
            _ if lesson.number == Lesson::UNNUMBERED && !lesson.is_free_walk() => {
                return Err(strings::SHARE_NO_STUDY);
            }
            _ if is_plain && !lesson.is_free_walk() => lesson.id.clone(),
            _ if self.has_link() => return Ok(format!("lightwalk open '#{}'", self.link())),
            _ => return Err(strings::SHARE_UNMOVED_ONLY),
        };
        Ok(format!("lightwalk open {what} --step {}", self.step()))
    }
}

/// As a shell takes it for one word.
fn in_quotes(path: &str) -> String {
    let plain = |c: char| c.is_alphanumeric() || "/._-".contains(c);
    match path.chars().all(plain) {
        true => path.to_owned(),
        false => format!("'{}'", path.replace('\'', r"'\''")),
    }
}
