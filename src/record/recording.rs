//! Events in fixed-size chunks, up to a limit of memory.

use super::{Outline, Recorder, spare};

/// Events a chunk: large enough that a full chunk is rare, small enough that little memory is left unused.
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
pub struct Recording<E: Send + 'static> {
    /// The chunk being written: held here, so that an event is kept with few memory accesses.
    chunk: Chunk<E>,
    /// The chunks before it.
    full: Vec<Chunk<E>>,
    /// Events that may still be kept. An `enter` pays for its `leave` in advance.
    room: usize,
    /// Scopes open that were not kept.
    skipped: usize,
    truncated: bool,
}

/// At most [`CHUNK`] events and their marks.
pub(super) struct Chunk<E> {
    events: Vec<E>,
    marks: Vec<Mark>,
}

impl<E> Chunk<E> {
    pub(super) fn new() -> Self {
        Chunk {
            events: Vec::with_capacity(CHUNK),
            marks: Vec::with_capacity(CHUNK),
        }
    }

    /// There must be room.
    #[inline]
    pub(super) fn push(&mut self, event: impl FnOnce() -> E, mark: Mark) {
        self.events.push(event());
        self.marks.push(mark);
    }

    #[cfg(test)]
    pub(super) fn is_empty(&self) -> bool {
        self.events.is_empty()
    }

    pub(super) fn clear(&mut self) {
        self.events.clear();
        self.marks.clear();
    }

    /// The memory that it takes, empty or full.
    pub(super) fn bytes(&self) -> usize {
        self.events.capacity() * size_of::<E>() + self.marks.capacity() * size_of::<Mark>()
    }
}

impl<E: Send + 'static> Recording<E> {
    pub fn new(limit: RecordingLimit) -> Self {
        Recording {
            chunk: empty_chunk(),
            full: Vec::new(),
            room: limit.events::<E>(),
            skipped: 0,
            truncated: false,
        }
    }

    pub fn len(&self) -> usize {
        self.full.len() * CHUNK + self.chunk.events.len()
    }

    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Whether the limit was met, so that only the beginning of the run was recorded.
    pub fn truncated(&self) -> bool {
        self.truncated
    }

    /// The event of step `step`, which must be below [`Recording::len`].
    pub fn event(&self, step: usize) -> &E {
        &self.chunk_of(step).events[step % CHUNK]
    }

    /// The mark of step `step`, which must be below [`Recording::len`].
    pub fn mark(&self, step: usize) -> Mark {
        self.chunk_of(step).marks[step % CHUNK]
    }

    /// All marks in order.
    pub fn marks(&self) -> impl Iterator<Item = Mark> {
        self.chunks().flat_map(|chunk| chunk.marks.iter().copied())
    }

    /// All events in order.
    pub fn events(&self) -> impl Iterator<Item = &E> {
        self.chunks().flat_map(|chunk| &chunk.events)
    }

    fn chunks(&self) -> impl Iterator<Item = &Chunk<E>> {
        self.full.iter().chain([&self.chunk])
    }

    fn chunk_of(&self, step: usize) -> &Chunk<E> {
        self.full.get(step / CHUNK).unwrap_or(&self.chunk)
    }

    /// Room is made before the event is built, so that it is built in its place.
    #[inline]
    fn push(&mut self, event: impl FnOnce() -> E, mark: Mark) {
        if self.chunk.events.len() == CHUNK {
            self.next_chunk();
        }
        self.chunk.push(event, mark);
    }

    #[cold]
    fn next_chunk(&mut self) {
        self.full
            .push(std::mem::replace(&mut self.chunk, empty_chunk()));
    }

    #[cold]
    fn meet_limit(&mut self) {
        self.truncated = true;
        self.room = 0;
    }
}

/// From a recording that is gone, or new.
fn empty_chunk<E: Send + 'static>() -> Chunk<E> {
    spare::take().unwrap_or_else(Chunk::new)
}

impl<E: Send + 'static> Drop for Recording<E> {
    fn drop(&mut self) {
        let last = std::mem::replace(
            &mut self.chunk,
            Chunk {
                events: Vec::new(),
                marks: Vec::new(),
            },
        );
        spare::keep(self.full.drain(..).chain([last]));
    }
}

impl<E: Send + 'static> Recorder<E> for Recording<E> {
    #[inline]
    fn step(&mut self, event: impl FnOnce() -> E) {
        if self.room == 0 {
            return self.meet_limit();
        }
        self.room -= 1;
        self.push(event, Mark::Step);
    }

    #[inline]
    fn enter(&mut self, event: impl FnOnce() -> E) {
        if self.room < 2 {
            self.skipped += 1;
            return self.meet_limit();
        }
        self.room -= 2;
        self.push(event, Mark::Enter);
    }

    #[inline]
    fn leave(&mut self, event: impl FnOnce() -> E) {
        if self.skipped > 0 {
            self.skipped -= 1;
            return;
        }
        self.push(event, Mark::Leave);
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
}
