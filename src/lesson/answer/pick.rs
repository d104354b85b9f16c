//! A thing of the scene: one of its objects, or nothing where a ray may meet none; or a patch of the room.

use super::Answer;
use crate::algorithms::focus::Focus;
use crate::language::{Language, Message};
use crate::panels::{object_name, patch_name, strings};
use crate::record::Value;
use crate::replay::Run;

const NOTHING: Message = Message("pick-nothing");

/// What is picked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Thing {
    Object,
    Patch,
}

impl Thing {
    /// What the numbers under a field's name count in `run`.
    fn of_field(run: &Run, field: &str) -> Option<Thing> {
        match field {
            "object" | "blocker" => Some(Thing::Object),
            "i" | "j" => run.enclosure().map(|_| Thing::Patch),
            _ => None,
        }
    }

    /// The names of all such things, by number and language.
    fn names(self, run: &Run) -> Vec<[String; 2]> {
        let prepared = run.prepared();
        let called =
            |name: &dyn Fn(Language) -> String| [Language::English, Language::Indonesian].map(name);
        match (self, run.enclosure()) {
            (Thing::Object, _) => (0..prepared.scene.objects.len() as u32)
                .map(|object| called(&|language| object_name(prepared, object, language).into()))
                .collect(),
            (Thing::Patch, Some(room)) => (0..room.patches.len())
                .map(|patch| {
                    called(&|language| {
                        let number = strings::focus(Focus::Patch(patch as u32), language);
                        let name = patch_name(prepared, room, patch, language);
                        format!("{number}, {name}")
                    })
                })
                .collect(),
            (Thing::Patch, None) => Vec::new(),
        }
    }
}

/// The thing whose number `step` records under `field`, by itself: what the scopes around it recorded is another thing.
pub(in crate::lesson) fn read(run: &Run, step: usize, field: &str) -> Result<Answer, String> {
    let thing = Thing::of_field(run, field).ok_or_else(|| {
        let patches = match run.enclosure() {
            Some(_) => ", `i` and `j`",
            None => "",
        };
        format!(
            "`{field}` counts neither objects nor patches; allowed are `object`, `blocker`{patches}"
        )
    })?;
    let mut names = thing.names(run);
    let fields = run.walk().own_fields(step);
    let nothing = names.len();
    // Whether a ray that meets nothing is a step of this kind too, and whether this is one.
    let (may_be_nothing, is_nothing) = match (run.walk().kind(step), field) {
        ("Found", "object") => (true, fields.get("met") == Some(Value::Word("nothing"))),
        ("Shadow", "blocker") => (true, fields.get("blocked") == Some(Value::Truth(false))),
        _ => (false, false),
    };
    if may_be_nothing {
        names.push(
            [Language::English, Language::Indonesian]
                .map(|language| NOTHING.text(language).to_owned()),
        );
    }
    let right = match fields.get(field) {
        Some(Value::Integer(number)) => usize::try_from(number).ok(),
        _ => is_nothing.then_some(nothing),
    };
    let right = right.filter(|&number| number < names.len());
    let right = right.ok_or_else(|| {
        format!(
            "the step of the answer, {}, does not record `{field}`",
            run.walk().kind(step)
        )
    })?;
    Ok(Answer::Pick {
        thing,
        names,
        right,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lesson::builtin;

    /// The answer at the first step of that kind of a lesson's run.
    fn answer(lesson: &str, kind: &str, field: &str) -> Result<Answer, String> {
        let open = builtin(lesson).unwrap().read().unwrap().open().unwrap();
        let walk = open.run.walk();
        let step = (0..walk.len()).find(|&step| walk.kind(step) == kind);
        read(&open.run, step.unwrap(), field)
    }

    #[test]
    fn things_are_called_by_their_names() {
        let object = answer("shadows", "Shadow", "blocker").unwrap();
        assert_eq!(object.in_words(Language::English), "large ball");
        assert_eq!(object.in_words(Language::Indonesian), "bola besar");
        let patch = answer("shooting", "Received", "j").unwrap();
        assert_eq!(patch.in_words(Language::English), "patch 0, lamp");
    }

    #[test]
    fn a_ray_may_meet_nothing() {
        let lesson = builtin("shadows").unwrap().read().unwrap();
        let run = lesson.open().unwrap().run;
        let walk = run.walk();
        let clear = |&step: &usize| {
            walk.kind(step) == "Shadow"
                && walk.own_fields(step).get("blocked") == Some(Value::Truth(false))
        };
        let step = (0..walk.len()).find(clear).unwrap();
        let answer = read(&run, step, "blocker").unwrap();
        assert_eq!(answer.in_words(Language::English), "nothing");
        assert_eq!(answer.in_words(Language::Indonesian), "tidak ada");
        // Of patches one always shoots.
        let patch = self::answer("shooting", "Received", "j").unwrap();
        let Answer::Pick { names, .. } = patch else {
            panic!("a patch")
        };
        assert!(names.iter().all(|[name, _]| name != "nothing"));
    }

    #[test]
    fn a_field_that_is_no_thing_or_not_recorded_is_refused() {
        assert_eq!(
            answer("shadows", "Shadow", "i").unwrap_err(),
            "`i` counts neither objects nor patches; allowed are `object`, `blocker`"
        );
        assert_eq!(
            answer("shooting", "Received", "k").unwrap_err(),
            "`k` counts neither objects nor patches; allowed are `object`, `blocker`, `i` and `j`"
        );
        // The scope around the step records the object that the ray met.
        assert_eq!(
            answer("shadows", "Shadow", "object").unwrap_err(),
            "the step of the answer, Shadow, does not record `object`"
        );
    }
}
