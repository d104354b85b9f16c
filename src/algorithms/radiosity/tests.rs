use super::cube::{cube, lamp};
use super::*;
use crate::algorithms::enclosure_needs::known_channels;
use crate::record::{Mark, Recording, RecordingLimit, Unrecorded};
use crate::scene::Parts;

fn solved(system: &System, solver: Solver) -> Result<Solution, Unsolved> {
    solve(
        system,
        solver,
        Stop::default(),
        &RecordFilter::default(),
        &mut Unrecorded,
    )
}

fn within(stop: Stop, system: &System, solver: Solver) -> Result<Solution, Unsolved> {
    solve(
        system,
        solver,
        stop,
        &RecordFilter::default(),
        &mut Unrecorded,
    )
}

#[test]
fn solvers_take_the_iterations_of_the_table() {
    let (f, area) = cube(8);
    let n = area.len();
    let matrix = Matrix::new(&f, n).unwrap();
    for &sum in matrix.row_sums() {
        assert!((sum - 1.0).abs() < 1e-11, "row sum {sum}");
    }
    let emission = lamp(8);
    let table = [
        (Solver::Jacobi, vec![17, 110, 1148, 11528]),
        (Solver::GaussSeidel, vec![9, 56, 584, 5862]),
        (Solver::Shooting, vec![3356, 21480, 223_000]),
        (Solver::Overshooting, vec![1203, 1978, 2980, 3498, 3941]),
        (Solver::Chebyshev, vec![9, 27, 87, 275, 869]),
        (Solver::ConjugateGradients, vec![6, 9, 11, 12, 14]),
    ];
    for (solver, expected) in table {
        for (rho, expected) in [0.5, 0.9, 0.99, 0.999, 0.9999].into_iter().zip(expected) {
            let rho = vec![rho; n];
            let patches = Patches::new(&area, &rho, &emission).unwrap();
            let system = System::new(&matrix, patches).unwrap();
            let found = solved(&system, solver).unwrap();
            println!(
                "{} {}: {} ({expected})",
                solver.name(),
                rho[0],
                found.iterations
            );
            let apart = (f64::from(found.iterations) / f64::from(expected) - 1.0).abs();
            let one = found.iterations.abs_diff(expected) <= 1;
            assert!(
                apart <= 0.1 || one,
                "{}: {} for {expected}",
                solver.name(),
                found.iterations
            );
        }
    }
}

/// Every patch emits E and sees only patches like itself: B = E + ρB.
#[test]
fn a_furnace_glows_with_e_over_1_minus_rho() {
    let (f, area) = cube(2);
    let n = area.len();
    let matrix = Matrix::new(&f, n).unwrap();
    let emission = vec![1.0; n];
    for loss in [0.5, 0.1, 1e-3, 1e-6] {
        let rho = vec![1.0 - loss; n];
        let system = System::new(&matrix, Patches::new(&area, &rho, &emission).unwrap()).unwrap();
        for solver in Solver::ALL {
            let fast = matches!(
                solver,
                Solver::Auto
                    | Solver::Overshooting
                    | Solver::Chebyshev
                    | Solver::ConjugateGradients
                    | Solver::Direct
            );
            if fast || loss >= 1e-3 {
                // The residual bounds the relative error: ‖B − B*‖ ≤ ‖r‖/(1 − ρ) and B* = E/(1 − ρ).
                let stop = Stop {
                    tolerance: 1e-7,
                    ..Stop::default()
                };
                let found = within(stop, &system, solver).unwrap();
                for b in found.radiosity {
                    let error = (b * loss - 1.0).abs();
                    assert!(
                        error <= 1e-6,
                        "{}, 1 − ρ = {loss}: {error:e}",
                        solver.name()
                    );
                }
            }
        }
    }
}

#[test]
fn infinite_plates_pass_the_light_to_and_fro() {
    let (f, area, emission, rho) = ([0.0, 1.0, 1.0, 0.0], [1.0; 2], [1.0, 0.0], [0.9; 2]);
    let matrix = Matrix::new(&f, 2).unwrap();
    let system = System::new(&matrix, Patches::new(&area, &rho, &emission).unwrap()).unwrap();
    for solver in Solver::ALL {
        let found = solved(&system, solver).unwrap();
        let exact = [1.0 / (1.0 - 0.81), 0.9 / (1.0 - 0.81)];
        for (b, exact) in found.radiosity.iter().zip(exact) {
            let bound = found.error_bound.unwrap();
            assert!((b - exact).abs() <= bound + 1e-14, "{}", solver.name());
        }
    }
    let stop = Stop::default();
    let wrong = chebyshev_on(
        &system,
        [0.0, 0.9],
        stop,
        &RecordFilter::default(),
        &mut Unrecorded,
    );
    assert!(matches!(wrong, Err(Unsolved::Diverges { .. })), "{wrong:?}");
}

/// F_ij = A_j/ΣA, so what arrives is the same everywhere: H = ⟨B⟩ = ⟨E⟩ + ⟨ρ⟩H.
#[test]
fn a_spherical_cavity_is_lit_evenly() {
    let area = [1.0, 2.0, 3.0, 0.5, 1.5];
    let (rho, emission) = ([0.9, 0.0, 0.5, 1.0, 0.3], [0.0, 1.0, 0.2, 0.0, 3.0]);
    let all: f64 = area.iter().sum();
    let f: Vec<f64> = (0..25).map(|k| area[k % 5] / all).collect();
    let mean = |values: &[f64; 5]| (0..5).map(|i| values[i] * area[i] / all).sum::<f64>();
    let arriving = mean(&emission) / (1.0 - mean(&rho));
    let matrix = Matrix::new(&f, 5).unwrap();
    let system = System::new(&matrix, Patches::new(&area, &rho, &emission).unwrap()).unwrap();
    let stop = Stop {
        tolerance: 1e-12,
        ..Stop::default()
    };
    for solver in Solver::ALL {
        if solver == Solver::Chebyshev {
            let refused = within(stop, &system, solver);
            assert!(matches!(refused, Err(Unsolved::NoInterval { .. })));
            continue;
        }
        let found = within(stop, &system, solver).unwrap();
        for i in 0..5 {
            let exact = emission[i] + rho[i] * arriving;
            assert!(
                (found.radiosity[i] - exact).abs() < 1e-10,
                "{} {i}",
                solver.name()
            );
        }
    }
}

/// Two cubes, 1e-4 of whose light goes over to the same patch of the other one.
#[test]
fn conjugate_gradients_are_not_stopped_by_a_slit() {
    let (one, area) = cube(4);
    let n = area.len();
    let mut f = vec![0.0; 4 * n * n];
    for enclosure in 0..2 {
        for i in 0..n {
            for j in 0..n {
                f[(enclosure * n + i) * 2 * n + enclosure * n + j] = (1.0 - 1e-4) * one[i * n + j];
            }
            f[(enclosure * n + i) * 2 * n + (1 - enclosure) * n + i] = 1e-4;
        }
    }
    let area = [area.clone(), area].concat();
    let rho = vec![0.9999; 2 * n];
    let mut emission = lamp(4);
    emission.resize(2 * n, 0.0);
    let matrix = Matrix::new(&f, 2 * n).unwrap();
    let system = System::new(&matrix, Patches::new(&area, &rho, &emission).unwrap()).unwrap();
    let fast = solved(&system, Solver::Auto).unwrap();
    let exact = solved(&system, Solver::Direct).unwrap();
    assert!(fast.iterations <= 22, "{} iterations", fast.iterations);
    for (b, exact) in fast.radiosity.iter().zip(&exact.radiosity) {
        assert!((b - exact).abs() <= fast.error_bound.unwrap());
    }
}

#[test]
fn recorded_or_not_the_result_is_the_same_and_scopes_balance() {
    let (f, area) = cube(2);
    let n = area.len();
    let rho: Vec<f64> = (0..n).map(|i| 0.1 * (i % 9) as f64).collect();
    let emission = lamp(2);
    let matrix = Matrix::new(&f, n).unwrap();
    let system = System::new(&matrix, Patches::new(&area, &rho, &emission).unwrap()).unwrap();
    for solver in Solver::ALL {
        let untold = solved(&system, solver).unwrap();
        for filter in [
            RecordFilter::default(),
            RecordFilter {
                iterations: Some(1..3),
                patch: Some(5),
            },
        ] {
            let mut recording = Recording::new(RecordingLimit::default());
            let recorded =
                solve(&system, solver, Stop::default(), &filter, &mut recording).unwrap();
            assert_eq!(recorded, untold);
            assert_eq!(recorded.radiosity.map_bits(), untold.radiosity.map_bits());
            let count = |mark| recording.marks().filter(|&m| m == mark).count();
            assert_eq!(count(Mark::Enter), count(Mark::Leave));
            let exchanges = recording
                .events()
                .filter(|e| matches!(e.recorded, SolverEvent::Exchanged { .. }));
            if filter.patch.is_some() {
                assert!(exchanges.count() <= 2 * n);
            }
        }
    }
}

trait Bits {
    fn map_bits(&self) -> Vec<u64>;
}

impl Bits for Vec<f64> {
    fn map_bits(&self) -> Vec<u64> {
        self.iter().map(|b| b.to_bits()).collect()
    }
}

#[test]
fn a_closed_room_that_loses_no_light_is_refused() {
    let (f, area) = cube(2);
    let n = area.len();
    let matrix = Matrix::new(&f, n).unwrap();
    let (emission, mut rho) = (lamp(2), vec![1.0; n]);
    for solver in Solver::ALL {
        let system = System::new(&matrix, Patches::new(&area, &rho, &emission).unwrap()).unwrap();
        assert!(matches!(
            solved(&system, solver),
            Err(Unsolved::NoSolution { .. })
        ));
    }
    // One patch that loses light is enough.
    rho[7] = 0.5;
    let system = System::new(&matrix, Patches::new(&area, &rho, &emission).unwrap()).unwrap();
    assert!(solved(&system, Solver::Auto).is_ok());
}

#[test]
fn rows_that_sum_to_more_than_1_are_not_believed() {
    let (mut f, area) = cube(2);
    f.iter_mut().for_each(|f| *f *= 1.01);
    let n = area.len();
    let (emission, rho) = (lamp(2), vec![0.999; n]);
    let matrix = Matrix::new(&f, n).unwrap();
    let system = System::new(&matrix, Patches::new(&area, &rho, &emission).unwrap()).unwrap();
    for solver in Solver::ALL {
        let stop = Stop {
            max_iterations: 100_000,
            ..Stop::default()
        };
        assert!(within(stop, &system, solver).is_err(), "{}", solver.name());
    }
}

#[test]
fn dark_and_equal_channels_are_not_solved() {
    let (f, area) = cube(2);
    let n = area.len();
    let matrix = Matrix::new(&f, n).unwrap();
    let (grey, black, lamp, dark) = (vec![0.5; n], vec![0.0; n], lamp(2), vec![0.0; n]);
    let channel = |name, rho, emission| Channel {
        name,
        rho,
        emission,
    };
    let channels = [
        channel("red", &grey[..], &lamp[..]),
        channel("green", &grey, &lamp),
        channel("blue", &grey, &dark),
        channel("all black", &black, &lamp),
    ];
    let mut recording = Recording::new(RecordingLimit::default());
    let (solver, stop, filter) = (Solver::Auto, Stop::default(), RecordFilter::default());
    let found = solve_channels(
        &area,
        channels,
        known_channels(&channels, Parts::NONE),
        solver,
        &mut recording,
        |patches, recorder| {
            let system = System::new(&matrix, *patches)?;
            solve(&system, solver, stop, &filter, recorder)
        },
    )
    .unwrap();
    assert_eq!(found[0], found[1]);
    assert_eq!(found[2].radiosity, dark);
    assert_eq!((found[3].iterations, &found[3].radiosity), (0, &lamp));
    let skipped = recording
        .events()
        .filter(|e| matches!(e.recorded, SolverEvent::ChannelLeftOut { .. }));
    assert_eq!(skipped.count(), 2);
}

#[test]
fn shooting_needs_no_stored_matrix() {
    struct Computed(Vec<f64>, usize, usize);
    impl Rows for Computed {
        fn row(&mut self, i: usize) -> &[f64] {
            self.2 += 1;
            &self.0[i * self.1..(i + 1) * self.1]
        }
    }
    let (f, area) = cube(4);
    let n = area.len();
    let (emission, rho) = (lamp(4), vec![0.7; n]);
    let patches = Patches::new(&area, &rho, &emission).unwrap();
    let matrix = Matrix::new(&f, n).unwrap();
    let stored = solved(
        &System::new(&matrix, patches).unwrap(),
        Solver::Overshooting,
    )
    .unwrap();
    let rows = Computed(f.clone(), n, 0);
    let found = shoot(
        rows,
        &patches,
        true,
        Stop::default(),
        &RecordFilter::default(),
        &mut Unrecorded,
    )
    .unwrap();
    assert_eq!(found.radiosity, stored.radiosity);
    assert_eq!(found.error_bound, None);
}

#[test]
fn what_is_not_finite_or_does_not_fit_is_refused() {
    let nan = Patches::new(&[1.0], &[0.5], &[f64::NAN]);
    assert!(matches!(
        nan,
        Err(Unsolved::Input {
            what: "emission",
            patch: 0,
            ..
        })
    ));
    assert!(matches!(
        Patches::new(&[0.0], &[0.5], &[1.0]),
        Err(Unsolved::Input { .. })
    ));
    assert!(matches!(
        Patches::new(&[1.0], &[1.5], &[1.0]),
        Err(Unsolved::Input { .. })
    ));
    assert!(matches!(
        Patches::new(&[1.0], &[], &[1.0]),
        Err(Unsolved::Sizes { .. })
    ));
    assert!(matches!(
        Matrix::new(&[f64::INFINITY], 1),
        Err(Unsolved::Input { .. })
    ));
    assert!(matches!(
        Matrix::new(&[0.0; 3], 2),
        Err(Unsolved::Sizes { .. })
    ));
}

#[test]
fn names_go_there_and_back() {
    for solver in Solver::ALL {
        assert_eq!(Solver::from_name(solver.name()), Some(solver));
    }
}
