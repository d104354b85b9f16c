//! Lines of text, and sections of such lines.

use crate::color::Rgb;
use crate::picture::{Ink, Style, Tag, Text};

/// The size of the text.
pub const SIZE: f32 = 12.0;

/// A line of words that may be broken between its parts.
pub struct Entry {
    pub parts: Vec<String>,
    pub set: Text,
    pub swatch: Option<Rgb>,
    pub tag: Option<Tag>,
}

impl Entry {
    pub fn new(text: impl Into<String>) -> Self {
        Entry::parts(vec![text.into()])
    }

    pub fn parts(parts: Vec<String>) -> Self {
        Entry {
            parts,
            set: Style::Label.size(SIZE),
            swatch: None,
            tag: None,
        }
    }

    pub fn ink(mut self, ink: Ink) -> Self {
        self.set = self.set.ink(ink);
        self
    }

    pub fn swatch(self, color: Option<Rgb>) -> Self {
        Entry {
            swatch: color,
            ..self
        }
    }

    pub fn tag(self, tag: Tag) -> Self {
        Entry {
            tag: Some(tag),
            ..self
        }
    }
}

/// A headline, and the lines under it.
pub struct Section {
    pub title: Entry,
    pub entries: Vec<Entry>,
}
