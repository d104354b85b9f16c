//! The time line: scopes as nested bars, a row for each depth, with the cursor, and marks for narrated steps and breakpoints.
//!
//! The track on top always spans the whole run. In a run of few steps every row does too. In a longer one a row spans the
//! scope that contains the cursor one depth further out, so that its bars stay readable however long the run is; what is
//! too narrow is drawn as one quiet bar for many. Drawing looks at a few steps for every bar, never at all steps of the run.

mod rows;

use super::message::{NO_STEPS, labelled, message};
use super::names;
use super::values::sentence;
use super::{PanelInput, Properties};
use crate::language::{Language, Message};
use crate::picture::{Ink, Picture, Rect, Style, Tag, elide};
use crate::record::Value;
use crate::replay::Walk;
use crate::vocabulary::Kind;
use glam::Vec2;
use rows::{Bar, MARGIN, Row, Span, TRACK, rows, track};

const TEXT: f32 = 12.0;

pub const PANEL: Properties = Properties::titled(Message("app-time-line"));

pub fn draw(input: &PanelInput, size: Vec2) -> Picture {
    let walk = input.run.walk();
    if walk.is_empty() {
        return message(NO_STEPS, input.language, size);
    }
    let position = walk.position();
    let track = track(size);
    let rows = rows(walk, size);
    let mut picture = Picture::new(size.x, size.y);
    picture.alt = in_words(input, &rows);

    let whole = Span::new(0..walk.len(), track);
    let y = MARGIN + 0.5 * TRACK;
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
    cursor(&mut picture, &whole, &rows, position, y);
    picture
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
        let mut kinds: Vec<&'static Kind> = Vec::new();
        let mut before = "";
        for bar in &self.bars {
            let current = self.is_current(bar);
            let rect = self.bar(bar);
            let scope = bar.steps.start;
            let ink = if current { Ink::LinkedTint } else { Ink::Faint };
            let tag = if bar.several { Tag::Step } else { Tag::Scope };
            picture.tagged(tag(scope), |picture| {
                let radius = if rect.width > 8.0 { 3.0 } else { 0.0 };
                picture.rounded_rect(rect, radius, ink);
            });
            if bar.several {
                continue;
            }
            let kind = walk.declared(scope);
            if kinds.iter().all(|known| known.name != kind.name) {
                kinds.push(kind);
            }
            // The first of its kind says what the numbers count.
            let long = current || kind.name != before;
            before = kind.name;
            let cursor = current.then(|| self.span.middle(walk.position()));
            picture.tagged(tag(scope), |picture| {
                label(picture, rect, input, scope, (cursor, long));
            });
        }
        self.draw_name(picture, walk, kinds, input.language);
    }

    /// The kinds of scope in the row, the current one first, as many as fit.
    fn draw_name(
        &self,
        picture: &mut Picture,
        walk: &dyn Walk,
        mut kinds: Vec<&'static Kind>,
        language: Language,
    ) {
        if let Some(current) = self.current.map(|scope| walk.kind(scope)) {
            kinds.sort_by_key(|kind| kind.name != current);
        }
        let style = Style::Body.size(TEXT).ink(Ink::Muted);
        let place = Rect {
            x: MARGIN,
            width: self.place.x - MARGIN - 8.0,
            ..self.place
        };
        let names: Vec<String> = kinds
            .into_iter()
            .map(|kind| in_text(kind, language))
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

/// What a bar is called, if it fits: its number, where it is `long` after its kind; of a ray, its kind and where it goes.
/// Beside the cursor, where there is room.
fn label(
    picture: &mut Picture,
    rect: Rect,
    input: &PanelInput,
    scope: usize,
    (cursor, long): (Option<f32>, bool),
) {
    let walk = input.run.walk();
    let style = if cursor.is_some() {
        Style::Bold.size(TEXT)
    } else {
        Style::Body.size(TEXT).ink(Ink::Muted)
    };
    let kind = in_text(walk.declared(scope), input.language);
    let ray = names::ray(walk, scope, input.run.prepared(), input.language);
    let names = match (ray, number_of(walk, scope, input.language)) {
        (Some(names), _) => names.to_vec(),
        (None, Some(number)) if long => {
            vec![names::numbered(&kind, &number, input.language), number]
        }
        (None, Some(number)) => vec![number],
        (None, None) => vec![kind],
    };
    let fitting = names
        .into_iter()
        .find(|name| style.width(name) + 6.0 <= rect.width);
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
}

/// What tells a scope from its neighbours, by the declaration of its kind: a number, or a word.
fn number_of(walk: &dyn Walk, scope: usize, language: Language) -> Option<String> {
    let name = walk.declared(scope).number?;
    match walk.own_fields(scope).get(name)? {
        Value::Integer(number) => Some(number.to_string()),
        Value::Word(word) => Some(names::word(word, language)),
        _ => None,
    }
}

/// What the scope is called that an event of `kind` opens.
fn in_text(kind: &Kind, language: Language) -> String {
    match kind.scope {
        Some(scope) => scope.text(language).to_string(),
        None => names::kind(kind.name, language),
    }
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
    let far = (distance / span.scale).ceil() as usize;
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
            let kind = in_text(walk.declared(scope), input.language);
            let ray = names::ray(walk, scope, input.run.prepared(), input.language);
            Some(match (ray, number_of(walk, scope, input.language)) {
                (Some([ray, ..]), _) => labelled(&kind, &ray, input.language),
                (None, Some(number)) => names::numbered(&kind, &number, input.language),
                (None, None) => kind,
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
