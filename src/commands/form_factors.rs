//! `lightwalk form-factors`: the matrix of a scene's form factors.

use super::arguments::{LimitArguments, parse_whole};
use super::failure::Failure;
use super::files;
use super::matrix_difference::{compare_matrix, read_matrix};
use super::notes;
use super::output;
use super::progress::{Progress, named};
use crate::algorithms::enclosure::{Enclosure, Settings};
use crate::algorithms::form_factor::{Method, Report};
use crate::export::Table;
use crate::render;
use crate::scene::Parts;
use crate::scene::Scene;
use crate::scene::patches::Patches;
use clap::builder::PossibleValuesParser;
use serde_json::{Value as Json, json};
use std::convert::Infallible;
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};
use std::thread::available_parallelism;
use web_time::Instant;

/// The most memory that a matrix takes unless told otherwise, in MiB.
const MAX_MEMORY: u64 = 8192;

#[derive(clap::Args)]
pub struct Arguments {
    /// A scene file
    scene: PathBuf,
    /// How a form factor is found
    #[arg(long, value_name = "METHOD", default_value = "auto", value_parser = PossibleValuesParser::new(Method::ALL.map(Method::name)))]
    method: String,
    #[command(flatten)]
    visibility: VisibilityArgument,
    #[command(flatten)]
    memory: MemoryArgument,
    /// Where the matrix goes: FILE.json with all that is known of it, or FILE.csv or FILE.npy (NumPy) with the numbers alone
    #[arg(long, value_name = "FILE", required_unless_present = "with")]
    out: Option<PathBuf>,
    /// A matrix of your own program to compare: JSON, rows of numbers, or FILE.npy
    #[arg(long, value_name = "MATRIX")]
    with: Option<PathBuf>,
    /// How far an entry of yours may be off
    #[arg(
        long,
        value_name = "T",
        default_value_t = 1e-4,
        requires = "with",
        allow_negative_numbers = true
    )]
    tolerance: f64,
    #[command(flatten)]
    limits: LimitArguments,
}

#[derive(clap::Args, Clone)]
pub struct VisibilityArgument {
    /// Whether what stands between two patches counts [default: auto]
    #[arg(long, value_name = "none,auto", value_parser = PossibleValuesParser::new(["auto", "none"]))]
    visibility: Option<String>,
}

impl VisibilityArgument {
    pub fn is_given(&self) -> bool {
        self.visibility.is_some()
    }
}

#[derive(clap::Args, Clone, Copy)]
pub struct MemoryArgument {
    /// The most memory that the matrix of form factors may take, in MiB
    #[arg(long, value_name = "MIB", allow_negative_numbers = true, value_parser = parse_whole::<u64>, default_value_t = MAX_MEMORY)]
    pub max_memory: u64,
}

impl MemoryArgument {
    /// What is wrong with a matrix for this room, if it is too large. Nothing has been allocated then.
    pub fn refusal(self, enclosure: &Enclosure) -> Option<String> {
        let needed = enclosure.matrix_bytes().div_ceil(1 << 20);
        (needed > self.max_memory).then(|| {
            format!(
                "the form factors of {} patches take {needed} MiB; at most {} are allowed (--max-memory)",
                enclosure.patches.len(),
                self.max_memory
            )
        })
    }
}

/// How form factors are to be found, by the name of a method that clap has checked; for the rest what `unless` says.
pub fn settings(
    method: Option<&str>,
    visibility: &VisibilityArgument,
    unless: Settings,
) -> Result<Settings, Failure> {
    let mut settings = unless;
    if let Some(method) = method {
        settings.form_factors = Method::from_name(method)
            .ok_or_else(|| Failure::Wrong(format!("{method}: there is no such method")))?;
    }
    if let Some(visibility) = &visibility.visibility {
        settings.visibility = visibility == "auto";
    }
    Ok(settings)
}

/// A scene's patches, or what is wrong with them.
pub fn enclosure(scene: &Scene, path: &Path, settings: Settings) -> Result<Enclosure, Failure> {
    named("dividing the scene into patches", || {
        Enclosure::of(scene, settings, Parts::NONE)
    })
    .map_err(|error| files::wrong(&path.display(), &error))
}

/// The matrix of a room, with progress.
pub fn matrix_of(enclosure: &Enclosure) -> &[f64] {
    let threads = available_parallelism().unwrap_or(NonZeroUsize::MIN);
    let progress = Progress::new("form factors");
    let show = |done, all| {
        progress.show(done, all);
        Ok::<(), Infallible>(())
    };
    let Ok(matrix) = render::matrix(enclosure, threads, &show);
    matrix
}

pub fn run(arguments: Arguments) -> Result<(), Failure> {
    if let Some(out) = &arguments.out {
        output::check_known_ending("--out", out, &["json", "csv", "npy"])?;
        output::check_output(out)?;
    }
    let tolerance = arguments.tolerance;
    if !(0.0..=1.0).contains(&tolerance) {
        return Err(Failure::Wrong(format!(
            "--tolerance {tolerance}: allowed are numbers from 0 to 1"
        )));
    }
    let unless = Settings {
        max_patches: arguments.limits.max_patches,
        closure: false,
        ..Settings::default()
    };
    let settings = settings(Some(&arguments.method), &arguments.visibility, unless)?;
    let (scene, ..) = files::scene(&arguments.scene, &arguments.limits.into())?;
    let enclosure = enclosure(&scene, &arguments.scene, settings)?;
    if let Some(refusal) = arguments.memory.refusal(&enclosure) {
        return Err(files::wrong(&arguments.scene.display(), &refusal));
    }
    notes::print(&arguments.scene.display(), &scene.notes);
    let mine = match &arguments.with {
        None => None,
        Some(path) => Some(read_matrix(path, &enclosure)?),
    };
    let start = Instant::now();
    let matrix = matrix_of(&enclosure);
    let seconds = start.elapsed().as_secs_f64();
    if let Some(out) = &arguments.out {
        match Table::of(out) {
            Some(table) => {
                let n = enclosure.patches.len();
                let rows = table.array(&[n, n], |i| matrix[i * n..(i + 1) * n].to_vec());
                output::write_made(out, "writing the matrix", rows)?;
            }
            None => write(out, &scene, &enclosure, matrix, seconds)?,
        }
    }
    match mine {
        None => Ok(()),
        Some(mine) => compare_matrix(&scene, &enclosure, (&mine, matrix), tolerance, false),
    }
}

fn write(
    out: &Path,
    scene: &Scene,
    enclosure: &Enclosure,
    matrix: &[f64],
    seconds: f64,
) -> Result<(), Failure> {
    let areas = enclosure.patches.areas();
    let Report {
        row_sums,
        reciprocity_defect,
        closure_defect,
    } = Report::of(&areas, matrix, &vec![true; areas.len()]);
    output::write_whole(out, |out| {
        let patches = serde_json::to_string(&patches(scene, &enclosure.patches))?;
        write!(out, "{{\"patches\":{patches},\"matrix\":[")?;
        let n = enclosure.patches.len();
        for (i, row) in matrix.chunks(n.max(1)).enumerate() {
            out.write_all(if i == 0 { b"\n" } else { b",\n" })?;
            serde_json::to_writer(&mut *out, row)?;
        }
        let rest = json!({
            "method": enclosure.settings.form_factors.name(),
            "seconds": seconds,
            "row_sums": row_sums,
            "reciprocity_defect": reciprocity_defect,
            "closure_defect": closure_defect,
            "notes": scene.notes,
        });
        // The rest of the one object
        writeln!(out, "],{}", rest.to_string().trim_start_matches('{'))
    })
}

/// Every patch by its object and cell, with its area.
fn patches(scene: &Scene, patches: &Patches) -> Vec<Json> {
    let recorded = patches.iter().map(|patch| {
        let object = &scene.objects[patch.object as usize].name;
        let [i, j] = patch.cell;
        json!({ "object": object, "i": i, "j": j, "area": patch.area })
    });
    recorded.collect()
}
