//! Another focus: it is recorded at once, and the walk goes on at the same place of the picture.

use super::{Refused, Session};
use crate::algorithms::focus::Focus;
use crate::app::strings;
use crate::panels::{Panel, TreeView};
use crate::picture::Tag;
use crate::record::{RecordingLimit, Value};
use crate::replay::{Comparison, Condition, Operand, Query, Run, Walk, query};

/// Fields that say where a step is, from the whole to its parts.
const PLACES: [&str; 11] = [
    "polygon", "vertex", "light", "corner", "y", "edge", "x", "channel", "k", "i", "j",
];

impl Session {
    /// Records another focus, and goes to the step that is most like the current one. The lesson's own focus goes on where it was
    /// left, so that no detour leads past a question.
    pub(super) fn focus_on(&mut self, focus: Focus) -> Result<(), Refused> {
        let recorded = self.open.lesson.method.records(focus);
        if !recorded || self.open.setup.check(focus).is_err() {
            return Err(strings::OUTSIDE.into());
        }
        if focus == self.focus {
            return Ok(());
        }
        if self.follows_lesson() {
            self.left_at = self.step();
        }
        let place = Place::of(self.walk(), self.step());
        let run = self.record(focus);
        let step = match focus {
            _ if focus == self.open.lesson.focus => Some(self.left_at),
            Focus::Pixel { x, y } => Place::colored(x, y)
                .find(run.walk())
                .or_else(|| place.find(run.walk())),
            _ => place.find(run.walk()),
        };
        self.switch_to(run, focus, step.unwrap_or(0));
        Ok(())
    }

    /// Records the focus again in a changed scene, and stays at the same step if there is one.
    pub(super) fn record_again(&mut self) {
        let here = self.step();
        let skipped = self.question_between(0, here).is_some();
        let place = Place::of(self.walk(), here);
        let run = self.record(self.focus);
        let step = place.nearest(run.walk(), here).unwrap_or(here);
        // Whoever moves a light goes on looking at the panel in which it is moved.
        let chosen = self.chosen;
        self.switch_to(run, self.focus, step);
        self.chosen = chosen;
        // No change of a parameter leads past a question.
        if let Some(asked) = self.question_between(0, self.step()).filter(|_| !skipped) {
            self.seek(asked);
        }
    }

    /// Switches to another run, at one of its steps. The lesson's narration is resolved in this run; where one of its events does not
    /// happen any more after a change, there is none.
    fn switch_to(&mut self, run: Run, focus: Focus, step: usize) {
        self.open.run = run;
        self.focus = focus;
        if matches!(focus, Focus::FormFactor { .. }) && !self.follows_lesson() {
            self.chosen = Some(Panel::FormFactor);
        }
        self.recording += 1;
        self.play = None;
        self.around = super::playing::Loop::default();
        self.tree = TreeView::WHOLE.zoomed(self.tree.zoom, None);
        self.seek(step.min(self.last_step()));
        let last = self.last_step();
        if let Some(breakpoints) = self.breakpoints.get_mut(&focus) {
            breakpoints.retain(|&step| step <= last);
        }
        self.narrated.clear();
        if self.follows_lesson() {
            let narrated = self.open.lesson.narrate_changed(&self.open.run);
            self.open.narrated = narrated.unwrap_or_default();
            let said = self.open.narrated.iter().map(|said| said.step);
            self.narrated.extend(said);
        }
    }

    /// Focuses on the polygon that is seen at a pixel.
    pub(super) fn focus_on_polygon(&mut self, x: u32, y: u32) -> Result<(), Refused> {
        let pixel = self.record(Focus::Pixel { x, y });
        let colored: Query = Place::colored(x, y).query(usize::MAX);
        let seen = query::previous(pixel.walk(), &colored, pixel.walk().len());
        match seen.and_then(|step| pixel.walk().fields(step).get("polygon")) {
            Some(Value::Integer(number)) => self.focus_on(Focus::Polygon(number as usize)),
            _ => Err(strings::NOTHING_DRAWN_THERE.into()),
        }
    }

    /// The focus that a tag stands for.
    pub fn focus_of(&self, tag: Tag) -> Option<Focus> {
        match tag {
            Tag::Pixel { x, y } => Some(Focus::Pixel { x, y }),
            Tag::ScanLine(y) => u32::try_from(y).ok().map(Focus::ScanLine),
            Tag::Polygon(number) => Some(Focus::Polygon(number)),
            Tag::Patch(number) => u32::try_from(number).ok().map(Focus::Patch),
            Tag::FormFactor { i, j } => Some(Focus::FormFactor {
                i: u32::try_from(i).ok()?,
                j: u32::try_from(j).ok()?,
            }),
            _ => None,
        }
    }

    pub(super) fn record(&self, focus: Focus) -> Run {
        Run::record(
            self.open.setup.clone(),
            self.open.lesson.method,
            focus,
            RecordingLimit::default(),
        )
    }
}

/// What a step is about, by values that another recording has too.
pub(super) struct Place {
    kind: &'static str,
    at: Vec<(&'static str, i64)>,
}

impl Place {
    pub(super) fn of(walk: &dyn Walk, step: usize) -> Self {
        if walk.is_empty() {
            return Place {
                kind: "Frame",
                at: Vec::new(),
            };
        }
        let fields = walk.fields(step);
        let at = PLACES
            .into_iter()
            .filter_map(|name| match fields.get(name) {
                Some(Value::Integer(value)) => Some((name, value)),
                _ => None,
            });
        Place {
            kind: walk.kind(step),
            at: at.collect(),
        }
    }

    fn colored(x: u32, y: u32) -> Self {
        Place {
            kind: "PixelColored",
            at: vec![("y", y.into()), ("x", x.into())],
        }
    }

    /// The step that agrees in kind and place; else one that agrees in ever less of its place.
    fn find(&self, walk: &dyn Walk) -> Option<usize> {
        let first = |query: &Query| query::matches(walk, query, 0..walk.len()).next();
        (1..=self.at.len()).rev().find_map(|known| {
            let mut query = self.query(known);
            first(&query).or_else(|| {
                query.kind = None;
                first(&query)
            })
        })
    }

    /// The step nearest to `here` that agrees in kind and place; else in its kind alone.
    pub(super) fn nearest(&self, walk: &dyn Walk, here: usize) -> Option<usize> {
        let here = here.min(walk.len().checked_sub(1)?);
        [self.at.len(), 0].into_iter().find_map(|known| {
            let query = self.query(known);
            let ahead = query::matches(walk, &query, here..walk.len()).next();
            if ahead == Some(here) {
                return ahead;
            }
            let behind = query::previous(walk, &query, here);
            let both = behind.into_iter().chain(ahead);
            both.min_by_key(|step| step.abs_diff(here))
        })
    }

    /// Selects the kind, and the first `known` parts of the place.
    fn query(&self, known: usize) -> Query {
        let conditions = self.at.iter().take(known).map(|&(name, value)| Condition {
            field: name.to_owned(),
            comparison: Comparison::Equal,
            value: Operand::Number(value as f64),
        });
        Query {
            kind: Some(self.kind.to_owned()),
            conditions: conditions.collect(),
        }
    }
}
