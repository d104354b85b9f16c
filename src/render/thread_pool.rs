//! The threads that work on one picture.

use std::num::NonZeroUsize;

/// Threads that take work item by item, whoever is free the next one; without the feature `parallel`, the caller's alone.
pub struct ThreadPool {
    #[cfg(feature = "parallel")]
    pool: Option<rayon::ThreadPool>,
}

#[cfg(feature = "parallel")]
impl ThreadPool {
    /// Where no more threads can be had, the caller's does all the work.
    pub fn new(threads: NonZeroUsize) -> Self {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads.get());
        ThreadPool {
            pool: (threads.get() > 1).then(|| pool.build().ok()).flatten(),
        }
    }

    /// How many work at a time.
    pub fn size(&self) -> usize {
        let threads = self
            .pool
            .as_ref()
            .map(rayon::ThreadPool::current_num_threads);
        threads.unwrap_or(1)
    }

    /// Works on every item; the results stand in the order of the items. After an error no more items are begun.
    pub fn map<T: Send, R: Send, E: Send>(
        &self,
        items: Vec<T>,
        work: impl Fn(T) -> Result<R, E> + Send + Sync,
    ) -> Result<Vec<R>, E> {
        use rayon::prelude::*;
        match &self.pool {
            Some(pool) => pool.install(|| {
                let one_by_one = items.into_par_iter().with_max_len(1);
                one_by_one.map(work).collect()
            }),
            None => items.into_iter().map(work).collect(),
        }
    }
}

#[cfg(not(feature = "parallel"))]
impl ThreadPool {
    pub fn new(_: NonZeroUsize) -> Self {
        ThreadPool {}
    }

    pub fn size(&self) -> usize {
        1
    }

    /// Works on every item; the results stand in the order of the items. After an error no more items are begun.
    pub fn map<T, R, E>(
        &self,
        items: Vec<T>,
        work: impl Fn(T) -> Result<R, E>,
    ) -> Result<Vec<R>, E> {
        items.into_iter().map(work).collect()
    }
}
