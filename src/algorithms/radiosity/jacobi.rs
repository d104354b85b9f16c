//! Jacobi's iteration: all patches gather the light of the iteration before (Jacobi 1845; Goral et al. 1984). After k iterations B holds the
//! light of at most k reflections.

use super::Solver;
use super::event::{Event, SolverEvent};
use super::gathering::{Gathering, Light, Sweep};
use super::outcome::{Solution, Unsolved};
use super::record_filter::Followed;
use super::solver::{Problem, Properties};
use crate::record::{Listing, Recorder};

pub static PSEUDOCODE: Listing = Listing {
    name: "Jacobi",
    lines: &[
        ("start started", "B ← E"),
        (
            "iteration weight",
            "{for} k = 0, 1, 2, … {until} ‖E − (I − ρF)B‖ ≤ ε‖E‖",
        ),
        ("gathering", "  {for-each-patch-i}"),
        ("", "    {for-each-patch-j}"),
        ("exchange", "      sum ← sum + F_ij B_j"),
        ("gathered", "    B'_i ← E_i + ρ_i sum"),
        ("", "  B ← B'"),
    ],
};

pub(super) const SOLVER: Properties = Properties::new("jacobi", "J", &PSEUDOCODE);

pub(super) fn solve<R: Recorder<Event>>(
    problem: &Problem,
    recorder: &mut R,
) -> Result<Solution, Unsolved> {
    let method = Gathering::new(problem.system, Jacobi::default());
    problem.run(Solver::Jacobi, method, recorder)
}

/// The light of the iteration before.
#[derive(Default)]
pub(super) struct Jacobi(Vec<f64>);

impl Sweep for Jacobi {
    fn sweep<R: Recorder<SolverEvent>>(
        &mut self,
        light: &mut Light,
        followed: Followed,
        recorder: &mut R,
    ) {
        let old = &mut self.0;
        old.clone_from(&light.b);
        for i in 0..old.len() {
            if light.gathers(i) {
                light.b[i] = light.gathered(i, old, followed, recorder, |gathered| gathered);
            }
        }
    }
}
