//! Gathering: every patch collects the light of all others, B_i = E_i + ρ_i Σ_j F_ij B_j, again and again
//! (Goral, Torrance, Greenberg & Battaile 1984). What [`super::jacobi`], [`super::gauss_seidel`] and [`super::over_relaxation`] share.
//!
//! A patch that reflects nothing keeps B_i = E_i, and is left out. Where F_ii > 0 the patch's own old value is gathered too.

use super::event::SolverEvent;
use super::iterate::Method;
use super::outcome::Unsolved;
use super::record_filter::Followed;
use super::system::{System, gather};
use crate::record::{Recorder, Unrecorded};

/// One iteration: every patch that reflects gathers once, in order.
pub(super) trait Sweep {
    fn sweep<R: Recorder<SolverEvent>>(
        &mut self,
        light: &mut Light,
        followed: Followed,
        recorder: &mut R,
    );
}

/// The system, and its light so far.
pub(super) struct Light<'a> {
    pub system: System<'a>,
    pub b: Vec<f64>,
}

impl Light<'_> {
    pub fn gathers(&self, i: usize) -> bool {
        self.system.patches.gathers(i)
    }

    /// What patch i gathers of the light `from`: `new` makes its new B_i of E_i + ρ_i Σ_j F_ij B_j.
    pub fn gathered<R: Recorder<SolverEvent>>(
        &self,
        i: usize,
        from: &[f64],
        followed: Followed,
        recorder: &mut R,
        new: impl FnOnce(f64) -> f64,
    ) -> f64 {
        let patches = &self.system.patches;
        let (e_i, rho_i, b_old) = (patches.emission[i], patches.rho[i], self.b[i]);
        let row = self.system.matrix.of(i);
        recorder.enter(|| SolverEvent::Gathering {
            i: i as u32,
            e_i,
            rho_i,
            b_old,
        });
        let sum = if followed.takes(i) {
            gather(row, from, recorder)
        } else {
            gather(row, from, &mut Unrecorded)
        };
        let b_new = new(e_i + rho_i * sum);
        recorder.leave(|| SolverEvent::Gathered {
            i: i as u32,
            b_new,
            change: b_new - b_old,
        });
        b_new
    }
}

/// A solver that gathers, sweep by sweep, from B = E on.
pub(super) struct Gathering<'a, S> {
    light: Light<'a>,
    sweep: S,
    r: Vec<f64>,
}

impl<'a, S: Sweep> Gathering<'a, S> {
    pub fn new(system: System<'a>, sweep: S) -> Self {
        let b = system.patches.emission.to_vec();
        let mut r = vec![0.0; b.len()];
        system.residual(&b, &mut r);
        Gathering {
            light: Light { system, b },
            sweep,
            r,
        }
    }
}

impl<S: Sweep> Method for Gathering<'_, S> {
    fn iterate<R: Recorder<SolverEvent>>(
        &mut self,
        followed: Followed,
        recorder: &mut R,
    ) -> Result<(), Unsolved> {
        self.sweep.sweep(&mut self.light, followed, recorder);
        self.light.system.residual(&self.light.b, &mut self.r);
        Ok(())
    }

    fn radiosity(&self) -> &[f64] {
        &self.light.b
    }

    fn residual(&self) -> &[f64] {
        &self.r
    }

    fn gain(&self) -> Option<f64> {
        Some(self.light.system.gain())
    }
}
