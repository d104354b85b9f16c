//! `lightwalk radiosity`: the light of a scene, patch by patch.

use super::form_factors::{MemoryArgument, VisibilityArgument, matrix, room, settings};
use super::progress::named;
use super::{Failure, LimitArguments, files, tell};
use crate::algorithms::form_factor::Method;
use crate::algorithms::radiosity::{ChannelUnsolved, Solver, Stop, Watch};
use crate::algorithms::room::{Light, Room, Settings};
use crate::record::Unrecorded;
use crate::scene::Scene;
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
    #[arg(long, value_name = "FILE.json")]
    out: PathBuf,
    #[command(flatten)]
    limits: LimitArguments,
}

/// How the light of a room is found.
#[derive(clap::Args, Clone)]
pub struct SolutionArguments {
    /// How the system of equations is solved
    #[arg(long, value_name = "SOLVER", default_value = "auto", value_parser = PossibleValuesParser::new(Solver::ALL.map(Solver::name)))]
    solver: String,
    /// How a form factor is found
    #[arg(long, value_name = "METHOD", default_value = "auto", value_parser = PossibleValuesParser::new(Method::NAMES))]
    form_factors: String,
    #[command(flatten)]
    visibility: VisibilityArgument,
    /// The relative residual that is small enough
    #[arg(long, value_name = "T", default_value_t = Stop::default().tolerance, allow_negative_numbers = true)]
    tolerance: f64,
    /// The most iterations, or shots of one patch
    #[arg(long, value_name = "N", default_value_t = Stop::default().max_iterations, allow_negative_numbers = true)]
    max_iterations: u32,
}

impl SolutionArguments {
    /// What was asked for.
    pub fn settings(&self, limits: LimitArguments) -> Result<Settings, Failure> {
        let tolerance = self.tolerance;
        if !(tolerance > 0.0 && tolerance < 1.0) {
            return Err(Failure::Wrong(format!(
                "--tolerance {tolerance}: allowed are numbers above 0 and below 1"
            )));
        }
        let mut settings = settings(&self.form_factors, &self.visibility, limits)?;
        settings.solver = Solver::from_name(&self.solver)
            .ok_or_else(|| Failure::Wrong(format!("{}: there is no such solver", self.solver)))?;
        settings.stop = Stop {
            tolerance,
            max_iterations: self.max_iterations,
        };
        Ok(settings)
    }
}

pub fn run(arguments: Arguments) -> Result<(), Failure> {
    files::check_output(&arguments.out)?;
    let settings = arguments.solution.settings(arguments.limits)?;
    let (scene, _) = files::scene(&arguments.scene, &arguments.limits.into())?;
    let start = Instant::now();
    let room = room(&scene, &arguments.scene, settings)?;
    let divided = start.elapsed();
    let shot: Light;
    let (exchanged, light) = match arguments.memory.refusal(&room) {
        None => {
            matrix(&room);
            (start.elapsed(), light(&room)?)
        }
        Some(refusal) if room.settings.solver.shoots() => {
            tell(format_args!(
                "lightwalk: {refusal}: they are found row by row, shot by shot"
            ));
            shot = shoot(&room)?;
            (divided, &shot)
        }
        Some(refusal) => {
            let advice = format!("{refusal}; --solver shooting and overshooting need no matrix");
            return Err(files::wrong(&arguments.scene.display(), &advice));
        }
    };
    let solved = start.elapsed();
    let solutions = &light.solutions;
    let result = json!({
        "solver": room.settings.solver.name(),
        "iterations": solutions.iter().map(|solution| solution.iterations).max(),
        "residual": solutions.each_ref().map(|solution| solution.residual),
        "error_bound": solutions.each_ref().map(|solution| solution.error_bound),
        "seconds": {
            "divide": divided.as_secs_f64(),
            "form_factors": (exchanged - divided).as_secs_f64(),
            "solve": (solved - exchanged).as_secs_f64(),
        },
        "surfaces": surfaces(&scene, &room, light),
    });
    files::write_whole(&arguments.out, |out| {
        serde_json::to_writer(&mut *out, &result)?;
        writeln!(out)
    })
}

/// The light of a room, or a failure of the work: what did not converge is no result.
pub fn light(room: &Room) -> Result<&Light, Failure> {
    let matrix = matrix(room);
    named("solving", || room.light(matrix)).map_err(|why| unsolved(room, why))
}

fn shoot(room: &Room) -> Result<Light, Failure> {
    let untold = &mut Unrecorded;
    named("shooting", || room.shoot(&Watch::default(), untold)).map_err(|why| unsolved(room, &why))
}

fn unsolved(room: &Room, why: &ChannelUnsolved) -> Failure {
    Failure::Failed(format!("{}: {why}", room.settings.solver.name()))
}

fn surfaces(scene: &Scene, room: &Room, light: &Light) -> Vec<Json> {
    let patches: Vec<_> = room.patches.iter().collect();
    let objects = scene.objects.iter().zip(&room.patches.surfaces);
    let surface = |(object, surface): (&crate::scene::Object, &crate::scene::patches::Surface)| {
        let [nu, nv] = surface.grid.map(|n| n as usize);
        let range = surface.first..surface.first + nu * nv;
        let told = range.map(|patch| {
            let [i, j] = patches[patch].cell;
            let radiosity = light.radiosity[patch].channels();
            json!({ "i": i, "j": j, "area": patches[patch].area, "radiosity": radiosity })
        });
        json!({ "object": object.name, "grid": surface.grid, "patches": told.collect::<Vec<_>>() })
    };
    objects.map(surface).collect()
}
