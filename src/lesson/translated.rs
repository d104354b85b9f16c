//! Every word on screen comes from a catalogue or the lesson's file: the pseudo-language marks what does, and nothing else may be
//! there but symbols.

use super::pictures::each_picture;
use super::{OpenLesson, builtin};
use crate::language::Language;
use crate::panels::Panel;
use crate::picture::{Picture, Shape};
use glam::Vec2;
use std::collections::BTreeSet;

/// Functions of mathematics, Greek letters by their names, what is abbreviated the same everywhere, names of the literature, and
/// the symbol of unshot radiosity, which is the same in formulas and pseudocode.
const SYMBOLS: &str = "alpha beta delta DeltaB eta Gamma omega rho theta arccos cos fov max min sin tan BFA flux NearestT SOR TIR unshot";

/// Functions and variables of the pseudocode, as it has them in every language, and subscripts, which are texts of their own there.
const PSEUDOCODE: &str = "GatherRad NearestObject PushPullRad Refine SolveSystem areaToArea blocked contour elementToPolygon formFactor hemicube hits illumination level \
    monteCarlo pixel table trace visible att down light sum";

/// What stands outside of the marks, without subscripts. A message that is broken into lines goes on in the next text.
fn outside<'a>(texts: impl Iterator<Item = &'a str>) -> String {
    let mut outside = String::new();
    let mut inside = false;
    for text in texts {
        let mut rest = text;
        while let Some(at) = rest.find(if inside { "!!]" } else { "[!!" }) {
            if !inside {
                outside += &rest[..at];
                // Arguments at the two sides of a message's text are words of their own.
                outside.push(' ');
            }
            rest = &rest[at + 3..];
            inside = !inside;
        }
        if !inside {
            outside += rest;
        }
        inside &= !text.ends_with('…');
        outside.push(' ');
    }
    outside
}

/// Words of three letters and more; what follows a `_` is a subscript, and Greek letters are symbols of their own, and powers none.
fn words(text: &str) -> impl Iterator<Item = &str> {
    let is_greek = |c| ('Α'..='ω').contains(&c);
    text.split(move |c: char| is_greek(c) || !(c.is_alphanumeric() || matches!(c, '_' | '{')))
        .map(|symbol| symbol.split('_').next().unwrap_or_default())
        .map(|symbol| symbol.trim_end_matches(['²', '³']))
        .filter(|word| word.chars().filter(|c| c.is_alphabetic()).count() > 2)
}

fn texts(picture: &Picture) -> impl Iterator<Item = &str> {
    picture.items.iter().filter_map(|item| match &item.shape {
        Shape::Text { text, .. } => Some(text.as_str()),
        _ => None,
    })
}

/// The lesson with the marks around what its file calls objects and materials.
fn with_marked_names(lesson: &str) -> OpenLesson {
    let mut lesson = builtin(lesson).unwrap().read().unwrap();
    for names in lesson.scene.names.values_mut() {
        *names = names.each_ref().map(|name| format!("[!!{name}!!]"));
    }
    lesson.open().unwrap()
}

/// Whether no language translates a word that stands in a panel.
fn is_symbol(word: &str, panel: Panel) -> bool {
    let of_code = matches!(panel, Panel::Code | Panel::Formula);
    words(SYMBOLS).any(|symbol| symbol == word)
        || of_code && words(PSEUDOCODE).any(|name| name == word)
}

/// The words of a lesson's panels that come from no catalogue, each with its panel.
fn untranslated(lesson: &str) -> BTreeSet<String> {
    let mut open = with_marked_names(lesson);
    let mut found = BTreeSet::new();
    let mut size = || Vec2::new(1000.0, 700.0);
    let mut look = |panel: Panel, _, picture: &Picture| {
        let shown = outside(texts(picture)) + &outside([picture.alt.as_str()].into_iter());
        let strange = words(&shown).filter(|word| !is_symbol(word, panel));
        found.extend(strange.map(|word| format!("{}: {word}", panel.name())));
    };
    each_picture(&mut open, Language::Pseudo, &mut size, &mut look);
    found
}

macro_rules! lessons {
    ($($name:ident $id:literal $_path:literal,)*) => {
        $(
            #[test]
            fn $name() {
                assert_eq!(untranslated($id), BTreeSet::new());
            }
        )*
    };
}
include!(concat!(env!("OUT_DIR"), "/lessons.rs"));

#[test]
fn only_what_is_outside_of_the_marks_counts() {
    let texts = [
        "[!!a long!!] plain",
        "[!!broken",
        "line!!] 3",
        "[!!short…",
        "k_d I_{light}",
    ];
    let outside = outside(texts.into_iter());
    assert_eq!(words(&outside).collect::<Vec<_>>(), ["plain"]);
}
