//! Conjugate gradients (Hestenes & Stiefel 1952) on the symmetrised system: row i times A_i/ρ_i makes it symmetric by
//! reciprocity, A_i F_ij = A_j F_ji, and positive definite where light is lost. With z the residual of the given system as
//! preconditioned residual, the lengths of steps are inner products weighted by w_i = A_i/ρ_i.
//!
//! A patch that reflects nothing has B_i = E_i from the start, and its row is left out: w_i = 0.

use super::Solver;
use super::event::{Event, SolverEvent};
use super::iterate::Method;
use super::outcome::{Solution, Unsolved};
use super::record_filter::Followed;
use super::solver::{Problem, Properties};
use super::system::{System, gather};
use crate::record::{Listing, Recorder, Unrecorded};
use std::iter::zip;

pub static PSEUDOCODE: Listing = Listing {
    name: "conjugate gradients, symmetrised",
    lines: &[
        ("start", "w_i ← A_i / ρ_i;  S ← w (I − ρF)"),
        (
            "started",
            "B ← E;  s ← w (E − (I − ρF)B);  p ← M⁻¹s, M = w;  δ ← s·M⁻¹s",
        ),
        (
            "iteration",
            "{for} k = 0, 1, 2, … {until} ‖r‖ ≤ ε‖E‖, r = M⁻¹s",
        ),
        ("", "  α ← δ / (p·Sp)"),
        ("updated", "  B ← B + α p"),
        (
            "step-lengths",
            "  s ← s − α Sp;  β ← (s·M⁻¹s) / δ;  δ ← s·M⁻¹s",
        ),
        ("", "  p ← M⁻¹s + β p"),
    ],
};

pub(super) const SOLVER: Properties = Properties::new("conjugate-gradients", "CG", &PSEUDOCODE);

pub(super) fn solve<R: Recorder<Event>>(
    problem: &Problem,
    recorder: &mut R,
) -> Result<Solution, Unsolved> {
    let method = ConjugateGradients::new(problem.system);
    problem.run(Solver::ConjugateGradients, method, recorder)
}

pub(super) struct ConjugateGradients<'a> {
    system: System<'a>,
    /// A_i/ρ_i; 0 where ρ_i is 0.
    weight: Vec<f64>,
    b: Vec<f64>,
    /// The residual of the given system: M⁻¹s.
    r: Vec<f64>,
    p: Vec<f64>,
    /// (I − ρF)p.
    ap: Vec<f64>,
    /// s·M⁻¹s.
    delta: f64,
}

impl<'a> ConjugateGradients<'a> {
    pub fn new(system: System<'a>) -> Self {
        let patches = &system.patches;
        let weight = zip(patches.area, patches.rho)
            .map(|(&a, &rho)| if rho > 0.0 { a / rho } else { 0.0 })
            .collect();
        let b = patches.emission.to_vec();
        let n = b.len();
        let mut solver = ConjugateGradients {
            system,
            weight,
            b,
            r: vec![0.0; n],
            p: vec![0.0; n],
            ap: vec![0.0; n],
            delta: 0.0,
        };
        solver.begin();
        solver
    }

    /// The direction of steepest descent, from the exact residual.
    fn begin(&mut self) {
        self.system.residual(&self.b, &mut self.r);
        self.p.copy_from_slice(&self.r);
        self.delta = weighted(&self.weight, &self.r, &self.r);
    }
}

/// Σ w_i x_i y_i.
fn weighted(w: &[f64], x: &[f64], y: &[f64]) -> f64 {
    zip(w, zip(x, y)).map(|(w, (x, y))| w * x * y).sum()
}

impl Method for ConjugateGradients<'_> {
    const CARRIES_RESIDUAL: bool = true;

    fn iterate<R: Recorder<SolverEvent>>(
        &mut self,
        _: Followed,
        recorder: &mut R,
    ) -> Result<(), Unsolved> {
        let rho = self.system.patches.rho;
        for (i, &rho_i) in rho.iter().enumerate() {
            if rho_i > 0.0 {
                let row = self.system.matrix.of(i);
                self.ap[i] = self.p[i] - rho_i * gather(row, &self.p, &mut Unrecorded);
            }
        }
        let curvature = weighted(&self.weight, &self.p, &self.ap);
        // Not positive definite: somewhere more light is reflected than arrives.
        if curvature.is_nan() || curvature <= 0.0 {
            return Err(Unsolved::GainsLight);
        }
        let alpha = self.delta / curvature;
        for i in 0..self.b.len() {
            let b_old = self.b[i];
            self.b[i] += alpha * self.p[i];
            self.r[i] -= alpha * self.ap[i];
            recorder.step(|| SolverEvent::Updated {
                i: i as u32,
                b_old,
                b_new: self.b[i],
            });
        }
        let delta = weighted(&self.weight, &self.r, &self.r);
        let beta = delta / self.delta;
        self.delta = delta;
        recorder.step(|| SolverEvent::StepLengths { alpha, beta });
        for (p, r) in zip(&mut self.p, &self.r) {
            *p = r + beta * *p;
        }
        Ok(())
    }

    fn radiosity(&self) -> &[f64] {
        &self.b
    }

    fn residual(&self) -> &[f64] {
        &self.r
    }

    /// Begins anew from the exact residual, should it turn out not to be small enough.
    fn confirm(&mut self) {
        self.begin();
    }

    fn gain(&self) -> Option<f64> {
        Some(self.system.gain())
    }
}
