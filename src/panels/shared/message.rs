//! What a panel says instead of a picture.

use crate::language::{Language, Message};
use crate::picture::{Ink, Picture, Style, wrap};
use glam::Vec2;

/// Where nothing was recorded.
pub const NO_STEPS: Message = Message("panels-no-steps");

/// Where rays are followed, and no polygons converted.
pub const NO_POLYGONS: Message = Message("panels-no-polygons");

/// Where no light is exchanged between patches.
pub const NO_PATCHES: Message = Message("panels-no-patches");

/// Where no other method is beside the run's, or not yet.
pub const NOT_COMPARED: Message = Message("panels-not-compared");

/// In the place of what a waiting question hides.
pub const AFTER_YOUR_ANSWER: Message = Message("panels-after-your-answer");

/// What is called so, and what it is: `error: 0.5 %`.
pub fn labelled(name: &str, what: &str, language: Language) -> String {
    Message("common-named").format(language, &[("name", name), ("what", what)])
}

/// A picture of one friendly sentence, centred.
pub fn message(strings: Message, language: Language, size: Vec2) -> Picture {
    centered(strings.text(language), size)
}

/// A picture of a text, centred.
pub fn centered(text: &str, size: Vec2) -> Picture {
    const LINE: f32 = 18.0;
    let mut picture = Picture::new(size.x, size.y);
    picture.alt = text.to_string();
    let style = Style::Body.size(13.0).ink(Ink::Muted).middle();
    let lines = wrap(text, style.style, style.size, (size.x - 32.0).min(420.0));
    let top = 0.5 * (size.y - LINE * lines.len() as f32);
    for (i, line) in lines.into_iter().enumerate() {
        let y = top + LINE * (i as f32 + 0.5) + style.baseline_below_middle();
        picture.text((0.5 * size.x, y), line, style);
    }
    picture
}
