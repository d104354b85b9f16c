//! The time line: scopes as nested bars, a row for each depth, with the cursor, and marks for narrated steps and breakpoints.
//!
//! The track on top always spans the whole run. In a run of few steps every row does too. In a longer one a row spans the
//! scope that contains the cursor one depth further out, so that its bars stay readable however long the run is; what is
//! too narrow is drawn as one quiet bar for many. Drawing looks at a few steps for every bar, never at all steps of the run.

mod rows;

use super::horizon::UNKNOWN;
use super::message::{AFTER_YOUR_ANSWER, NO_STEPS, labelled, message};
use super::names;
use super::values::sentence;
use super::{PanelInput, Properties};
use crate::language::{Language, Message};
use crate::picture::{Ink, Picture, Rect, Style, Tag, elide};
use crate::replay::Walk;
use crate::vocabulary::Kind;
use glam::Vec2;
use rows::{Bar, EDGE, MARGIN, Row, Span, TRACK, USUAL_ROWS, height, rows, track};
use std::ops::RangeInclusive;

const TEXT: f32 = 12.0;

pub const PANEL: Properties = Properties::titled(Message("app-time-line"));

pub fn draw(input: &PanelInput, size: Vec2) -> Picture {
    let walk = input.run.walk();
    if walk.is_empty() {
        return message(NO_STEPS, input.language, size);
    }
    let position = walk.position();
    let track = track(size);
    let mut rows = rows(walk, size);
    if input.is_pending() {
        rows.iter_mut().for_each(|row| row.hide_after(position));
    }
    let mut picture = Picture::new(size.x, size.y);
    picture.alt = in_words(input, &rows);

    let whole = Span::new(0..walk.len(), track);
    let y = EDGE + 0.5 * TRACK;
    let rule = Ink::Rule.stroke(2.0);
    picture.line((track.x, y), (track.right(), y), rule);
    marks(&mut picture, input, &whole, y);
    for (i, row) in rows.iter().enumerate() {
        if i > 0 && row.span.steps != rows[i - 1].span.steps {
            funnel(&mut picture, &rows[i - 1], row);
        }
    }
    for row in &rows {
        row.draw(&mut picture, input);
    }
    for (number, row) in rows.iter().enumerate() {
        row.draw_hidden(&mut picture, input.language, number == 0);
    }
    cursor(&mut picture, &whole, &rows, position, y);
    picture
}

/// The height that shows the usual rows of a run, and the one that shows all of them.
pub fn heights(walk: &dyn Walk) -> RangeInclusive<f32> {
    let outline = walk.outline();
    // A scope around the whole run has no row.
    let whole = !outline.is_empty() && outline.last(0) + 1 == outline.len();
    let rows = outline.deepest() - usize::from(whole && outline.deepest() > 1);
    height(rows.min(USUAL_ROWS))..=height(rows)
}

/// The step under `x` on the track that spans the whole run, in a time line of that size; 0 in an empty run.
pub fn step_at(input: &PanelInput, size: Vec2, x: f32) -> usize {
    let len = input.run.walk().len();
    let step = Span::new(0..len, track(size)).step(x);
    step.min(len.saturating_sub(1))
}

impl Row {
    fn bar(&self, bar: &Bar) -> Rect {
        let (left, right) = (self.span.x(bar.steps.start), self.span.x(bar.steps.end));
        let gap = if right - left > 6.0 { 1.0 } else { 0.5 };
        let right = (right - gap).min(self.place.right());
        Rect::new(left, self.place.y, right - left, self.place.height)
    }

    fn is_current(&self, bar: &Bar) -> bool {
        self.current.is_some_and(|scope| bar.steps.contains(&scope))
    }

    fn draw(&self, picture: &mut Picture, input: &PanelInput) {
        let walk = input.run.walk();
        let kinds = self.kinds(walk);
        // Numbers alone are those of one kind, the most frequent one.
        let most = kinds.iter().map(|&(_, count)| count).max();
        let counted = kinds.iter().find(|&&(_, count)| Some(count) == most);
        let counted = counted.map_or("", |(kind, _)| kind.name);
        let mut before = "";
        let mut current_is_named = false;
        for bar in &self.bars {
            let current = self.is_current(bar);
            let rect = self.bar(bar);
            let scope = bar.steps.start;
            let ink = if current { Ink::Linked } else { Ink::Faint };
            let paint = if rect.width > 4.0 {
                ink.fill().outlined(Ink::Rule.stroke(1.0))
            } else {
                ink.into()
            };
            let tag = if bar.several { Tag::Step } else { Tag::Scope };
            picture.tagged(tag(scope), |picture| {
                let radius = if rect.width > 8.0 { 3.0 } else { 0.0 };
                picture.rounded_rect(rect, radius, paint);
            });
            if bar.several {
                continue;
            }
            let kind = walk.kind(scope);
            let mut names = names(input, scope);
            if !walk.declared(scope).numbers.is_empty() && kind != "Ray" {
                match kind == counted {
                    // The first of its kind says what the numbers count.
                    true if !current && kind == before => drop(names.remove(0)),
                    true => {}
                    false => names.truncate(1),
                }
            }
            before = kind;
            let cursor = current.then(|| self.span.middle(walk.position()));
            picture.tagged(tag(scope), |picture| {
                let fits = label(picture, rect, names, cursor);
                current_is_named |= current && fits;
            });
        }
        match self.current.filter(|_| !current_is_named) {
            Some(scope) => self.draw_current(picture, input, scope),
            None => self.draw_kinds(picture, walk, kinds, input.language),
        }
    }

    /// In the place of what a waiting question hides: words, or a question mark alone.
    fn draw_hidden(&self, picture: &mut Picture, language: Language, in_words: bool) {
        let Some(hidden) = &self.hidden else { return };
        let left = self.span.x(hidden.start);
        let width = self.place.right() - left;
        let place = Rect {
            x: left,
            width,
            ..self.place
        };
        let outline = Ink::Muted.stroke(1.0).dotted();
        picture.rounded_rect(place, 3.0, Ink::Surface.fill().outlined(outline));
        let style = Style::Body.size(TEXT).ink(Ink::Muted).middle();
        let words = AFTER_YOUR_ANSWER.text(language);
        let text = match in_words && style.width(words) + 6.0 <= width {
            true => words,
            false => UNKNOWN,
        };
        if style.width(text) <= width {
            picture.text_in(place, text, style);
        }
    }

    /// The kinds of scope that have bars of their own, each with how many.
    fn kinds(&self, walk: &dyn Walk) -> Vec<(&'static Kind, usize)> {
        let mut kinds: Vec<(&'static Kind, usize)> = Vec::new();
        for bar in self.bars.iter().filter(|bar| !bar.several) {
            let kind = walk.declared(bar.steps.start);
            match kinds.iter_mut().find(|(known, _)| known.name == kind.name) {
                Some((_, count)) => *count += 1,
                None => kinds.push((kind, 1)),
            }
        }
        kinds
    }

    /// The current scope, whose bar is too narrow to name it.
    fn draw_current(&self, picture: &mut Picture, input: &PanelInput, scope: usize) {
        let style = Style::Bold.size(TEXT);
        let place = self.place_of_name();
        let mut names = names(input, scope);
        let fitting = names
            .iter()
            .position(|name| style.width(name) <= place.width);
        let name = match fitting {
            Some(fitting) => names.swap_remove(fitting),
            None => elide(&names[0], Style::Bold, TEXT, place.width),
        };
        picture.tagged(Tag::Scope(scope), |picture| {
            picture.text_in(place, name, style);
        });
    }

    /// To the left of the bars.
    fn place_of_name(&self) -> Rect {
        Rect {
            x: MARGIN,
            width: self.place.x - MARGIN - 8.0,
            ..self.place
        }
    }

    /// The kinds of scope in the row, the current one first, as many as fit.
    fn draw_kinds(
        &self,
        picture: &mut Picture,
        walk: &dyn Walk,
        mut kinds: Vec<(&'static Kind, usize)>,
        language: Language,
    ) {
        if let Some(current) = self.current.map(|scope| walk.kind(scope)) {
            kinds.sort_by_key(|(kind, _)| kind.name != current);
        }
        let style = Style::Body.size(TEXT).ink(Ink::Muted);
        let place = self.place_of_name();
        let names: Vec<String> = kinds
            .into_iter()
            .map(|(kind, _)| names::scope_kind(kind, language))
            .collect();
        let name = (1..=names.len())
            .rev()
            .map(|count| names[..count].join(", "))
            .find(|name| style.width(name) <= place.width)
            .or_else(|| Some(elide(names.first()?, Style::Body, TEXT, place.width)));
        if let Some(name) = name {
            picture.text_in(place, name, style);
        }
    }
}

/// What a scope is called, as far as it is known.
fn names(input: &PanelInput, scope: usize) -> Vec<String> {
    names::scope_known_at(input.run, scope, input.last_known(), input.language)
}

/// The first of the names that fits into a bar, beside the cursor where there is room. Returns whether one does.
fn label(picture: &mut Picture, rect: Rect, names: Vec<String>, cursor: Option<f32>) -> bool {
    let style = if cursor.is_some() {
        Style::Bold.size(TEXT).ink(Ink::Surface)
    } else {
        Style::Body.size(TEXT).ink(Ink::Muted)
    };
    let fitting = names
        .into_iter()
        .find(|name| style.width(name) + 6.0 <= rect.width);
    let fits = fitting.is_some();
    if let Some(name) = fitting {
        let half = 0.5 * style.width(&name) + 4.0;
        let covered = |x: f32| cursor.is_some_and(|cursor| (cursor - x).abs() < half);
        let cursor = cursor.unwrap_or_default();
        let place = [rect.center().x, cursor + half, cursor - half]
            .into_iter()
            .find(|&x| !covered(x) && x - half >= rect.x && x + half <= rect.right())
            .unwrap_or(rect.center().x);
        let rect = rect.shifted(Vec2::new(place - rect.center().x, 0.0));
        picture.text_in(rect, name, style.middle());
    }
    fits
}

/// From the current bar to the row below, which shows the inside of it.
fn funnel(picture: &mut Picture, above: &Row, below: &Row) {
    let Some(bar) = above.bars.iter().find(|bar| above.is_current(bar)) else {
        return;
    };
    let bar = above.bar(bar);
    let (top, bottom) = (bar.bottom(), below.place.y);
    picture.polygon(
        [
            (bar.x, top),
            (bar.right(), top),
            (below.place.right(), bottom),
            (below.place.x, bottom),
        ],
        Ink::LinkedTint.fill().opacity(0.6),
    );
}

/// Green dots where something is said, red diamonds where playing stops; one mark for all that lie closer than it is wide.
fn marks(picture: &mut Picture, input: &PanelInput, whole: &Span, y: f32) {
    for step in apart(input.narrated, whole, 7.0) {
        picture.tagged(Tag::Step(step), |picture| {
            picture.circle((whole.middle(step), y), 3.5, Ink::Good);
        });
    }
    for step in apart(input.breakpoints, whole, 7.0) {
        let x = whole.middle(step);
        picture.tagged(Tag::Step(step), |picture| {
            let corners = [(x, y - 5.0), (x + 5.0, y), (x, y + 5.0), (x - 5.0, y)];
            let edge = Ink::Surface.stroke(1.0);
            picture.polygon(corners, Ink::Bad.fill().outlined(edge));
        });
    }
}

/// Of ascending steps those at least `distance` points apart.
fn apart(steps: &[usize], span: &Span, distance: f64) -> Vec<usize> {
    let far = span.steps_in(distance);
    let mut rest = steps;
    std::iter::from_fn(|| {
        let &step = rest.first().filter(|&&step| step < span.steps.end)?;
        rest = &rest[rest.partition_point(|&other| other < step + far)..];
        Some(step)
    })
    .collect()
}

/// Through the track and all rows, on the scale of each.
fn cursor(picture: &mut Picture, whole: &Span, rows: &[Row], position: usize, y: f32) {
    let x = whole.middle(position);
    let mut points = vec![Vec2::new(x, y)];
    for row in rows {
        // The step that opens the scope of a row lies before its first step.
        if row.span.steps.contains(&position) {
            let x = row.span.middle(position);
            points.extend([Vec2::new(x, row.place.y), Vec2::new(x, row.place.bottom())]);
        }
    }
    picture.tagged(Tag::Step(position), |picture| {
        // It crosses the current bars.
        picture.polyline(points.clone(), Ink::Surface.stroke(5.0));
        picture.polyline(points, Ink::This.stroke(2.0));
        let top = y - 0.5 * TRACK - 1.0;
        let head = [(x - 7.0, top), (x + 7.0, top), (x, y + 1.0)];
        picture.polygon(head, Ink::This);
    });
}

/// Where the cursor stands, from the outermost scope shown to the innermost.
fn in_words(input: &PanelInput, rows: &[Row]) -> String {
    let walk = input.run.walk();
    let scopes: Vec<String> = rows
        .iter()
        .filter_map(|row| {
            let scope = row.current?;
            let name = names(input, scope).swap_remove(0);
            let kind = || names::scope_kind(walk.declared(scope), input.language);
            Some(match walk.kind(scope) {
                "Ray" => labelled(&kind(), &name, input.language),
                _ => name,
            })
        })
        .collect();
    let [step, steps] = [walk.position(), walk.len()].map(|number| number.to_string());
    let head =
        Message("time-line-at-step").format(input.language, &[("step", &step), ("steps", &steps)]);
    sentence(&head, &scopes, input.language)
}

#[cfg(test)]
mod tests;
