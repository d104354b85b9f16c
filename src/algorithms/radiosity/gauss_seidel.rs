//! Gauss–Seidel's iteration: each patch gathers the newest light there is (Seidel 1874; Cohen & Greenberg 1985). About half as many
//! iterations as Jacobi's.

use super::Solver;
use super::event::{Event, SolverEvent};
use super::gathering::{Gathering, Light, Sweep};
use super::outcome::{Solution, Unsolved};
use super::record_filter::Followed;
use super::solver::{Problem, Properties};
use crate::record::{Listing, Recorder};

pub static PSEUDOCODE: Listing = Listing {
    name: "Gauss–Seidel",
    lines: &[
        ("start started", "B ← E"),
        (
            "iteration weight",
            "{for} k = 0, 1, 2, … {until} ‖E − (I − ρF)B‖ ≤ ε‖E‖",
        ),
        ("gathering", "  {for-each-patch-i}"),
        ("", "    {for-each-patch-j}"),
        ("exchange", "      sum ← sum + F_ij B_j"),
        ("gathered", "    B_i ← E_i + ρ_i sum"),
    ],
};

pub(super) const SOLVER: Properties = Properties::new("gauss-seidel", "GS", &PSEUDOCODE);

pub(super) fn solve<R: Recorder<Event>>(
    problem: &Problem,
    recorder: &mut R,
) -> Result<Solution, Unsolved> {
    let method = Gathering::new(problem.system, GaussSeidel);
    problem.run(Solver::GaussSeidel, method, recorder)
}

pub(super) struct GaussSeidel;

impl Sweep for GaussSeidel {
    fn sweep<R: Recorder<SolverEvent>>(
        &mut self,
        light: &mut Light,
        followed: Followed,
        recorder: &mut R,
    ) {
        for i in 0..light.b.len() {
            if light.gathers(i) {
                light.b[i] = light.gathered(i, &light.b, followed, recorder, |gathered| gathered);
            }
        }
    }
}
