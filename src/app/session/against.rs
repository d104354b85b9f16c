//! A picture of the user's own program beside what is shown: compared in the background, and again whenever either changes.

use super::{Drawer, Refused, Session};
use crate::app::background::{Work, Worker};
use crate::app::strings;
use crate::color::StoredImage;
use crate::lesson::{Lesson, LessonError};
use crate::methods::{Method, Setup};
use crate::study::against::{self, Comparison};
use std::num::NonZeroUsize;
use std::sync::Arc;
use std::thread::available_parallelism;

/// How far a channel may be off: a step of 8 bits.
pub(super) const TOLERANCE: f64 = 1.0 / 255.0;
/// The largest picture that a scene is walked with.
const MOST_PIXELS: u64 = 1 << 22;

/// A picture that is compared with ours. Dropped, the comparison ends before the next mistake.
pub struct Against {
    /// Of its file.
    pub name: String,
    pub mine: Arc<StoredImage>,
    /// What is known so far; the mistakes come last.
    pub found: Option<Comparison>,
    /// Counts what has come in over all comparisons, so that what was drawn of an earlier one is known to be old.
    pub version: u64,
    work: Work<Comparison>,
}

impl Against {
    fn begin(name: String, mine: Arc<StoredImage>, of: (Arc<Setup>, Method), version: u64) -> Self {
        let pixels = mine.clone();
        let compare = move |worker: &_| compare(&pixels, &of.0, of.1, worker);
        Against {
            name,
            mine,
            found: None,
            version,
            work: Work::begin("comparison", compare),
        }
    }

    /// How many of the mistakes have been tried, in percent; none where all have.
    pub fn percent(&self) -> Option<usize> {
        self.work.percent()
    }

    fn keep(&mut self, found: Vec<Comparison>) {
        self.version += found.len() as u64;
        self.found = found.into_iter().next_back().or(self.found.take());
    }
}

fn compare(mine: &StoredImage, setup: &Setup, method: Method, worker: &Worker<Comparison>) {
    let progress = |done, all| worker.progress(done, all);
    let first = |found: &Comparison| worker.send(found.clone());
    let threads = available_parallelism().unwrap_or(NonZeroUsize::MIN);
    let found = against::compare(mine, setup, method, TOLERANCE, threads, &progress, first);
    if let Ok(found) = found {
        worker.send(found);
    }
}

impl Session {
    pub fn against(&self) -> Option<&Against> {
        self.against.as_ref()
    }

    /// Compares a picture with what is shown. A scene that is walked freely is then walked in a picture of that size. Errors: what of it
    /// does not fit, and nothing has changed then.
    pub fn compare_with(&mut self, name: String, mine: StoredImage) -> Result<(), Refused> {
        if self.is_on_page() {
            return Err(strings::COMPARE_WHERE.into());
        }
        let (size, ours) = ([mine.width, mine.height], self.lesson().size);
        let in_words = |[width, height]: [u32; 2]| format!("{width} × {height}");
        let refused = |message: crate::language::Message| {
            let sizes = [("found", in_words(size)), ("wanted", in_words(ours))];
            let sizes = sizes.each_ref().map(|(key, size)| (*key, size.as_str()));
            Refused::Error(message.format(self.look.language, &sizes))
        };
        if size != ours {
            if !self.lesson().is_free_walk() {
                return Err(refused(strings::COMPARE_SIZE));
            }
            if u64::from(mine.width) * u64::from(mine.height) > MOST_PIXELS {
                return Err(refused(strings::COMPARE_TOO_LARGE));
            }
            let resized = self.lesson().of_size(size);
            self.replace_compared(resized)
                .map_err(|error| Refused::Error(error.to_string()))?;
        }
        self.begin_comparison(name, Arc::new(mine));
        self.look.drawer = Some(Drawer::Against);
        Ok(())
    }

    fn begin_comparison(&mut self, name: String, mine: Arc<StoredImage>) {
        let version = self.against.as_ref().map_or(0, |old| old.version + 1);
        let of = (self.open.setup.clone(), self.lesson().method);
        self.against = Some(Against::begin(name, mine, of, version));
    }

    /// Compares the picture with what is shown now.
    pub(super) fn compare_again(&mut self) {
        if let Some(against) = &self.against {
            let (name, mine) = (against.name.clone(), against.mine.clone());
            self.begin_comparison(name, mine);
        }
    }

    /// Puts another walk through the same scene in place of this one, and compares the picture with that.
    pub(super) fn replace_compared(&mut self, lesson: Lesson) -> Result<(), LessonError> {
        let (against, drawer) = (self.against.take(), self.look.drawer);
        let mistake = self.what_if.on;
        let replaced = self.replace(lesson);
        self.against = against;
        self.what_if.on = mistake.filter(|mistake| mistake.concerns(self.lesson().method));
        self.look.drawer = drawer;
        if replaced.is_ok() {
            self.compare_again();
        }
        replaced
    }

    /// Nothing is compared any more: another lesson is shown.
    pub(super) fn forget_comparison(&mut self) {
        self.against = None;
        if self.look.drawer == Some(Drawer::Against) {
            self.look.drawer = None;
        }
    }

    /// Takes what the comparison has found.
    pub fn take_comparison(&mut self) {
        if let Some(against) = &mut self.against {
            let found = against.work.take();
            against.keep(found);
        }
    }

    /// Waits until the picture is compared.
    #[cfg(test)]
    pub fn wait_for_comparison(&mut self) {
        let against = self.against.as_mut().expect("a picture");
        let found = against.work.wait();
        against.keep(found);
    }
}

#[cfg(test)]
pub(super) mod tests;
