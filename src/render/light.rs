//! The light of an enclosure: all form factors, in blocks of rows, and then the solution.

use super::thread_pool::ThreadPool;
use crate::algorithms::enclosure::{Enclosure, Light};
use crate::algorithms::form_factor::Estimated;
use crate::algorithms::radiosity::race::Race;
use crate::algorithms::radiosity::{ChannelUnsolved, Unsolved};
use crate::methods::Setup;
use std::convert::Infallible;
use std::num::NonZeroUsize;
use std::sync::atomic::{AtomicUsize, Ordering};
use web_time::Instant;

/// Blocks of rows for each thread: more than one, as the first rows are longer where a pair counts once.
const BLOCKS: usize = 16;

/// The matrix of an enclosure, computed on `threads` threads where it is not there yet. The same, bit for bit, for any number of them.
///
/// `progress` is called with the rows done and the rows in all. Errors: those of `progress`, which end the work.
pub fn matrix<'a, E: Send>(
    enclosure: &'a Enclosure,
    threads: NonZeroUsize,
    progress: &(impl Fn(usize, usize) -> Result<(), E> + Sync),
) -> Result<&'a [f64], E> {
    matrix_by(enclosure, &ThreadPool::new(threads), progress)
}

/// Σ_j |δF_ij| by row, against the form factors of the automatic choice: none where the method has an estimate of its own, or the matrix is
/// not there yet.
pub fn reference_errors(enclosure: &Enclosure, threads: NonZeroUsize) -> Option<Vec<f64>> {
    let reference = enclosure.form_factors().reference()?;
    let matrix = enclosure.matrix()?;
    let n = enclosure.patches.len();
    let rows = (0..n).collect();
    let difference = |i: usize| {
        let mut row = vec![0.0; n];
        reference.row(i, &mut row);
        let entries = row.iter().zip(&matrix[i * n..(i + 1) * n]);
        Ok::<f64, Infallible>(entries.map(|(right, f)| (right - f).abs()).sum())
    };
    let Ok(errors) = ThreadPool::new(threads).map(rows, difference);
    Some(errors)
}

/// How all solvers do on the scene's enclosure, one after the other on one thread; none where it has no matrix yet.
/// Errors: those of `go_on`, which is asked before each.
pub fn race<E>(
    setup: &Setup,
    go_on: impl Fn() -> Result<(), E>,
) -> Result<Option<Result<Race, Unsolved>>, E> {
    let start = Instant::now();
    let enclosure = setup.enclosure().ok();
    let matrix = enclosure.and_then(|enclosure| Some((enclosure, enclosure.matrix()?)));
    let clock = || start.elapsed().as_secs_f64();
    let race = matrix.map(|(enclosure, matrix)| enclosure.race(matrix, clock, go_on));
    race.transpose()
}

/// The light of an enclosure, or why there is none to be shown.
pub(super) fn light<'a, E: Send>(
    enclosure: &'a Enclosure,
    thread_pool: &ThreadPool,
    progress: &(impl Fn(usize, usize) -> Result<(), E> + Sync),
) -> Result<Result<&'a Light, &'a ChannelUnsolved>, E> {
    matrix_by(enclosure, thread_pool, progress).map(|matrix| enclosure.light(matrix))
}

fn matrix_by<'a, E: Send>(
    enclosure: &'a Enclosure,
    thread_pool: &ThreadPool,
    progress: &(impl Fn(usize, usize) -> Result<(), E> + Sync),
) -> Result<&'a [f64], E> {
    if let Some(matrix) = enclosure.matrix() {
        return Ok(matrix);
    }
    let n = enclosure.patches.len();
    let form_factors = enclosure.form_factors();
    let rows = n.div_ceil(BLOCKS * thread_pool.size()).max(1);
    let mut matrix = vec![0.0; n * n];
    let blocks = matrix.chunks_mut((rows * n).max(1)).enumerate().collect();
    let done = AtomicUsize::new(0);
    let errors = thread_pool.map(blocks, |(index, block): (usize, &mut [f64])| {
        let mut errors = Vec::new();
        for (row, entries) in (index * rows..).zip(block.chunks_mut(n)) {
            errors.extend(form_factors.block(row..row + 1, entries));
            progress(done.fetch_add(1, Ordering::Relaxed) + 1, n)?;
        }
        Ok(errors)
    })?;
    form_factors.complete(&mut matrix);
    // In the order of the rows, whatever the number of threads.
    let row_errors = form_factors.row_errors(&matrix, &errors.concat());
    Ok(enclosure.matrix_or(|| Estimated { matrix, row_errors }))
}
