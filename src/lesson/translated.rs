//! Every word on screen comes from a catalogue: the pseudo-language marks what does, and nothing else may be there but symbols,
//! names of the lesson's own scene, and names that are the same in every language.

use super::{OpenLesson, builtin};
use crate::algorithms::radiosity::Solver;
use crate::language::Language;
use crate::methods::Method;
use crate::panels::{Panel, PanelInput, TreeView, draw};
use crate::picture::{Picture, Shape};
use crate::render::compare::compare_on;
use crate::render::{Finished, render};
use crate::vocabulary::FAMILIES;
use std::collections::BTreeSet;
use std::num::NonZeroUsize;

/// Names of functions and variables in pseudocode and formulas, words that formulas have as symbols, and subscripts where a
/// picture has them apart.
const SYMBOLS: &str = "bound cosθ degrees SOR ΔRad alpha beta delta DeltaB eta Gamma omega rho theta ambient arccos areaToArea att auto blocked contour cos elementToPolygon exact formFactor hemicube hits \
    illumination level light max min monteCarlo NearestObject NearestT pixel rms sin sum table TIR trace unshot visible";

/// What stands outside of the marks, without subscripts. A message that is broken into lines goes on in the next text.
fn outside<'a>(texts: impl Iterator<Item = &'a str>) -> String {
    let mut outside = String::new();
    let mut inside = false;
    for text in texts {
        let mut rest = text;
        while let Some(at) = rest.find(if inside { "!!]" } else { "[!!" }) {
            if !inside {
                outside += &rest[..at];
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

/// Words of three letters and more; what follows a `_` is a subscript.
fn words(text: &str) -> impl Iterator<Item = &str> {
    text.split(|c: char| !(c.is_alphanumeric() || matches!(c, '_' | '{')))
        .map(|symbol| symbol.split('_').next().unwrap_or_default())
        .filter(|word| word.chars().filter(|c| c.is_alphabetic()).count() > 2)
}

fn texts(picture: &Picture) -> impl Iterator<Item = &str> {
    picture.items.iter().filter_map(|item| match &item.shape {
        Shape::Text { text, .. } => Some(text.as_str()),
        _ => None,
    })
}

/// Names that no language translates: of the scene, of methods and solvers, and of variables.
fn names(open: &OpenLesson) -> BTreeSet<String> {
    let objects = open.run.prepared().scene.objects.iter();
    let mut names: Vec<&str> = objects.map(|object| object.name.as_str()).collect();
    names.extend(Method::ALL.map(Method::name));
    names.extend(Solver::ALL.map(Solver::name));
    names.push(SYMBOLS);
    let formulas = FAMILIES.into_iter().flatten().flat_map(|kind| kind.entries);
    names.extend(
        formulas
            .flat_map(|entry| entry.formulas)
            .map(|formula| formula.text),
    );
    names
        .into_iter()
        .flat_map(words)
        .map(str::to_owned)
        .collect()
}

/// The words of a lesson's panels that come from no catalogue, each with its panel.
fn untranslated(lesson: &str) -> BTreeSet<String> {
    let mut open = builtin(lesson).unwrap().read().unwrap().open().unwrap();
    let draw_all = |method| render(&open.setup, method, NonZeroUsize::MIN, &|_, _| {});
    let mut finished = Finished::new(
        draw_all(open.lesson.method),
        &open.setup.prepared.scene.lights,
    );
    let methods = open.lesson.compare.iter();
    finished.compared = methods
        .map(|&method| compare_on(&open.setup, method, || 0.0))
        .collect();
    let mut panels = open.lesson.panels.clone();
    panels.extend([
        Panel::Code,
        Panel::Formula,
        Panel::TimeLine,
        Panel::Inspector,
    ]);
    if panels.contains(&Panel::Race) {
        let enclosure = open.setup.enclosure().unwrap();
        let matrix = enclosure.matrix().unwrap();
        finished.race = Some(enclosure.race(matrix, &mut || 0.0));
    }
    let names = names(&open);
    let steps: Vec<usize> = open.narrated.iter().map(|narrated| narrated.step).collect();
    let mut found = BTreeSet::new();
    for &step in steps.iter().step_by(steps.len().div_ceil(4).max(1)) {
        open.run.walk_mut().seek(step);
        for &panel in &panels {
            let input = PanelInput {
                run: &open.run,
                finished: &finished,
                focus: open.lesson.focus,
                language: Language::Pseudo,
                narrated: &steps,
                breakpoints: &[],
                tree: TreeView::whole(),
                smooth: None,
            };
            let picture = draw(panel, &input, (1000.0, 700.0).into());
            let shown = outside(texts(&picture)) + &outside([picture.alt.as_str()].into_iter());
            let strange = words(&shown).filter(|word| !names.contains(*word));
            found.extend(strange.map(|word| format!("{}: {word}", panel.name())));
        }
    }
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
