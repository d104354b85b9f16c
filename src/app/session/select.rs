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
    looked: Looked,
}

/// Where the step of a thing was looked for already, so that it need not be again after a move: of the steps from `from` up to, but
/// without, `to` none but the one that was found is about it, which is the first.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Looked {
    recording: u64,
    from: usize,
    to: usize,
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
        let Some(Selected { tag, step, .. }) = self.selected else {
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
        let new = self.look_for(tag, None);
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
        if let Some(before) = self.selected.take() {
            self.selected = Some(self.look_for(before.tag, Some(before)));
        }
    }

    /// What a tag shows with the step that is about it: the last one so far. `before` was found when the run stood at another step.
    fn look_for(&self, tag: Tag, before: Option<Selected>) -> Selected {
        let walk = self.walk();
        let step = match tag {
            Tag::Step(step) | Tag::Scope(step) => Some(step).filter(|&step| step < walk.len()),
            Tag::Pixel { x, y } => {
                let canvas = self.open.run.canvas();
                let step = canvas.and_then(|canvas| canvas.get(x as usize, y as usize)?.step);
                step.map(|step| step as usize)
            }
            Tag::Field(name) => {
                let recorded = walk.recorded(self.inspected());
                let value = recorded.iter().rfind(|value| value.field.name == name);
                value.map(|value| value.step)
            }
            _ => return self.look_for_thing(tag, before),
        };
        Selected {
            tag,
            step,
            looked: Looked::default(),
        }
    }

    fn look_for_thing(&self, tag: Tag, before: Option<Selected>) -> Selected {
        let before = before.filter(|before| before.looked.recording == self.recording);
        let step = before.and_then(|before| before.step);
        let Looked { from, to, .. } = before.map(|before| before.looked).unwrap_or_default();
        let in_room = self.open.run.enclosure().is_some();
        let is_about = |&step: &usize| is_about(self.walk(), step, tag, in_room);
        let (least, end) = (self.step().saturating_sub(FAR), self.step() + 1);
        let behind = || (least.max(to)..end).rev().find(is_about);
        let known = || step.filter(|step| (least..end).contains(step));
        let in_front = || (least..end.min(from)).rev().find(is_about);
        let step = behind().or_else(known).or_else(in_front);
        Selected {
            tag,
            step,
            looked: Looked {
                recording: self.recording,
                from: step.unwrap_or(least),
                to: end,
            },
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
        let step = self.look_for(tag, None).step.or_else(ahead);
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lesson::builtin;

    #[test]
    fn wherever_the_run_goes_the_last_step_about_a_thing_is_found_as_if_all_were_looked_through() {
        let lesson = builtin("gouraud-triangle").unwrap().read().unwrap();
        let mut session = Session::new(lesson).unwrap();
        session.update(Command::Questions).unwrap();
        let last = session.last_step();
        let mut found = 0;
        for tag in [Tag::Vertex(1), Tag::Edge(0), Tag::Edge(2), Tag::Edge(99)] {
            session.seek(last / 2);
            session.select(tag);
            let far_apart = (0..60).map(|i| i * 7919 % (last + 1));
            let one_by_one = (last / 3..last / 3 + 30).chain((0..last / 3).rev().take(30));
            for step in far_apart.chain(one_by_one) {
                session.seek(step);
                let mut steps = (0..=step).rev();
                let expected = steps.find(|&step| is_about(session.walk(), step, tag, false));
                assert_eq!(session.selected_step(), expected, "{tag:?} at {step}");
                found += usize::from(expected.is_some());
            }
            session.select(tag);
        }
        assert!(found > 100, "{found} steps were found");
    }
}
