//! Solvers of the radiosity system by iterations: how far B is off when a solver stops, against elimination (LU).

use super::scenes;
use crate::algorithms::enclosure::{self, Enclosure};
use crate::algorithms::radiosity::{
    Event, Matrix, Patches, RecordFilter, Solution, Solver, Stop, System, solve,
};
use crate::color::Rgb;
use crate::language::Message;
use crate::record::Counter;
use crate::record::{Recorder, Unrecorded};
use crate::scene::Parts;
use crate::scene::Scene;
use crate::study::count::operations;
use crate::study::fit::Law;
use crate::study::form::{Axes, Curve, Reference, Request, Setting, Study, Sweep, Values};
use crate::study::label::Label;
use std::rc::Rc;
use web_time::Instant;

pub static STUDY: Study = Study {
    name: "solvers",
    title: Message("study-solvers"),
    about: Message("study-solvers-about"),
    sweeps,
};

/// One channel of a room, which the settings share.
pub struct Problem {
    f: Vec<f64>,
    area: Vec<f64>,
    rho: Vec<f64>,
    emission: Vec<f64>,
}

impl Problem {
    /// The channel in which the scene emits most. Errors: it cannot be divided, has too many patches, or emits nothing.
    pub fn of(scene: &Scene, most_patches: usize) -> Result<Problem, String> {
        let enclosure = Enclosure::of(scene, enclosure::Settings::default(), Parts::NONE)
            .map_err(|error| error.to_string())?;
        let n = enclosure.patches.len();
        if n > most_patches {
            return Err(format!(
                "the scene has {n} patches; at most {most_patches} are measured"
            ));
        }
        let in_channel = |channel: usize, of: &[Rgb]| -> Vec<f64> {
            of.iter().map(|color| color.channels()[channel]).collect()
        };
        let emitted = |channel: &usize| {
            in_channel(*channel, &enclosure.emission)
                .iter()
                .sum::<f64>()
        };
        let by_emission = |a: &usize, b: &usize| emitted(b).total_cmp(&emitted(a));
        let brightest = (0..3).min_by(by_emission).unwrap_or(0);
        if emitted(&brightest) == 0.0 {
            return Err("nothing in the scene emits light".into());
        }
        Ok(Problem {
            f: enclosure.form_factors().matrix(),
            area: enclosure.patches.areas(),
            rho: in_channel(brightest, &enclosure.reflectance),
            emission: in_channel(brightest, &enclosure.emission),
        })
    }

    pub fn patches(&self) -> usize {
        self.area.len()
    }

    /// The matrix, and four numbers a patch.
    pub fn bytes(&self) -> u64 {
        ((self.f.len() + 4 * self.patches()) * size_of::<f64>()) as u64
    }

    /// Solves it. Errors: why there is no solution.
    pub fn solve<R: Recorder<Event>>(
        &self,
        solver: Solver,
        tolerance: f64,
        recorder: &mut R,
    ) -> Result<Solution, String> {
        let stop = Stop {
            tolerance,
            max_iterations: 10_000_000,
        };
        let patches = Patches::new(&self.area, &self.rho, &self.emission);
        let matrix = Matrix::new(&self.f, self.patches()).map_err(|why| why.to_string())?;
        let system = patches.and_then(|patches| System::new(&matrix, patches));
        let solution = system
            .and_then(|system| solve(&system, solver, stop, &RecordFilter::default(), recorder));
        solution.map_err(|why| why.to_string())
    }
}

/// The solvers that differ: the automatic choice is one of the others.
pub fn solvers() -> impl Iterator<Item = Solver> {
    let differs = |solver: &Solver| *solver != Solver::Auto;
    Solver::ALL.into_iter().filter(differs)
}

fn sweeps(request: &Request) -> Result<Vec<Sweep>, String> {
    let most = request.either(600, 4000);
    let problem = match request.scene {
        Some(scene) => Problem::of(scene, most)?,
        None => Problem::of(&scenes::cube(request.either(4, 8)), most)?,
    };
    let right = problem.solve(Solver::Direct, 1e-13, &mut Unrecorded)?;
    let reference = Reference {
        what: Label::with("reference-elimination", "count", problem.patches()),
        error: right.error_bound.unwrap_or(1e-13),
        known_by: Label::of("reference-bound"),
    };
    let truth: Rc<[f64]> = right.radiosity.into();
    let problem = Rc::new(problem);
    let finest = request.either(8, 12);
    let longest = request.either(0.3, 5.0);
    let curves = solvers().map(|solver| {
        Curve::against(
            &truth,
            Label::Solver(solver),
            sweep_settings(&problem, solver, finest, longest),
        )
    });
    Ok(vec![Sweep {
        title: Label::of("part-one-channel"),
        axes: Axes::ErrorOverTime,
        size: Message("measure-sweeps"),
        quantity: Message("measure-radiosity-in-the-unit-of-the-emission"),
        law: Law::Geometric,
        reference,
        memory: Message("memory-two-matrices"),
        curves: curves.collect(),
    }])
}

/// Smaller and smaller residuals, as far as the solver needs more iterations for them, and no more than `longest` seconds.
fn sweep_settings(
    problem: &Rc<Problem>,
    solver: Solver,
    finest: i32,
    longest: f64,
) -> Vec<Setting> {
    let mut sweep_settings: Vec<Setting> = Vec::new();
    for exponent in 1..=finest {
        let tolerance = 10_f64.powi(-exponent);
        let start = Instant::now();
        let Ok(solution) = problem.solve(solver, tolerance, &mut Unrecorded) else {
            break;
        };
        if start.elapsed().as_secs_f64() > longest {
            break;
        }
        let iterations = f64::from(solution.iterations);
        let sweeps = if solver.shoots() {
            iterations / problem.patches() as f64
        } else {
            iterations
        };
        if sweep_settings
            .last()
            .is_some_and(|last| last.size == sweeps)
        {
            continue;
        }
        let counted = &mut Counter::default();
        let again = problem.solve(solver, tolerance, counted);
        debug_assert!(again.is_ok(), "recorded or not, the result is the same");
        let matrices = if solver == Solver::Direct { 2 } else { 1 };
        let shared = problem.clone();
        sweep_settings.push(Setting {
            setting: match solver.shoots() {
                true => Label::with("setting-shots", "count", solution.iterations),
                false => Label::with("setting-iterations", "count", solution.iterations),
            },
            size: sweeps,
            bytes: matrices * problem.bytes(),
            operations: operations(
                counted,
                &[
                    ("Iteration", "iterations"),
                    ("Exchanged", "exchanges_gathered"),
                    ("Received", "exchanges_shot"),
                ],
            ),
            truth: None,
            drawn: None,
            run: Box::new(move || {
                let solution = shared.solve(solver, tolerance, &mut Unrecorded)?;
                Ok(Values::Numbers(solution.radiosity))
            }),
        });
    }
    sweep_settings
}
