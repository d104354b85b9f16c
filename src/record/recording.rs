//! Events in fixed-size chunks, up to a limit of memory, in pages that the next run uses again.

use super::{Outline, Recorder};

/// Events a chunk: large enough that a full chunk is rare, small enough that little lies unused.
const CHUNK: usize = 1 << 14;

/// What an event was to the scopes around it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[repr(u8)]
pub enum Mark {
    Step,
    Enter,
    Leave,
}

/// The most memory, in bytes, that a recording and its outline may take. Checkpoints have a limit of their own.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct RecordingLimit(pub usize);

impl Default for RecordingLimit {
    /// 512 MiB: above the whole recorded frame of every lesson.
    fn default() -> Self {
        RecordingLimit(512 << 20)
    }
}

impl RecordingLimit {
    /// How many events of type `E` fit, their outline included.
    pub fn events<E>(self) -> usize {
        (self.0 / (size_of::<E>() + size_of::<Mark>() + Outline::BYTES_AN_EVENT))
            .min(u32::MAX as usize - 1)
    }
}

/// A recorder that keeps every event, until its limit is met; from there on only the scopes already open are closed.
///
/// Invariant: the marks kept are always balanced once the run has ended.
pub struct Recording<E> {
    events: Vec<Vec<E>>,
    marks: Vec<Vec<Mark>>,
    /// Chunks in use; those behind it are empty and wait to be used again.
    used: usize,
    /// Events that may still be kept. An `enter` pays for its `leave` in advance.
    room: usize,
    /// Scopes open that were not kept.
    skipped: usize,
    truncated: bool,
}

impl<E> Recording<E> {
    pub fn new(limit: RecordingLimit) -> Self {
        Recording {
            events: vec![Vec::with_capacity(CHUNK)],
            marks: vec![Vec::with_capacity(CHUNK)],
            used: 1,
            room: limit.events::<E>(),
            skipped: 0,
            truncated: false,
        }
    }

    /// Empties the recording for another run, and keeps its memory: fresh pages cost more than the events written to them.
    pub fn restart(&mut self, limit: RecordingLimit) {
        self.events.iter_mut().for_each(Vec::clear);
        self.marks.iter_mut().for_each(Vec::clear);
        (self.used, self.room, self.skipped, self.truncated) = (1, limit.events::<E>(), 0, false);
    }

    pub fn len(&self) -> usize {
        (self.used - 1) * CHUNK + self.events[self.used - 1].len()
    }

    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Whether the limit was met, so that the recording tells only the beginning of the run.
    pub fn truncated(&self) -> bool {
        self.truncated
    }

    /// The event of step `step`, which must be below [`Recording::len`].
    pub fn event(&self, step: usize) -> &E {
        &self.events[step / CHUNK][step % CHUNK]
    }

    /// The mark of step `step`, which must be below [`Recording::len`].
    pub fn mark(&self, step: usize) -> Mark {
        self.marks[step / CHUNK][step % CHUNK]
    }

    /// All marks in order.
    pub fn marks(&self) -> impl Iterator<Item = Mark> {
        self.marks[..self.used].iter().flatten().copied()
    }

    /// All events in order.
    pub fn events(&self) -> impl Iterator<Item = &E> {
        self.events[..self.used].iter().flatten()
    }

    #[inline]
    fn push(&mut self, event: E, mark: Mark) {
        if self.events[self.used - 1].len() == CHUNK {
            self.next_chunk();
        }
        self.events[self.used - 1].push(event);
        self.marks[self.used - 1].push(mark);
    }

    #[cold]
    fn next_chunk(&mut self) {
        if self.used == self.events.len() {
            self.events.push(Vec::with_capacity(CHUNK));
            self.marks.push(Vec::with_capacity(CHUNK));
        }
        self.used += 1;
    }

    #[cold]
    fn meet_limit(&mut self) {
        self.truncated = true;
        self.room = 0;
    }
}

impl<E> Recorder<E> for Recording<E> {
    #[inline]
    fn step(&mut self, event: impl FnOnce() -> E) {
        if self.room == 0 {
            return self.meet_limit();
        }
        self.room -= 1;
        self.push(event(), Mark::Step);
    }

    #[inline]
    fn enter(&mut self, event: impl FnOnce() -> E) {
        if self.room < 2 {
            self.skipped += 1;
            return self.meet_limit();
        }
        self.room -= 2;
        self.push(event(), Mark::Enter);
    }

    #[inline]
    fn leave(&mut self, event: impl FnOnce() -> E) {
        if self.skipped > 0 {
            self.skipped -= 1;
            return;
        }
        self.push(event(), Mark::Leave);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_limit_drops_steps_but_closes_every_scope_that_it_kept() {
        let bytes = |events: usize| {
            RecordingLimit(events * (size_of::<u32>() + 1 + Outline::BYTES_AN_EVENT))
        };
        for limit in 0..12 {
            let mut recording = Recording::new(bytes(limit));
            for scope in 0..3_u32 {
                recording.enter(|| scope);
                recording.step(|| 10 + scope);
                recording.enter(|| 20 + scope);
                recording.leave(|| 30 + scope);
                recording.leave(|| 40 + scope);
            }
            assert!(recording.len() <= limit);
            assert!(recording.truncated());
            let open = recording.marks().fold(0_i32, |open, mark| match mark {
                Mark::Step => open,
                Mark::Enter => open + 1,
                Mark::Leave => open - 1,
            });
            assert_eq!(open, 0, "scopes balance at limit {limit}");
        }
    }

    #[test]
    fn a_restarted_recording_is_as_good_as_new() {
        let mut recording = Recording::new(RecordingLimit::default());
        (0..40_000_u32).for_each(|i| recording.step(|| i));
        recording.restart(RecordingLimit::default());
        assert!(recording.is_empty());
        (0..20_000_u32).for_each(|i| recording.step(|| 7 * i));
        assert_eq!(recording.len(), 20_000);
        assert!(
            recording
                .events()
                .enumerate()
                .all(|(i, &event)| event == 7 * i as u32)
        );
        assert_eq!(*recording.event(17_000), 7 * 17_000);
    }
}
