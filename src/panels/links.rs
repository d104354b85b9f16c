//! Hierarchical radiosity as its links: the elements of the enclosure as the scene's camera sees them, the links that the step is about
//! as lines between them, and how many links there are by level, against the pairs of patches that the full matrix has.
//!
//! A level is told by colour, dash and mark. A click on a link goes to the step that made it.

mod counts;
mod shown;
mod sketch;

use super::message::{NO_PATCHES, NO_STEPS, labelled, message};
use super::radiosity::NO_ROOM;
use super::values::step_as_sentence;
use super::{PanelInput, Properties, names};
use crate::figure::elided;
use crate::language::{Language, Message};
use crate::picture::{Ink, Picture, Rect, Style, Tag};
use crate::replay::Run;
use crate::replay::hierarchical::State;
use counts::Counts;
use glam::Vec2;
use shown::{Chosen, Shown};
use sketch::Sketch;

const MARGIN: f32 = 5.0;
const TEXT: f32 = 11.0;
const TITLE: f32 = 18.0;
/// Of the counts, where they stand beside the room.
const BESIDE: f32 = 170.0;
/// A smaller room shows nothing.
const LEAST: Vec2 = Vec2::new(60.0, 40.0);

const NO_LINKS: Message = Message("links-no-links");
const TOO_SMALL: Message = Message("links-too-small");
const ALL: Message = Message("links-all");
const COARSEST: Message = Message("links-coarsest");
const BETWEEN: Message = Message("links-between");
const TOWARD: Message = Message("links-toward");

pub const PANEL: Properties = Properties::titled(Message("app-links"));

pub fn draw(input: &PanelInput, size: Vec2) -> Picture {
    let language = input.language;
    let (setup, replay) = match input.run {
        Run::Hierarchical(setup, replay) => (setup, replay),
        Run::Radiosity(..) | Run::FormFactor(..) => return message(NO_LINKS, language, size),
        _ => return message(NO_PATCHES, language, size),
    };
    let state = replay.state();
    let (Some(room), Some(solved)) = (input.run.enclosure(), &state.solved) else {
        return message(NO_ROOM, language, size);
    };
    if input.run.walk().is_empty() {
        return message(NO_STEPS, language, size);
    }
    let shown = Shown::of(state);
    let counts = Counts::of(input, state);
    let mut picture = Picture::new(size.x, size.y);
    let whole = picture.bounds().grown(-MARGIN);
    let place = Rect::between((whole.x, whole.y + TITLE), whole.max());
    let is_wide = whole.width >= 400.0 && whole.width > 1.5 * whole.height;
    let (ground, below) = match is_wide {
        true => {
            let right = place.right() - BESIDE;
            let beside = Rect::between((right + 8.0, place.y), place.max());
            (Rect::between(place.min(), (right, place.bottom())), beside)
        }
        false => {
            let top = place.bottom() - counts.height(place, language);
            let ground = Rect::between(place.min(), (place.right(), top));
            (ground, Rect::between((place.x, top), place.max()))
        }
    };
    let area = ground.grown(-4.0);
    if area.width < LEAST.x || area.height < LEAST.y {
        return message(TOO_SMALL, language, size);
    }
    let title = title(input, state, &shown);
    picture.alt = [
        step_as_sentence(input),
        format!("{title}."),
        counts.in_words(language),
    ]
    .join(" ");
    let style = Style::Body.size(TEXT).ink(Ink::Muted);
    let row = Rect {
        height: TITLE,
        ..whole
    };
    elided(&mut picture, row, &title, style);
    counts.draw(&mut picture, below, language);
    picture.rect(ground, Ink::Faint);
    let sketch = Sketch::new(input, &setup.prepared, room, (state, solved), area);
    sketch.elements(&mut picture);
    input.answered.draw(&mut picture, |tag| {
        let Tag::Patch(patch) = tag else { return None };
        let at = sketch.of_patch(patch)?;
        Some(Rect::between(at, at))
    });
    sketch.links(&mut picture, &shown);
    picture
}

/// Which links are drawn.
fn title(input: &PanelInput, state: &State, shown: &Shown) -> String {
    let language = input.language;
    let name = |element: u32| element_name(input, state, element, language);
    let what = match shown.chosen {
        Chosen::All => ALL.text(language).to_string(),
        Chosen::Between([p, q]) => {
            BETWEEN.format(language, &[("one", &name(p)), ("other", &name(q))])
        }
        Chosen::Toward(p) => {
            TOWARD.format(language, &[("p", &p.to_string()), ("object", &name(p))])
        }
    };
    let drawn = match shown.links.len() == shown.count {
        true => language.number(shown.count as f64),
        false => {
            let [shown, all] =
                [shown.links.len(), shown.count].map(|count| language.number(count as f64));
            COARSEST.format(language, &[("shown", &shown), ("all", &all)])
        }
    };
    labelled(&what, &drawn, language)
}

/// The object that an element is a part of.
fn element_name(input: &PanelInput, state: &State, element: u32, language: Language) -> String {
    let solved = state.solved.as_ref();
    let element = solved.and_then(|solved| solved.tree.elements.get(element as usize));
    element.map_or_else(String::new, |element| {
        names::object(input.run.prepared(), element.object, language).to_string()
    })
}

#[cfg(test)]
mod tests;
