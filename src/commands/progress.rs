//! A word on standard error about work that takes longer than a second.

use std::io::{IsTerminal, Write};
use std::sync::{Mutex, mpsc};
use web_time::{Duration, Instant};

/// How long a user waits without a word.
const PATIENCE: Duration = Duration::from_secs(1);

/// Does work of unknown length, and says what it is once it has taken longer than a second.
pub fn named<T>(what: &str, work: impl FnOnce() -> T) -> T {
    std::thread::scope(|scope| {
        let (done, wait) = mpsc::channel::<()>();
        scope.spawn(move || {
            // The sender is dropped when the work is done.
            if wait.recv_timeout(PATIENCE) == Err(mpsc::RecvTimeoutError::Timeout) {
                super::tell(format_args!("lightwalk: {what} …"));
            }
        });
        let result = work();
        drop(done);
        result
    })
}

/// Silent for a second, then one line that is written over four times a second; without a terminal, a line every ten.
pub struct Progress {
    what: &'static str,
    start: Instant,
    shown: Mutex<Option<Instant>>,
}

impl Progress {
    pub fn new(what: &'static str) -> Self {
        Progress {
            what,
            start: Instant::now(),
            shown: Mutex::new(None),
        }
    }

    /// Hears that `done` of `all` parts are done.
    pub fn show(&self, done: usize, all: usize) {
        let now = Instant::now();
        let terminal = std::io::stderr().is_terminal();
        let pause = if terminal {
            Duration::from_millis(250)
        } else {
            Duration::from_secs(10)
        };
        // A poisoned lock means that another thread panicked: then there is nothing more to say here.
        let Ok(mut shown) = self.shown.lock() else {
            return;
        };
        let due = shown.map_or(now - self.start >= PATIENCE, |last| now - last >= pause);
        if due {
            *shown = Some(now);
            let percent = 100 * done / all.max(1);
            let (start, end) = if terminal { ("\r", "") } else { ("", "\n") };
            // A terminal that is gone needs no progress.
            let mut terminal = std::io::stderr();
            let _ = write!(terminal, "{start}{}: {percent} %{end}", self.what);
            let _ = terminal.flush();
        }
    }
}

impl Drop for Progress {
    /// Ends the line that was written over.
    fn drop(&mut self) {
        if std::io::stderr().is_terminal() && matches!(self.shown.lock().as_deref(), Ok(Some(_))) {
            super::tell(format_args!(""));
        }
    }
}
