//! The words of panels and window in both languages: one typed table, so that no text can be missing in one of them.

use crate::algorithms::focus::Focus;

/// A language that lessons and the window speak.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub enum Language {
    #[default]
    English,
    Indonesian,
}

impl Language {
    pub const ALL: [Language; 2] = [Language::English, Language::Indonesian];

    /// ISO 639-1.
    pub fn code(self) -> &'static str {
        match self {
            Language::English => "en",
            Language::Indonesian => "id",
        }
    }
}

/// A text in both languages.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Words {
    pub en: &'static str,
    pub id: &'static str,
}

impl Words {
    pub const fn new(en: &'static str, id: &'static str) -> Self {
        Words { en, id }
    }

    pub fn in_language(self, language: Language) -> &'static str {
        match language {
            Language::English => self.en,
            Language::Indonesian => self.id,
        }
    }
}

const WHOLE: Words = Words::new("the whole picture", "seluruh gambar");
const POLYGON: Words = Words::new("polygon", "poligon");
const LINE: Words = Words::new("scan line", "garis scan");
const PIXEL: Words = Words::new("pixel", "piksel");
const ITERATIONS: Words = Words::new("iterations", "iterasi");
const PATCH: Words = Words::new("patch", "patch");

/// The part of a run that is looked at.
pub fn focus(focus: Focus, language: Language) -> String {
    let localize = |strings: Words| strings.in_language(language);
    match focus {
        Focus::Frame => localize(WHOLE).to_owned(),
        Focus::Polygon(number) => format!("{} {number}", localize(POLYGON)),
        Focus::ScanLine(y) => format!("{} {y}", localize(LINE)),
        Focus::Pixel { x, y } => format!("{} ({x}, {y})", localize(PIXEL)),
        Focus::Iterations { start, end } => format!("{} {start}–{}", localize(ITERATIONS), end - 1),
        Focus::Patch(number) => format!("{} {number}", localize(PATCH)),
        Focus::FormFactor { i, j } => format!("F({i}, {j})"),
    }
}
