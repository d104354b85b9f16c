//! All form factors of a room, in blocks of rows.

use super::crew::Crew;
use crate::algorithms::room::Room;
use std::num::NonZeroUsize;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Rows are dealt out in so many blocks a thread: the first ones are longer, where a pair counts once.
const BLOCKS: usize = 16;

/// The matrix of a room, made where it is not there yet. The same, bit for bit, for any number of threads.
///
/// `progress` hears how many of how many rows are done. Errors: those of `progress`, which end the work.
pub fn matrix<'a, E: Send>(
    room: &'a Room,
    threads: NonZeroUsize,
    progress: &(impl Fn(usize, usize) -> Result<(), E> + Sync),
) -> Result<&'a [f64], E> {
    if let Some(matrix) = room.matrix() {
        return Ok(matrix);
    }
    let n = room.patches.len();
    let crew = Crew::new(threads);
    let form_factors = room.form_factors();
    let rows = n.div_ceil(BLOCKS * crew.size()).max(1);
    let mut matrix = vec![0.0; n * n];
    let blocks = matrix.chunks_mut((rows * n).max(1)).enumerate().collect();
    let done = AtomicUsize::new(0);
    crew.map(blocks, |(index, block): (usize, &mut [f64])| {
        for (row, entries) in (index * rows..).zip(block.chunks_mut(n)) {
            form_factors.block(row..row + 1, entries);
            progress(done.fetch_add(1, Ordering::Relaxed) + 1, n)?;
        }
        Ok(())
    })?;
    form_factors.complete(&mut matrix);
    Ok(room.matrix_or(|| matrix))
}
