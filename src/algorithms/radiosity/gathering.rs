//! Gathering: every patch collects the light of all others, B_i = E_i + ρ_i Σ_j F_ij B_j, again and again
//! (Goral, Torrance, Greenberg & Battaile 1984; the iterations are those of Jacobi 1845, Gauss & Seidel 1874, Young 1954).
//!
//! Jacobi's keeps the old values until all are gathered; Gauss–Seidel's uses each new value at once; over-relaxation goes ω times as
//! far. A patch that reflects nothing keeps B_i = E_i, and is left out. Where F_ii > 0 the patch's own old value is gathered too.

use super::event::Told;
use super::iterate::Method;
use super::outcome::Unsolved;
use super::system::{System, gather};
use super::watch::Followed;
use crate::record::{Listing, Recorder, Unrecorded};

pub static JACOBI: Listing = Listing {
    name: "Jacobi",
    lines: &[
        "B ← E",
        "for k = 0, 1, 2, … until ‖E − (I − ρF)B‖ ≤ ε‖E‖",
        "  for each patch i",
        "    for each patch j",
        "      sum ← sum + F_ij B_j",
        "    B'_i ← E_i + ρ_i sum",
        "  B ← B'",
    ],
};

pub static GAUSS_SEIDEL: Listing = Listing {
    name: "Gauss–Seidel",
    lines: &[
        "B ← E",
        "for k = 0, 1, 2, … until ‖E − (I − ρF)B‖ ≤ ε‖E‖",
        "  for each patch i",
        "    for each patch j",
        "      sum ← sum + F_ij B_j",
        "    B_i ← E_i + ρ_i sum",
    ],
};

pub static OVER_RELAXATION: Listing = Listing {
    name: "successive over-relaxation",
    lines: &[
        "B ← E",
        "for k = 0, 1, 2, … until ‖E − (I − ρF)B‖ ≤ ε‖E‖",
        "  for each patch i",
        "    for each patch j",
        "      sum ← sum + F_ij B_j",
        "    B_i ← B_i + ω (E_i + ρ_i sum − B_i)",
    ],
};

pub(super) fn line(told: &Told) -> usize {
    match told {
        Told::Gathering { .. } => 2,
        Told::Exchanged { .. } => 4,
        Told::Gathered { .. } => 5,
        Told::Iteration { .. } | Told::IterationDone { .. } | Told::Weighted { .. } => 1,
        Told::Converged { .. } | Told::NotConverged { .. } => 1,
        _ => 0,
    }
}

/// Which values are gathered, and how far each patch goes.
enum Sweep {
    /// All old ones.
    Old,
    /// The newest ones, ω times as far; ω = 1 is Gauss–Seidel's.
    Newest { omega: f64 },
}

pub(super) struct Gathering<'a> {
    system: System<'a>,
    sweep: Sweep,
    b: Vec<f64>,
    /// The values gathered from, where they are not those of `b`.
    old: Vec<f64>,
    r: Vec<f64>,
}

impl<'a> Gathering<'a> {
    pub fn jacobi(system: System<'a>) -> Self {
        Self::new(system, Sweep::Old)
    }

    pub fn gauss_seidel(system: System<'a>) -> Self {
        Self::new(system, Sweep::Newest { omega: 1.0 })
    }

    pub fn over_relaxation(system: System<'a>, omega: f64) -> Self {
        Self::new(system, Sweep::Newest { omega })
    }

    fn new(system: System<'a>, sweep: Sweep) -> Self {
        let b = system.patches.emission.to_vec();
        let mut r = vec![0.0; b.len()];
        system.residual(&b, &mut r);
        Gathering {
            old: b.clone(),
            system,
            sweep,
            b,
            r,
        }
    }

    /// B_i + ω (E_i + ρ_i Σ_j F_ij B_j − B_i); for ω = 1 just what was gathered.
    fn gathered<R: Recorder<Told>>(&self, i: usize, followed: Followed, recorder: &mut R) -> f64 {
        let patches = &self.system.patches;
        let (e_i, rho_i, b_old) = (patches.emission[i], patches.rho[i], self.b[i]);
        let (from, omega) = match self.sweep {
            Sweep::Old => (&self.old, 1.0),
            Sweep::Newest { omega } => (&self.b, omega),
        };
        let row = self.system.matrix.of(i);
        recorder.enter(|| Told::Gathering {
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
        let b_new = if omega == 1.0 {
            e_i + rho_i * sum
        } else {
            b_old + omega * (e_i + rho_i * sum - b_old)
        };
        recorder.leave(|| Told::Gathered {
            i: i as u32,
            b_new,
            change: b_new - b_old,
        });
        b_new
    }
}

impl Method for Gathering<'_> {
    fn iterate<R: Recorder<Told>>(
        &mut self,
        followed: Followed,
        recorder: &mut R,
    ) -> Result<(), Unsolved> {
        match self.sweep {
            Sweep::Old => self.old.copy_from_slice(&self.b),
            Sweep::Newest { omega } if omega != 1.0 => recorder.step(|| Told::Weighted { omega }),
            Sweep::Newest { .. } => {}
        }
        for i in 0..self.b.len() {
            if self.system.patches.rho[i] > 0.0 {
                self.b[i] = self.gathered(i, followed, recorder);
            }
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

/// Young's ω = 2 / (1 + √(1 − μ²)) for the bound μ = max_i ρ_i Σ_j F_ij on the spectral radius; 1 where μ is no bound below 1.
pub(super) fn youngs_omega(gain: f64) -> f64 {
    if gain < 1.0 {
        2.0 / (1.0 + (1.0 - gain * gain).sqrt())
    } else {
        1.0
    }
}
