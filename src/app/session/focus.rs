//! Another part of the frame: it is recorded at once, and the walk goes on at the same place of the picture.

use super::{Refused, Session};
use crate::algorithms::focus::Focus;
use crate::app::words;
use crate::panels::TreeView;
use crate::picture::Tag;
use crate::record::{RecordingLimit, Value};
use crate::replay::{Comparison, Condition, Operand, Query, Run, Walk, query};

/// Fields that say where a step is, from the whole to its parts.
const PLACES: [&str; 7] = ["polygon", "vertex", "light", "corner", "y", "edge", "x"];

impl Session {
    /// Records another part of the frame, and goes to the step that is most like the present one; the lesson's own part
    /// goes on where it was left, so that no way around leads past a question.
    pub(super) fn look_at(&mut self, focus: Focus) -> Result<(), Refused> {
        let view = &self.open.stage.view;
        let exists = match focus {
            Focus::Frame => true,
            Focus::Polygon(number) => self.open.stage.polygon(number).is_some(),
            Focus::ScanLine(y) => y < view.height,
            Focus::Pixel { x, y } => x < view.width && y < view.height,
        };
        if !exists {
            return Err(words::OUTSIDE.into());
        }
        if focus == self.focus {
            return Ok(());
        }
        if self.follows_lesson() {
            self.left_at = self.step();
        }
        let place = Place::of(self.walk(), self.step());
        let mut run = self.record(focus);
        let step = match focus {
            _ if focus == self.open.lesson.focus => Some(self.left_at),
            Focus::Pixel { x, y } => Place::colored(x, y)
                .find(run.walk())
                .or_else(|| place.find(run.walk())),
            _ => place.find(run.walk()),
        };
        run.walk_mut().seek(step.unwrap_or(0));
        self.open.run = run;
        self.focus = focus;
        self.recording += 1;
        self.play = None;
        self.around = super::play::Loop::default();
        self.tree = TreeView::WHOLE;
        let said = self.open.narrated.iter().map(|said| said.step);
        self.narrated = said.filter(|_| self.follows_lesson()).collect();
        Ok(())
    }

    /// Looks at the polygon that is seen at a pixel.
    pub(super) fn look_at_polygon(&mut self, x: u32, y: u32) -> Result<(), Refused> {
        let pixel = self.record(Focus::Pixel { x, y });
        let colored: Query = Place::colored(x, y).query(usize::MAX);
        let seen = query::previous(pixel.walk(), &colored, pixel.walk().len());
        match seen.and_then(|step| pixel.walk().fields(step).get("polygon")) {
            Some(Value::Integer(number)) => self.look_at(Focus::Polygon(number as usize)),
            _ => Err(words::NOTHING_DRAWN_THERE.into()),
        }
    }

    /// The part of the frame that a tag shows.
    pub fn focus_of(&self, tag: Tag) -> Option<Focus> {
        match tag {
            Tag::Pixel { x, y } => Some(Focus::Pixel { x, y }),
            Tag::ScanLine(y) => u32::try_from(y).ok().map(Focus::ScanLine),
            Tag::Polygon(number) => Some(Focus::Polygon(number)),
            _ => None,
        }
    }

    fn record(&self, focus: Focus) -> Run {
        Run::record(
            self.open.stage.clone(),
            self.open.lesson.method,
            focus,
            RecordingLimit::default(),
        )
    }
}

/// What a step is about, in words that another recording knows too.
struct Place {
    kind: &'static str,
    at: Vec<(&'static str, i64)>,
}

impl Place {
    fn of(walk: &dyn Walk, step: usize) -> Self {
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
