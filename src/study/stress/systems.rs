//! Radiosity systems of which something is known.

use super::case::{Measured, Ran};
use crate::algorithms::radiosity::cube::{cube, lamp};
use crate::algorithms::radiosity::{
    Matrix, Patches, RecordFilter, Solution, Solver, Stop, System, solve,
};
use crate::record::Unrecorded;
use std::iter::zip;

/// Looks at a system of form factors, areas, reflectances and emissions. Errors: what is wrong with them.
pub fn with(
    f: &[f64],
    area: &[f64],
    rho: &[f64],
    emission: &[f64],
    look: impl FnOnce(&System) -> Result<Ran, String>,
) -> Result<Ran, String> {
    let matrix = Matrix::new(f, area.len()).map_err(|why| why.to_string())?;
    let patches = Patches::new(area, rho, emission).map_err(|why| why.to_string())?;
    look(&System::new(&matrix, patches).map_err(|why| why.to_string())?)
}

pub fn by(system: &System, solver: Solver, stop: Stop) -> Result<Solution, String> {
    solve(
        system,
        solver,
        stop,
        &RecordFilter::default(),
        &mut Unrecorded,
    )
    .map_err(|why| why.to_string())
}

/// A solution of what has none.
pub fn answer(found: Result<Solution, String>) -> Result<Ran, String> {
    found.map(|_| Measured::share(1, 1).into())
}

/// All patches of a cube emit the same.
pub fn furnace(rho: f64, emission: f64, tolerance: f64) -> Result<Ran, String> {
    let stop = Stop {
        tolerance,
        ..Stop::default()
    };
    furnace_by(Solver::Auto, rho, emission, stop)
}

pub fn furnace_by(solver: Solver, rho: f64, emission: f64, stop: Stop) -> Result<Ran, String> {
    let (f, area) = cube(4);
    let n = area.len();
    with(&f, &area, &vec![rho; n], &vec![emission; n], |system| {
        let found = by(system, solver, stop)?;
        let exact = emission / (1.0 - rho);
        let error = |b: f64| (b / exact - 1.0).abs();
        let farthest = |a: f64, b: f64| if error(a) > error(b) { a } else { b };
        let farthest = found.radiosity.into_iter().reduce(farthest);
        let measured = Measured::relative(farthest.unwrap_or(f64::NAN), exact);
        Ok(Ran::from(measured).conditioned((1.0 + rho) / (1.0 - rho)))
    })
}

pub fn plates() -> Result<Ran, String> {
    let rho = 0.9;
    let f = [0.0, 1.0, 1.0, 0.0];
    with(&f, &[1.0; 2], &[rho; 2], &[1.0, 0.0], |system| {
        let exact = [1.0, rho].map(|b| b / (1.0 - rho * rho));
        let mut worst = 0.0_f64;
        for solver in Solver::ALL {
            let found = by(system, solver, Stop::default())?;
            // Where the bound is that of rounding itself, so is the error.
            let rounding = 8.0 * f64::EPSILON * exact[0];
            let bound = found.error_bound.ok_or("no bound is known")? + rounding;
            for (b, exact) in zip(found.radiosity, exact) {
                worst = worst.max((b - exact).abs() / bound);
            }
        }
        Ok(Ran::from(Measured::absolute(worst, 0.0)).conditioned((1.0 + rho) / (1.0 - rho)))
    })
}

pub fn cavity(solver: Solver) -> Result<Ran, String> {
    let area = [1.0, 2.0, 3.0, 0.5, 1.5];
    let (rho, emission) = ([0.9, 0.0, 0.5, 1.0, 0.3], [0.0, 1.0, 0.2, 0.0, 3.0]);
    let all: f64 = area.iter().sum();
    let f: Vec<f64> = (0..25).map(|k| area[k % 5] / all).collect();
    let mean = |values: [f64; 5]| {
        zip(values, area)
            .map(|(value, a)| value * a / all)
            .sum::<f64>()
    };
    let arriving = mean(emission) / (1.0 - mean(rho));
    with(&f, &area, &rho, &emission, |system| {
        let stop = Stop {
            tolerance: 1e-14,
            ..Stop::default()
        };
        let found = by(system, solver, stop)?;
        let errors = (0..5).map(|i| {
            let exact = emission[i] + rho[i] * arriving;
            (found.radiosity[i] / exact - 1.0).abs()
        });
        Ok(Measured::absolute(errors.fold(0.0, f64::max), 0.0).into())
    })
}

/// Two cubes, 10⁻⁴ of whose light goes over to the same patch of the other one.
pub fn slit() -> Result<Ran, String> {
    let (one, area) = cube(4);
    let n = area.len();
    let mut f = vec![0.0; 4 * n * n];
    for i in 0..2 * n {
        let (enclosure, patch) = (i / n, i % n);
        let row = &mut f[i * 2 * n..(i + 1) * 2 * n];
        for j in 0..n {
            row[enclosure * n + j] = (1.0 - 1e-4) * one[patch * n + j];
        }
        row[(1 - enclosure) * n + patch] = 1e-4;
    }
    let rho = 0.9999;
    let mut emission = lamp(4);
    emission.resize(2 * n, 0.0);
    with(
        &f,
        &[area.clone(), area].concat(),
        &vec![rho; 2 * n],
        &emission,
        |system| {
            let found = by(system, Solver::ConjugateGradients, Stop::default())?;
            let count = Measured::relative(found.iterations.into(), 20.0);
            Ok(Ran::from(count).conditioned((1.0 + rho) / (1.0 - rho)))
        },
    )
}

/// Iterations of a solver in the closed cube of 384 patches.
pub fn stiff(solver: Solver, rho: f64, expected: u32, condition: f64) -> Result<Ran, String> {
    let (f, area) = cube(8);
    with(&f, &area, &vec![rho; area.len()], &lamp(8), |system| {
        let found = by(system, solver, Stop::default())?;
        let count = Measured::relative(found.iterations.into(), expected.into());
        Ok(Ran::from(count).conditioned(condition))
    })
}

pub fn small_residual() -> Result<Ran, String> {
    let (f, area) = cube(4);
    let rho = 0.99;
    with(&f, &area, &vec![rho; area.len()], &lamp(4), |system| {
        let exact = by(system, Solver::Direct, Stop::default())?.radiosity;
        let found = by(system, Solver::Jacobi, Stop::default())?.radiosity;
        let errors = zip(found, exact).map(|(b, exact)| (b / exact - 1.0).abs());
        let worst = Measured::absolute(errors.fold(0.0, f64::max), 0.0);
        Ok(Ran::from(worst).conditioned((1.0 + rho) / (1.0 - rho)))
    })
}
