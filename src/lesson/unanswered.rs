//! While a question waits, no panel gives its answer away: what is right occurs in no display list.

mod numbers;
mod secrets;

use super::narrated::Question;
use super::pictures::{finished, input, panels};
use super::{Builtin, OpenLesson, builtins};
use crate::language::Language;
use crate::panels::{Answered, PanelInput, draw, form_factor, named_by, patch_values, word_name};
use crate::picture::{Picture, Shape, Style, Tag};
use crate::record::{Field, Value};
use glam::Vec2;
use numbers::{Written, numbers, parts};
use secrets::{Secret, secrets};
use std::collections::BTreeSet;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

/// The texts of a picture, and its words for who cannot see it.
fn texts(picture: &Picture) -> impl Iterator<Item = &str> {
    let items = picture.items.iter().filter_map(|item| match &item.shape {
        Shape::Text { text, .. } => Some(text.as_str()),
        _ => None,
    });
    items.chain([picture.alt.as_str()])
}

/// Whether something small stands in the middle of that pixel, wherever the picture shows the rendered image.
fn is_marked(picture: &Picture, x: u32, y: u32) -> bool {
    let images = picture.items.iter().filter_map(|item| match &item.shape {
        Shape::Image {
            rect,
            image,
            first_pixel: Some((left, top)),
        } => Some((*rect, rect.width / image.width() as f32, [*left, *top])),
        _ => None,
    });
    let places: Vec<(Vec2, f32)> = images
        .map(|(rect, side, [left, top])| {
            let pixel = Vec2::new((x - left) as f32 + 0.5, (y - top) as f32 + 0.5);
            (rect.min() + side * pixel, side)
        })
        .collect();
    picture.items.iter().any(|item| {
        let (center, extent) = match &item.shape {
            Shape::Rect { rect, .. } => (rect.center(), rect.width.max(rect.height)),
            Shape::Circle { center, radius, .. } => (*center, 2.0 * radius),
            _ => return false,
        };
        places.iter().any(|&(place, side)| {
            center.distance(place) <= 0.75 * side && extent <= (3.0 * side).max(14.0)
        })
    })
}

/// The straight lines of a picture.
fn lines(picture: &Picture) -> impl Iterator<Item = [Vec2; 2]> {
    picture.items.iter().filter_map(|item| match &item.shape {
        Shape::Polyline { points, .. } => <[Vec2; 2]>::try_from(&**points).ok(),
        _ => None,
    })
}

/// Whether `picture` has a line from the start of the arrow that `with_arrow` has beside it, and toward where it points.
fn is_drawn(picture: &Picture, with_arrow: &Picture, tolerance: f64) -> bool {
    const SHORTEST: f32 = 8.0;
    let known: Vec<[Vec2; 2]> = lines(picture).collect();
    // The same line drawn twice is the arrow over another that gives it away.
    let mut before = known.clone();
    let mut arrow = lines(with_arrow).filter(|line| {
        let same = before.iter().position(|known| known == line);
        same.map(|at| before.swap_remove(at)).is_none()
    });
    arrow.any(|[start, end]| {
        known.iter().any(|&[from, to]| {
            let angle = (end - start).angle_to(to - from).abs().to_degrees();
            let near = from.distance(start) < SHORTEST && from.distance(to) > SHORTEST;
            near && f64::from(angle) <= tolerance
        })
    })
}

/// What may be read at a step without looking ahead.
struct Known {
    /// The values that the step and the scopes around it recorded.
    here: Vec<Field>,
    names: Vec<String>,
    /// Those of all steps up to this, ascending, but for references, which say what a run is to find.
    before: Vec<f64>,
}

impl Known {
    fn at(open: &OpenLesson, step: usize, language: Language) -> Known {
        let walk = open.run.walk();
        let here = walk.fields(step).0;
        let name = |field: &Field| match field.value {
            Value::Word(word) => Some(word_name(word, language)),
            value => named_by(&open.setup.prepared, field.name, value, language).map(str::to_owned),
        };
        let past = (0..=step).filter(|&step| walk.kind(step) != "Reference");
        let mut before: Vec<f64> = past
            .flat_map(|step| walk.own_fields(step).0)
            .flat_map(|field| parts(field.value))
            .collect();
        before.sort_by(f64::total_cmp);
        Known {
            names: here.iter().filter_map(name).collect(),
            here,
            before,
        }
    }

    fn shows(&self, written: &Written) -> bool {
        let mut here = self.here.iter().flat_map(|field| parts(field.value));
        here.any(|value| written.rounds(value))
    }

    /// Whether an earlier value would be written so.
    fn explains(&self, written: &Written) -> bool {
        let from = self
            .before
            .partition_point(|&value| value < written.value - written.half);
        self.before
            .get(from)
            .is_some_and(|&value| written.rounds(value))
    }
}

/// Where a picture gives a secret away; none where it does not.
fn leak(picture: &Picture, secret: &Secret, known: &Known, language: Language) -> Option<String> {
    let found = |is: &dyn Fn(&Written) -> bool| {
        let gives_away = |written: &Written| is(written) && !known.shows(written);
        texts(picture)
            .find(|text| numbers(text, language).iter().any(gives_away))
            .map(str::to_owned)
    };
    match secret {
        Secret::Number { value, tolerance } => found(&|written| {
            let near = (written.value - value).abs() <= *tolerance;
            // A short number, or one that only comes near, may be another value.
            let by_chance = !written.rounds(*value) || written.half > 5e-4 * value.abs();
            near && written.half <= *tolerance && !(by_chance && known.explains(written))
        }),
        Secret::Whole(whole) => {
            found(&|written| written.value == *whole as f64 && !known.explains(written))
        }
        Secret::Name { right, wrong } => {
            let occurs = |name: &String| texts(picture).any(|text| text.contains(name.as_str()));
            let new = !known.names.contains(right);
            let text = || texts(picture).find(|text| text.contains(right.as_str()));
            (new && occurs(right) && !wrong.iter().all(occurs)).then(|| text().unwrap().to_owned())
        }
        Secret::Word(right) => {
            let values = |text: &str| {
                let mut values = text.split(['=', ':', '→', '·', ';', ',']);
                values.any(|value| value.trim() == right)
            };
            let new = !known.names.contains(right);
            let found = texts(picture).find(|text| new && values(text));
            found.map(str::to_owned)
        }
        Secret::Sequence(names) => {
            let mut texts = texts(picture).map(str::to_lowercase);
            let follows = |name: &String| texts.any(|text| text.contains(name.as_str()));
            names.iter().all(follows).then(|| names.join(" → "))
        }
        Secret::Direction { .. } => None,
        Secret::Pixel { x, y } => is_marked(picture, *x, *y).then(|| format!("({x}, {y})")),
    }
}

/// A part of a picture that leads to a step behind `step`, but to an explanation; none where there is none.
fn leads_ahead(picture: &Picture, step: usize, narrated: &[usize]) -> Option<usize> {
    picture.items.iter().find_map(|item| match item.tag? {
        Tag::Step(to) | Tag::Scope(to) | Tag::Fold(to) if to > step && !narrated.contains(&to) => {
            Some(to)
        }
        _ => None,
    })
}

/// What the pointer finds out of patches and form factors; but not of the numbers of patches, which say nothing of them.
fn cards(input: &PanelInput) -> Picture {
    let count = input.run.enclosure().map_or(0, |room| room.patches.len());
    let pairs = (0..count).flat_map(|i| (0..count).map(move |j| [i, j]));
    let patches = (0..count).filter_map(|patch| patch_values(input, patch));
    let values =
        patches.flat_map(|said| said.lines().skip(1).map(str::to_owned).collect::<Vec<_>>());
    let form_factors = pairs.filter_map(|pair| form_factor(input, pair));
    let form_factors = form_factors.filter_map(|said| Some(said.split_once(" = ")?.1.to_owned()));
    let mut picture = Picture::default();
    for text in values.chain(form_factors) {
        picture.text(Vec2::ZERO, text, Style::Body.size(11.0));
    }
    picture
}

/// What only happens to be near the right number: the share of an end of a span in the normal between them.
const BY_CHANCE: [(&str, &str); 1] = [("phong-highlight", "→ N_5")];

/// The places where a lesson's panels give an answer away.
fn leaks(lesson: Builtin) -> BTreeSet<String> {
    let mut open = lesson.read().unwrap().open().unwrap();
    let finished = finished(&open);
    let mut leaks = BTreeSet::new();
    let steps: Vec<usize> = open.narrated.iter().map(|narrated| narrated.step).collect();
    for (index, &step) in steps.iter().enumerate() {
        if open.narrated[index].question.is_none() {
            continue;
        }
        open.run.walk_mut().seek(step);
        for language in Language::ALL {
            let known = Known::at(&open, step, language);
            let secrets = secrets(&open, index, language);
            let Question { hide, .. } = open.narrated[index].question.as_ref().unwrap();
            let cards = cards(&PanelInput {
                pending: Some(hide),
                ..input(&open, &finished, &steps, language)
            });
            for secret in &secrets {
                if let Some(text) = leak(&cards, secret, &known, language) {
                    leaks.insert(format!(
                        "{} steps[{index}] cards: {secret:?} in “{text}”",
                        lesson.id
                    ));
                }
            }
            for panel in panels(&open) {
                for size in [Vec2::new(900.0, 700.0), Vec2::new(420.0, 300.0)] {
                    let input = PanelInput {
                        pending: Some(hide),
                        ..input(&open, &finished, &steps, language)
                    };
                    let picture = draw(panel, &input, size);
                    let place = format!("{} steps[{index}] {}", lesson.id, panel.name());
                    if let Some(ahead) = leads_ahead(&picture, step, &steps) {
                        leaks.insert(format!("{place}: leads to step {ahead}"));
                    }
                    for secret in &secrets {
                        if let &Secret::Direction { arrow, tolerance } = secret {
                            let arrow = Some(arrow);
                            let answered = Answered {
                                arrow,
                                ..input.answered
                            };
                            let input = PanelInput { answered, ..input };
                            if is_drawn(&picture, &draw(panel, &input, size), tolerance) {
                                leaks.insert(format!("{place}: draws the arrow"));
                            }
                        }
                        let chance = |text: &String| {
                            let by_chance =
                                |&(id, part): &(&str, &str)| id == lesson.id && text.contains(part);
                            BY_CHANCE.iter().any(by_chance)
                        };
                        let leak = leak(&picture, secret, &known, language);
                        if let Some(text) = leak.filter(|text| !chance(text)) {
                            leaks.insert(format!("{place}: {secret:?} in “{text}”"));
                        }
                    }
                }
            }
        }
    }
    leaks
}

#[test]
fn no_panel_gives_the_answer_of_a_waiting_question_away() {
    let next = AtomicUsize::new(0);
    let work = || {
        let mut found = BTreeSet::new();
        while let Some(lesson) = builtins().get(next.fetch_add(1, Ordering::Relaxed)) {
            found.extend(leaks(*lesson));
        }
        found
    };
    let found: BTreeSet<String> = thread::scope(|scope| {
        let workers = [(); 2].map(|()| scope.spawn(work));
        workers
            .into_iter()
            .flat_map(|worker| worker.join().unwrap())
            .collect()
    });
    let found: Vec<String> = found.into_iter().collect();
    assert!(found.is_empty(), "\n{}", found.join("\n"));
}
