//! All values known at the step, or at the one that is selected: its own first, then those of the scopes around it from the innermost
//! outwards, each under the step that recorded it. Of a name that several scopes record the innermost value is shown.

mod layout;
mod values;
mod view;

pub use view::InspectorView;

use super::message::{NO_STEPS, message};
use super::names;
use super::values::{sentence, shown, step_in_words as shown_step_in_words};
use super::{PanelInput, Properties};
use crate::language::Message;
use crate::picture::{Ink, Picture, Rect, Style, Tag, elide};
use crate::record::Field;
use crate::replay::RecordedField;
use crate::vocabulary::counted;
use glam::Vec2;
use layout::{GAP, Layout, MARGIN, TITLE};
use values::{Line, known, step_in_words};

pub const PANEL: Properties = Properties::titled(Message("app-inspector"));

pub fn draw(input: &PanelInput, size: Vec2) -> Picture {
    let walk = input.run.walk();
    if walk.is_empty() {
        return message(NO_STEPS, input.language, size);
    }
    let step = shown_step(input);
    let recorded = known(walk, step);
    let layout = Layout::of(&recorded, step, input, size);

    let mut picture = Picture::new(size.x, size.y);
    picture.alt = in_words(&recorded, input);
    title(&mut picture, input, size);
    let muted = Style::Body.size(layout.text).ink(Ink::Muted);
    if layout.lines.is_empty() {
        let nothing = match recorded.is_empty() {
            true => Message("inspector-no-values"),
            false => Message("inspector-none-found"),
        };
        let line = Rect::new(MARGIN, TITLE, size.x - 2.0 * MARGIN, 20.0);
        picture.text_in(
            line,
            nothing.text(input.language),
            Style::Body.size(12.0).ink(Ink::Muted),
        );
        return picture;
    }
    let (seen, [before, after]) = layout.seen(input.inspector.first);
    let count = |lines: &[Line]| {
        let values = lines.iter().filter(|line| matches!(line, Line::Value(_)));
        values.count().to_string()
    };
    let first = usize::from(before);
    if before {
        let count = count(&layout.lines[..seen.start]);
        let text = Message("inspector-before").format(input.language, &[("count", &count)]);
        picture.text_in(layout.place(0), text, muted);
    }
    for (i, line) in layout.lines[seen.clone()].iter().enumerate() {
        layout.draw(&mut picture, line, layout.place(first + i), input);
    }
    if after {
        let count = count(&layout.lines[seen.end..]);
        let text = Message("inspector-more").format(input.language, &[("count", &count)]);
        picture.text_in(layout.place(first + seen.len()), text, muted);
    }
    picture
}

/// How many lines are scrolled past where so many are asked for, in a panel of that size: the last line stays in sight.
pub fn scrolled(input: &PanelInput, size: Vec2, first: usize) -> usize {
    let walk = input.run.walk();
    if walk.is_empty() {
        return 0;
    }
    let step = shown_step(input);
    let layout = Layout::of(&known(walk, step), step, input, size);
    layout.seen(first).0.start
}

/// The selected step, unless a question waits and it lies ahead; else the one that is shown.
fn shown_step(input: &PanelInput) -> usize {
    let selected = input.selected.filter(|&step| step <= input.last_known());
    selected.unwrap_or(input.run.walk().position())
}

/// The kind of the step, its number and its depth; in blue where it is another one than is shown elsewhere.
fn title(picture: &mut Picture, input: &PanelInput, size: Vec2) {
    let walk = input.run.walk();
    let step = shown_step(input);
    let ink = match step == walk.position() {
        true => Ink::This,
        false => Ink::Linked,
    };
    let line = Rect::new(MARGIN, 6.0, size.x - 2.0 * MARGIN, 20.0);
    let place = Style::Body.size(12.0).ink(Ink::Muted).end();
    let [number, depth] = [step, walk.outline().depth(step)].map(|number| number.to_string());
    let long = Message("inspector-step-and-depth")
        .format(input.language, &[("step", &number), ("depth", &depth)]);
    let short = step_in_words(step, input.language);
    let name = names::kind(walk.kind(step), input.language);
    let kind = Style::Bold.size(14.0).ink(ink);
    let room = line.width - kind.width(&name) - GAP;
    let fits = place.width(&long) <= room;
    let text = if fits { long } else { short };
    let room = line.width - place.width(&text) - GAP;
    picture.tagged(Tag::Step(step), |picture| {
        picture.text_in(line, elide(&name, kind.style, kind.size, room), kind);
        picture.text_in(line, text, place);
    });
    let y = TITLE - 3.0;
    picture.line((MARGIN, y), (size.x - MARGIN, y), Ink::Rule.stroke(1.0));
}

/// The step with its own values.
fn in_words(recorded: &[RecordedField], input: &PanelInput) -> String {
    let walk = input.run.walk();
    let step = shown_step(input);
    let heading = match input.selected {
        Some(_) => {
            let kind = names::kind(walk.kind(step), input.language);
            names::numbered(&kind, &step.to_string(), input.language)
        }
        None => shown_step_in_words(input),
    };
    let own: Vec<String> = recorded
        .iter()
        .filter(|recorded| recorded.step == step)
        .map(|recorded| {
            let Field { name, value } = recorded.field;
            let value = shown(counted(name, value), 4, input.language);
            let name = names::field(name, input.language);
            format!("{name} = {value}")
        })
        .collect();
    sentence(&heading, &own, input.language)
}

#[cfg(test)]
mod tests;
