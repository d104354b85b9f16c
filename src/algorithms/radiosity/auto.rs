//! The default: conjugate gradients, which need few iterations however little light is lost; elimination where they fail, because
//! the matrix is too far from reciprocal.

use super::event::Event;
use super::outcome::{Solution, Unsolved};
use super::solver::{Problem, Properties, solve as solve_by};
use super::{Solver, conjugate_gradients};
use crate::record::Recorder;

pub(super) const SOLVER: Properties = Properties {
    name: "auto",
    symbol: "auto",
    ..conjugate_gradients::SOLVER
};

pub(super) fn solve<R: Recorder<Event>>(
    problem: &Problem,
    recorder: &mut R,
) -> Result<Solution, Unsolved> {
    let Problem {
        system,
        stop,
        filter,
    } = problem;
    match solve_by(system, Solver::ConjugateGradients, *stop, filter, recorder) {
        Err(Unsolved::NotConverged { .. } | Unsolved::GainsLight | Unsolved::Diverges { .. }) => {
            solve_by(system, Solver::Direct, *stop, filter, recorder)
        }
        done => done,
    }
}
