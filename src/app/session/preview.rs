//! The whole picture, those of the methods that are compared, and the race of the radiosity solvers, made in the background. They can
//! be cancelled at any time.

use crate::algorithms::frame::Frame;
use crate::algorithms::radiosity::Unsolved;
use crate::algorithms::radiosity::race::Race;
use crate::app::background::{Work, Worker};
use crate::methods::Setup;
use crate::render::compare::{Compared, compare_unless};
use crate::render::{Cancelled, Finished, Layers, Method, layers, preview, race};
use crate::study::ablation;
use crate::study::timing::{Patience, Timing};
use std::num::NonZeroUsize;
use std::sync::Arc;
use std::thread;
use web_time::{Duration, Instant};

/// Progress is shown only of pictures that take longer.
const PATIENCE: Duration = Duration::from_millis(200);

/// How long the cost of forced parts is measured: a few seconds, in the background.
const MEASURING: Patience = Patience {
    longest: Duration::from_secs(1),
    ..Patience::QUICK
};

/// Run times with everything skipped that the scene does not need, and with the forced parts; or why there are none.
pub type Times = Result<[Timing; 2], String>;

/// A picture that is being rendered. Dropped, its work ends within milliseconds.
pub struct Preview {
    /// As far as it has come. Before the first pass its picture is the background, or the one before the scene was changed.
    finished: Finished,
    /// Where something is forced that the scene does not need.
    times: Option<Times>,
    passes: Work<Pass>,
    /// The layers of the picture, once they are asked for.
    survey: Option<Work<Layers>>,
    start: Instant,
}

/// The picture's method, and those that it is compared with.
#[derive(Clone, Debug, PartialEq)]
pub struct Methods {
    pub picture: Method,
    pub compared: Vec<Method>,
}

/// What arrives.
enum Pass {
    Picture(Frame),
    Compared(Compared),
    /// The solvers have run.
    Raced(Result<Race, Unsolved>),
    Timed(Times),
}

impl Preview {
    /// Begins the picture of the scene.
    pub fn new(setup: Arc<Setup>, methods: Methods) -> Self {
        Preview::over(setup.prepared.empty_frame(), setup, methods)
    }

    /// Begins anew with a scene of the same view; the old picture stays until the first pass arrives.
    pub fn restart(&mut self, setup: Arc<Setup>, methods: Methods) {
        let nothing = Frame::new(0, 0..0, setup.prepared.scene.background);
        let frame = std::mem::replace(&mut self.finished.picture, nothing);
        *self = Preview::over(frame, setup, methods);
    }

    fn over(frame: Frame, setup: Arc<Setup>, methods: Methods) -> Self {
        let threads = thread::available_parallelism().unwrap_or(NonZeroUsize::MIN);
        let finished = Finished::new(frame, &setup.prepared.scene.lights);
        Preview::of(finished, move |worker| {
            let progress = |done, all| worker.progress(done, all);
            let show = &mut |pass: &Frame| worker.send(Pass::Picture(pass.clone()));
            let Ok(whole) = preview(&setup, methods.picture, threads, progress, show) else {
                return;
            };
            worker.send(Pass::Picture(whole));
            // An error is that nobody wants the rest.
            let _ = beside(&setup, &methods, worker);
        })
    }

    /// Shows `finished` until `make` sends more.
    fn of(finished: Finished, make: impl FnOnce(&Worker<Pass>) + Send + 'static) -> Self {
        Preview {
            finished,
            times: None,
            passes: Work::begin("preview", make),
            survey: None,
            start: Instant::now(),
        }
    }

    /// Begins to find the layers of the picture of that scene, unless they are found or on their way.
    pub fn survey(&mut self, setup: &Arc<Setup>, method: Method) {
        if self.finished.layers.is_some() || self.survey.is_some() {
            return;
        }
        let setup = setup.clone();
        let find = move |worker: &Worker<Layers>| {
            let progress = |done, all| worker.progress(done, all);
            if let Ok(layers) = layers(&setup, method, progress) {
                worker.send(layers);
            }
        };
        self.survey = Some(Work::begin("survey", find));
    }

    /// As far as it has come.
    pub fn finished(&self) -> &Finished {
        &self.finished
    }

    /// Run times of what is forced, once they are measured.
    pub fn times(&self) -> Option<&Times> {
        self.times.as_ref()
    }

    pub fn is_done(&self) -> bool {
        self.passes.is_done() && self.survey.as_ref().is_none_or(Work::is_done)
    }

    /// How much of a picture that takes long is done, in percent.
    pub fn percent(&self) -> Option<usize> {
        let is_long = self.start.elapsed() >= PATIENCE;
        let survey = || self.survey.as_ref()?.percent();
        is_long.then(|| self.passes.percent().or_else(survey))?
    }

    /// Takes the passes that have arrived; whether there was one.
    pub fn take(&mut self) -> bool {
        let passes = self.passes.take();
        let layers = self.survey.as_mut().map(Work::take).unwrap_or_default();
        let taken = !passes.is_empty() || !layers.is_empty();
        passes.into_iter().for_each(|pass| self.keep(pass));
        for layers in layers {
            self.finished.layers = Some(layers);
        }
        taken
    }

    /// Waits until the picture is whole.
    #[cfg(test)]
    pub fn wait(&mut self) {
        let passes = self.passes.wait();
        passes.into_iter().for_each(|pass| self.keep(pass));
    }

    fn keep(&mut self, pass: Pass) {
        match pass {
            Pass::Picture(frame) => self.finished.picture = frame,
            Pass::Compared(compared) => self.finished.compared.push(compared),
            Pass::Raced(race) => self.finished.race = Some(race),
            Pass::Timed(times) => self.times = Some(times),
        }
    }
}

/// What is shown beside the picture.
fn beside(setup: &Setup, methods: &Methods, worker: &Worker<Pass>) -> Result<(), Cancelled> {
    for &method in &methods.compared {
        let compared = compare_unless(setup, method, &|| worker.go_on())?;
        worker.send(Pass::Compared(compared));
    }
    if methods.picture == Method::Radiosity
        && let Some(race) = race(setup, || worker.go_on())?
    {
        worker.send(Pass::Raced(race));
    }
    if !setup.forced().is_empty() {
        let times = ablation::both(setup, methods.picture, MEASURING, &|| worker.go_on())?;
        worker.send(Pass::Timed(times));
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::color::Rgb;
    use std::sync::mpsc::{Sender, channel};

    fn frame(gray: f64) -> Frame {
        Frame::new(4, 0..3, Rgb::splat(gray))
    }

    fn black() -> Finished {
        Finished::new(frame(0.0), &[])
    }

    /// A picture of two passes; the thread waits for a message before each.
    fn on_request() -> (Preview, Sender<()>) {
        let (go_on, word) = channel();
        let preview = Preview::of(black(), move |worker| {
            for pass in 1..=2 {
                if word.recv().is_err() {
                    return;
                }
                worker.progress(pass, 2).unwrap();
                worker.send(Pass::Picture(frame(pass as f64)));
            }
        });
        (preview, go_on)
    }

    #[test]
    fn passes_are_shown_as_they_come() {
        let (mut preview, go_on) = on_request();
        assert!(!preview.take() && !preview.is_done());
        assert_eq!(&preview.finished().picture, &frame(0.0));
        go_on.send(()).unwrap();
        while !preview.take() {
            thread::yield_now();
        }
        assert_eq!(&preview.finished().picture, &frame(1.0));
        assert!(!preview.is_done());
        preview.start = Instant::now() - PATIENCE;
        assert_eq!(preview.percent(), Some(50));
        go_on.send(()).unwrap();
        preview.wait();
        assert_eq!(&preview.finished().picture, &frame(2.0));
        assert!(preview.is_done() && preview.percent().is_none() && !preview.take());
    }

    #[test]
    fn a_thread_that_fails_leaves_the_last_pass() {
        let (mut preview, go_on) = on_request();
        go_on.send(()).unwrap();
        drop(go_on);
        preview.wait();
        assert!(preview.is_done());
        assert_eq!(&preview.finished().picture, &frame(1.0));
    }
}
