//! The solvers by name, and one channel solved by one of them.

use super::chebyshev::Chebyshev;
use super::conjugate_gradients::ConjugateGradients;
use super::direct::Direct;
use super::event::Event;
use super::gathering::Gathering;
use super::gauss_seidel::GaussSeidel;
use super::iterate::{TaggingRecorder, run};
use super::jacobi::Jacobi;
use super::outcome::{Solution, Stop, Unsolved};
use super::over_relaxation::{OverRelaxation, youngs_omega};
use super::record_filter::RecordFilter;
use super::shooting::Shooter;
use super::singularity_check::refuse_endless_light;
use super::system::{Patches, Rows, System};
use crate::record::Recorder;

/// A way to solve the radiosity system.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Solver {
    /// Conjugate gradients: few iterations however little light is lost. Where they fail, because the matrix given is too far from
    /// reciprocal, elimination.
    #[default]
    Auto,
    Jacobi,
    GaussSeidel,
    /// With Young's ω for the bound max_i ρ_i Σ_j F_ij on the spectral radius.
    OverRelaxation,
    Shooting,
    Overshooting,
    /// On [−μ, μ], μ = max_i ρ_i Σ_j F_ij.
    Chebyshev,
    ConjugateGradients,
    Direct,
}

impl Solver {
    pub const ALL: [Solver; 9] = [
        Solver::Auto,
        Solver::Jacobi,
        Solver::GaussSeidel,
        Solver::OverRelaxation,
        Solver::Shooting,
        Solver::Overshooting,
        Solver::Chebyshev,
        Solver::ConjugateGradients,
        Solver::Direct,
    ];

    /// As on the command line and in lesson files.
    pub fn name(self) -> &'static str {
        match self {
            Solver::Auto => "auto",
            Solver::Jacobi => "jacobi",
            Solver::GaussSeidel => "gauss-seidel",
            Solver::OverRelaxation => "over-relaxation",
            Solver::Shooting => "shooting",
            Solver::Overshooting => "overshooting",
            Solver::Chebyshev => "chebyshev",
            Solver::ConjugateGradients => "conjugate-gradients",
            Solver::Direct => "direct",
        }
    }

    /// Whether it needs one row of form factors at a time, and so no stored matrix.
    pub fn shoots(self) -> bool {
        matches!(self, Solver::Shooting | Solver::Overshooting)
    }

    pub fn from_name(name: &str) -> Option<Self> {
        Solver::ALL.into_iter().find(|solver| solver.name() == name)
    }
}

/// Solves one channel.
///
/// Errors: a system that has no solution, and whatever kept the solver from one within `stop`.
pub fn solve<R: Recorder<Event>>(
    system: &System,
    solver: Solver,
    stop: Stop,
    filter: &RecordFilter,
    recorder: &mut R,
) -> Result<Solution, Unsolved> {
    refuse_endless_light(system)?;
    let (system, patches, gain) = (*system, system.patches, system.gain());
    let mut by = TaggingRecorder { solver, recorder };
    let by = &mut by;
    let solution = match solver {
        Solver::Auto => {
            let fast = solve(
                &system,
                Solver::ConjugateGradients,
                stop,
                filter,
                by.recorder,
            );
            return match fast {
                Err(
                    Unsolved::NotConverged { .. }
                    | Unsolved::GainsLight
                    | Unsolved::Diverges { .. },
                ) => solve(&system, Solver::Direct, stop, filter, by.recorder),
                done => done,
            };
        }
        Solver::Jacobi => run(
            Gathering::new(system, Jacobi::default()),
            &patches,
            stop,
            filter,
            by,
        ),
        Solver::GaussSeidel => run(
            Gathering::new(system, GaussSeidel),
            &patches,
            stop,
            filter,
            by,
        ),
        Solver::OverRelaxation => {
            let method = Gathering::new(
                system,
                OverRelaxation {
                    omega: youngs_omega(gain),
                },
            );
            run(method, &patches, stop, filter, by)
        }
        Solver::Shooting | Solver::Overshooting => {
            let overshoots = solver == Solver::Overshooting;
            let method = Shooter::new(system.matrix, patches, overshoots, Some(gain));
            run(method, &patches, stop, filter, by)
        }
        Solver::Chebyshev => {
            let method = Chebyshev::new(system, [-gain, gain])?;
            run(method, &patches, stop, filter, by)
        }
        Solver::ConjugateGradients => {
            run(ConjugateGradients::new(system), &patches, stop, filter, by)
        }
        Solver::Direct => run(Direct::new(system), &patches, stop, filter, by),
    }?;
    refuse_negative_light(&patches, &solution)?;
    Ok(solution)
}

/// Chebyshev's iteration on an interval of one's own, below 1, which ought to hold the spectrum of ρF.
pub fn chebyshev_on<R: Recorder<Event>>(
    system: &System,
    interval: [f64; 2],
    stop: Stop,
    filter: &RecordFilter,
    recorder: &mut R,
) -> Result<Solution, Unsolved> {
    refuse_endless_light(system)?;
    let solver = Solver::Chebyshev;
    let method = Chebyshev::new(*system, interval)?;
    run(
        method,
        &system.patches,
        stop,
        filter,
        &mut TaggingRecorder { solver, recorder },
    )
}

/// Shooting, or overshooting, with no matrix stored: rows are asked for shot by shot, and all of them once at the end, for the
/// residual. No bound on the error is known, since that takes the sums of all rows.
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

/// Light that is emitted and reflected is nowhere negative (Perron & Frobenius), unless reflections gain light.
fn refuse_negative_light(patches: &Patches, solution: &Solution) -> Result<(), Unsolved> {
    let brightest = solution
        .radiosity
        .iter()
        .fold(0.0, |most: f64, b| most.max(b.abs()));
    let emits = patches.emission.iter().all(|&e| e >= 0.0);
    let allowed = -1e-6 * brightest - solution.error_bound.unwrap_or(0.0);
    if emits && solution.radiosity.iter().any(|&b| b < allowed) {
        return Err(Unsolved::GainsLight);
    }
    Ok(())
}
