//! Chebyshev's semi-iteration: gathering, with each iterate weighted so that the error polynomial is the smallest one on an
//! interval that holds the spectrum of ρF (Golub & Varga 1961; Varga, "Matrix Iterative Analysis", §5.1).
//!
//! By default the interval is [−μ, μ], μ = max_i ρ_i Σ_j F_ij, which bounds the spectral radius. An interval that leaves part of
//! the spectrum out makes the residual grow, and that is what is said then.

use super::Solver;
use super::event::{Event, SolverEvent};
use super::iterate::Method;
use super::outcome::{Solution, Stop, Unsolved};
use super::record_filter::{Followed, RecordFilter};
use super::singularity_check::refuse_endless_light;
use super::solver::{Problem, Properties};
use super::system::System;
use crate::record::{Listing, Recorder};

pub static PSEUDOCODE: Listing = Listing {
    name: "Chebyshev iteration on [a, b]",
    lines: &[
        (
            "start started",
            "B ← E;  γ ← 2 / (2 − a − b);  σ ← (b − a) / (2 − a − b);  ω ← 1",
        ),
        (
            "iteration",
            "{for} k = 0, 1, 2, … {until} ‖r‖ ≤ ε‖E‖, r = E − (I − ρF)B",
        ),
        (
            "weight",
            "  ω ← 1, {then} 1 / (1 − σ²/2), {then} 1 / (1 − σ²ω/4)",
        ),
        ("updated", "  B' ← B_before + ω (γ r + B − B_before)"),
        ("", "  B_before ← B;  B ← B'"),
    ],
};

pub(super) const SOLVER: Properties = Properties::new("chebyshev", "Ch", &PSEUDOCODE);

pub(super) fn solve<R: Recorder<Event>>(
    problem: &Problem,
    recorder: &mut R,
) -> Result<Solution, Unsolved> {
    let gain = problem.system.gain();
    let method = Chebyshev::new(problem.system, [-gain, gain])?;
    problem.run(Solver::Chebyshev, method, recorder)
}

/// On an interval of one's own, below 1, which ought to hold the spectrum of ρF.
pub fn chebyshev_on<R: Recorder<Event>>(
    system: &System,
    interval: [f64; 2],
    stop: Stop,
    filter: &RecordFilter,
    recorder: &mut R,
) -> Result<Solution, Unsolved> {
    refuse_endless_light(system)?;
    let problem = Problem {
        system: *system,
        stop,
        filter,
    };
    let method = Chebyshev::new(*system, interval)?;
    problem.run(Solver::Chebyshev, method, recorder)
}

pub(super) struct Chebyshev<'a> {
    system: System<'a>,
    gamma: f64,
    sigma: f64,
    omega: f64,
    k: u32,
    b: Vec<f64>,
    b_before: Vec<f64>,
    r: Vec<f64>,
}

impl<'a> Chebyshev<'a> {
    /// Errors: an interval that is not below 1, or is empty.
    pub fn new(system: System<'a>, [low, high]: [f64; 2]) -> Result<Self, Unsolved> {
        if !(low <= high && high < 1.0 && low.is_finite()) {
            return Err(Unsolved::NoInterval { gain: high });
        }
        let b = system.patches.emission.to_vec();
        let mut r = vec![0.0; b.len()];
        system.residual(&b, &mut r);
        Ok(Chebyshev {
            system,
            gamma: 2.0 / (2.0 - low - high),
            sigma: (high - low) / (2.0 - low - high),
            omega: 1.0,
            k: 0,
            b_before: b.clone(),
            b,
            r,
        })
    }
}

impl Method for Chebyshev<'_> {
    fn iterate<R: Recorder<SolverEvent>>(
        &mut self,
        _: Followed,
        recorder: &mut R,
    ) -> Result<(), Unsolved> {
        let square = self.sigma * self.sigma;
        self.omega = match self.k {
            0 => 1.0,
            1 => 1.0 / (1.0 - square / 2.0),
            _ => 1.0 / (1.0 - square * self.omega / 4.0),
        };
        self.k += 1;
        let omega = self.omega;
        recorder.step(|| SolverEvent::Weighted { omega });
        for i in 0..self.b.len() {
            let (b_old, before) = (self.b[i], self.b_before[i]);
            let b_new = before + omega * (self.gamma * self.r[i] + b_old - before);
            (self.b_before[i], self.b[i]) = (b_old, b_new);
            recorder.step(|| SolverEvent::Updated {
                i: i as u32,
                b_old,
                b_new,
            });
        }
        self.system.residual(&self.b, &mut self.r);
        Ok(())
    }

    fn radiosity(&self) -> &[f64] {
        &self.b
    }

    fn residual(&self) -> &[f64] {
        &self.r
    }

    fn gain(&self) -> Option<f64> {
        Some(self.system.gain())
    }
}
