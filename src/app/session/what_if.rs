//! Classic mistakes made on purpose: the picture with one of them beside ours, and how much of the picture each would change. All of it
//! is drawn in the background, and again whenever ours changes.

use super::against::TOLERANCE;
use super::{Drawer, Session};
use crate::algorithms::frame::Frame;
use crate::app::background::{Job, Work};
use crate::color::StoredImage;
use crate::methods::{Method, Mistake, Setup};
use crate::render::render_unless;
use crate::study::against::{Comparison, with_mistake};
use crate::study::mistakes::Workers;
use std::num::NonZeroUsize;
use std::sync::{Arc, OnceLock};
use std::thread::available_parallelism;

/// A picture with a mistake, and how it differs from ours.
type WrongPicture = (StoredImage, Comparison);

/// What is known of the mistakes.
#[derive(Default)]
pub struct WhatIf {
    /// The one that is switched on.
    pub on: Option<Mistake>,
    /// Its picture; none where it is not drawn yet, or no pixel differs.
    pub made: Option<WrongPicture>,
    /// Counts the pictures, so that what was drawn of an earlier one is known to be old.
    pub version: u64,
    /// Of how many pixels each is off, as far as known.
    off: Vec<(Mistake, usize)>,
    /// Ours.
    right: Arc<OnceLock<Frame>>,
    /// What is drawn in the background; dropped, it ends before the next picture.
    work: Option<Work<Drawn>>,
}

/// None where no pixel differs.
type Drawn = (Mistake, Option<WrongPicture>);

impl WhatIf {
    /// How many pixels are off with a mistake; none before that is known.
    pub fn off(&self, mistake: Mistake) -> Option<usize> {
        let known = self.off.iter().find(|(of, _)| *of == mistake);
        known.map(|(_, off)| *off)
    }

    /// Draws the mistakes, one after the other.
    fn begin(&mut self, mistakes: Vec<Mistake>, setup: &Arc<Setup>, method: Method) {
        let jobs = mistakes.into_iter().map(|mistake| {
            let (right, setup) = (self.right.clone(), setup.clone());
            let job: Job<Drawn> = Box::new(move |worker| {
                let threads = available_parallelism().unwrap_or(NonZeroUsize::MIN);
                let go_on = || worker.go_on();
                if right.get().is_none()
                    && let Ok(drawn) = render_unless(&setup, method, threads, |_, _| go_on())
                {
                    // Nobody else draws it.
                    let _ = right.set(drawn);
                }
                let workers = Workers {
                    threads,
                    go_on: &go_on,
                };
                let made = right.get().and_then(|right| {
                    with_mistake(mistake, (&setup, method), right, TOLERANCE, workers)
                });
                if go_on().is_ok() {
                    worker.send((mistake, made));
                }
            });
            job
        });
        self.work = Some(Work::begin_all("what-if", jobs.collect()));
    }

    fn keep(&mut self, (mistake, made): Drawn) {
        let off = made.as_ref().map_or(0, |(_, found)| found.off);
        self.off.retain(|(of, _)| *of != mistake);
        self.off.push((mistake, off));
        if self.on == Some(mistake) {
            self.made = made;
            self.version += 1;
        }
    }

    /// Of another lesson nothing is known.
    pub(super) fn forget(&mut self) {
        *self = WhatIf {
            version: self.version + 1,
            ..WhatIf::default()
        };
    }

    /// What was found was found of another picture. The mistake stays on, and its picture until the next one is there.
    pub(super) fn restart(&mut self) {
        self.off.clear();
        self.right = Arc::default();
        self.work = None;
    }
}

impl Session {
    pub fn what_if(&self) -> &WhatIf {
        &self.what_if
    }

    /// The mistakes that a program can make by the method shown.
    pub fn possible_mistakes(&self) -> impl Iterator<Item = Mistake> {
        let method = self.lesson().method;
        let all = Mistake::GROUPS.iter().flat_map(|(_, group)| *group);
        all.copied().filter(move |mistake| mistake.concerns(method))
    }

    /// Whether mistakes are still being drawn.
    pub fn draws_mistakes(&self) -> bool {
        self.what_if.work.is_some()
    }

    /// Switches a mistake on, or all off, in their drawer.
    pub(super) fn make_mistake(&mut self, mistake: Option<Mistake>) {
        self.look.drawer = Some(Drawer::WhatIf);
        let what_if = &mut self.what_if;
        (what_if.on, what_if.made) = (mistake, None);
        // Its picture is wanted before the rest.
        what_if.work = None;
        if let Some(mistake) = mistake {
            what_if.off.retain(|(of, _)| *of != mistake);
        }
    }

    /// Takes what was drawn with mistakes, and lets what is missing be drawn while their drawer is open: the one that is switched on
    /// first.
    pub fn take_mistakes(&mut self) {
        if let Some(work) = &mut self.what_if.work {
            let drawn = work.take();
            if work.is_done() {
                self.what_if.work = None;
            }
            drawn.into_iter().for_each(|drawn| self.what_if.keep(drawn));
        }
        let is_open = self.look.drawer == Some(Drawer::WhatIf);
        if !is_open || self.draws_mistakes() || self.awaits_picture() {
            return;
        }
        let is_unknown = |mistake: &Mistake| self.what_if.off(*mistake).is_none();
        let mut missing: Vec<Mistake> = self.possible_mistakes().filter(is_unknown).collect();
        missing.sort_by_key(|mistake| self.what_if.on != Some(*mistake));
        if !missing.is_empty() {
            let (setup, method) = (self.open.setup.clone(), self.lesson().method);
            self.what_if.begin(missing, &setup, method);
        }
    }

    /// Waits until all mistakes are drawn.
    #[cfg(test)]
    pub fn wait_for_mistakes(&mut self) {
        self.wait_for_picture();
        self.take_mistakes();
        while let Some(mut work) = self.what_if.work.take() {
            work.wait()
                .into_iter()
                .for_each(|drawn| self.what_if.keep(drawn));
            self.take_mistakes();
        }
    }
}

#[cfg(test)]
mod tests;
