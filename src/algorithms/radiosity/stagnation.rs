//! Whether rounding keeps the residual from falling any further: then a smaller tolerance is never met.

use super::system::Patches;

/// So many iterations in a row without a smaller residual.
const ITERATIONS: u32 = 100;
/// So many residuals in a row, computed anew, of which none is less than half of one before.
const CONFIRMATIONS: u32 = 3;

/// How the residual of one run falls.
pub(super) struct Stagnation {
    least: f64,
    /// Since it was the least.
    iterations: u32,
    least_confirmed: f64,
    confirmations: u32,
}

impl Stagnation {
    pub fn new(residual: f64) -> Self {
        Stagnation {
            least: residual,
            iterations: 0,
            least_confirmed: f64::INFINITY,
            confirmations: 0,
        }
    }

    pub fn iterated(&mut self, residual: f64) {
        self.iterations += 1;
        if residual < self.least {
            (self.least, self.iterations) = (residual, 0);
        }
    }

    /// The residual that an iteration carries along was small enough, and this one, computed anew, is not.
    pub fn confirmed(&mut self, residual: f64) {
        (self.least, self.iterations) = (residual, 0);
        self.confirmations += 1;
        if residual < 0.5 * self.least_confirmed {
            (self.least_confirmed, self.confirmations) = (residual, 0);
        }
    }

    /// Whether the residual no longer falls, and is as small as its own rounding errors may be. One that is carried along has no
    /// such errors: of it only that counts which was computed anew.
    pub fn is_reached(&self, carried: bool, patches: &Patches, radiosity: &[f64]) -> bool {
        self.confirmations >= CONFIRMATIONS
            || !carried
                && self.iterations >= ITERATIONS
                && self.least <= rounding(patches, radiosity)
    }
}

/// A bound on what rounding adds to ‖E − (I − ρF)B‖₂ / ‖E‖₂ near the solution, where ρF|B| is |B − E| (Higham, "Accuracy and
/// Stability of Numerical Algorithms", §3.1, with eight sums side by side).
fn rounding(patches: &Patches, radiosity: &[f64]) -> f64 {
    let operations = radiosity.len() as f64 / 8.0 + 8.0;
    let (mut terms, mut emitted) = (0.0, 0.0);
    for (b, e) in radiosity.iter().zip(patches.emission) {
        let term = 2.0 * (b.abs() + e.abs());
        terms += term * term;
        emitted += e * e;
    }
    operations * 0.5 * f64::EPSILON * (terms / emitted).sqrt()
}

#[cfg(test)]
mod tests {
    use crate::algorithms::radiosity::cube::{cube, lamp};
    use crate::algorithms::radiosity::{
        Matrix, Patches, RecordFilter, Solution, Solver, Stop, System, Unsolved, solve,
    };
    use crate::record::Unrecorded;

    const SIDE: usize = 3;

    fn solved(rho: f64, solver: Solver, tolerance: f64) -> Result<Solution, Unsolved> {
        let (f, area) = cube(SIDE);
        let (rho, emission) = (vec![rho; area.len()], lamp(SIDE));
        let matrix = Matrix::new(&f, area.len())?;
        let system = System::new(&matrix, Patches::new(&area, &rho, &emission)?)?;
        let stop = Stop {
            tolerance,
            max_iterations: 1_000_000,
        };
        solve(
            &system,
            solver,
            stop,
            &RecordFilter::default(),
            &mut Unrecorded,
        )
    }

    /// A residual that is carried along falls to the tolerance four times, from 1 to 1e-30 instead of 1e-13.
    const TIMES: u32 = 10;
    const MORE: u32 = 2 * super::ITERATIONS;

    #[test]
    fn a_tolerance_below_what_rounding_allows_ends_soon_and_says_why() {
        for rho in [0.5, 0.95] {
            for solver in Solver::ALL {
                let met = solved(rho, solver, 1e-13).unwrap();
                let (iterations, residual) = match solved(rho, solver, 1e-30) {
                    Err(Unsolved::Stagnates {
                        iterations,
                        residual,
                    }) => (iterations, residual),
                    Ok(exact) if exact.residual == 0.0 => (exact.iterations, 0.0),
                    other => panic!("{solver:?}, ρ = {rho}: {other:?}"),
                };
                let most = TIMES * met.iterations + MORE;
                assert!(iterations <= most, "{solver:?}: {iterations} of {most}");
                // Ten units in the last place are reached.
                assert!(residual < 10.0 * f64::EPSILON, "{solver:?}: {residual}");
                let reached = solved(rho, solver, 10.0 * f64::EPSILON);
                assert!(reached.is_ok(), "{solver:?}: {reached:?}");
            }
        }
    }
}
