//! Standing at one step of a run, and walking from there.

use super::moves::Move;
use super::{Fold, RecordedField, Timeline};
use crate::record::{Event, Fields, Line, Outline};
use crate::vocabulary::{Declared, Kind};
use std::ops::Range;

/// A timeline, the step at which it is looked at, and the state there.
///
/// Invariant: the state is the fold of the events 0..=position; with nothing recorded, it is the initial one.
pub struct Replay<E: Send + 'static, S> {
    timeline: Timeline<E, S>,
    position: usize,
    state: S,
}

impl<E: Send + 'static, S: Fold<E>> Replay<E, S> {
    /// Stands at the first step.
    pub fn new(timeline: Timeline<E, S>) -> Self {
        let mut state = timeline.initial().clone();
        timeline.fold(&mut state, 0..timeline.len().min(1));
        Replay {
            timeline,
            position: 0,
            state,
        }
    }

    /// Goes to `step`, or to the last step where it lies beyond. Folds on from here where that is nearer than a
    /// checkpoint: one step forward applies one event.
    pub fn seek(&mut self, step: usize) {
        let step = step.min(self.timeline.len().saturating_sub(1));
        if step == self.position {
            return;
        }
        if step > self.position && self.timeline.checkpoint_before(step) <= self.position + 1 {
            self.timeline
                .fold(&mut self.state, self.position + 1..step + 1);
        } else {
            self.state = self.timeline.state_at(step);
        }
        self.position = step;
    }

    pub fn position(&self) -> usize {
        self.position
    }

    /// The state after the event at [`Replay::position`].
    pub fn state(&self) -> &S {
        &self.state
    }

    /// The event at [`Replay::position`]; none where nothing was recorded.
    pub fn event(&self) -> Option<&E> {
        (!self.timeline.is_empty()).then(|| self.timeline.event(self.position))
    }

    pub fn timeline(&self) -> &Timeline<E, S> {
        &self.timeline
    }
}

/// A replay of any algorithm, for panels, commands and lessons that need not know which.
///
/// A `step` handed in must be below `len()`, except to `seek`, which clamps.
pub trait Walk {
    /// The number of steps.
    fn len(&self) -> usize;
    fn position(&self) -> usize;
    /// Goes to `step`, or to the last step where it lies beyond.
    fn seek(&mut self, step: usize);
    fn outline(&self) -> &Outline;
    /// Whether the recording met its limit, so that only the beginning of the run is shown.
    fn truncated(&self) -> bool;
    /// What is declared of the kind of event at `step`.
    fn declared(&self, step: usize) -> &'static Kind;
    /// The name of the event at `step`.
    fn kind(&self, step: usize) -> &'static str;
    /// The line of pseudocode that `step` carries out.
    fn line(&self, step: usize) -> Line;
    /// Appends the own values of the event at `step`.
    fn push_fields(&self, step: usize, fields: &mut Fields);
    /// See [`Timeline::heading`].
    fn heading(&self, scope: usize, step: usize) -> Range<usize>;
    /// All values known at `step`, each with where it came from; see [`Timeline::recorded`].
    fn recorded(&self, step: usize) -> Vec<RecordedField>;

    fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The own values of the event at `step`.
    fn own_fields(&self, step: usize) -> Fields {
        let mut fields = Fields::default();
        self.push_fields(step, &mut fields);
        fields
    }

    /// All values known at `step`.
    fn fields(&self, step: usize) -> Fields {
        Fields(
            self.recorded(step)
                .into_iter()
                .map(|recorded| recorded.field)
                .collect(),
        )
    }

    /// Where a move ([`over`](super::moves::over), …) leads from here; `None` where it cannot act.
    fn target(&self, go: Move) -> Option<usize> {
        (!self.is_empty())
            .then(|| go(self.outline(), self.position()))
            .flatten()
    }
}

impl<E: Event + Declared, S: Fold<E>> Walk for Replay<E, S> {
    fn declared(&self, step: usize) -> &'static Kind {
        Declared::kind(self.timeline.event(step))
    }

    fn len(&self) -> usize {
        self.timeline.len()
    }
    fn position(&self) -> usize {
        self.position
    }
    fn seek(&mut self, step: usize) {
        Replay::seek(self, step);
    }
    fn outline(&self) -> &Outline {
        self.timeline.outline()
    }
    fn truncated(&self) -> bool {
        self.timeline.truncated()
    }
    fn kind(&self, step: usize) -> &'static str {
        Event::kind(self.timeline.event(step))
    }
    fn line(&self, step: usize) -> Line {
        self.timeline.event(step).line()
    }
    fn push_fields(&self, step: usize, fields: &mut Fields) {
        self.timeline.event(step).fields(fields);
    }
    fn heading(&self, scope: usize, step: usize) -> Range<usize> {
        self.timeline.heading(scope, step)
    }
    fn recorded(&self, step: usize) -> Vec<RecordedField> {
        self.timeline.recorded(step)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::replay::generators::{History, Note, Trace, trace};
    use crate::replay::moves;
    use proptest::prelude::*;
    use proptest::sample::Index;

    proptest! {
        #[test]
        fn seeking_in_any_order_finds_the_state_of_the_timeline(
            trace in trace(),
            steps in prop::collection::vec(any::<Index>(), 0..60),
            interval in 1_usize..20,
        ) {
            let timeline = Timeline::with_checkpoints(trace.recording(), History::default(), interval, usize::MAX);
            let mut replay = Replay::new(timeline);
            for step in steps {
                let len = replay.timeline().len();
                let step = step.index(len + 2);
                replay.seek(step);
                prop_assert_eq!(replay.position(), step.min(len.saturating_sub(1)));
                if len == 0 {
                    prop_assert_eq!(replay.state(), &History::default());
                } else {
                    prop_assert_eq!(replay.state(), &replay.timeline().state_at(replay.position()));
                }
            }
        }

        #[test]
        fn a_walk_knows_what_the_timeline_knows(trace in trace()) {
            let replay = Replay::new(Timeline::new(trace.recording(), History::default()));
            let walk: &dyn Walk = &replay;
            prop_assert_eq!(walk.truncated(), trace.recording().truncated());
            for step in 0..walk.len() {
                let event = replay.timeline().event(step);
                prop_assert_eq!((walk.kind(step), walk.line(step)), (Event::kind(event), event.line()));
                prop_assert_eq!(walk.fields(step), replay.timeline().fields(step));
                prop_assert!(walk.recorded(step).iter().filter(|recorded| recorded.step == step).map(|recorded| &recorded.field)
                    .eq(walk.own_fields(step).iter()));
            }
        }
    }

    #[derive(Clone, Default)]
    struct Applied(usize);

    impl Fold<Note> for Applied {
        fn apply(&mut self, step: usize, _: &Note) {
            // Counts the events applied to this very copy, and not those that it was copied with.
            assert!(step < 5000);
            self.0 += 1;
        }
    }

    #[test]
    fn one_step_forward_applies_one_event() {
        let trace = Trace::parse(&".".repeat(5000));
        let mut replay = Replay::new(Timeline::new(trace.recording(), Applied::default()));
        replay.seek(3000);
        replay.state.0 = 0;
        replay.seek(3001);
        assert_eq!(replay.state.0, 1);
        // 3071 is as far as the fold from here is nearer than the checkpoint after it.
        replay.seek(3070);
        assert_eq!(replay.state.0, 70);
        replay.seek(3071);
        assert_eq!(replay.state.0, 3072);
    }

    #[test]
    fn moves_lead_through_a_run() {
        let mut replay = Replay::new(Timeline::new(
            Trace::parse("(.(.).)").recording(),
            History::default(),
        ));
        let walk: &mut dyn Walk = &mut replay;
        for (step, go, target) in [
            (0, moves::into as Move, Some(1)),
            (2, moves::over, Some(5)),
            (5, moves::out, Some(6)),
            (6, moves::into, None),
        ] {
            walk.seek(step);
            assert_eq!(walk.target(go), target, "from {step}");
        }
    }

    #[test]
    fn nothing_recorded_can_be_stood_at() {
        let mut replay = Replay::new(Timeline::new(
            Trace::parse("").recording(),
            History::default(),
        ));
        let walk: &mut dyn Walk = &mut replay;
        walk.seek(7);
        assert!(walk.is_empty() && walk.position() == 0);
        for go in [moves::into, moves::over, moves::out] {
            assert_eq!(walk.target(go), None);
        }
        assert!(replay.event().is_none());
    }
}
