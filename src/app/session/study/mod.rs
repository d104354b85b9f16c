//! A study that is measured in the background: its parts are shown as they arrive, and it can be cancelled.

#[cfg(test)]
mod tests;

use super::command::{PointAt, Refused};
use crate::app::background::in_background;
use crate::app::strings;
use crate::render::Cancelled;
use crate::study::families;
use crate::study::form::{Request, Study};
use crate::study::harness::{Line, Part, Point, Unmeasured};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::mpsc::{Receiver, Sender, TryRecvError, channel};

/// The view of error against run time.
pub struct Studying {
    pub is_open: bool,
    /// An index into all studies.
    pub chosen: usize,
    /// Whether few and small settings are enough.
    pub quick: bool,
    /// The study that was measured last, or is, and whether quickly.
    pub of: Option<(&'static Study, bool)>,
    /// As many of its parts as have come.
    pub parts: Vec<Part>,
    /// Which of them is shown.
    pub part: usize,
    pub outcome: Outcome,
    measuring: Option<Measuring>,
    /// The point that is described.
    pub picked: Option<PointAt>,
}

/// What became of the study that was measured last.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// Done, under way, or never begun.
    Well,
    Cancelled,
    /// It has no findings, for this reason, which is in English.
    Because(String),
}

/// Dropped, it is cancelled: its thread ends by itself after the current setting.
struct Measuring {
    state: Arc<State>,
    news: Receiver<News>,
}

enum News {
    Part(Box<Part>),
    Unmeasured(Unmeasured),
}

/// What the two threads share.
#[derive(Default)]
struct State {
    called_off: AtomicBool,
    percent: AtomicUsize,
}

impl Drop for Measuring {
    fn drop(&mut self) {
        self.state.called_off.store(true, Ordering::Relaxed);
    }
}

impl Studying {
    pub(super) fn new() -> Self {
        Studying {
            is_open: false,
            chosen: 0,
            quick: true,
            of: None,
            parts: Vec::new(),
            part: 0,
            outcome: Outcome::Well,
            measuring: None,
            picked: None,
        }
    }

    /// How far the measuring is, in percent; none where nothing is measured.
    pub fn percent(&self) -> Option<usize> {
        let measuring = self.measuring.as_ref()?;
        Some(measuring.state.percent.load(Ordering::Relaxed))
    }

    pub fn point(&self, at: PointAt) -> Option<(&Part, &Line, &Point)> {
        let part = self.parts.get(at.part)?;
        let line = part.lines.get(at.line)?;
        Some((part, line, line.points.get(at.point)?))
    }

    /// The command that measures the shown study again, and writes a table with a row for every point.
    pub fn command_line(&self) -> Option<String> {
        let (study, quick) = self.of?;
        let quick = if quick { " --quick" } else { "" };
        Some(format!("lightwalk study {}{quick} --out found", study.name))
    }

    pub(super) fn begin(&mut self) -> Result<(), Refused> {
        if self.measuring.is_some() {
            return Err(strings::STILL_MEASURING.into());
        }
        let study = *families::ALL
            .get(self.chosen)
            .ok_or(strings::NO_SUCH_STUDY)?;
        let quick = self.quick;
        let state = Arc::new(State::default());
        let (sender, news) = channel();
        let of_thread = state.clone();
        let measure = move || measure(study, quick, &of_thread, &sender);
        in_background("study", vec![Box::new(measure)]);
        self.measuring = Some(Measuring { state, news });
        self.of = Some((study, quick));
        self.parts.clear();
        self.part = 0;
        self.picked = None;
        self.outcome = Outcome::Well;
        Ok(())
    }

    pub(super) fn cancel(&mut self) -> Result<(), Refused> {
        let measuring = self.measuring.take();
        measuring.ok_or(strings::NOTHING_IS_MEASURED)?;
        self.outcome = Outcome::Cancelled;
        Ok(())
    }

    /// Takes what has come in.
    pub(super) fn take(&mut self) {
        while let Some(measuring) = &self.measuring {
            match measuring.news.try_recv() {
                Ok(news) => self.keep(news),
                Err(TryRecvError::Empty) => break,
                Err(TryRecvError::Disconnected) => self.measuring = None,
            }
        }
    }

    fn keep(&mut self, news: News) {
        match news {
            News::Part(part) => self.parts.push(*part),
            News::Unmeasured(Unmeasured::Cancelled(_)) => self.outcome = Outcome::Cancelled,
            News::Unmeasured(Unmeasured::Because(why)) => self.outcome = Outcome::Because(why),
        }
    }

    /// Waits until the study is measured.
    #[cfg(test)]
    pub fn wait(&mut self) {
        while let Some(news) = self.measuring.as_ref().and_then(|m| m.news.recv().ok()) {
            self.keep(news);
        }
        self.measuring = None;
    }
}

fn measure(study: &'static Study, quick: bool, state: &State, sender: &Sender<News>) {
    let progress = |done: usize, all: usize| {
        let percent = 100 * done / all.max(1);
        // A part begins at its first share, where its settings are run for the first time.
        state.percent.fetch_max(percent, Ordering::Relaxed);
        match state.called_off.load(Ordering::Relaxed) {
            true => Err(Cancelled),
            false => Ok(()),
        }
    };
    // The receiver may be gone; then the news is not needed.
    let found = |part: &Part| drop(sender.send(News::Part(Box::new(part.clone()))));
    let request = Request { scene: None, quick };
    if let Err(why) = study.measure(&request, &progress, &found) {
        drop(sender.send(News::Unmeasured(why)));
    }
}
