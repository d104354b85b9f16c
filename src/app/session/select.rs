//! What a click selects: it lights up in all panels with what belongs to it, and the inspector has its values. The step stays; going
//! there is a second action.

use super::{Command, Refused, Session};
use crate::algorithms::focus::Focus;
use crate::app::strings;
use crate::language::Message;
use crate::picture::Tag;
use crate::record::{Fields, Value};
use crate::replay::{Run, Walk};

/// How far back the step of a thing is looked for.
const FAR: usize = 20_000;

/// What is selected, with the step that is about it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Selected {
    tag: Tag,
    step: Option<usize>,
}

impl Session {
    /// The tag that was clicked.
    pub fn selected(&self) -> Option<Tag> {
        self.selected.map(|selected| selected.tag)
    }

    /// The step that is about what is selected, as far as the run has come; a step that was clicked, wherever it is.
    pub fn selected_step(&self) -> Option<usize> {
        self.selected?.step
    }

    /// The step whose values the inspector shows.
    pub fn inspected(&self) -> usize {
        self.selected_step().unwrap_or(self.step())
    }

    /// All that lights up: what is under the pointer, what is selected, and what belongs to them.
    pub fn lit(&self) -> Vec<Tag> {
        let mut lit: Vec<Tag> = self.hovered.into_iter().flat_map(alike).collect();
        let Some(Selected { tag, step }) = self.selected else {
            return lit;
        };
        lit.extend(alike(tag));
        let is_place = matches!(tag, Tag::Step(_) | Tag::Scope(_) | Tag::Pixel { .. });
        if let Some(step) = step.filter(|_| is_place) {
            lit.extend([Tag::Step(step), Tag::Scope(step)]);
            let in_room = self.open.run.enclosure().is_some();
            lit.extend(things(self.walk(), step, in_room));
        }
        lit
    }

    /// The two patches that are selected.
    pub fn pair(&self) -> Option<[usize; 2]> {
        match self.selected()? {
            Tag::FormFactor { i, j } => Some([i, j]),
            _ => None,
        }
    }

    /// Selects what a tag shows; a second time, it is selected no more. After a patch another one makes a pair with it, and the
    /// pixel of a room shows a patch.
    pub(super) fn select(&mut self, tag: Tag) {
        let tag = match tag {
            Tag::Pixel { x, y } => self.patch_at(x, y).map_or(tag, Tag::Patch),
            _ => tag,
        };
        let tag = match (self.selected(), tag) {
            (Some(Tag::Patch(i)), Tag::Patch(j)) if i != j => Tag::FormFactor { i, j },
            _ => tag,
        };
        let step = self.step_of(tag);
        let new = Selected { tag, step };
        let is_selected = self.selected() == Some(tag);
        self.selected = Some(new).filter(|_| !is_selected);
    }

    /// What looks at the form factor between the two patches, step by step.
    pub fn step_by_step(&self) -> Option<Command> {
        let [i, j] = self.pair()?.map(|patch| patch as u32);
        Some(Command::Focus(Focus::FormFactor { i, j }))
    }

    /// Why a form factor cannot be followed; none where it can.
    pub(super) fn cannot_follow(&self, focus: Focus) -> Option<Message> {
        if self.question_at(self.step()) {
            Some(strings::ANSWER_FIRST)
        } else if focus == self.focus {
            Some(strings::FOLLOWED_ALREADY)
        } else if self.setup().check(focus).is_err() {
            Some(strings::OUTSIDE)
        } else {
            None
        }
    }

    /// Whether the solver keeps what patches have still to shoot.
    pub(super) fn has_unshot(&self) -> bool {
        match (&self.open.run, self.open.run.enclosure()) {
            (Run::Radiosity(..), Some(room)) => room.settings.solver.shoots(),
            _ => false,
        }
    }

    /// The patch that a pixel of the picture shows, where the run exchanges light between patches.
    pub fn patch_at(&self, x: u32, y: u32) -> Option<usize> {
        self.open.run.enclosure()?;
        self.setup().patch_at(x, y)
    }

    /// After a move, the step that is about the same thing.
    pub(super) fn select_again(&mut self) {
        let selected = self.selected.take();
        self.selected = selected.map(|Selected { tag, .. }| Selected {
            tag,
            step: self.step_of(tag),
        });
    }

    /// The step that is about what a tag shows: the last one so far.
    fn step_of(&self, tag: Tag) -> Option<usize> {
        let walk = self.walk();
        match tag {
            Tag::Step(step) | Tag::Scope(step) => Some(step).filter(|&step| step < walk.len()),
            Tag::Pixel { x, y } => {
                let dot = self.open.run.canvas()?.get(x as usize, y as usize)?;
                dot.step.map(|step| step as usize)
            }
            Tag::Field(name) => {
                let recorded = walk.recorded(self.inspected());
                let value = recorded.iter().rfind(|value| value.field.name == name)?;
                Some(value.step)
            }
            _ => {
                let here = self.step();
                let in_room = self.open.run.enclosure().is_some();
                let mut before = (here.saturating_sub(FAR)..=here).rev();
                before.find(|&step| is_about(walk, step, tag, in_room))
            }
        }
    }

    /// Goes to the step that is about what a tag shows.
    pub(super) fn go_to_thing(&mut self, tag: Tag) -> Result<(), Refused> {
        let walk = self.walk();
        let in_room = self.open.run.enclosure().is_some();
        let ahead = || {
            let mut ahead = self.step() + 1..walk.len();
            ahead.find(|&step| is_about(walk, step, tag, in_room))
        };
        let step = self.step_of(tag).or_else(ahead);
        self.go_to(step.ok_or(strings::NOT_FOUND)?)
    }
}

/// Tags that light up together: a step and the scope that it opens, a form factor and its two patches.
fn alike(tag: Tag) -> Vec<Tag> {
    match tag {
        Tag::Step(step) => vec![tag, Tag::Scope(step)],
        Tag::Scope(step) => vec![tag, Tag::Step(step)],
        Tag::FormFactor { i, j } => vec![tag, Tag::Patch(i), Tag::Patch(j)],
        _ => vec![tag],
    }
}

/// Whether a step is about a thing: it records the thing's number itself.
fn is_about(walk: &dyn Walk, step: usize, tag: Tag, in_room: bool) -> bool {
    things(walk, step, in_room).contains(&tag)
}

/// The things whose numbers a step records; of a pair, one of the numbers may be that of a scope around it.
fn things(walk: &dyn Walk, step: usize, in_room: bool) -> Vec<Tag> {
    let own = walk.own_fields(step);
    let number = |fields: &Fields, name: &str| match fields.get(name) {
        Some(Value::Integer(number)) => usize::try_from(number).ok(),
        _ => None,
    };
    let named = |name, tag: fn(usize) -> Tag| number(&own, name).map(tag);
    let single = [
        named("polygon", Tag::Polygon),
        named("edge", Tag::Edge),
        named("light", Tag::Light),
        named("vertex", |number| Tag::Vertex(number as u32)),
    ];
    let pair = |names: [&str; 2]| {
        let is_own = names.iter().any(|name| own.get(name).is_some());
        let all = is_own.then(|| walk.fields(step))?;
        Some([number(&all, names[0])?, number(&all, names[1])?])
    };
    let pixel = pair(["x", "y"]).map(|[x, y]| Tag::Pixel {
        x: x as u32,
        y: y as u32,
    });
    let mut things: Vec<Tag> = single.into_iter().chain([pixel]).flatten().collect();
    if in_room {
        let patches = ["i", "j"].into_iter().filter_map(|name| number(&own, name));
        things.extend(patches.map(Tag::Patch));
        things.extend(pair(["i", "j"]).map(|[i, j]| Tag::FormFactor { i, j }));
    }
    things
}
