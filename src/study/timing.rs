//! Run times that can be believed: every setting is run once before, then all in turn, in an order that changes from round to
//! round, so that a machine that slows down slows down all; median and quartiles.

use super::form::{Setting, Values};
use crate::render::Cancelled;
use std::hint::black_box;
use web_time::{Duration, Instant};

/// How much measuring there is.
#[derive(Clone, Copy, Debug)]
pub struct Patience {
    /// What is quicker is run so often that it takes this long, so that the clock's own steps do not count.
    pub shortest: Duration,
    /// What takes longer is left out, and so is what is finer.
    pub longest: Duration,
    /// For all rounds of a ladder, which has at least five.
    pub whole: Duration,
    pub most_rounds: usize,
}

impl Patience {
    pub const QUICK: Patience = Patience {
        shortest: Duration::from_micros(500),
        longest: Duration::from_millis(500),
        whole: Duration::from_millis(1500),
        most_rounds: 15,
    };
    pub const THOROUGH: Patience = Patience {
        shortest: Duration::from_millis(2),
        longest: Duration::from_secs(5),
        whole: Duration::from_secs(12),
        most_rounds: 31,
    };

    const FEWEST_ROUNDS: usize = 5;
}

/// Seconds of one run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Timing {
    pub median: f64,
    /// Quartiles.
    pub lower: f64,
    pub upper: f64,
    pub runs: usize,
}

impl Timing {
    /// Of the seconds of single runs, of which there must be one or more.
    pub fn of(mut seconds: Vec<f64>) -> Timing {
        seconds.sort_by(f64::total_cmp);
        let quarter = |k: usize| seconds[k * (seconds.len() - 1) / 4];
        Timing {
            median: quarter(2),
            lower: quarter(1),
            upper: quarter(3),
            runs: seconds.len(),
        }
    }

    /// Whether the difference is within noise: the quartiles of the two overlap.
    pub fn ties(&self, other: &Timing) -> bool {
        self.lower <= other.upper && other.lower <= self.upper
    }
}

/// What became of a rung: its values and its time, or why there are none.
pub type Timed = Result<(Values, Timing), String>;

/// Hears how many of how many parts are done, and may call the rest off.
pub type Progress<'a> = dyn Fn(usize, usize) -> Result<(), Cancelled> + 'a;

/// Runs the rungs of all curves in turn, round by round. Where a rung takes too long, the rest of its curve is not run.
pub fn time(
    curves: &[&[Setting]],
    patience: Patience,
    progress: &Progress,
) -> Result<Vec<Timed>, Cancelled> {
    let mut first: Vec<WarmedUp> = Vec::new();
    for curve in curves {
        first.extend(warm_up(curve, patience.longest, &|| progress(0, 1))?);
    }
    let sweep_settings: Vec<&Setting> = curves.iter().copied().flatten().collect();
    let repeats: Vec<u32> = first
        .iter()
        .map(|first| match first {
            Ok((_, once)) => {
                let times = patience.shortest.as_secs_f64() / once.as_secs_f64().max(1e-9);
                (times.ceil() as u32).max(1)
            }
            Err(_) => 0,
        })
        .collect();
    let round = |(first, &repeats): (&WarmedUp, &u32)| match first {
        Ok((_, once)) => *once * repeats,
        Err(_) => Duration::ZERO,
    };
    let round: Duration = first.iter().zip(&repeats).map(round).sum();
    let affordable = patience.whole.as_secs_f64() / round.as_secs_f64().max(1e-9);
    let rounds = (affordable as usize).clamp(Patience::FEWEST_ROUNDS, patience.most_rounds);

    let mut seconds = vec![Vec::with_capacity(rounds); sweep_settings.len()];
    for round in 0..rounds {
        for turn in order(round, sweep_settings.len()) {
            if repeats[turn] == 0 {
                continue;
            }
            progress(round, rounds)?;
            let start = Instant::now();
            for _ in 0..repeats[turn] {
                // What succeeded before does so again: runs are deterministic.
                let _ = black_box((sweep_settings[turn].run)());
            }
            seconds[turn].push(start.elapsed().as_secs_f64() / f64::from(repeats[turn]));
        }
        progress(round + 1, rounds)?;
    }
    let timed = first.into_iter().zip(seconds);
    let timed =
        timed.map(|(first, seconds)| first.map(|(values, _)| (values, Timing::of(seconds))));
    Ok(timed.collect())
}

/// Values, and how long it took to find them.
type WarmedUp = Result<(Values, Duration), String>;

/// Every rung once, from coarse to fine, until one takes too long.
fn warm_up(
    curve: &[Setting],
    longest: Duration,
    go_on: &dyn Fn() -> Result<(), Cancelled>,
) -> Result<Vec<WarmedUp>, Cancelled> {
    let mut too_long: Option<String> = None;
    let mut run = |sweep_setting: &Setting| {
        if let Some(why) = &too_long {
            return Err(why.clone());
        }
        let start = Instant::now();
        let values = (sweep_setting.run)()?;
        let once = start.elapsed();
        if once > longest {
            let limit = longest.as_secs_f64();
            let why = format!("it takes longer than {limit} s, and so would what is finer");
            too_long = Some(why.clone());
            return Err(why);
        }
        Ok((values, once))
    };
    let run = |sweep_setting| {
        go_on()?;
        Ok(run(sweep_setting))
    };
    curve.iter().map(run).collect()
}

/// Whose turn it is in a round: each begins one later, and every other one runs backwards.
fn order(round: usize, count: usize) -> impl Iterator<Item = usize> {
    (0..count).map(move |turn| {
        let turn = if round % 2 == 1 {
            count - 1 - turn
        } else {
            turn
        };
        (turn + round) % count
    })
}

#[cfg(test)]
mod tests {
    use super::super::label::Label;
    use super::*;
    use std::cell::RefCell;
    use std::rc::Rc;

    #[test]
    fn quartiles_and_ties() {
        let timing = Timing::of(vec![5.0, 1.0, 3.0, 2.0, 4.0]);
        assert_eq!((timing.lower, timing.median, timing.upper), (2.0, 3.0, 4.0));
        let at = |median: f64| Timing {
            median,
            lower: median - 0.5,
            upper: median + 0.5,
            runs: 5,
        };
        assert!(at(1.0).ties(&at(1.9)) && at(1.9).ties(&at(1.0)));
        assert!(!at(1.0).ties(&at(2.1)));
    }

    #[test]
    fn every_round_runs_every_setting_once_in_an_order_of_its_own() {
        let orders: Vec<Vec<usize>> = (0..4).map(|round| order(round, 4).collect()).collect();
        assert_eq!(orders[0], [0, 1, 2, 3]);
        for (i, one) in orders.iter().enumerate() {
            let mut sorted = one.clone();
            sorted.sort_unstable();
            assert_eq!(sorted, [0, 1, 2, 3]);
            assert!(!orders[..i].contains(one), "{one:?}");
        }
        assert_eq!(order(3, 0).count(), 0);
    }

    #[test]
    fn a_rung_that_fails_says_why_and_is_not_run_again() {
        let runs = Rc::new(RefCell::new([0, 0]));
        let sweep_setting = |which: usize, fails: bool| {
            let runs = runs.clone();
            Setting {
                setting: Label::Plain(String::new()),
                size: 1.0,
                bytes: 0,
                operations: Vec::new(),
                truth: None,
                drawn: None,
                run: Box::new(move || {
                    runs.borrow_mut()[which] += 1;
                    match fails {
                        true => Err("diverges".into()),
                        false => Ok(Values::Numbers(vec![1.0])),
                    }
                }),
            }
        };
        let patience = Patience {
            shortest: Duration::ZERO,
            longest: Duration::from_secs(3600),
            whole: Duration::ZERO,
            most_rounds: 9,
        };
        let sweep_settings = [sweep_setting(0, false), sweep_setting(1, true)];
        let timed = time(&[&sweep_settings], patience, &|_, _| Ok(())).unwrap();
        assert!(matches!(&timed[0], Ok((_, timing)) if timing.runs == 5));
        assert!(matches!(&timed[1], Err(why) if why == "diverges"));
        assert_eq!(*runs.borrow(), [6, 1]);

        // Nothing is that quick: the first is run once, and the second not at all.
        let hasty = Patience {
            longest: Duration::ZERO,
            ..patience
        };
        let timed = time(&[&sweep_settings], hasty, &|_, _| Ok(())).unwrap();
        let skipped = |timed: &Timed| matches!(timed, Err(why) if why.contains("longer than"));
        assert!(timed.iter().all(skipped));
        assert_eq!(*runs.borrow(), [7, 1]);
    }
}
