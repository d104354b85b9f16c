//! Rows and cells of lists and tables: text in a form that fits, after the swatch of its colour.

use crate::picture::{Ink, Picture, Rect, Style, Tag, Text, elide};

/// One line of text in a box, its end left out where it does not fit.
pub fn elided(picture: &mut Picture, place: Rect, text: &str, set: Text) {
    let text = elide(text, set.style, set.size, place.width);
    if !text.is_empty() {
        picture.text_in(place, text, set);
    }
}

/// The first part, and as many of the others after it as fit into `room`.
pub fn joined(
    parts: impl IntoIterator<Item = String>,
    between: &str,
    set: Text,
    room: f32,
) -> String {
    let mut parts = parts.into_iter();
    let mut text = parts.next().unwrap_or_default();
    for part in parts {
        let longer = format!("{text}{between}{part}");
        if set.width(&longer) <= room {
            text = longer;
        }
    }
    text
}

/// A name, a value or a note.
#[derive(Clone, Debug)]
pub struct Cell {
    swatch: Option<Ink>,
    /// From the most to the least that can be said.
    forms: Vec<(String, Text)>,
}

impl Cell {
    pub fn new(text: impl Into<String>, set: Text) -> Self {
        Cell::forms([(text.into(), set)])
    }

    /// Of several forms, the first that fits is written.
    pub fn forms(forms: impl IntoIterator<Item = (String, Text)>) -> Self {
        Cell {
            swatch: None,
            forms: forms.into_iter().collect(),
        }
    }

    /// The colour that the text stands for, if any.
    pub fn swatch(self, swatch: Option<Ink>) -> Self {
        Cell { swatch, ..self }
    }

    /// Of the first form.
    pub fn width(&self) -> f32 {
        let text = self
            .forms
            .first()
            .map_or(0.0, |(text, set)| set.width(text));
        text + self.before_text()
    }

    fn before_text(&self) -> f32 {
        match (self.swatch, self.forms.first()) {
            (Some(_), Some((_, set))) => (1.35 * set.size).round(),
            _ => 0.0,
        }
    }

    /// In `place`, as the text is anchored; the swatch stands at the left. Returns the right end of what is written.
    pub fn draw(&self, picture: &mut Picture, place: Rect) -> f32 {
        let before = self.before_text();
        if let Some(ink) = self.swatch {
            let side = (0.65 * before).round();
            let y = (place.center().y - 0.5 * side).round();
            let paint = ink.fill().outlined(Ink::Muted.stroke(1.0));
            picture.rect(Rect::new(place.x, y, side, side), paint);
        }
        let room = Rect::between((place.x + before, place.y), place.max());
        let fits = |(text, set): &&(String, Text)| set.width(text) <= room.width + 0.01;
        let Some((text, set)) = self.forms.iter().find(fits).or(self.forms.last()) else {
            return room.x;
        };
        elided(picture, room, text, *set);
        room.x + set.width(text).min(room.width)
    }
}

/// A line of a list: cells that begin one behind the other, each with room up to the right end.
#[derive(Clone, Debug)]
pub struct Row {
    tag: Tag,
    cells: Vec<(f32, Cell)>,
}

impl Row {
    pub fn new(tag: Tag) -> Self {
        Row {
            tag,
            cells: Vec::new(),
        }
    }

    /// With a cell more, `x` from the left end.
    pub fn cell(mut self, x: f32, cell: Cell) -> Self {
        self.cells.push((x, cell));
        self
    }

    /// In `place`, each cell under the tag.
    pub fn draw(&self, picture: &mut Picture, place: Rect) {
        picture.tagged(self.tag, |picture| {
            for (x, cell) in &self.cells {
                let x = (place.x + x).min(place.right());
                cell.draw(picture, Rect::between((x, place.y), place.max()));
            }
        });
    }
}

/// A value in typewriter where that fits, else in the narrower text face.
pub fn mono_or_narrow(text: String, size: f32, ink: Ink) -> [(String, Text); 2] {
    [Style::Mono.size(size), Style::Body.size(11.0)].map(|set| (text.clone(), set.ink(ink)))
}
