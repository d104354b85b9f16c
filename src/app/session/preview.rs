//! The whole picture, those of the methods that are compared, and the race of the radiosity solvers, made in the background. They can
//! be cancelled at any time.

use crate::algorithms::frame::Frame;
use crate::algorithms::radiosity::Unsolved;
use crate::algorithms::radiosity::race::Race;
use crate::app::background::in_background;
use crate::methods::Setup;
use crate::render::compare::{Compared, compare};
use crate::render::{Cancelled, Finished, Layers, Method, layers, preview, race};
use crate::study::ablation;
use crate::study::timing::{Patience, Timing};
use std::num::NonZeroUsize;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::mpsc::{Receiver, Sender, TryRecvError, channel};
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

/// A picture that is being rendered. Dropped, it is cancelled, and its thread ends by itself within milliseconds.
pub struct Preview {
    /// As far as it has come. Before the first pass its picture is the background, or the one before the scene was changed.
    finished: Finished,
    /// Where something is forced that the scene does not need.
    times: Option<Times>,
    /// Where the passes arrive; none once all of them have.
    passes: Option<Receiver<Pass>>,
    /// Where the layers of the picture arrive, once they are asked for.
    survey: Option<Receiver<Layers>>,
    state: Arc<State>,
    start: Instant,
}

/// The picture's method, and those that it is compared with.
#[derive(Clone, Debug, PartialEq)]
pub struct Methods {
    pub picture: Method,
    pub compared: Vec<Method>,
}

/// What the thread sends.
enum Pass {
    Picture(Frame),
    Compared(Compared),
    /// The solvers have run.
    Raced(Result<Race, Unsolved>),
    Timed(Times),
}

/// What the two threads share.
#[derive(Default)]
struct State {
    cancelled: AtomicBool,
    percent: AtomicUsize,
}

impl State {
    fn progress(&self, done: usize, all: usize) -> Result<(), Cancelled> {
        let percent = 100 * done / all.max(1);
        self.percent.store(percent, Ordering::Relaxed);
        self.go_on()
    }

    fn go_on(&self) -> Result<(), Cancelled> {
        match self.cancelled.load(Ordering::Relaxed) {
            true => Err(Cancelled),
            false => Ok(()),
        }
    }
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
        Preview::of(finished, move |state, passes| {
            let progress = |done, all| state.progress(done, all);
            // The receiver may be gone; then the pass is not needed.
            let show = &mut |pass: &Frame| drop(passes.send(Pass::Picture(pass.clone())));
            let Ok(whole) = preview(&setup, methods.picture, threads, progress, show) else {
                return;
            };
            drop(passes.send(Pass::Picture(whole)));
            for &method in &methods.compared {
                if progress(1, 1).is_err() {
                    return;
                }
                drop(passes.send(Pass::Compared(compare(&setup, method))));
            }
            if methods.picture == Method::Radiosity
                && progress(1, 1).is_ok()
                && let Some(race) = race(&setup)
            {
                drop(passes.send(Pass::Raced(race)));
            }
            if !setup.forced().is_empty() && progress(1, 1).is_ok() {
                let times = ablation::both(&setup, methods.picture, MEASURING);
                drop(passes.send(Pass::Timed(times)));
            }
        })
    }

    /// Shows `finished` until `make` sends more.
    fn of(finished: Finished, make: impl FnOnce(&State, &Sender<Pass>) + Send + 'static) -> Self {
        let state = Arc::new(State::default());
        let (sender, passes) = channel();
        let its_state = state.clone();
        let make = move || make(&its_state, &sender);
        in_background("preview", vec![Box::new(make)]);
        Preview {
            finished,
            times: None,
            passes: Some(passes),
            survey: None,
            state,
            start: Instant::now(),
        }
    }

    /// Begins to find the layers of the picture of that scene, unless they are found or on their way.
    pub fn survey(&mut self, setup: &Arc<Setup>, method: Method) {
        if self.finished.layers.is_some() || self.survey.is_some() {
            return;
        }
        let (sender, found) = channel();
        let (setup, state) = (setup.clone(), self.state.clone());
        let find = move || {
            let progress = |_, _| state.go_on();
            if let Ok(layers) = layers(&setup, method, progress) {
                // The receiver may be gone; then they are not needed.
                drop(sender.send(layers));
            }
        };
        in_background("survey", vec![Box::new(find)]);
        self.survey = Some(found);
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
        self.passes.is_none() && self.survey.is_none()
    }

    /// How much of a picture that takes long is done, in percent.
    pub fn percent(&self) -> Option<usize> {
        let waits = !self.is_done() && self.start.elapsed() >= PATIENCE;
        waits.then(|| self.state.percent.load(Ordering::Relaxed))
    }

    /// Takes the passes that have arrived; whether there was one.
    pub fn take(&mut self) -> bool {
        let mut taken = false;
        while let Some(passes) = &self.passes {
            match passes.try_recv() {
                Ok(pass) => {
                    self.keep(pass);
                    taken = true;
                }
                Err(TryRecvError::Empty) => break,
                Err(TryRecvError::Disconnected) => self.passes = None,
            }
        }
        match self.survey.as_ref().map(Receiver::try_recv) {
            None | Some(Err(TryRecvError::Empty)) => {}
            Some(found) => {
                self.finished.layers = found.ok();
                self.survey = None;
                taken = true;
            }
        }
        taken
    }

    /// Waits until the picture is whole.
    #[cfg(test)]
    pub fn wait(&mut self) {
        for pass in self.passes.take().into_iter().flatten() {
            self.keep(pass);
        }
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

impl Drop for Preview {
    fn drop(&mut self) {
        self.state.cancelled.store(true, Ordering::Relaxed);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::color::Rgb;

    fn frame(gray: f64) -> Frame {
        Frame::new(4, 0..3, Rgb::splat(gray))
    }

    fn black() -> Finished {
        Finished::new(frame(0.0), &[])
    }

    /// A picture of two passes; the thread waits for a message before each.
    fn on_request() -> (Preview, Sender<()>) {
        let (go_on, word) = channel();
        let word = std::sync::Mutex::new(word);
        let preview = Preview::of(black(), move |state, passes| {
            for pass in 1..=2 {
                if word.lock().unwrap().recv().is_err() {
                    return;
                }
                let _ = state.progress(pass, 2);
                passes.send(Pass::Picture(frame(pass as f64))).unwrap();
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

    #[test]
    fn a_dropped_picture_is_cancelled() {
        let (sender, ended) = channel();
        let endless = Preview::of(black(), move |state, _| {
            while state.progress(0, 1).is_ok() {
                thread::yield_now();
            }
            sender.send(()).unwrap();
        });
        assert!(ended.try_recv().is_err());
        drop(endless);
        // The maker says that it has ended; without that, this would wait for ever.
        ended.recv().unwrap();
    }
}
