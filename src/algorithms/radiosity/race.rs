//! All solvers on one system, side by side: what is left after how many iterations, and after how long.
//!
//! Each runs from its own start to the same tolerance, as everywhere else, and is recorded by a stopwatch that keeps laps.
//! The exact solution is taken from the default solver at [`REFERENCE`].

use super::Solver;
use super::event::{Event, SolverEvent};
use super::outcome::{Stop, Unsolved};
use super::record_filter::RecordFilter;
use super::solver::solve;
use super::system::System;
use crate::record::{Recorder, Unrecorded};
use std::iter::zip;

/// Multiplications that a solver may take: then it has lost.
const PATIENCE: f64 = 1e8;
/// Each lap is this many times as many iterations after the start as the one before, so that a million of them leave a hundred.
const APART: f64 = 1.06;
/// Iterations before a solver is timed.
const WARM_UP: u32 = 10;
/// The relative residual of what counts as exact.
pub const REFERENCE: f64 = 1e-13;

/// How every solver did on one system.
#[derive(Clone, Debug, PartialEq)]
pub struct Race {
    pub channel: &'static str,
    pub patches: usize,
    pub tolerance: f64,
    pub racers: Vec<Racer>,
}

/// How one solver did.
#[derive(Clone, Debug, PartialEq)]
pub struct Racer {
    pub solver: Solver,
    /// Ascending, the last one at its end.
    pub laps: Vec<Lap>,
    /// What kept it from a result.
    pub unsolved: Option<Unsolved>,
}

/// Where a solver stands after an iteration.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lap {
    /// Iterations done, or shots of one patch.
    pub iterations: u32,
    /// Since it began, without the time that looking at it took.
    pub seconds: f64,
    /// ‖E − (I − ρF)B‖₂ / ‖E‖₂.
    pub residual: f64,
    /// ‖B − B*‖_∞ / ‖B*‖_∞.
    pub error: f64,
}

impl Race {
    /// Lets every solver run, one after the other, on the clock given, in seconds.
    ///
    /// Errors: those of `go_on`, which is asked before each and calls the rest off; inside, those of the reference.
    pub fn run<E>(
        system: &System,
        channel: &'static str,
        tolerance: f64,
        mut clock: impl FnMut() -> f64,
        go_on: impl Fn() -> Result<(), E>,
    ) -> Result<Result<Race, Unsolved>, E> {
        let exactly = Stop {
            tolerance: REFERENCE,
            ..Stop::default()
        };
        let filter = RecordFilter::default();
        let reference = match solve(system, Solver::Auto, exactly, &filter, &mut Unrecorded) {
            Ok(solution) => solution.radiosity,
            Err(why) => return Ok(Err(why)),
        };
        let patches = reference.len();
        let solvers = Solver::ALL.into_iter().filter(|&solver| {
            solver != Solver::Auto && solver.multiplications(patches) <= PATIENCE
        });
        let racers = solvers.map(|solver| {
            go_on()?;
            let stop = Stop {
                tolerance,
                max_iterations: (PATIENCE / solver.multiplications(patches)) as u32,
            };
            // A first few iterations untimed: whoever runs first would else fetch the matrix from memory for all.
            let warm_up = Stop {
                max_iterations: stop.max_iterations.min(WARM_UP),
                ..stop
            };
            let _ = solve(system, solver, warm_up, &filter, &mut Unrecorded);
            let mut stopwatch = Stopwatch::new(system.patches.emission, &reference, &mut clock);
            let solution = solve(system, solver, stop, &filter, &mut stopwatch);
            Ok(stopwatch.finish(solver, solution))
        });
        Ok(Ok(Race {
            channel,
            patches,
            tolerance,
            racers: racers.collect::<Result<_, E>>()?,
        }))
    }
}

impl Racer {
    /// Where it stands at `now`, as `by` counts: at its last lap until then.
    pub fn at(&self, now: f64, by: impl Fn(&Lap) -> f64) -> Option<&Lap> {
        let behind = self.laps.partition_point(|lap| by(lap) <= now);
        self.laps.get(behind.checked_sub(1)?)
    }

    /// Rows of the matrix that were used, over the number of patches: of the shooting methods as many shots count as one iteration
    /// as there are patches.
    pub fn sweeps(&self, lap: &Lap, patches: usize) -> f64 {
        let count = f64::from(lap.iterations);
        match self.solver.shoots() {
            true => count / patches as f64,
            false => count,
        }
    }
}

/// Takes the time of a solver after its iterations, and stands still while the result so far is looked at.
struct Stopwatch<'a, C> {
    clock: &'a mut C,
    start: f64,
    /// Seconds that do not count.
    paused: f64,
    exact: &'a [f64],
    largest: f64,
    /// B as recorded so far.
    b: Vec<f64>,
    /// How many scopes are open.
    depth: usize,
    iterations: u32,
    /// The number of iterations after which the next lap is kept.
    next: u32,
    laps: Vec<Lap>,
}

/// The solver's system is open, and in it an iteration.
const ITERATION: usize = 2;

impl<'a, C: FnMut() -> f64> Stopwatch<'a, C> {
    fn new(emission: &[f64], exact: &'a [f64], clock: &'a mut C) -> Self {
        Stopwatch {
            start: clock(),
            clock,
            paused: 0.0,
            exact,
            largest: largest(exact.iter().copied()),
            b: emission.to_vec(),
            depth: 0,
            iterations: 0,
            next: 1,
            laps: Vec::new(),
        }
    }

    fn seconds(&mut self) -> f64 {
        (self.clock)() - self.start - self.paused
    }

    fn error(&self, b: &[f64]) -> f64 {
        largest(zip(b, self.exact).map(|(b, exact)| b - exact)) / self.largest
    }

    fn lap(&mut self, residual: f64, seconds: f64) {
        self.laps.push(Lap {
            iterations: self.iterations,
            seconds,
            residual,
            error: self.error(&self.b),
        });
    }

    fn take(&mut self, recorded: SolverEvent) {
        match recorded {
            SolverEvent::Started { i, b, .. }
            | SolverEvent::Gathered { i, b_new: b, .. }
            | SolverEvent::Updated { i, b_new: b, .. }
            | SolverEvent::ShotDone { i, b_i: b, .. } => self.b[i as usize] = b,
            _ => {}
        }
    }

    fn finish(mut self, solver: Solver, solution: Result<super::Solution, Unsolved>) -> Racer {
        let seconds = self.seconds();
        let last = self.laps.last().map_or(0, |lap| lap.iterations);
        let unsolved = match solution {
            Ok(solution) => {
                self.b = solution.radiosity;
                if last < solution.iterations {
                    self.iterations = solution.iterations;
                    self.lap(solution.residual, seconds);
                }
                None
            }
            Err(Unsolved::NotConverged {
                iterations,
                residual,
            }) if last < iterations => {
                self.iterations = iterations;
                self.lap(residual, seconds);
                Some(Unsolved::NotConverged {
                    iterations,
                    residual,
                })
            }
            Err(unsolved) => Some(unsolved),
        };
        Racer {
            solver,
            laps: self.laps,
            unsolved,
        }
    }
}

impl<C: FnMut() -> f64> Recorder<Event> for Stopwatch<'_, C> {
    #[inline(always)]
    fn step(&mut self, event: impl FnOnce() -> Event) {
        self.take(event().recorded);
    }

    #[inline(always)]
    fn enter(&mut self, _: impl FnOnce() -> Event) {
        self.depth += 1;
    }

    #[inline(always)]
    fn leave(&mut self, event: impl FnOnce() -> Event) {
        if self.depth == ITERATION {
            self.iterations += 1;
            if self.iterations >= self.next {
                let seconds = self.seconds();
                if let SolverEvent::IterationDone { residual, .. } = event().recorded {
                    self.lap(residual, seconds);
                }
                self.next = (f64::from(self.iterations) * APART) as u32 + 1;
                self.paused += self.seconds() - seconds;
            }
        } else {
            self.take(event().recorded);
        }
        self.depth -= 1;
    }
}

fn largest(values: impl Iterator<Item = f64>) -> f64 {
    values.fold(0.0, |most: f64, value| most.max(value.abs()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algorithms::radiosity::cube::{cube, lamp};
    use crate::algorithms::radiosity::{Matrix, Patches};
    use std::convert::Infallible;

    /// The race on the cube of n×n patches a face, on a clock that ticks a second each time it is looked at.
    fn race(n: usize, rho: f64) -> Race {
        let (f, area) = cube(n);
        let (rho, emission) = (vec![rho; area.len()], lamp(n));
        let matrix = Matrix::new(&f, area.len()).unwrap();
        let patches = Patches::new(&area, &rho, &emission).unwrap();
        let system = System::new(&matrix, patches).unwrap();
        let mut ticks = 0.0;
        let clock = || {
            ticks += 1.0;
            ticks
        };
        let Ok(race) = Race::run(&system, "red", 1e-6, clock, || Ok::<(), Infallible>(()));
        race.unwrap()
    }

    #[test]
    fn every_solver_ends_where_it_would_end_alone() {
        let race = race(4, 0.9);
        let (f, area) = cube(4);
        let (rho, emission) = (vec![0.9; area.len()], lamp(4));
        let matrix = Matrix::new(&f, area.len()).unwrap();
        let patches = Patches::new(&area, &rho, &emission).unwrap();
        let system = System::new(&matrix, patches).unwrap();
        assert_eq!(race.racers.len(), Solver::ALL.len() - 1);
        for racer in &race.racers {
            let (stop, filter) = (Stop::default(), RecordFilter::default());
            let alone = solve(&system, racer.solver, stop, &filter, &mut Unrecorded).unwrap();
            let last = racer.laps.last().unwrap();
            let name = racer.solver.name();
            assert_eq!(racer.unsolved, None, "{name}");
            assert_eq!(last.iterations, alone.iterations, "{name}");
            // A residual that is carried along is recorded as it was then, and computed anew at the end.
            assert!((last.residual - alone.residual).abs() < 1e-12, "{name}");
        }
    }

    #[test]
    fn laps_ascend_and_errors_shrink_to_what_is_left() {
        for racer in race(3, 0.5).racers {
            let name = racer.solver.name();
            let pairs = || racer.laps.windows(2);
            assert!(
                pairs().all(|lap| lap[0].iterations < lap[1].iterations),
                "{name}"
            );
            assert!(pairs().all(|lap| lap[0].seconds < lap[1].seconds), "{name}");
            assert!(racer.laps.last().unwrap().error < 1e-5, "{name}");
            let first = racer.laps[0];
            assert_eq!(racer.at(0.5 * first.seconds, |lap| lap.seconds), None);
            assert_eq!(racer.at(first.seconds, |lap| lap.seconds), Some(&first));
        }
    }

    #[test]
    fn who_is_too_slow_is_said_to_have_lost() {
        let race = race(6, 0.9999);
        let named = |solver| {
            let racer = race.racers.iter().find(|racer| racer.solver == solver);
            racer.unwrap()
        };
        let jacobi = named(Solver::Jacobi);
        assert!(matches!(
            jacobi.unsolved,
            Some(Unsolved::NotConverged { .. })
        ));
        let conjugate_gradients = named(Solver::ConjugateGradients);
        assert_eq!(conjugate_gradients.unsolved, None);
        assert!(conjugate_gradients.laps.len() < 20);
    }
}
