//! Work that nobody waits for: on a thread of its own; in a page, which has none, between two frames.

/// A piece of work. In a page it holds up a frame, so it should be small; where it is cancelled, it ends within milliseconds.
pub type Job = Box<dyn FnOnce() + Send>;

/// Does one job after the other.
#[cfg(not(target_arch = "wasm32"))]
pub fn in_background(name: &str, jobs: Vec<Job>) {
    use std::sync::{Arc, Mutex, PoisonError};
    use std::thread;

    let jobs = Arc::new(Mutex::new(jobs));
    let work = {
        let jobs = jobs.clone();
        move || {
            let jobs = std::mem::take(&mut *jobs.lock().unwrap_or_else(PoisonError::into_inner));
            jobs.into_iter().for_each(|job| job());
        }
    };
    let thread = thread::Builder::new().name(name.to_owned());
    // Where there are no threads left, at once.
    if thread.spawn(work.clone()).is_err() {
        work();
    }
}

#[cfg(target_arch = "wasm32")]
pub use page::{do_next, in_background};

#[cfg(target_arch = "wasm32")]
mod page {
    use super::Job;
    use std::cell::RefCell;
    use std::collections::VecDeque;

    thread_local! {
        static JOBS: RefCell<VecDeque<Job>> = RefCell::default();
    }

    /// Does one job after the other, one a frame.
    pub fn in_background(_: &str, jobs: Vec<Job>) {
        JOBS.with_borrow_mut(|all| all.extend(jobs));
    }

    /// Does the next job, and says whether there was one.
    pub fn do_next() -> bool {
        let job = JOBS.with_borrow_mut(VecDeque::pop_front);
        job.map(|job| job()).is_some()
    }
}
