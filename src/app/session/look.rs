//! How things are shown: language, theme, size, and what is open.

use super::Sheet;
use crate::language::Language;
use crate::picture::Theme;

/// Text sizes, relative to the normal one.
pub(super) const TEXT_SIZES: [f32; 8] = [0.8, 0.9, 1.0, 1.15, 1.3, 1.5, 1.75, 2.0];

/// What opens beside the key panel, in place of the other panels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Drawer {
    Inspector,
    Parameters,
    /// A picture of the user's own beside ours.
    Against,
    /// Classic mistakes beside ours.
    WhatIf,
    /// What a search has found.
    Results,
    /// The lesson as its file has it, to be written.
    Author,
}

/// How things are shown.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Look {
    pub language: Language,
    pub theme: Theme,
    /// An index into the text sizes.
    pub(super) text: usize,
    pub presenting: bool,
    /// The theme to return to after presenting.
    pub(super) before_presenting: Theme,
    pub keys: bool,
    /// The page of all lessons, in place of the lesson.
    pub home: bool,
    /// The page of classic mistakes, in place of the lesson.
    pub mistakes: bool,
    /// The page of the scene that is shown, in place of its panels.
    pub editing: bool,
    /// What lies over the lesson.
    pub sheet: Option<Sheet>,
    /// The view of what is left out.
    pub skipped: bool,
    pub drawer: Option<Drawer>,
    /// Whether rooms are shown smooth, not patch by patch.
    pub smooth: bool,
    /// Whether rooms are shown with what is unshot, in place of their light.
    pub unshot: bool,
    pub questions: bool,
}

impl Look {
    pub(super) fn new() -> Self {
        Look {
            language: Language::English,
            theme: Theme::Light,
            text: 2,
            presenting: false,
            before_presenting: Theme::Light,
            keys: false,
            home: false,
            mistakes: false,
            editing: false,
            sheet: None,
            skipped: false,
            drawer: None,
            smooth: false,
            unshot: false,
            questions: true,
        }
    }

    pub(super) fn stop_presenting(&mut self) {
        if self.presenting {
            self.presenting = false;
            self.theme = self.before_presenting;
        }
    }

    /// How much larger than normal everything is drawn.
    pub fn zoom(&self) -> f32 {
        TEXT_SIZES[self.text] * self.theme.text_scale()
    }
}
