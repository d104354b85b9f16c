//! A study that is measured in the background: nobody waits for it, its parts are shown as they come, and it can be called off.

#[cfg(test)]
mod tests;

use super::{Refused, Session};
use crate::app::strings;
use crate::language::Message;
use crate::lesson::Lesson;
use crate::render::Cancelled;
use crate::study::families;
use crate::study::form::{Request, Study};
use crate::study::harness::{Line, Part, Point, Unmeasured};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::mpsc::{Receiver, Sender, TryRecvError, channel};
use std::thread;

/// One point of the study that is shown: indices of its part, of its curve there, and of itself on that.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PointAt {
    pub part: usize,
    pub line: usize,
    pub point: usize,
}

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
    /// Which of them is looked at.
    pub part: usize,
    pub outcome: Outcome,
    measuring: Option<Measuring>,
    /// The point that is told of.
    pub picked: Option<PointAt>,
}

/// What became of the study that was measured last.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// Done, under way, or never begun.
    Well,
    CalledOff,
    /// It has no findings, for this reason, which is in English.
    Because(String),
}

/// Dropped, it is called off: its thread ends by itself after the setting that it runs.
struct Measuring {
    state: Arc<State>,
    news: Receiver<News>,
}

enum News {
    Part(Box<Part>),
    Unmeasured(Unmeasured),
}

/// What measurer and viewer tell each other.
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

    fn begin(&mut self) -> Result<(), Refused> {
        if self.measuring.is_some() {
            return Err(strings::STILL_MEASURING.into());
        }
        let study = *families::ALL
            .get(self.chosen)
            .ok_or(strings::NO_SUCH_STUDY)?;
        let quick = self.quick;
        let state = Arc::new(State::default());
        let (tell, news) = channel();
        let of_thread = state.clone();
        thread::Builder::new()
            .name("study".into())
            .spawn(move || measure(study, quick, &of_thread, &tell))
            .map_err(|error| Refused::Error(error.to_string()))?;
        self.measuring = Some(Measuring { state, news });
        self.of = Some((study, quick));
        self.parts.clear();
        self.part = 0;
        self.picked = None;
        self.outcome = Outcome::Well;
        Ok(())
    }

    fn call_off(&mut self) -> Result<(), Refused> {
        let measuring = self.measuring.take();
        measuring.ok_or(strings::NOTHING_IS_MEASURED)?;
        self.outcome = Outcome::CalledOff;
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
            News::Unmeasured(Unmeasured::Cancelled(_)) => self.outcome = Outcome::CalledOff,
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

fn measure(study: &'static Study, quick: bool, state: &State, tell: &Sender<News>) {
    let progress = |done: usize, all: usize| {
        let percent = 100 * done / all.max(1);
        // A part begins at its first share, where its settings are run for the first time.
        state.percent.fetch_max(percent, Ordering::Relaxed);
        match state.called_off.load(Ordering::Relaxed) {
            true => Err(Cancelled),
            false => Ok(()),
        }
    };
    // The other end may be gone: then there is nobody to be sorry for.
    let found = |part: &Part| drop(tell.send(News::Part(Box::new(part.clone()))));
    let request = Request { scene: None, quick };
    if let Err(why) = study.measure(&request, &progress, &found) {
        drop(tell.send(News::Unmeasured(why)));
    }
}

/// What a session is asked to do with studies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StudyCommand {
    /// Opens the view, or closes it.
    View,
    /// By its index among all studies.
    Choose(usize),
    /// Few and small settings, or all of them.
    Quick,
    /// Measures the chosen study.
    Measure,
    CallOff,
    /// Looks at a part of what was found.
    Part(usize),
    /// Tells of a point; where that draws a picture, opens it to be walked through.
    Pick(PointAt),
}

impl Session {
    pub fn studying(&self) -> &Studying {
        &self.studying
    }

    #[cfg(test)]
    pub fn studying_mut(&mut self) -> &mut Studying {
        &mut self.studying
    }

    /// Takes what the study that is measured has found.
    pub fn take_findings(&mut self) {
        self.studying.take();
    }

    pub(super) fn study(&mut self, command: StudyCommand) -> Result<(), Refused> {
        let studying = &mut self.studying;
        match command {
            StudyCommand::View => {
                studying.is_open = !studying.is_open;
                self.play = None;
            }
            StudyCommand::Choose(index) if index < families::ALL.len() => studying.chosen = index,
            StudyCommand::Choose(_) => return Err(strings::NO_SUCH_STUDY.into()),
            StudyCommand::Quick => studying.quick = !studying.quick,
            StudyCommand::Part(part) => studying.part = part,
            StudyCommand::Measure => return studying.begin(),
            StudyCommand::CallOff => return studying.call_off(),
            StudyCommand::Pick(at) => return self.pick(at),
        }
        Ok(())
    }

    /// Why a command about studies cannot act, if it cannot.
    pub(super) fn cannot_study(&self, command: StudyCommand) -> Option<Message> {
        let measures = self.studying.percent().is_some();
        match command {
            StudyCommand::Measure => measures.then_some(strings::STILL_MEASURING),
            StudyCommand::CallOff => (!measures).then_some(strings::NOTHING_IS_MEASURED),
            StudyCommand::Pick(at) if self.studying.point(at).is_none() => {
                Some(strings::NO_SUCH_POINT)
            }
            _ => None,
        }
    }

    fn pick(&mut self, at: PointAt) -> Result<(), Refused> {
        let found = self.studying.point(at);
        let (_, line, point) = found.ok_or(strings::NO_SUCH_POINT)?;
        let lesson = point.drawn.as_ref().map(|drawn| {
            let name = format!("{}, {}", line.name, point.setting);
            let localize = strings::said_of_a_point(point);
            Lesson::of_picture(
                name,
                localize,
                &drawn.prepared.lock(),
                drawn.method,
                drawn.settings,
            )
        });
        self.studying.picked = Some(at);
        if let Some(lesson) = lesson {
            self.replace(lesson)
                .map_err(|error| Refused::Error(error.to_string()))?;
            self.studying.is_open = false;
        }
        Ok(())
    }
}
