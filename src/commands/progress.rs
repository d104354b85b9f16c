//! A word on standard error about work that takes longer than a second.

use super::failure::note;
use std::io::{IsTerminal, Write};
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::mpsc;
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
                note(format_args!("lightwalk: {what} …"));
            }
        });
        let result = work();
        drop(done);
        result
    })
}

/// Silent for a second, then one line that is written over four times a second; without a terminal, a line every ten seconds.
///
/// Calls cost little, however many there are.
pub struct Progress {
    what: &'static str,
    start: Instant,
    terminal: bool,
    /// When the next word is due, in milliseconds from the start.
    due: AtomicU64,
}

impl Progress {
    pub fn new(what: &'static str) -> Self {
        Progress {
            what,
            start: Instant::now(),
            terminal: std::io::stderr().is_terminal(),
            due: AtomicU64::new(PATIENCE.as_millis() as u64),
        }
    }

    /// Hears that `done` of `all` parts are done.
    pub fn show(&self, done: usize, all: usize) {
        let now = self.start.elapsed().as_millis() as u64;
        let due = self.due.load(Ordering::Relaxed);
        let (pause, start, end) = match self.terminal {
            true => (250, "\r", ""),
            false => (10_000, "", "\n"),
        };
        // Of several threads that come at once, one speaks.
        let relaxed = Ordering::Relaxed;
        let exchanged = |next| self.due.compare_exchange(due, next, relaxed, relaxed);
        if now >= due && exchanged(now + pause).is_ok() {
            let percent = 100 * done / all.max(1);
            // A terminal that is gone needs no progress.
            let mut terminal = std::io::stderr();
            let left = remaining(now / 1000, done, all);
            let _ = write!(terminal, "{start}{}: {percent} %{left}{end}", self.what);
            let _ = terminal.flush();
        }
    }
}

/// In words how long the rest takes if it goes on as before, given the seconds so far; nothing before a hundredth is done. Spaces cover a longer
/// word before.
fn remaining(seconds: u64, done: usize, all: usize) -> String {
    if done == 0 || all / done > 100 {
        return String::new();
    }
    let left = seconds * all.saturating_sub(done) as u64 / done as u64;
    match left {
        0..60 => format!(", {left} s left   "),
        60..3600 => format!(", {} min {} s left   ", left / 60, left % 60),
        _ => format!(", {} h {} min left   ", left / 3600, left % 3600 / 60),
    }
}

impl Drop for Progress {
    /// Ends the line that was written over.
    fn drop(&mut self) {
        let spoken = self.due.load(Ordering::Relaxed) > PATIENCE.as_millis() as u64;
        if self.terminal && spoken {
            note(format_args!(""));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::remaining;

    #[test]
    fn the_rest_takes_as_long_as_what_is_done() {
        assert_eq!(remaining(10, 50, 100).trim_end(), ", 10 s left");
        assert_eq!(remaining(10, 1, 100).trim_end(), ", 16 min 30 s left");
        assert_eq!(remaining(3600, 25, 100).trim_end(), ", 3 h 0 min left");
        assert_eq!(remaining(10, 0, 100), "");
        assert_eq!(remaining(10, 1, 1000), "");
    }
}
