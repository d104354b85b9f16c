//! Radiosity: rooms that lose little light, systems with a closed form, what each solver takes for a stiff one, and what has no solution.

use super::case::{Case, Measured, degrades, holds, refused};
use super::systems::{
    answer, by, cavity, furnace, furnace_by, plates, slit, small_residual, stiff, with,
};
use crate::algorithms::radiosity::cube::{cube, lamp};
use crate::algorithms::radiosity::{RecordFilter, Solver, Stop, chebyshev_on};
use crate::record::Unrecorded;
use std::iter::zip;

const TABLE: &str = "counted by another program for the same cube, E and stop; a tenth more or less is a matter of rounding";

pub const CASES: &[Case] = &[
    Case {
        name: "radiosity/furnace-0.5",
        asks: "the farthest B from E/(1 − ρ) in a cube whose patches all emit 1, ρ = 0.5, to a residual of 10⁻¹²",
        expects: "1/(1 − ρ)",
        because: "each patch sees only patches like itself: B = E + ρB",
        run: || furnace(0.5, 1.0, 1e-12),
        recorded: holds(1e-11),
    },
    Case {
        name: "radiosity/furnace-1-1e-6",
        asks: "the same with ρ = 1 − 10⁻⁶, to a residual of 10⁻⁸: what f64 resolves of B = 10⁶ is 10⁻¹⁰",
        expects: "1/(1 − ρ) = 10⁶",
        because: "the same; rows are to sum to 1, and an error δ of a row's sum changes B by δ/(1 − ρ)",
        run: || furnace(1.0 - 1e-6, 1.0, 1e-8),
        recorded: degrades(1e-11, 1e-6),
    },
    Case {
        name: "radiosity/furnace-1e75",
        asks: "the same with ρ = 0.5 and E = 10⁷⁵",
        expects: "2·10⁷⁵",
        because: "the system is linear, and norms are taken so that squares do not overflow",
        run: || furnace(0.5, 1e75, 1e-12),
        recorded: holds(1e-11),
    },
    Case {
        name: "radiosity/furnace-1e-300",
        asks: "the same with ρ = 0.5 and E = 10⁻³⁰⁰",
        expects: "2·10⁻³⁰⁰",
        because: "the system is linear, and norms are taken so that squares do not vanish",
        run: || furnace(0.5, 1e-300, 1e-12),
        recorded: holds(1e-11),
    },
    Case {
        name: "radiosity/beyond-f64",
        asks: "the furnace of ρ = 1 − 10⁻⁶ to a residual of 10⁻¹² in 200 iterations of conjugate gradients",
        expects: "refused with the residual that is left: it no longer falls",
        because: "B = 10⁶ is rounded by 10⁻¹⁰, and so is the residual: no iterate of f64 has a smaller one",
        run: || {
            let stop = Stop {
                tolerance: 1e-12,
                max_iterations: 200,
            };
            furnace_by(Solver::ConjugateGradients, 1.0 - 1e-6, 1.0, stop)
        },
        recorded: refused("the residual no longer falls"),
    },
    Case {
        name: "radiosity/plates",
        asks: "the largest error of any solver for two infinite plates, ρ = 0.9, E = (1, 0), as a share of its own bound",
        expects: "B = (1, ρ)/(1 − ρ²) within ‖r‖_∞/(1 − ρ)",
        because: "the bound holds for every B: ‖(I − ρF)⁻¹‖_∞ ≤ 1/(1 − max ρ_i Σ_j F_ij); the spectrum is ±ρ",
        run: plates,
        recorded: holds(1.0),
    },
    Case {
        name: "radiosity/chebyshev-wrong",
        asks: "the plates by Chebyshev's iteration on [0, 0.9], which leaves −0.9 out",
        expects: "recognised: it says that the iteration diverges",
        because: "the polynomial that is smallest on an interval grows without bounds outside of it",
        run: || {
            let (f, rho) = ([0.0, 1.0, 1.0, 0.0], [0.9; 2]);
            with(&f, &[1.0; 2], &rho, &[1.0, 0.0], |system| {
                let (stop, watch) = (Stop::default(), RecordFilter::default());
                let found = chebyshev_on(system, [0.0, 0.9], stop, &watch, &mut Unrecorded);
                answer(found.map_err(|why| why.to_string()))
            })
        },
        recorded: refused("the iteration diverges: the residual is"),
    },
    Case {
        name: "radiosity/chebyshev-none",
        asks: "a cavity with one patch of ρ = 1 by Chebyshev's iteration",
        expects: "refused: no interval below 1 is known to hold the spectrum",
        because: "max ρ_i Σ_j F_ij is 1",
        run: || cavity(Solver::Chebyshev),
        recorded: refused("no interval below 1 is known to hold the spectrum"),
    },
    Case {
        name: "radiosity/cavity",
        asks: "a spherical cavity of five patches, one black and one of ρ = 1: the largest relative error of B",
        expects: "B_i = E_i + ρ_i ⟨E⟩/(1 − ⟨ρ⟩)",
        because: "F_ij = A_j/ΣA, so what arrives is the same everywhere",
        run: || cavity(Solver::Auto),
        recorded: holds(1e-12),
    },
    Case {
        name: "radiosity/slit",
        asks: "two cubes joined by a slit of 10⁻⁴, ρ = 0.9999: iterations of conjugate gradients to 10⁻⁶",
        expects: "20, give or take a tenth",
        because: "two small eigenvalues cost them two iterations; they stop overshooting and constant-mode corrections",
        run: slit,
        recorded: holds(0.11),
    },
    Case {
        name: "radiosity/stiff-jacobi",
        asks: "iterations of Jacobi to 10⁻⁶ in a cube of 384 patches, a lamp in one face, ρ = 0.99",
        expects: "1148",
        because: TABLE,
        run: || stiff(Solver::Jacobi, 0.99, 1148, 137.0),
        recorded: holds(0.1),
    },
    Case {
        name: "radiosity/stiff-gauss-seidel",
        asks: "iterations of Gauss–Seidel for the same, ρ = 0.99",
        expects: "584",
        because: TABLE,
        run: || stiff(Solver::GaussSeidel, 0.99, 584, 137.0),
        recorded: holds(0.1),
    },
    Case {
        name: "radiosity/stiff-shooting",
        asks: "shots of one patch for the same, ρ = 0.9",
        expects: "21480",
        because: TABLE,
        run: || stiff(Solver::Shooting, 0.9, 21480, 13.0),
        recorded: holds(0.1),
    },
    Case {
        name: "radiosity/stiff-overshooting",
        asks: "shots with overshoot for the same, ρ = 0.9999",
        expects: "3941",
        because: TABLE,
        run: || stiff(Solver::Overshooting, 0.9999, 3941, 13770.0),
        recorded: holds(0.1),
    },
    Case {
        name: "radiosity/stiff-chebyshev",
        asks: "iterations of Chebyshev on [−ρ, ρ] for the same, ρ = 0.9999",
        expects: "869",
        because: TABLE,
        run: || stiff(Solver::Chebyshev, 0.9999, 869, 13770.0),
        recorded: holds(0.1),
    },
    Case {
        name: "radiosity/stiff-conjugate",
        asks: "iterations of conjugate gradients for the same, ρ = 0.9999",
        expects: "14",
        because: TABLE,
        run: || stiff(Solver::ConjugateGradients, 0.9999, 14, 13770.0),
        recorded: holds(0.1),
    },
    Case {
        name: "radiosity/small-residual",
        asks: "the largest error of a cube of 96 patches, ρ = 0.99, by Jacobi to a residual of 10⁻⁶, as a share of B",
        expects: "10⁻⁶, but for what the condition number makes of the residual",
        because: "‖B − B*‖ ≤ κ(I − ρF) ‖r‖/‖E‖ ‖B*‖; against elimination",
        run: small_residual,
        recorded: degrades(1e-6, 1e-4),
    },
    Case {
        name: "radiosity/all-black",
        asks: "a cube that reflects nothing: the largest |B − E|",
        expects: "0, exactly",
        because: "B = E + 0",
        run: || {
            let (f, area) = cube(2);
            let (emission, black) = (lamp(2), vec![0.0; area.len()]);
            with(&f, &area, &black, &emission, |system| {
                let found = by(system, Solver::Auto, Stop::default())?;
                let errors = zip(&found.radiosity, &emission).map(|(b, e)| (b - e).abs());
                Ok(Measured::absolute(errors.fold(0.0, f64::max), 0.0).into())
            })
        },
        recorded: holds(0.0),
    },
    Case {
        name: "radiosity/no-emitter",
        asks: "a cube of ρ = 1 − 10⁻⁹ in which nothing emits: the largest |B| of any solver",
        expects: "0, exactly, although the residual has nothing to be measured by",
        because: "E = 0 has the solution B = 0, and the residual is 0 by definition there",
        run: || {
            let (f, area) = cube(2);
            let n = area.len();
            with(&f, &area, &vec![1.0 - 1e-9; n], &vec![0.0; n], |system| {
                let mut most = 0.0_f64;
                for solver in Solver::ALL {
                    let found = by(system, solver, Stop::default())?;
                    most = found
                        .radiosity
                        .iter()
                        .fold(most, |most, b| most.max(b.abs()));
                }
                Ok(Measured::absolute(most, 0.0).into())
            })
        },
        recorded: holds(0.0),
    },
    Case {
        name: "radiosity/no-loss",
        asks: "a lamp in a closed cube of ρ = 1",
        expects: "refused: no solution exists, and which patch is in the closed part",
        because: "light that is never lost adds up without end",
        run: || {
            let (f, area) = cube(2);
            let white = vec![1.0; area.len()];
            with(&f, &area, &white, &lamp(2), |system| {
                answer(by(system, Solver::Auto, Stop::default()))
            })
        },
        recorded: refused(
            "no solution exists: patch 0 lies in a closed part of the scene where every reflectance is 1",
        ),
    },
    Case {
        name: "radiosity/one-lossy-patch",
        asks: "the same with one of 24 patches of ρ = 0.5: light that leaves against light that is given off",
        expects: "1: Σ A_i (1 − ρ_i) H_i = Σ A_i E_i",
        because: "energy; all light ends at the one patch, H = (B − E)/ρ arrives there",
        run: || {
            let (f, area) = cube(2);
            let (emission, mut rho) = (lamp(2), vec![1.0; area.len()]);
            rho[7] = 0.5;
            with(&f, &area, &rho, &emission, |system| {
                let stop = Stop {
                    tolerance: 1e-12,
                    ..Stop::default()
                };
                let b = by(system, Solver::Auto, stop)?.radiosity[7];
                let given_off: f64 = zip(&area, &emission).map(|(a, e)| a * e).sum();
                let ends = area[7] * (1.0 - rho[7]) * (b - emission[7]) / rho[7];
                Ok(Measured::relative(ends, given_off).into())
            })
        },
        recorded: holds(1e-9),
    },
    Case {
        name: "radiosity/rows-above-1",
        asks: "a cube of ρ = 0.999 whose form factors are all 1 % too large",
        expects: "refused: more light is reflected than arrives",
        because: "the spectral radius is 1.009: the solution is negative, and means nothing",
        run: || {
            let (mut f, area) = cube(2);
            f.iter_mut().for_each(|f| *f *= 1.01);
            let rho = vec![0.999; area.len()];
            with(&f, &area, &rho, &lamp(2), |system| {
                answer(by(system, Solver::Auto, Stop::default()))
            })
        },
        recorded: refused("more light is reflected than arrives"),
    },
    Case {
        name: "radiosity/not-a-number",
        asks: "an emission that is not a number",
        expects: "refused with the patch",
        because: "it would spread to every patch",
        run: || {
            with(
                &[0.0; 4],
                &[1.0; 2],
                &[0.5; 2],
                &[1.0, f64::NAN],
                |system| answer(by(system, Solver::Auto, Stop::default())),
            )
        },
        recorded: refused("the emission of patch 1 is NaN"),
    },
];
