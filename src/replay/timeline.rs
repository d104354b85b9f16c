//! The whole of a recorded run: its events, their outline, and checkpoints that make any state a short fold away.

use crate::record::{Event, Field, Fields, Mark, Outline, Recording};
use std::ops::Range;

/// A state that follows from the events alone: the state at a step is the fold of all events up to and including it.
pub trait Fold<E>: Clone {
    fn apply(&mut self, step: usize, event: &E);

    /// Bytes that keeping `self` takes when `before`, an earlier state of the same run, is kept too.
    /// A state with memory behind pointers (a [`Canvas`](super::Canvas), a vector) adds that.
    fn bytes_beyond(&self, _before: &Self) -> usize {
        size_of::<Self>()
    }
}

/// Events between checkpoints in a short run.
const INTERVAL: usize = 1 << 10;

/// The most checkpoints that a timeline keeps.
const MOST_CHECKPOINTS: usize = 1 << 10;

/// The most memory, in bytes, that checkpoints take: beyond it every other one is dropped. Ten million events that write
/// a 640×480 picture of 40 bytes a pixel eight times over, in small polygons, stay below it.
const CHECKPOINT_BYTES: usize = 512 << 20;

/// The most plain steps that count as the heading of a scope, so that a scope of a million steps stays quick to read: enough for
/// the edge table of a textured polygon of 32 corners.
const HEADING: usize = 128;

/// A value, and the step that recorded it.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct RecordedField {
    pub step: usize,
    pub field: Field,
}

/// A recording that can be read at any step, and says what the state was there.
pub struct Timeline<E: Send + 'static, S> {
    recording: Recording<E>,
    outline: Outline,
    /// `checkpoints[c]` is the state before step `c * interval`.
    checkpoints: Vec<S>,
    interval: usize,
}

impl<E: Send + 'static, S: Fold<E>> Timeline<E, S> {
    /// Folds the recording once, from the state `initial` before its first step.
    ///
    /// At most 1024 checkpoints are kept, and at most 512 MiB of them by [`Fold::bytes_beyond`].
    pub fn new(recording: Recording<E>, initial: S) -> Self {
        let mut interval = INTERVAL;
        while recording.len() / interval >= MOST_CHECKPOINTS {
            interval *= 2;
        }
        Self::with_checkpoints(recording, initial, interval, CHECKPOINT_BYTES)
    }

    /// With a checkpoint every `interval` steps, fewer where they would take more than `limit` bytes.
    pub(super) fn with_checkpoints(
        recording: Recording<E>,
        initial: S,
        mut interval: usize,
        limit: usize,
    ) -> Self {
        let outline = Outline::of(&recording);
        let mut state = initial.clone();
        let mut checkpoints = vec![initial];
        let mut bytes = 0;
        for (step, event) in recording.events().enumerate() {
            if step == checkpoints.len() * interval {
                bytes += state.bytes_beyond(&checkpoints[checkpoints.len() - 1]);
                checkpoints.push(state.clone());
                while bytes > limit && checkpoints.len() > 1 {
                    checkpoints = checkpoints.into_iter().step_by(2).collect();
                    interval *= 2;
                    bytes = checkpoints
                        .windows(2)
                        .map(|pair| pair[1].bytes_beyond(&pair[0]))
                        .sum();
                }
            }
            state.apply(step, event);
        }
        Timeline {
            recording,
            outline,
            checkpoints,
            interval,
        }
    }

    /// The state after step `step`, which must be below [`Timeline::len`].
    pub fn state_at(&self, step: usize) -> S {
        let checkpoint = self.checkpoint_before(step);
        let mut state = self.checkpoints[checkpoint / self.interval].clone();
        self.fold(&mut state, checkpoint..step + 1);
        state
    }

    /// The state before the first step.
    pub fn initial(&self) -> &S {
        &self.checkpoints[0]
    }

    /// The first step that the nearest checkpoint leaves to be folded on the way to the state after `step`.
    pub(super) fn checkpoint_before(&self, step: usize) -> usize {
        ((step + 1) / self.interval).min(self.checkpoints.len() - 1) * self.interval
    }

    /// Applies the events of `steps` to the state before them.
    pub(super) fn fold(&self, state: &mut S, steps: Range<usize>) {
        for step in steps {
            state.apply(step, self.event(step));
        }
    }
}

impl<E: Send + 'static, S> Timeline<E, S> {
    /// The number of steps.
    pub fn len(&self) -> usize {
        self.recording.len()
    }

    pub fn is_empty(&self) -> bool {
        self.recording.is_empty()
    }

    /// The event of step `step`, which must be below [`Timeline::len`].
    pub fn event(&self, step: usize) -> &E {
        self.recording.event(step)
    }

    /// All events in order.
    pub fn events(&self) -> impl Iterator<Item = &E> {
        self.recording.events()
    }

    pub fn outline(&self) -> &Outline {
        &self.outline
    }

    /// Whether the recording met its limit, so that the timeline shows only the beginning of the run.
    pub fn truncated(&self) -> bool {
        self.recording.truncated()
    }
}

impl<E: Event, S> Timeline<E, S> {
    /// The heading of `scope`, as far as it lies before `step`: the step that enters it, and the plain steps (128 at most)
    /// that directly follow. Their values hold for every step of the scope.
    pub fn heading(&self, scope: usize, step: usize) -> Range<usize> {
        let most = step.min(scope + 1 + HEADING);
        let end = (scope + 1..most).find(|&inner| {
            self.recording.mark(inner) != Mark::Step || !self.event(inner).holds_on()
        });
        scope..end.unwrap_or(most)
    }

    /// All values known at `step`, each with the step that recorded it: the headings of the scopes around it, from the
    /// outermost to the innermost, then its own. So a later entry of the same name goes before an earlier one.
    /// Nothing comes from a later step.
    pub fn recorded(&self, step: usize) -> Vec<RecordedField> {
        let mut scopes: Vec<usize> = self.outline.scopes(step).collect();
        scopes.reverse();
        let headings = scopes
            .into_iter()
            .flat_map(|scope| self.heading(scope, step));
        let mut recorded = Vec::new();
        let mut fields = Fields::default();
        for source in headings.chain([step]) {
            fields.0.clear();
            self.event(source).fields(&mut fields);
            recorded.extend(fields.iter().map(|&field| RecordedField {
                step: source,
                field,
            }));
        }
        recorded
    }

    /// The values of [`Timeline::recorded`], without where they came from.
    pub fn fields(&self, step: usize) -> Fields {
        Fields(
            self.recorded(step)
                .into_iter()
                .map(|recorded| recorded.field)
                .collect(),
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::record::{Recorder, RecordingLimit};
    use crate::replay::generators::{History, Note, Trace, trace};
    use proptest::prelude::*;

    fn plain_fold(recording: &Recording<Note>, step: usize) -> History {
        History((0..=step).map(|i| (i, *recording.event(i))).collect())
    }

    proptest! {
        #[test]
        fn a_state_is_the_fold_of_all_events_up_to_it(trace in trace(), interval in 1_usize..9, limit in 0_usize..2000) {
            let recording = trace.recording();
            let timeline = Timeline::with_checkpoints(trace.recording(), History::default(), interval, limit);
            prop_assert_eq!(timeline.initial(), &History::default());
            for step in 0..recording.len() {
                prop_assert_eq!(timeline.state_at(step), plain_fold(&recording, step));
            }
            let kept: usize = timeline.checkpoints.iter().map(|state| state.0.len()).sum();
            prop_assert!(kept <= limit);
        }

        #[test]
        fn scopes_balance_and_contain_each_other(trace in trace()) {
            let timeline = Timeline::new(trace.recording(), History::default());
            let outline = timeline.outline();
            for step in 0..timeline.len() {
                prop_assert!(outline.last(step) >= step);
                prop_assert_eq!(outline.opens(step), timeline.recording.mark(step) == Mark::Enter);
                for scope in outline.scopes(step) {
                    prop_assert!(scope < step && outline.last(scope) >= outline.last(step));
                }
            }
        }

        #[test]
        fn what_is_recorded_comes_from_the_step_and_the_headings_around_it(trace in trace()) {
            let timeline = Timeline::new(trace.recording(), History::default());
            let mark = |step| timeline.recording.mark(step);
            for step in 0..timeline.len() {
                let recorded = timeline.recorded(step);
                prop_assert!(recorded.iter().all(|recorded| recorded.step <= step));
                prop_assert!(recorded.is_sorted_by_key(|recorded| recorded.step));
                // A step's values hold at `step` when it is that step, or heads a scope that is still open there.
                let mut sources = Vec::new();
                let mut open: Vec<Vec<usize>> = Vec::new();
                let mut heads = false;
                for i in 0..=step {
                    if i == step {
                        sources = open.concat();
                        sources.push(i);
                    }
                    match mark(i) {
                        Mark::Step if heads => open.last_mut().expect("a scope").push(i),
                        Mark::Step => {}
                        Mark::Enter => open.push(vec![i]),
                        Mark::Leave => drop(open.pop()),
                    }
                    heads = mark(i) == Mark::Enter || mark(i) == Mark::Step && heads;
                }
                let mut expected = Vec::new();
                for i in sources {
                    let mut fields = Fields::default();
                    timeline.event(i).fields(&mut fields);
                    expected.extend(fields.0.into_iter().map(|field| RecordedField { step: i, field }));
                }
                prop_assert_eq!(recorded, expected);
            }
        }
    }

    #[test]
    fn a_leave_and_a_late_step_know_the_heading_but_not_what_came_between() {
        //                                   0123456789
        let timeline = Timeline::new(Trace::parse("(.(..).)").recording(), History::default());
        let sources = |step| {
            let mut steps: Vec<usize> = timeline
                .recorded(step)
                .iter()
                .map(|recorded| recorded.step)
                .collect();
            steps.dedup();
            steps
        };
        // Note(0) has no values, so step 0 is silent.
        assert_eq!(sources(4), [1, 2, 3, 4]);
        assert_eq!(sources(5), [1, 2, 3, 4, 5]);
        assert_eq!(sources(6), [1, 6]);
        assert_eq!(sources(7), [1, 7]);
        assert_eq!(sources(1), [1]);
    }

    #[test]
    fn a_long_heading_is_cut() {
        let text = format!("({})", ".".repeat(200));
        let timeline = Timeline::new(Trace::parse(&text).recording(), History::default());
        assert_eq!(timeline.heading(0, 10), 0..10);
        assert_eq!(timeline.heading(0, 150), 0..129);
    }

    #[test]
    fn nothing_recorded_is_a_timeline_too() {
        let timeline = Timeline::new(Trace::parse("").recording(), History::default());
        assert!(timeline.is_empty() && !timeline.truncated());
        assert_eq!(timeline.initial(), &History::default());
    }

    #[test]
    fn a_long_run_keeps_few_checkpoints() {
        #[derive(Clone)]
        struct Count(usize);
        impl Fold<u8> for Count {
            fn apply(&mut self, step: usize, _: &u8) {
                assert_eq!(step, self.0);
                self.0 += 1;
            }
        }
        let mut recording = Recording::new(RecordingLimit::default());
        (0..3_000_000).for_each(|_| recording.step(|| 0));
        let timeline = Timeline::new(recording, Count(0));
        assert!((512..=MOST_CHECKPOINTS).contains(&timeline.checkpoints.len()));
        for step in [0, 1023, 1024, 4095, 4096, 2_222_222, 2_999_999] {
            assert_eq!(timeline.state_at(step).0, step + 1);
        }
    }
}
