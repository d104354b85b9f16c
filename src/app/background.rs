//! Work that nobody waits for: on a thread of its own; in a page, which has none, between two frames.

use crate::render::Cancelled;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::mpsc::{Receiver, Sender, TryRecvError, channel};

/// Work under way, and what it finds. Dropped, it is cancelled: it ends by itself when it next reports its progress.
pub struct Work<T> {
    /// None once all has arrived.
    found: Option<Receiver<T>>,
    state: Arc<State>,
}

/// The side of the work that does it.
pub struct Worker<T> {
    sender: Sender<T>,
    state: Arc<State>,
}

/// A piece of work. In a page it holds up a frame, so it should be small; where it is cancelled, it ends within milliseconds.
pub type Job<T> = Box<dyn FnOnce(&Worker<T>) + Send>;

/// A job as it is done, a step at a time.
type Step = Box<dyn FnMut() -> Stage + Send>;

/// What a step has left.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Stage {
    Unfinished,
    Done,
    /// Nothing was done: it is not wanted any more.
    Cancelled,
}

/// What both sides share.
#[derive(Default)]
struct State {
    cancelled: AtomicBool,
    percent: AtomicUsize,
}

impl<T: Send + 'static> Work<T> {
    /// Begins it on a thread of that name.
    pub fn begin(name: &str, job: impl FnOnce(&Worker<T>) + Send + 'static) -> Self {
        Work::begin_all(name, vec![Box::new(job)])
    }

    /// Does one job after the other.
    pub fn begin_all(name: &str, jobs: Vec<Job<T>>) -> Self {
        let (work, worker) = Work::pair();
        let worker = Arc::new(worker);
        let jobs = jobs.into_iter().map(|job| {
            let worker = worker.clone();
            let mut job = Some(job);
            let step: Step = Box::new(move || match (worker.go_on(), job.take()) {
                (Ok(()), Some(job)) => {
                    job(&worker);
                    Stage::Done
                }
                _ => Stage::Cancelled,
            });
            step
        });
        in_background(name, jobs.collect());
        work
    }

    /// Does `step` again and again for as long as it says that there is more to do; in a page, once a frame.
    pub fn begin_in_steps(
        name: &str,
        mut step: impl FnMut(&Worker<T>) -> bool + Send + 'static,
    ) -> Self {
        let (work, worker) = Work::pair();
        let job: Step = Box::new(move || match worker.go_on() {
            Err(Cancelled) => Stage::Cancelled,
            Ok(()) if step(&worker) => Stage::Unfinished,
            Ok(()) => Stage::Done,
        });
        in_background(name, vec![job]);
        work
    }
}

impl<T> Work<T> {
    /// Both sides of work that is not begun.
    pub(super) fn pair() -> (Self, Worker<T>) {
        let state = Arc::new(State::default());
        let (sender, found) = channel();
        let work = Work {
            found: Some(found),
            state: state.clone(),
        };
        (work, Worker { sender, state })
    }

    /// What has arrived since it was last asked.
    pub fn take(&mut self) -> Vec<T> {
        let mut taken = Vec::new();
        while let Some(found) = &self.found {
            match found.try_recv() {
                Ok(found) => taken.push(found),
                Err(TryRecvError::Empty) => break,
                Err(TryRecvError::Disconnected) => self.found = None,
            }
        }
        taken
    }

    /// Waits for the end, and takes what has arrived.
    #[cfg(test)]
    pub fn wait(&mut self) -> Vec<T> {
        self.found.take().into_iter().flatten().collect()
    }

    /// Whether it has ended, and all that it found is taken.
    pub fn is_done(&self) -> bool {
        self.found.is_none()
    }

    /// How far it is; none once it is done.
    pub fn percent(&self) -> Option<usize> {
        (!self.is_done()).then(|| self.state.percent.load(Ordering::Relaxed))
    }

    pub fn cancel(&self) {
        self.state.cancelled.store(true, Ordering::Relaxed);
    }
}

impl<T> Drop for Work<T> {
    fn drop(&mut self) {
        self.cancel();
    }
}

impl<T> Worker<T> {
    pub fn send(&self, found: T) {
        // The receiver may be gone; then it is not needed.
        drop(self.sender.send(found));
    }

    /// Tells how much is done, which never goes back. An error where the work is cancelled.
    pub fn progress(&self, done: usize, all: usize) -> Result<(), Cancelled> {
        let percent = 100 * done / all.max(1);
        self.state.percent.fetch_max(percent, Ordering::Relaxed);
        self.go_on()
    }

    /// An error where the work is cancelled.
    pub fn go_on(&self) -> Result<(), Cancelled> {
        match self.state.cancelled.load(Ordering::Relaxed) {
            true => Err(Cancelled),
            false => Ok(()),
        }
    }
}

#[cfg(not(target_arch = "wasm32"))]
fn in_background(name: &str, jobs: Vec<Step>) {
    use std::sync::{Mutex, PoisonError};
    use std::thread;

    let jobs = Arc::new(Mutex::new(jobs));
    let work = {
        let jobs = jobs.clone();
        move || {
            let jobs = std::mem::take(&mut *jobs.lock().unwrap_or_else(PoisonError::into_inner));
            for mut job in jobs {
                while job() == Stage::Unfinished {}
            }
        }
    };
    let thread = thread::Builder::new().name(name.to_owned());
    // Where there are no threads left, at once.
    if thread.spawn(work.clone()).is_err() {
        work();
    }
}

#[cfg(target_arch = "wasm32")]
use page::in_background;

#[cfg(target_arch = "wasm32")]
pub use page::do_next;

#[cfg(target_arch = "wasm32")]
mod page {
    use super::{Stage, Step};
    use std::cell::RefCell;
    use std::collections::VecDeque;

    thread_local! {
        static JOBS: RefCell<VecDeque<Step>> = RefCell::default();
    }

    /// Does one job after the other, one a frame.
    pub fn in_background(_: &str, jobs: Vec<Step>) {
        JOBS.with_borrow_mut(|all| all.extend(jobs));
    }

    /// Does a step of the next job that is not cancelled, and says whether there was one. Jobs of many steps take turns.
    pub fn do_next() -> bool {
        while let Some(mut job) = JOBS.with_borrow_mut(VecDeque::pop_front) {
            match job() {
                Stage::Cancelled => {}
                Stage::Done => return true,
                Stage::Unfinished => {
                    JOBS.with_borrow_mut(|all| all.push_back(job));
                    return true;
                }
            }
        }
        false
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::thread;

    #[test]
    fn what_is_found_arrives_in_order_and_then_the_work_is_done() {
        let jobs = (1..=3).map(|n| {
            let job: Job<usize> = Box::new(move |worker| {
                worker.send(n);
                assert_eq!(worker.progress(n, 3), Ok(()));
            });
            job
        });
        let mut work = Work::begin_all("test", jobs.collect());
        assert_eq!(work.wait(), [1, 2, 3]);
        assert!(work.is_done() && work.take().is_empty());
    }

    #[test]
    fn work_in_steps_goes_on_until_there_is_no_more_to_do() {
        let mut left = 3;
        let mut work = Work::begin_in_steps("test", move |worker| {
            worker.send(left);
            left -= 1;
            left > 0
        });
        assert_eq!(work.wait(), [3, 2, 1]);
    }

    #[test]
    fn the_percentage_never_goes_back_and_ends_with_the_work() {
        let (mut work, worker) = Work::pair();
        for (done, percent) in [(1, 25), (3, 75), (2, 75)] {
            assert_eq!(worker.progress(done, 4), Ok(()));
            assert_eq!(work.percent(), Some(percent));
        }
        worker.send("all of it");
        assert_eq!(work.take(), ["all of it"]);
        assert!(!work.is_done());
        drop(worker);
        assert!(work.take().is_empty() && work.is_done());
        assert_eq!(work.percent(), None);
    }

    #[test]
    fn work_that_is_dropped_is_cancelled() {
        let (began, has_begun) = channel();
        let (sender, ended) = channel();
        let endless = Work::<()>::begin("test", move |worker| {
            began.send(()).unwrap();
            while worker.progress(0, 1).is_ok() {
                thread::yield_now();
            }
            sender.send(()).unwrap();
        });
        has_begun.recv().unwrap();
        assert!(ended.try_recv().is_err());
        drop(endless);
        // The work says that it has ended; without that, this would wait for ever.
        ended.recv().unwrap();
    }
}
