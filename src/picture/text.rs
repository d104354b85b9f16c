//! How text is set: styles, widths, line breaks, and the places of its glyphs.

use glam::Vec2;

use super::font::{Face, Glyph, Glyphs, glyphs};
use super::ink::Ink;
use super::math::{Script, math};
use super::rect::Rect;

/// A typeface and whether [`math`](super::math()) notation is set in it.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Style {
    /// Sentences.
    Body,
    Bold,
    /// Pseudocode and columns of numbers.
    Mono,
    MonoBold,
    /// As body, with `I_4` and `a^2` set as subscripts and superscripts: labels in a drawing.
    Label,
    LabelBold,
    /// As label, with variables in italics: formulas.
    Formula,
}

/// Size of subscripts and superscripts, and how far they are shifted down and up, in sizes of the text.
const SCRIPT_SIZE: f32 = 0.7;
const SUBSCRIPT_DROP: f32 = 0.22;
const SUPERSCRIPT_RISE: f32 = 0.42;

impl Style {
    /// Text of this style, `size` points to the em, starting at its place, in [`Ink::Text`].
    pub fn size(self, size: f32) -> Text {
        Text {
            style: self,
            size,
            ink: Ink::Text,
            anchor: Anchor::Start,
        }
    }

    fn face(self) -> Face {
        match self {
            Style::Body | Style::Label | Style::Formula => Face::Sans,
            Style::Bold | Style::LabelBold => Face::Bold,
            Style::Mono => Face::Mono,
            Style::MonoBold => Face::MonoBold,
        }
    }
}

/// Which part of the text is at its place.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Anchor {
    Start,
    Middle,
    End,
}

/// How a line of text is drawn; the size is in points to the em.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Text {
    pub style: Style,
    pub size: f32,
    pub ink: Ink,
    pub anchor: Anchor,
}

impl Text {
    pub fn ink(self, ink: Ink) -> Self {
        Text { ink, ..self }
    }

    /// Centred on its place.
    pub fn middle(self) -> Self {
        Text {
            anchor: Anchor::Middle,
            ..self
        }
    }

    /// Ending at its place.
    pub fn end(self) -> Self {
        Text {
            anchor: Anchor::End,
            ..self
        }
    }

    /// The width of `text`, in points.
    pub fn width(&self, text: &str) -> f32 {
        measure(text, self.style, self.size)
    }

    /// The box from ascent to descent of `text` with its baseline at `at`.
    pub fn bounds(&self, at: impl Into<Vec2>, text: &str) -> Rect {
        let at = at.into();
        let width = self.width(text);
        let ascent = ascent(self.style, self.size);
        Rect::new(
            at.x - self.anchor.share() * width,
            at.y - ascent,
            width,
            ascent + descent(self.style, self.size),
        )
    }

    /// How far below the middle of a line the baseline is, so that capitals and digits stand centred; in points.
    pub fn baseline_below_middle(&self) -> f32 {
        0.5 * self.size * self.style.face().cap_height()
    }
}

impl Anchor {
    /// The share of the width that lies left of the place.
    pub(super) fn share(self) -> f32 {
        match self {
            Anchor::Start => 0.0,
            Anchor::Middle => 0.5,
            Anchor::End => 1.0,
        }
    }
}

/// The bundled TrueType file behind a style, for those that set text themselves.
pub fn font_file(style: Style) -> &'static [u8] {
    style.face().file()
}

/// The width of one line of text, in points.
pub fn measure(text: &str, style: Style, size: f32) -> f32 {
    place(&mut glyphs(), text, style, size, |_| {})
}

/// The height above the baseline that a line needs, in points.
pub fn ascent(style: Style, size: f32) -> f32 {
    style.face().extent().0 * size
}

/// The depth below the baseline that a line needs, in points.
pub fn descent(style: Style, size: f32) -> f32 {
    style.face().extent().1 * size
}

/// Breaks text into lines of at most `width` points: at spaces, and within a word only where it alone is too wide. A line
/// break in the text stays one.
pub fn wrap(text: &str, style: Style, size: f32, width: f32) -> Vec<String> {
    let fits = |line: &str| measure(line, style, size) <= width;
    let mut lines = Vec::new();
    for paragraph in text.split('\n') {
        let mut line = String::new();
        for word in paragraph.split_whitespace() {
            let gap = if line.is_empty() { "" } else { " " };
            let longer = format!("{line}{gap}{word}");
            if fits(&longer) {
                line = longer;
                continue;
            }
            if !line.is_empty() {
                lines.push(std::mem::take(&mut line));
            }
            for c in word.chars() {
                line.push(c);
                if line.len() > c.len_utf8() && !fits(&line) {
                    line.pop();
                    lines.push(std::mem::replace(&mut line, c.to_string()));
                }
            }
        }
        lines.push(line);
    }
    lines
}

/// `text` if it fits into `width` points, else its beginning with `…`; empty where not even that fits.
pub fn elide(text: &str, style: Style, size: f32, width: f32) -> String {
    let fits = |line: &str| measure(line, style, size) <= width;
    if fits(text) {
        return text.to_string();
    }
    let cuts: Vec<usize> = text.char_indices().map(|(at, _)| at).skip(1).collect();
    let shortened = |&cut: &usize| format!("{}…", text[..cut].trim_end());
    // Longer beginnings are wider, so the last that fits is found by bisection.
    let fitting = cuts.partition_point(|cut| fits(&shortened(cut)));
    cuts[..fitting].last().map(shortened).unwrap_or_default()
}

/// A glyph with its size and the pen's place, right of the start and above the baseline, in points.
#[derive(Clone, Copy, Debug)]
pub(super) struct Placed {
    pub character: char,
    pub glyph: Glyph,
    pub size: f32,
    pub x: f32,
    pub rise: f32,
}

/// Hands the glyphs of one line to `put`, from left to right, and returns the line's width.
pub(super) fn place(
    glyphs: &mut Glyphs,
    text: &str,
    style: Style,
    size: f32,
    mut put: impl FnMut(Placed),
) -> f32 {
    let mut set = |text: &str, face: Face, size: f32, start: f32, rise: f32| {
        text.chars().fold(start, |x, character| {
            let glyph = glyphs.find(face, character);
            put(Placed {
                character,
                glyph,
                size,
                x,
                rise,
            });
            x + glyph.advance * size
        })
    };
    let face = style.face();
    if !matches!(style, Style::Label | Style::LabelBold | Style::Formula) {
        return set(text, face, size, 0.0, 0.0);
    }

    // A subscript and a superscript of one base stand above each other: both start at the base's end.
    let (mut end, mut base_end) = (0.0_f32, 0.0);
    let mut last = Script::Base;
    for run in math(text) {
        let face = if run.italic && style == Style::Formula {
            Face::SerifItalic
        } else {
            face
        };
        let (size, rise) = match run.script {
            Script::Base => (size, 0.0),
            Script::Sub => (size * SCRIPT_SIZE, -size * SUBSCRIPT_DROP),
            Script::Super => (size * SCRIPT_SIZE, size * SUPERSCRIPT_RISE),
        };
        let beside = last == Script::Base || last == run.script;
        let start = if run.script == Script::Base || beside {
            base_end = end;
            end
        } else {
            base_end
        };
        end = end.max(set(&run.text, face, size, start, rise));
        last = run.script;
    }
    end
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn widths_add_up_and_scale() {
        let mono = measure("0", Style::Mono, 14.0);
        assert!((measure("0.514→", Style::Mono, 14.0) - 6.0 * mono).abs() < 1e-4);
        assert!((measure("0", Style::Mono, 28.0) - 2.0 * mono).abs() < 1e-5);
        // DejaVu Sans Mono advances 1233 of 2048 units.
        assert!((mono - 14.0 * 1233.0 / 2048.0).abs() < 1e-5);
    }

    #[test]
    fn scripts_are_smaller_and_stack() {
        let label = |text| measure(text, Style::Label, 20.0);
        let (base, script) = (label("x"), SCRIPT_SIZE * label("2"));
        assert!((label("x_2") - base - script).abs() < 1e-4);
        assert!((label("x_2^2") - base - script).abs() < 1e-4);
        assert!((label("x_2y") - base - script - label("y")).abs() < 1e-4);
        assert!(label("x_2") < measure("x_2", Style::Body, 20.0));
    }

    #[test]
    fn lines_fit_and_nothing_is_lost() {
        let text = "On this scan line the left edge is cut at I.\nExtraordinarilylongword ends";
        for width in [60.0, 120.0, 1e4] {
            let lines = wrap(text, Style::Body, 14.0, width);
            for line in &lines {
                assert!(measure(line, Style::Body, 14.0) <= width, "{line}");
            }
            let joined: String = lines.concat().split_whitespace().collect();
            assert_eq!(joined, text.split_whitespace().collect::<String>());
        }
        assert_eq!(wrap(text, Style::Body, 14.0, 1e4).len(), 2);
        // Narrower than a letter: one letter a line, and an end.
        assert_eq!(wrap("abc", Style::Body, 14.0, 1.0).len(), 3);
    }

    #[test]
    fn what_does_not_fit_is_shortened() {
        assert_eq!(elide("scan lines", Style::Body, 12.0, 500.0), "scan lines");
        let short = elide("scan lines", Style::Body, 12.0, 50.0);
        assert!(short.ends_with('…') && short.starts_with("sc"), "{short}");
        assert!(measure(&short, Style::Body, 12.0) <= 50.0);
        assert_eq!(elide("scan lines", Style::Body, 12.0, 2.0), "");
    }
}
