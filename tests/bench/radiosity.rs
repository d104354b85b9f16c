//! The solvers in a closed cube: iterations at 384 patches; seconds of each beside those of elimination at 500, 2000 and 6000 patches,
//! taken in one run; and how quickly any of a million recorded exchanges is reached.

use lightwalk::algorithms::radiosity::cube::{cube, lamp};
use lightwalk::algorithms::radiosity::{
    Matrix, Patches, RecordFilter, Solver, Stop, System, solve,
};
use lightwalk::record::{Recording, RecordingLimit, Unrecorded};
use lightwalk::replay::{Timeline, radiosity::State};
use std::hint::black_box;
use std::time::Instant;

fn main() {
    let (f, area) = cube(8);
    for rho in [0.5, 0.9, 0.99, 0.999, 0.9999] {
        for solver in Solver::ALL {
            report(&f, &area, &lamp(8), rho, solver);
        }
    }
    // How time and memory grow: 486, 1944 and 6144 patches
    for side in [9, 18, 32] {
        let (f, area) = cube(side);
        println!("a matrix of {} bytes", size_of_val(&f[..]));
        for solver in Solver::ALL {
            report(&f, &area, &lamp(side), 0.5, solver);
        }
    }
    seek();
}

fn report(f: &[f64], area: &[f64], emission: &[f64], rho: f64, solver: Solver) {
    let rho = vec![rho; area.len()];
    let start = Instant::now();
    let patches = Patches::new(area, &rho, emission).expect("patches");
    let matrix = Matrix::new(f, area.len()).expect("a matrix");
    let system = System::new(&matrix, patches).expect("a system");
    // Millions of shots are wanted where little light is lost.
    let stop = Stop {
        max_iterations: 100_000_000,
        ..Stop::default()
    };
    let watch = RecordFilter::default();
    let found = solve(&system, solver, stop, &watch, &mut Unrecorded);
    let seconds = start.elapsed().as_secs_f64();
    match found {
        Ok(found) => println!(
            "{} patches, ρ = {}, {}: {} iterations, {seconds:.4} s, residual {:.1e}, error at most {:.1e}",
            area.len(),
            rho[0],
            solver.name(),
            found.iterations,
            found.residual,
            found.error_bound.unwrap_or(f64::NAN)
        ),
        Err(why) => println!("{} patches, {}: {why}", area.len(), solver.name()),
    }
}

/// Seven Jacobi iterations of 384 patches: 1.03 million exchanges.
fn seek() {
    let (f, area) = cube(8);
    let (rho, emission) = (vec![0.5; area.len()], lamp(8));
    let matrix = Matrix::new(&f, area.len()).expect("a matrix");
    let patches = Patches::new(&area, &rho, &emission).expect("patches");
    let system = System::new(&matrix, patches).expect("a system");
    let watch = RecordFilter {
        iterations: Some(0..7),
        patch: None,
    };
    let mut recording = Recording::new(RecordingLimit::default());
    let solved = solve(
        &system,
        Solver::Jacobi,
        Stop::default(),
        &watch,
        &mut recording,
    );
    solved.expect("a solution");
    let start = Instant::now();
    let timeline = Timeline::new(recording, State::default());
    println!(
        "{} events folded in {:.3} s",
        timeline.len(),
        start.elapsed().as_secs_f64()
    );
    let mut times: Vec<f64> = (0..1000_usize)
        .map(|i| {
            let step = i * 7_919_993 % timeline.len();
            let start = Instant::now();
            black_box(timeline.state_at(step));
            1e3 * start.elapsed().as_secs_f64()
        })
        .collect();
    times.sort_by(f64::total_cmp);
    println!(
        "seek: median {:.3} ms, slowest {:.3} ms",
        times[500], times[999]
    );
}
