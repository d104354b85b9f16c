//! The checks of a lesson's file by itself, before it is run.

use super::chapter::Chapter;
use super::error::problem;
use super::file::{FocusFile, LessonFile};
use super::text::Text;
use crate::algorithms::focus::Focus;
use crate::methods::{Method, Mistake};
use crate::panels::{Hidden, Panel};
use crate::render::{MAX_PIXELS, MAX_SIDE};
use crate::scene::document::{Keyed, Problem};
use crate::scene::{Names, Scene};
use std::collections::BTreeSet;

/// The chapter that a lesson file names.
pub(super) fn chapter(file: &LessonFile, problems: &mut Vec<Problem>) -> Option<Chapter> {
    let name = file.chapter.as_deref()?;
    let chapter = Chapter::from_name(name);
    if chapter.is_none() {
        let known = Chapter::ALL.map(Chapter::name).join(", ");
        let message = format!("found \"{name}\"; allowed are {known}");
        problems.push(problem("chapter", message));
    }
    chapter
}

/// The method of that name.
pub(super) fn method(file: &LessonFile, problems: &mut Vec<Problem>) -> Option<Method> {
    let method = Method::from_name(&file.method);
    if method.is_none() {
        let known = Method::ALL.map(Method::name).join(", ");
        let message = format!("found \"{}\"; allowed are {known}", file.method);
        problems.push(problem("method", message));
    }
    method
}

/// The panels of those names.
pub(super) fn panels(file: &LessonFile, problems: &mut Vec<Problem>) -> Vec<Panel> {
    let mut panels = Vec::new();
    for (index, name) in file.panels.iter().enumerate() {
        match Panel::called(name) {
            Some(panel) => panels.push(panel),
            None => {
                let known = Panel::ALL.map(Panel::name).join(", ");
                let message = format!("found \"{name}\"; allowed are {known}");
                problems.push(problem(format!("panels[{index}]"), message));
            }
        }
    }
    panels
}

/// The mistakes that the steps name are known, and can be made by the method.
pub(super) fn mistakes(file: &LessonFile, method: Option<Method>, problems: &mut Vec<Problem>) {
    let Some(method) = method else { return };
    for (index, Keyed(step)) in file.steps.iter().enumerate() {
        let Some(name) = &step.mistake else { continue };
        let possible = |mistake: &Mistake| mistake.concerns(method);
        if !Mistake::from_name(name).is_some_and(|mistake| possible(&mistake)) {
            let possible = Mistake::ALL.into_iter().filter(possible).map(Mistake::name);
            let message = format!(
                "found \"{name}\"; with the method {} allowed are {}",
                method.name(),
                possible.collect::<Vec<_>>().join(", ")
            );
            problems.push(problem(format!("steps[{index}].mistake"), message));
        }
    }
}

/// What is recorded, which is something that the method has.
pub(super) fn focus(
    file: &LessonFile,
    method: Option<Method>,
    problems: &mut Vec<Problem>,
) -> Focus {
    let focus = match file.focus {
        FocusFile::Frame => Focus::Frame,
        FocusFile::Polygon(number) => Focus::Polygon(number),
        FocusFile::ScanLine(y) => Focus::ScanLine(y),
        FocusFile::Pixel([x, y]) => Focus::Pixel { x, y },
        FocusFile::Iterations([start, end]) => Focus::Iterations { start, end },
        FocusFile::Patch(number) => Focus::Patch(number),
        FocusFile::FormFactor([i, j]) => Focus::FormFactor { i, j },
    };
    if let Some(method) = method.filter(|method| !method.records(focus)) {
        let allowed = if method.converts_polygons() {
            "allowed are `frame`, `polygon`, `scan_line` and `pixel`"
        } else if method.follows_rays() {
            "ray methods go pixel by pixel: allowed are `pixel`, `scan_line` and `frame`"
        } else {
            "allowed are `frame`, `iterations`, `patch` and `form_factor`"
        };
        let message = format!(
            "found a focus that {} does not have; {allowed}",
            method.name()
        );
        problems.push(problem("focus", message));
    }
    focus
}

/// Its words and lists, and the panels that its steps name.
pub(super) fn texts(file: &LessonFile, problems: &mut Vec<Problem>) {
    check_keys(file, problems);
    check_hidden(file, problems);
    check_words(file, problems);
}

/// What the objects and materials of the scene are called.
pub(super) fn names(
    names: &[(String, Keyed<Text>)],
    scene: &Scene,
    problems: &mut Vec<Problem>,
) -> Names {
    let objects = scene.objects.iter().map(|object| object.name.as_str());
    let materials = scene
        .materials
        .iter()
        .map(|material| material.name.as_str());
    let known: BTreeSet<&str> = objects.chain(materials).collect();
    for (name, _) in names.iter().filter(|(name, _)| !known.contains(&**name)) {
        let allowed: Vec<&str> = known.iter().copied().collect();
        let message = format!(
            "there is no object or material of this name; allowed are {}",
            allowed.join(", ")
        );
        problems.push(problem(format!("names.{name}"), message));
    }
    let texts = names.iter().map(|(name, Keyed(text))| {
        let texts = text.both().map(|(_, text)| text.to_owned());
        (name.clone(), texts)
    });
    texts.collect()
}

/// A key panel is one of the lesson's.
fn check_keys(file: &LessonFile, problems: &mut Vec<Problem>) {
    for (index, Keyed(step)) in file.steps.iter().enumerate() {
        let Some(key) = &step.key else { continue };
        if !file.panels.contains(key) {
            problems.push(problem(
                format!("steps[{index}].key"),
                format!(
                    "found \"{key}\"; allowed are the lesson's panels: {}",
                    file.panels.join(", ")
                ),
            ));
        }
    }
}

/// What a question hides is something that can be hidden.
fn check_hidden(file: &LessonFile, problems: &mut Vec<Problem>) {
    for (index, Keyed(step)) in file.steps.iter().enumerate() {
        let Some(Keyed(question)) = &step.question else {
            continue;
        };
        for (number, name) in question.hide.iter().flatten().enumerate() {
            if Hidden::from_name(name).is_none() {
                let place = format!("steps[{index}].question.hide[{number}]");
                let known = Hidden::ALL.map(Hidden::name).join(", ");
                let message = format!("found \"{name}\"; allowed are {known}");
                problems.push(problem(place, message));
            }
        }
    }
}

/// What can be wrong with words and numbers before anything is run.
fn check_words(file: &LessonFile, problems: &mut Vec<Problem>) {
    let plain = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-';
    if file.id.is_empty() || !file.id.chars().all(plain) {
        problems.push(problem(
            "id",
            format!(
                "found \"{}\"; allowed are lower-case letters, digits and `-`",
                file.id
            ),
        ));
    }
    let [width, height] = file.size.map(u64::from);
    let sides = 1..=u64::from(MAX_SIDE);
    if !sides.contains(&width) || !sides.contains(&height) || width * height > MAX_PIXELS {
        let message = format!(
            "found {width}×{height}; sides are from 1 to {MAX_SIDE}, with at most {MAX_PIXELS} pixels in all"
        );
        problems.push(problem("size", message));
    }
    if file.panels.is_empty() {
        problems.push(problem(
            "panels",
            "found an empty list; a lesson shows one panel or more",
        ));
    }
    if file.steps.is_empty() {
        problems.push(problem(
            "steps",
            "found an empty list; a lesson says something at one step or more",
        ));
    }
}
