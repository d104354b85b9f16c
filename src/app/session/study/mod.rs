//! A study that is measured in the background: its parts are shown as they arrive, and it can be cancelled.

#[cfg(test)]
mod tests;

use super::command::{PointAt, Refused};
use crate::app::background::{Work, Worker};
use crate::app::strings;
use crate::language::Language;
use crate::study::families;
use crate::study::form::{Request, Study};
use crate::study::harness::{Line, Part, Point, Unmeasured};

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
    /// Dropped, it ends after the current setting.
    measuring: Option<Work<News>>,
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

enum News {
    Part(Box<Part>),
    Unmeasured(Unmeasured),
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
        self.measuring.as_ref()?.percent()
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
        let measure = move |worker: &_| measure(study, quick, worker);
        self.measuring = Some(Work::begin("study", measure));
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
        let Some(measuring) = &mut self.measuring else {
            return;
        };
        let news = measuring.take();
        if measuring.is_done() {
            self.measuring = None;
        }
        news.into_iter().for_each(|news| self.keep(news));
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
        let measuring = self.measuring.take();
        let news = measuring.map_or_else(Vec::new, |mut measuring| measuring.wait());
        news.into_iter().for_each(|news| self.keep(news));
    }
}

/// The curve and the setting of a point.
pub fn name_of_point(line: &Line, point: &Point, language: Language) -> String {
    let [line, setting] = [&line.name, &point.setting].map(|label| label.text(language));
    format!("{line}, {setting}")
}

fn measure(study: &'static Study, quick: bool, worker: &Worker<News>) {
    let progress = |done, all| worker.progress(done, all);
    let found = |part: &Part| worker.send(News::Part(Box::new(part.clone())));
    let request = Request { scene: None, quick };
    if let Err(why) = study.measure(&request, &progress, &found) {
        worker.send(News::Unmeasured(why));
    }
}
