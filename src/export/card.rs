//! An explanation as one picture: its title, its panel, and under it what is said.

use super::{ExportedLesson, Page};
use crate::picture::{Ink, Picture, Rect, Style, braced, elide, wrap};
use glam::Vec2;

/// The smallest picture with room for every explanation, in points.
pub const SMALLEST_CARD: [u32; 2] = [480, 360];

const MARGIN: f32 = 14.0;
const TITLE: f32 = 19.0;
/// From a line to the next, in sizes of the text.
const LINE: f32 = 1.4;
/// Sizes of what is said, the largest that leaves the panel half of the picture.
const SIZES: [f32; 6] = [18.0, 16.0, 15.0, 14.0, 13.0, 12.0];

/// How long one looks and reads, in seconds: 200 words a minute, and a moment for the picture.
pub fn reading_seconds(page: &Page) -> f64 {
    let words = page.said.split_whitespace().count() + page.title.split_whitespace().count();
    2.0 + 0.3 * words as f64
}

/// The page with the number `place` of so many.
pub fn card(shown: &mut ExportedLesson, page: &Page, place: [usize; 2], size: Vec2) -> Picture {
    // Code has no type of its own here.
    let said = braced(&page.said.replace('`', ""));
    let width = size.x - 2.0 * MARGIN;
    let set = |text: f32| (text, wrap(&said, Style::Label, text, width));
    let height = |text: f32, lines: usize| lines as f32 * LINE * text;
    let fits = |(text, lines): &(f32, Vec<String>)| height(*text, lines.len()) <= 0.4 * size.y;
    let smallest = SIZES[SIZES.len() - 1];
    let fitting = SIZES.into_iter().map(set).find(fits);
    let (text, lines) = fitting.unwrap_or_else(|| set(smallest));

    let mut picture = Picture::new(size.x, size.y);
    let head = 2.0 * TITLE;
    let number = format!("{} / {}", place[0] + 1, place[1]);
    let number_set = Style::Body.size(13.0).ink(Ink::Muted).end();
    let room = width - number_set.width(&number) - MARGIN;
    let title = elide(&page.title, Style::LabelBold, TITLE, room);
    let bar = Rect::new(MARGIN, 0.0, width, head);
    picture.text_in(bar, title, Style::LabelBold.size(TITLE));
    picture.text_in(bar, number, number_set);
    let top = size.y - MARGIN - height(text, lines.len());
    let frame = Rect::between((MARGIN, head), (size.x - MARGIN, top - 0.5 * MARGIN));
    let panel = shown.draw(page.panel, page.step, Vec2::new(frame.width, frame.height));
    let mut alt = panel.alt.clone();
    picture.place(frame.min(), panel);
    picture.rounded_rect(frame, 3.0, Ink::Rule.stroke(1.0));
    for (number, line) in lines.into_iter().enumerate() {
        let top = top + height(text, number);
        let row = Rect::new(MARGIN, top, width, LINE * text);
        picture.text_in(row, line, Style::Label.size(text));
    }
    alt.insert_str(0, &format!("{}. {} ", page.title, page.said));
    picture.alt = alt;
    picture
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::language::Language;
    use crate::lesson::builtins;

    #[test]
    fn what_any_lesson_says_fits_into_the_smallest_card() {
        let [width, height] = SMALLEST_CARD.map(|side| side as f32);
        let smallest = SIZES[SIZES.len() - 1];
        for lesson in builtins() {
            let lesson = lesson.read().unwrap();
            for text in Language::ALL
                .iter()
                .flat_map(|&language| lesson.texts(language))
            {
                let lines = wrap(text, Style::Label, smallest, width - 2.0 * MARGIN);
                let needed = lines.len() as f32 * LINE * smallest;
                assert!(needed <= 0.5 * height, "{}: {text}", lesson.id);
            }
        }
    }
}
