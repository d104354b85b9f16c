//! Jacobi's iteration: all patches gather the light of the iteration before (Jacobi 1845; Goral et al. 1984). After k iterations B holds the
//! light of at most k reflections.

use super::event::SolverEvent;
use super::gathering::{Light, Sweep};
use super::record_filter::Followed;
use crate::record::{Listing, Recorder};

pub static PSEUDOCODE: Listing = Listing {
    name: "Jacobi",
    lines: &[
        ("start started", "B ← E"),
        (
            "iteration weight",
            "for k = 0, 1, 2, … until ‖E − (I − ρF)B‖ ≤ ε‖E‖",
        ),
        ("gathering", "  for each patch i"),
        ("", "    for each patch j"),
        ("exchange", "      sum ← sum + F_ij B_j"),
        ("gathered", "    B'_i ← E_i + ρ_i sum"),
        ("", "  B ← B'"),
    ],
};

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
