//! Chunks of recordings that are gone, kept for the recordings to come: fresh pages cost more than the events written to them.

use super::recording::Chunk;
use std::any::Any;
use std::collections::VecDeque;
use std::sync::{Mutex, PoisonError};

/// 128 MiB: enough for a whole recorded frame of almost two million events of 64 bytes.
static SPARE: Mutex<Spare> = Mutex::new(Spare::new(128 << 20));

/// Empty chunks with their sizes in bytes, each for one type of event, the oldest first.
struct Spare {
    chunks: VecDeque<(usize, Box<dyn Any + Send>)>,
    bytes: usize,
    max_bytes: usize,
}

impl Spare {
    const fn new(max_bytes: usize) -> Self {
        Spare {
            chunks: VecDeque::new(),
            bytes: 0,
            max_bytes,
        }
    }

    fn take<E: Send + 'static>(&mut self) -> Option<Chunk<E>> {
        let index = (self.chunks.iter()).rposition(|(_, chunk)| chunk.is::<Chunk<E>>())?;
        let (bytes, chunk) = self.chunks.remove(index)?;
        self.bytes -= bytes;
        chunk.downcast().ok().map(|chunk| *chunk)
    }

    fn keep<E: Send + 'static>(&mut self, mut chunk: Chunk<E>) {
        chunk.clear();
        let bytes = chunk.bytes();
        self.bytes += bytes;
        self.chunks.push_back((bytes, Box::new(chunk)));
        while self.bytes > self.max_bytes
            && let Some((bytes, _)) = self.chunks.pop_front()
        {
            self.bytes -= bytes;
        }
    }
}

/// A chunk for events of type `E`, of a recording that is gone.
pub(super) fn take<E: Send + 'static>() -> Option<Chunk<E>> {
    SPARE.lock().unwrap_or_else(PoisonError::into_inner).take()
}

/// Empties and keeps the chunks of a recording that goes; beyond the limit the oldest chunks are freed.
pub(super) fn keep<E: Send + 'static>(chunks: impl Iterator<Item = Chunk<E>>) {
    let mut spare = SPARE.lock().unwrap_or_else(PoisonError::into_inner);
    chunks.for_each(|chunk| spare.keep(chunk));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_chunk_comes_back_empty_and_for_its_own_type_of_event() {
        let mut spare = Spare::new(usize::MAX);
        let mut chunk = Chunk::<u32>::new();
        chunk.push(|| 7, crate::record::Mark::Step);
        spare.keep(chunk);
        assert!(spare.take::<f32>().is_none());
        assert!(spare.take::<u32>().is_some_and(|chunk| chunk.is_empty()));
        assert!(spare.take::<u32>().is_none());
        assert_eq!(spare.bytes, 0);
    }

    #[test]
    fn beyond_the_limit_the_oldest_chunks_go() {
        let mut spare = Spare::new(2 * Chunk::<u64>::new().bytes());
        spare.keep(Chunk::<u32>::new());
        spare.keep(Chunk::<u64>::new());
        assert_eq!(spare.chunks.len(), 2);
        spare.keep(Chunk::<u64>::new());
        assert_eq!(spare.bytes, spare.max_bytes);
        assert!(spare.take::<u32>().is_none());
    }
}
