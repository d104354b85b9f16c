//! What the drivers have in common: cases are made from seeds, tried on a thread of their own, counted and timed. No case panics, and
//! none takes longer than ten seconds, or half a minute where the program is built for quick rebuilding.

use lightwalk::numeric::Random;
use std::any::Any;
use std::panic::catch_unwind;
use std::str::FromStr;
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::thread;
use std::time::{Duration, Instant};

const LONGEST: Duration = Duration::from_secs(if cfg!(debug_assertions) { 30 } else { 10 });

/// After so many failures a driver stops: they are often the same.
const MOST_FAILURES: usize = 12;

/// What became of a case that obeys the rules.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Outcome {
    /// With a clear error.
    Refused,
    Done,
}

#[derive(Clone, Copy)]
pub struct Driver {
    pub kind: &'static str,
    /// How many are tried unless more are wanted.
    pub cases: u64,
    /// Of a hundred cases so many are done at least; were there fewer, most of the program would not be reached.
    pub done_percent: u64,
    /// A case as a text.
    pub make: fn(&mut Random) -> String,
    /// Errors: which rule is broken.
    pub attempt: fn(&str) -> Result<Outcome, String>,
}

impl Driver {
    fn case(self, seed: u64) -> String {
        // Neighbouring seeds of the generator begin alike.
        (self.make)(&mut Random(Random(seed).bits()))
    }

    pub fn attack(self) {
        let first = number("ATTACK_SEED").unwrap_or(0);
        let time = number("ATTACK_SECONDS").map(Duration::from_secs);
        let Driver { kind, cases, .. } = self;
        let start = Instant::now();
        let (sender, tried) = channel();
        thread::spawn(move || {
            for seed in first.. {
                let case = self.case(seed);
                let outcome = catch_unwind(|| (self.attempt)(&case));
                let outcome =
                    outcome.unwrap_or_else(|panic| Err(format!("panics: {}", message(&*panic))));
                // The other side has enough.
                if sender.send(outcome).is_err() {
                    return;
                }
            }
        });
        let (mut seed, mut done, mut failures) = (first, 0, Vec::new());
        let enough = |seed: u64| match time {
            Some(time) => start.elapsed() >= time,
            None => seed - first >= cases,
        };
        while !enough(seed) && failures.len() < MOST_FAILURES {
            let failed = |what: &str| format!("{kind}, seed {seed}: {what}\n{}", self.case(seed));
            match tried.recv_timeout(LONGEST) {
                Ok(Ok(Outcome::Done)) => done += 1,
                Ok(Ok(Outcome::Refused)) => {}
                Ok(Err(what)) => failures.push(failed(&what)),
                Err(RecvTimeoutError::Timeout) => {
                    failures.push(failed(&format!("no end within {LONGEST:?}")));
                    break;
                }
                Err(RecvTimeoutError::Disconnected) => panic!("{}", failed("the thread is gone")),
            }
            seed += 1;
        }
        let all = seed - first;
        println!(
            "{kind}: {all} cases from seed {first}, {done} done, {} failed",
            failures.len()
        );
        assert!(failures.is_empty(), "{}", failures.join("\n\n"));
        assert!(
            100 * done >= self.done_percent * all,
            "{kind}: {done} of {all} are done"
        );
    }
}

fn number<T: FromStr>(variable: &str) -> Option<T> {
    let text = std::env::var(variable).ok()?;
    Some(
        text.parse()
            .unwrap_or_else(|_| panic!("{variable}={text}: a whole number is wanted")),
    )
}

fn message(panic: &(dyn Any + Send)) -> &str {
    match (panic.downcast_ref::<String>(), panic.downcast_ref::<&str>()) {
        (Some(message), _) => message,
        (_, Some(message)) => message,
        _ => "something",
    }
}

/// One of `count`.
pub fn pick(random: &mut Random, count: usize) -> usize {
    (random.bits() % count.max(1) as u64) as usize
}

pub fn one_of<T: Copy>(random: &mut Random, all: &[T]) -> T {
    all[pick(random, all.len())]
}

/// Where a text has a number that is not finite, as Rust writes them. Pictures in it are letters at random, and not looked at.
pub fn not_finite(text: &str) -> Option<&str> {
    let mut parts = text.split(";base64,");
    let first = parts.next().into_iter();
    let others = parts.filter_map(|part| part.split_once('"').map(|(_, behind)| behind));
    first.chain(others).find_map(|part| {
        let found = part.match_indices("NaN").chain(part.match_indices("inf"));
        let mut found = found.filter(|&(at, word)| {
            let small = |c: Option<char>| c.is_some_and(char::is_lowercase);
            let (before, behind) = (&part[..at], &part[at + word.len()..]);
            // No part of a word
            !small(before.chars().next_back()) && !small(behind.chars().next())
        });
        let (at, word) = found.next()?;
        let mut starts = (at.saturating_sub(120)..=at).filter(|&from| part.is_char_boundary(from));
        part.get(starts.next()?..at + word.len())
    })
}

/// Whether a message of refusal says something in every line, and nothing of how the program is made.
pub fn is_clear(message: &str) -> Result<(), String> {
    // A line of its own names an argument that is missing.
    let names = |line: &str| line.trim().starts_with(['<', '-']);
    let bare = |line: &str| (1..10).contains(&line.trim().len()) && !names(line);
    let ours = ["panicked", "src/", ".rs:", "unwrap", "Some(", "None"];
    match message.lines().any(bare)
        || message.is_empty()
        || ours.iter().any(|ours| message.contains(ours))
    {
        true => Err(format!("an unclear message: {message}")),
        false => Ok(()),
    }
}
