//! Successive over-relaxation: Gauss–Seidel's step, ω times as far (Young 1954).

use super::Solver;
use super::event::{Event, SolverEvent};
use super::gathering::{Gathering, Light, Sweep};
use super::outcome::{Solution, Unsolved};
use super::record_filter::Followed;
use super::solver::{Problem, Properties};
use crate::record::{Listing, Recorder};

pub static PSEUDOCODE: Listing = Listing {
    name: "successive over-relaxation",
    lines: &[
        ("start started", "B ← E"),
        (
            "iteration weight",
            "{for} k = 0, 1, 2, … {until} ‖E − (I − ρF)B‖ ≤ ε‖E‖",
        ),
        ("gathering", "  {for-each-patch-i}"),
        ("", "    {for-each-patch-j}"),
        ("exchange", "      sum ← sum + F_ij B_j"),
        ("gathered", "    B_i ← B_i + ω (E_i + ρ_i sum − B_i)"),
    ],
};

pub(super) const SOLVER: Properties = Properties::new("over-relaxation", "SOR", &PSEUDOCODE);

pub(super) fn solve<R: Recorder<Event>>(
    problem: &Problem,
    recorder: &mut R,
) -> Result<Solution, Unsolved> {
    let omega = youngs_omega(problem.system.gain());
    let method = Gathering::new(problem.system, OverRelaxation { omega });
    problem.run(Solver::OverRelaxation, method, recorder)
}

struct OverRelaxation {
    omega: f64,
}

impl Sweep for OverRelaxation {
    fn sweep<R: Recorder<SolverEvent>>(
        &mut self,
        light: &mut Light,
        followed: Followed,
        recorder: &mut R,
    ) {
        let omega = self.omega;
        recorder.step(|| SolverEvent::Weighted { omega });
        for i in 0..light.b.len() {
            if light.gathers(i) {
                let b_i = light.b[i];
                let farther = |gathered| b_i + omega * (gathered - b_i);
                light.b[i] = light.gathered(i, &light.b, followed, recorder, farther);
            }
        }
    }
}

/// Young's ω = 2 / (1 + √(1 − μ²)) for the bound μ = max_i ρ_i Σ_j F_ij on the spectral radius; 1 where μ is no bound below 1.
fn youngs_omega(gain: f64) -> f64 {
    if gain < 1.0 {
        2.0 / (1.0 + (1.0 - gain * gain).sqrt())
    } else {
        1.0
    }
}
