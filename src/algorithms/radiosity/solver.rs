//! What a solver is: a value of [`Solver`], its properties, and how it solves one channel.

use super::Solver;
use super::event::Event;
use super::iterate::{Method, TaggingRecorder, run};
use super::outcome::{Solution, Stop, Unsolved};
use super::record_filter::RecordFilter;
use super::singularity_check::refuse_endless_light;
use super::system::{Patches, System};
use crate::record::{Listing, Recorder};

/// What is known of a solver without running it.
#[derive(Clone, Copy)]
pub(super) struct Properties {
    /// As on the command line and in lesson files.
    pub name: &'static str,
    /// As short as a label at a curve must be.
    pub symbol: &'static str,
    pub listing: &'static Listing,
    /// Of one iteration, for n patches.
    pub multiplications: fn(f64) -> f64,
    /// Whether an iteration is a shot of one patch, which needs one row of form factors and so no stored matrix.
    pub shoots: bool,
}

impl Properties {
    /// Those of a solver each of whose iterations takes the whole matrix.
    pub const fn new(name: &'static str, symbol: &'static str, listing: &'static Listing) -> Self {
        Properties {
            name,
            symbol,
            listing,
            multiplications: |n| n * n,
            shoots: false,
        }
    }
}

/// One channel to be solved.
#[derive(Clone, Copy)]
pub(super) struct Problem<'a> {
    pub system: System<'a>,
    pub stop: Stop,
    pub filter: &'a RecordFilter,
}

impl Problem<'_> {
    /// Runs `method` to its end, as `solver`.
    pub fn run<R: Recorder<Event>>(
        &self,
        solver: Solver,
        method: impl Method,
        recorder: &mut R,
    ) -> Result<Solution, Unsolved> {
        let recorder = &mut TaggingRecorder { solver, recorder };
        run(
            method,
            &self.system.patches,
            self.stop,
            self.filter,
            recorder,
        )
    }
}

/// Declares the solvers: each has its file, with its `SOLVER` properties and `solve`.
macro_rules! solvers {
    ($($(#[$about:meta])* $solver:ident: $module:ident,)*) => {
        named! {
            /// A way to solve the radiosity system.
            #[derive(Default)]
            pub enum Solver {
                $($(#[$about])* $solver = $module::SOLVER.name,)*
            }
        }

        impl Solver {
            fn properties(self) -> solver::Properties {
                match self {
                    $(Solver::$solver => $module::SOLVER,)*
                }
            }

            fn solve<R: Recorder<Event>>(
                self,
                problem: &solver::Problem,
                recorder: &mut R,
            ) -> Result<Solution, Unsolved> {
                match self {
                    $(Solver::$solver => $module::solve(problem, recorder),)*
                }
            }
        }
    };
}

impl Solver {
    /// As short as a label at a curve must be.
    pub fn symbol(self) -> &'static str {
        self.properties().symbol
    }

    pub fn listing(self) -> &'static Listing {
        self.properties().listing
    }

    /// Of one iteration, for so many patches.
    pub(super) fn multiplications(self, patches: usize) -> f64 {
        (self.properties().multiplications)(patches as f64)
    }

    /// Whether an iteration is a shot of one patch, which needs one row of form factors and so no stored matrix.
    pub fn shoots(self) -> bool {
        self.properties().shoots
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
    let problem = Problem {
        system: *system,
        stop,
        filter,
    };
    let solution = solver.solve(&problem, recorder)?;
    refuse_negative_light(&system.patches, &solution)?;
    Ok(solution)
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
