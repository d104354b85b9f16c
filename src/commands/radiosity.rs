//! `lightwalk radiosity`: the light of a scene, patch by patch.

use super::accuracy;
use super::arguments::{LimitArguments, parse_number, parse_whole};
use super::failure::{Failure, note};
use super::files;
use super::form_factors::{MemoryArgument, VisibilityArgument, enclosure, matrix_of, settings};
use super::notes;
use super::output;
use super::progress::named;
use crate::algorithms::enclosure::{Enclosure, Light, Settings};
use crate::algorithms::form_factor::Method;
use crate::algorithms::radiosity::{ChannelUnsolved, RecordFilter, Solver, Unsolved};
use crate::algorithms::{enclosure_notes, lamp_notes};
use crate::export::{Table, TakeAway, radiosities, system};
use crate::methods;
use crate::record::Unrecorded;
use crate::scene::{Note, Scene};
use clap::builder::PossibleValuesParser;
use serde_json::{Value as Json, json};
use std::path::PathBuf;
use web_time::Instant;

#[derive(clap::Args)]
pub struct Arguments {
    /// A scene file
    scene: PathBuf,
    #[command(flatten)]
    solution: SolutionArguments,
    #[command(flatten)]
    memory: MemoryArgument,
    /// Where the radiosities go: FILE.json with all that is known of them, FILE.csv with ρ, E and B of every patch, or FILE.npy (NumPy)
    /// with B alone, a row a patch
    #[arg(long, value_name = "FILE")]
    out: PathBuf,
    /// Where the matrix I − ρF goes that was solved with, FILE.npy or FILE.csv: all rows of red, then those of green and of blue
    #[arg(long, value_name = "FILE")]
    matrix: Option<PathBuf>,
    #[command(flatten)]
    limits: LimitArguments,
}

/// How the light of a room is found.
#[derive(clap::Args, Clone)]
pub struct SolutionArguments {
    #[command(flatten)]
    system: SystemArguments,
    #[command(flatten)]
    tolerance: ToleranceArgument,
}

/// When a solver has done enough.
#[derive(clap::Args, Clone, Copy, Default)]
pub struct ToleranceArgument {
    /// The relative residual that is small enough [default: 1e-6]
    #[arg(long, value_name = "T", allow_negative_numbers = true, value_parser = parse_number)]
    tolerance: Option<f64>,
}

/// Which system is solved, and how.
#[derive(clap::Args, Clone)]
pub struct SystemArguments {
    /// How the system of equations is solved [default: auto]
    #[arg(long, value_name = "SOLVER", value_parser = PossibleValuesParser::new(Solver::ALL.map(Solver::name)))]
    solver: Option<String>,
    /// How a form factor is found [default: auto]
    #[arg(long, value_name = "METHOD", value_parser = PossibleValuesParser::new(Method::ALL.map(Method::name)))]
    form_factors: Option<String>,
    #[command(flatten)]
    visibility: VisibilityArgument,
    /// Whether the form factors of a closed scene are changed, as little as it takes, so that those from a patch sum to 1 [default: auto]
    #[arg(long, value_name = "auto,off", value_parser = PossibleValuesParser::new(["auto", "off"]))]
    closure: Option<String>,
    /// The most iterations, or shots of one patch [default: 1000000]
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = parse_whole::<u32>)]
    max_iterations: Option<u32>,
}

impl SolutionArguments {
    /// The options given, and for the rest those of `unless`.
    pub fn or(&self, unless: Settings, limits: LimitArguments) -> Result<Settings, Failure> {
        self.tolerance.or(self.system.or(unless, limits)?)
    }

    /// Notes on the options given, where `method` has no use for them.
    pub fn notes(&self, method: methods::Method) -> Vec<Note> {
        self.system.notes(self.tolerance, method)
    }
}

impl ToleranceArgument {
    /// The option, where it is given.
    pub fn given(self) -> Option<&'static str> {
        self.tolerance.map(|_| "--tolerance")
    }

    /// The tolerance given, or that of `settings`.
    pub fn or(self, mut settings: Settings) -> Result<Settings, Failure> {
        let tolerance = self.tolerance.unwrap_or(settings.stop.tolerance);
        if !(tolerance > 0.0 && tolerance < 1.0) {
            return Err(Failure::Wrong(format!(
                "--tolerance {tolerance:?}: allowed are numbers above 0 and below 1"
            )));
        }
        settings.stop.tolerance = tolerance;
        Ok(settings)
    }
}

impl SystemArguments {
    /// The options that are given.
    pub fn given(&self) -> Vec<&'static str> {
        let all = [
            ("--solver", self.solver.is_some()),
            ("--form-factors", self.form_factors.is_some()),
            ("--visibility", self.visibility.is_given()),
            ("--closure", self.closure.is_some()),
            ("--max-iterations", self.max_iterations.is_some()),
        ];
        let given = all.into_iter().filter(|(_, is_given)| *is_given);
        given.map(|(option, _)| option).collect()
    }

    /// Notes on the options given, where `method` has no use for them.
    pub fn notes(&self, tolerance: ToleranceArgument, method: methods::Method) -> Vec<Note> {
        let given = self.given().into_iter().chain(tolerance.given());
        let of_matrix =
            |option: &&str| ["--solver", "--form-factors", "--closure"].contains(option);
        let (of_matrix, of_both): (Vec<_>, Vec<_>) = given.partition(of_matrix);
        let solves = |method| method == methods::Method::Radiosity;
        let finds_light = |method: methods::Method| method.family().exchanges_light();
        [
            notes::without_effect(of_matrix, method, solves),
            notes::without_effect(of_both, method, finds_light),
        ]
        .concat()
    }

    /// The options given, and for the rest those of `unless`.
    pub fn or(&self, unless: Settings, limits: LimitArguments) -> Result<Settings, Failure> {
        let mut settings = settings(self.form_factors.as_deref(), &self.visibility, unless)?;
        settings.max_patches = limits.max_patches;
        if let Some(name) = &self.solver {
            settings.solver = Solver::from_name(name)
                .ok_or_else(|| Failure::Wrong(format!("{name}: there is no such solver")))?;
        }
        if let Some(closure) = &self.closure {
            settings.closure = closure == "auto";
        }
        settings.stop.max_iterations = self.max_iterations.unwrap_or(settings.stop.max_iterations);
        Ok(settings)
    }
}

pub fn run(arguments: Arguments) -> Result<(), Failure> {
    let endings = [&["json"], TakeAway::Radiosities.endings()].concat();
    output::check_known_ending("--out", &arguments.out, &endings)?;
    output::check_output(&arguments.out)?;
    if let Some(path) = &arguments.matrix {
        output::check_ending("--matrix", path, TakeAway::System.endings())?;
        output::check_output(path)?;
    }
    let (scene, unless) = files::scene(&arguments.scene, &arguments.limits.into())?;
    let settings = arguments.solution.or(unless.get(), arguments.limits)?;
    let start = Instant::now();
    let enclosure = enclosure(&scene, &arguments.scene, settings)?;
    let divided = start.elapsed();
    let mut notes = scene.notes.clone();
    notes.extend(enclosure_notes::notes(&scene));
    let (patches, primitives) = (&enclosure.patches, &enclosure.primitives);
    notes.extend(lamp_notes::notes(&scene, patches, primitives));
    notes::print(&arguments.scene.display(), &notes);
    let shot: Light;
    let (exchanged, light) = match arguments.memory.refusal(&enclosure) {
        None => {
            matrix_of(&enclosure);
            (start.elapsed(), light(&scene, &enclosure)?)
        }
        Some(refusal) if enclosure.settings.solver.shoots() && arguments.matrix.is_none() => {
            note(format_args!(
                "lightwalk: {refusal}: they are found row by row, shot by shot"
            ));
            shot = shoot(&scene, &enclosure)?;
            (divided, &shot)
        }
        Some(refusal) => {
            let advice = format!("{refusal}; --solver shooting and overshooting need no matrix");
            return Err(files::wrong(&arguments.scene.display(), &advice));
        }
    };
    let solved = start.elapsed();
    let accuracy = accuracy::of(&enclosure);
    if let Some(accuracy) = &accuracy {
        accuracy::report_excess(&scene, &enclosure, accuracy);
    }
    if let Some(path) = &arguments.matrix {
        let table = Table::of(path).unwrap_or(Table::Npy);
        let rows = system(table, &enclosure, matrix_of(&enclosure));
        output::write_made(path, "writing the matrix", rows)?;
    }
    if let Some(table) = Table::of(&arguments.out) {
        let rows = radiosities(table, &scene, &enclosure, light);
        return output::write_made(&arguments.out, "writing the light", rows);
    }
    let solutions = &light.solutions;
    let mut result = json!({
        "solver": enclosure.settings.solver.name(),
        "iterations": solutions.iter().map(|solution| solution.iterations).max(),
        "residual": solutions.each_ref().map(|solution| solution.residual),
        "error_bound": solutions.each_ref().map(|solution| solution.error_bound),
        "seconds": {
            "divide": divided.as_secs_f64(),
            "form_factors": (exchanged - divided).as_secs_f64(),
            "solve": (solved - exchanged).as_secs_f64(),
        },
        "surfaces": surfaces(&scene, &enclosure, light),
        "notes": notes,
    });
    if let (Json::Object(result), Json::Object(accuracy)) = (
        &mut result,
        accuracy::json(&enclosure, accuracy.as_ref(), light),
    ) {
        result.extend(accuracy);
    }
    output::write_whole(&arguments.out, |out| {
        serde_json::to_writer(&mut *out, &result)?;
        writeln!(out)
    })
}

/// The light of a room, or a failure of the work: what did not converge is no result.
pub fn light<'a>(scene: &Scene, enclosure: &'a Enclosure) -> Result<&'a Light, Failure> {
    let matrix = matrix_of(enclosure);
    named("solving", || enclosure.light(matrix)).map_err(|why| unsolved(scene, enclosure, why))
}

fn shoot(scene: &Scene, enclosure: &Enclosure) -> Result<Light, Failure> {
    named("shooting", || {
        enclosure.shoot(&RecordFilter::default(), &mut Unrecorded)
    })
    .map_err(|why| unsolved(scene, enclosure, &why))
}

fn unsolved(scene: &Scene, enclosure: &Enclosure, why: &ChannelUnsolved) -> Failure {
    let gained = match why.why {
        Unsolved::GainsLight => accuracy::why_light_is_gained(scene, enclosure),
        _ => None,
    };
    let gained = gained.map_or(String::new(), |gained| format!(": {gained}"));
    Failure::Failed(format!(
        "{}: {why}{gained}",
        enclosure.settings.solver.name()
    ))
}

fn surfaces(scene: &Scene, enclosure: &Enclosure, light: &Light) -> Vec<Json> {
    let patches: Vec<_> = enclosure.patches.iter().collect();
    let objects = scene.objects.iter().zip(&enclosure.patches.surfaces);
    let surface = |(object, surface): (&crate::scene::Object, &crate::scene::patches::Surface)| {
        let [nu, nv] = surface.grid.map(|n| n as usize);
        let range = surface.first..surface.first + nu * nv;
        let recorded = range.map(|patch| {
            let [i, j] = patches[patch].cell;
            let radiosity = light.radiosity[patch].channels();
            json!({ "i": i, "j": j, "area": patches[patch].area, "radiosity": radiosity })
        });
        json!({ "object": object.name, "grid": surface.grid, "patches": recorded.collect::<Vec<_>>() })
    };
    objects.map(surface).collect()
}
