//! Shooting: the patch with the most unshot light sends it to all others, F_ji by reciprocity from its own row
//! (progressive refinement: Cohen, Chen, Wallace & Greenberg 1988; the relaxation is Southwell's 1946).
//! [`super::overshooting`] shares the body.
//!
//! A shot needs only the row of its patch, so no matrix need be stored; the exact residual at the end takes all rows.

use super::Solver;
use super::event::{Event, SolverEvent};
use super::iterate::Method;
use super::iterate::{TaggingRecorder, run};
use super::outcome::{Solution, Stop, Unsolved};
use super::record_filter::{Followed, RecordFilter};
use super::solver::{Problem, Properties};
use super::system::{Patches, Rows, System, residual};
use crate::record::{Listing, Recorder};
use std::iter::zip;

pub static PSEUDOCODE: Listing = Listing {
    name: "shooting",
    lines: &[
        ("start started", "B ← 0;  unshot ← E"),
        ("iteration", "{for} k = 0, 1, 2, … {until} ‖unshot‖ ≤ ε‖E‖"),
        ("shooting", "  i ← {the-patch-of-largest} |unshot_i| A_i"),
        ("", "  {for-each-patch-j}"),
        ("", "    F_ji ← F_ij A_i / A_j"),
        ("received", "    unshot_j ← unshot_j + ρ_j F_ji unshot_i"),
        (
            "shot",
            "  B_i ← B_i + unshot_i;  unshot_i ← {what-it-received}",
        ),
    ],
};

pub(super) const SOLVER: Properties = Properties {
    multiplications: |n| n,
    shoots: true,
    ..Properties::new("shooting", "S", &PSEUDOCODE)
};

pub(super) fn solve<R: Recorder<Event>>(
    problem: &Problem,
    recorder: &mut R,
) -> Result<Solution, Unsolved> {
    shoot_by(Solver::Shooting, problem, recorder)
}

/// Shooting or overshooting, with the rows of the stored matrix.
pub(super) fn shoot_by<R: Recorder<Event>>(
    solver: Solver,
    problem: &Problem,
    recorder: &mut R,
) -> Result<Solution, Unsolved> {
    let System {
        matrix, patches, ..
    } = problem.system;
    let gain = Some(problem.system.gain());
    let method = Shooter::new(matrix, patches, solver == Solver::Overshooting, gain);
    problem.run(solver, method, recorder)
}

/// Shooting, or overshooting, with no matrix stored: each shot computes its row, and the residual at the end all of them. No bound on the error is known, since that takes the sums of all rows.
pub fn shoot<F: Rows, R: Recorder<Event>>(
    rows: F,
    patches: &Patches,
    overshoots: bool,
    stop: Stop,
    filter: &RecordFilter,
    recorder: &mut R,
) -> Result<Solution, Unsolved> {
    let solver = if overshoots {
        Solver::Overshooting
    } else {
        Solver::Shooting
    };
    let method = Shooter::new(rows, *patches, overshoots, None);
    run(
        method,
        patches,
        stop,
        filter,
        &mut TaggingRecorder { solver, recorder },
    )
}

struct Shooter<'a, F> {
    rows: F,
    patches: Patches<'a>,
    overshoots: bool,
    /// ⟨ρ⟩, and the area of all patches.
    mean_rho: f64,
    area: f64,
    b: Vec<f64>,
    unshot: Vec<f64>,
    gain: Option<f64>,
}

impl<'a, F: Rows> Shooter<'a, F> {
    /// `gain` is max_i ρ_i Σ_j F_ij, where it is known.
    pub fn new(rows: F, patches: Patches<'a>, overshoots: bool, gain: Option<f64>) -> Self {
        let area: f64 = patches.area.iter().sum();
        let reflecting: f64 = zip(patches.area, patches.rho).map(|(a, rho)| a * rho).sum();
        Shooter {
            rows,
            overshoots,
            mean_rho: reflecting / area,
            area,
            b: vec![0.0; patches.len()],
            unshot: patches.emission.to_vec(),
            gain,
            patches,
        }
    }

    /// What the unshot light will come to in the mean, were the enclosure evenly lit; 0 where nothing is lost.
    fn ambient(&self) -> f64 {
        let flux: f64 = zip(self.patches.area, &self.unshot)
            .map(|(a, r)| a * r)
            .sum();
        if self.mean_rho < 1.0 {
            self.mean_rho * (flux / self.area) / (1.0 - self.mean_rho)
        } else {
            0.0
        }
    }

    /// The patch with the most to shoot; the first of equals.
    fn brightest(&self, ambient: f64) -> usize {
        let (mut brightest, mut most) = (0, -1.0);
        for (i, (r, a)) in zip(&self.unshot, self.patches.area).enumerate() {
            let flux = (r + ambient).abs() * a;
            if flux > most {
                (brightest, most) = (i, flux);
            }
        }
        brightest
    }
}

impl<F: Rows> Method for Shooter<'_, F> {
    const CARRIES_RESIDUAL: bool = true;

    fn iterate<R: Recorder<SolverEvent>>(
        &mut self,
        followed: Followed,
        recorder: &mut R,
    ) -> Result<(), Unsolved> {
        let ambient = if self.overshoots { self.ambient() } else { 0.0 };
        if self.overshoots {
            recorder.step(|| SolverEvent::Ambient { ambient });
        }
        let i = self.brightest(ambient);
        let a_i = self.patches.area[i];
        let shot = self.unshot[i] + ambient;
        recorder.enter(|| SolverEvent::Shooting {
            i: i as u32,
            unshot: self.unshot[i],
            shot,
            a_i,
        });
        self.b[i] += shot;
        self.unshot[i] = -ambient;
        let Patches { area, rho, .. } = self.patches;
        for (j, &f_ij) in self.rows.row(i).iter().enumerate() {
            let f_ji = f_ij * a_i / area[j];
            let delta = rho[j] * f_ji * shot;
            self.unshot[j] += delta;
            if followed.takes(i) || followed.takes(j) {
                recorder.step(|| SolverEvent::Received {
                    j: j as u32,
                    f_ji,
                    rho_j: rho[j],
                    delta,
                    b_j: self.b[j],
                    unshot_j: self.unshot[j],
                });
            }
        }
        recorder.leave(|| SolverEvent::ShotDone {
            i: i as u32,
            b_i: self.b[i],
            unshot: self.unshot[i],
        });
        Ok(())
    }

    fn radiosity(&self) -> &[f64] {
        &self.b
    }

    fn residual(&self) -> &[f64] {
        &self.unshot
    }

    fn confirm(&mut self) {
        residual(&mut self.rows, &self.patches, &self.b, &mut self.unshot);
    }

    fn gain(&self) -> Option<f64> {
        self.gain
    }
}
