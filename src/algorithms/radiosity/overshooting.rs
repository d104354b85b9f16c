//! Overshooting: shooting in which a patch sends, beside its unshot light, what it will come to have in the mean
//! (Feda & Purgathofer 1992).

use super::Solver;
use super::event::Event;
use super::outcome::{Solution, Unsolved};
use super::shooting::{self, shoot_by};
use super::solver::{Problem, Properties};
use crate::record::{Listing, Recorder};

pub static PSEUDOCODE: Listing = Listing {
    name: "overshooting",
    lines: &[
        ("start started", "B ← 0;  unshot ← E"),
        ("iteration", "{for} k = 0, 1, 2, … {until} ‖unshot‖ ≤ ε‖E‖"),
        (
            "ambient",
            "  ambient ← ⟨ρ⟩⟨unshot⟩ / (1 − ⟨ρ⟩), {means-by-area}",
        ),
        (
            "shooting",
            "  i ← {the-patch-of-largest} |unshot_i + ambient| A_i",
        ),
        ("", "  {for-each-patch-j}"),
        ("", "    F_ji ← F_ij A_i / A_j"),
        (
            "received",
            "    unshot_j ← unshot_j + ρ_j F_ji (unshot_i + ambient)",
        ),
        (
            "shot",
            "  B_i ← B_i + unshot_i + ambient;  unshot_i ← −ambient + {what-it-received}",
        ),
    ],
};

pub(super) const SOLVER: Properties = Properties {
    name: "overshooting",
    symbol: "S+",
    listing: &PSEUDOCODE,
    ..shooting::SOLVER
};

pub(super) fn solve<R: Recorder<Event>>(
    problem: &Problem,
    recorder: &mut R,
) -> Result<Solution, Unsolved> {
    shoot_by(Solver::Overshooting, problem, recorder)
}
