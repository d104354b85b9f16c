//! `lightwalk needs`: what a scene needs, what is left out, why, and what that saves.

use super::arguments::{LimitArguments, RayArguments, method, method_names};
use super::failure::Failure;
use super::progress::Progress;
use super::radiosity::SolutionArguments;
use super::{files, form_factors, notes};
use crate::methods::{Method, Settings, Setup};
use crate::scene::{Camera, LeftOut, Part, Scene};
use crate::study::ablation::{Ablation, Ablations, Measured, Sameness, Steps, ablations};
use crate::study::timing::Patience;
use glam::DVec3;
use serde_json::{Value as Json, json};
use std::io::Write;
use std::path::PathBuf;
use web_time::Duration;

/// The picture on which the saving is measured.
const SIZE: [u32; 2] = [160, 120];

/// What takes longer than two seconds is not measured: so all of it together takes about a minute at most.
const PATIENCE: Patience = Patience {
    shortest: Duration::from_millis(2),
    longest: Duration::from_secs(2),
    whole: Duration::from_secs(4),
    most_rounds: 15,
};

#[derive(clap::Args)]
pub struct Arguments {
    /// A scene file
    scene: PathBuf,
    /// For which way to draw it: ray-tracing unless given
    #[arg(long, value_parser = method_names(), value_name = "METHOD")]
    method: Option<String>,
    /// As a JSON object
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    rays: RayArguments,
    #[command(flatten)]
    solution: SolutionArguments,
    #[command(flatten)]
    limits: LimitArguments,
}

pub fn run(arguments: Arguments) -> Result<(), Failure> {
    let method = match &arguments.method {
        Some(name) => method(name)?,
        None => Method::RayTracing,
    };
    let path = &arguments.scene;
    let (scene, settings) = files::scene(path, &arguments.limits.into())?;
    let has_camera = scene.camera.is_some();
    let solution = &arguments.solution;
    let radiosity = solution.or(settings.get(), arguments.limits)?;
    if method.family().exchanges_light() {
        form_factors::enclosure(&scene, path, radiosity)?;
    }
    let settings = Settings::from(arguments.rays.or(settings.get())).with(radiosity);
    let prepared = files::prepared(with_camera(scene), SIZE, method, &path.display())?;
    let setup = Setup::new(prepared, settings);
    let skipped = setup.skipped(method);
    let without_effect = [arguments.rays.notes(method), solution.notes(method)].concat();
    let notes = [without_effect, setup.notes(method), setup.replaced(method)].concat();
    notes::print(&path.display(), &notes);
    // The light of a room is the same for every camera.
    let measured = (has_camera || method == Method::Radiosity).then(|| {
        let progress = Progress::new("measuring what is saved");
        ablations(&setup, method, PATIENCE, &|done, all| {
            progress.show(done, all)
        })
    });
    let mut out = std::io::stdout().lock();
    if arguments.json {
        let recorded = json!({
            "scene": path.display().to_string(),
            "method": method.name(),
            "needed": needed(method, &skipped).map(Part::name).collect::<Vec<_>>(),
            "left_out": self::skipped(&setup, method),
            "size": SIZE,
            "notes": notes,
            "saved": measured.map(|measured| measured.map_or_else(|why| json!({ "error": why }), |ablations| saved(&ablations))),
        });
        writeln!(out, "{recorded:#}")?;
        return Ok(());
    }
    writeln!(out, "{} of {}", method.name(), path.display())?;
    write_list(&setup, method, &skipped, &mut out)?;
    match measured {
        Some(Ok(ablations)) => print_ablations(&ablations, method, &mut out),
        Some(Err(why)) => Ok(writeln!(out, "not measured: {why}")?),
        None => Ok(writeln!(out, "not measured: the scene has no camera")?),
    }
}

/// With some camera, where the scene has none: what a scene needs does not hang on it.
fn with_camera(mut scene: Scene) -> Scene {
    scene.camera.get_or_insert(Camera {
        eye: DVec3::ZERO,
        target: DVec3::NEG_Z,
        up: DVec3::Y,
        fov_x: 1.0,
    });
    scene
}

/// What the method does of it all, and cannot leave out.
fn needed(method: Method, skipped: &[LeftOut]) -> impl Iterator<Item = Part> {
    let is_needed = move |&part: &Part| {
        let mut skipped = skipped.iter();
        method.parts().contains(&part) && skipped.all(|skipped| skipped.part != part)
    };
    Part::ALL.into_iter().filter(is_needed)
}

fn write_list(
    setup: &Setup,
    method: Method,
    skipped: &[LeftOut],
    out: &mut impl Write,
) -> Result<(), Failure> {
    for part in needed(method, skipped) {
        writeln!(out, "  needed    {}", part.name())?;
    }
    for skipped in skipped {
        let LeftOut { part, place, share } = skipped;
        let share = share.map_or(String::new(), |[some, all]| {
            format!(", for {some} of {all} {}", part.counted())
        });
        let (name, why) = (part.name(), part.why());
        writeln!(out, "  left out  {name}{share}: {place}: {why}")?;
    }
    for object in infinite(setup, method) {
        writeln!(out, "  left out  object \"{object}\": {INFINITE}")?;
    }
    Ok(())
}

const INFINITE: &str = "an infinite plane has no polygons";

/// The names of objects that the method cannot draw.
fn infinite(setup: &Setup, method: Method) -> impl Iterator<Item = &str> {
    let planes = setup.prepared.tessellation.skipped.iter();
    let names = planes.map(|&object| setup.prepared.scene.objects[object].name.as_str());
    names.filter(move |_| method.converts_polygons())
}

/// What was left out of a picture, for `render --stats`.
pub fn skipped(setup: &Setup, method: Method) -> Vec<Json> {
    let recorded = |skipped: LeftOut| {
        let LeftOut { part, place, share } = skipped;
        let mut recorded = json!({ "what": part.name(), "place": place, "why": part.why() });
        if let Some(share) = share {
            recorded[part.counted().replace(' ', "_")] = json!(share);
        }
        recorded
    };
    let parts = setup.skipped(method).into_iter().map(recorded);
    let planes = infinite(setup, method).map(
        |object| json!({ "what": "object", "object": object, "place": "objects", "why": INFINITE }),
    );
    parts.chain(planes).collect()
}

/// A line a part: what it would take, and that nothing else would change.
fn print_ablations(
    ablations: &Ablations,
    method: Method,
    out: &mut impl Write,
) -> Result<(), Failure> {
    let Ablations { time, steps, parts } = ablations;
    let what = match method {
        Method::Radiosity => "form factors and solution".to_owned(),
        _ => format!("a picture of {}x{}", SIZE[0], SIZE[1]),
    };
    writeln!(
        out,
        "{what} on one thread, all that is not needed left out: {} ms (median of {} runs), {} steps if recorded",
        milliseconds(time.median),
        time.runs,
        steps.count
    )?;
    if parts.is_empty() {
        return Ok(());
    }
    writeln!(
        out,
        "{:<20} {:>11} {:>22} {:>12} {:>12}  result",
        "done all the same", "ms", "saved by leaving out", "steps saved", "KiB saved"
    )?;
    for Ablation { part, measured } in parts {
        let name = part.map_or("all of these", Part::name);
        let Measured {
            time: with,
            steps: recorded,
            sameness,
        } = match measured {
            Ok(measured) => measured,
            Err(why) => {
                writeln!(out, "{name:<20} {why}")?;
                continue;
            }
        };
        let saved = match with.ties(time) {
            true => "tie: within noise".to_owned(),
            false => {
                let difference = with.median - time.median;
                let share = 100.0 * difference / with.median;
                format!("{} ms ({share:.0} %)", milliseconds(difference))
            }
        };
        let Steps { count, bytes } = *recorded;
        writeln!(
            out,
            "{name:<20} {:>11} {saved:>22} {:>12} {:>12}  {}",
            milliseconds(with.median),
            i128::from(count) - i128::from(steps.count),
            (i128::from(bytes) - i128::from(steps.bytes)) / 1024,
            in_words(*sameness)
        )?;
    }
    Ok(())
}

fn milliseconds(seconds: f64) -> String {
    format!("{:.3}", 1e3 * seconds)
}

fn in_words(sameness: Sameness) -> String {
    match sameness {
        Sameness::Same => "the same, bit by bit".into(),
        Sameness::Within(difference) => format!("the same to {difference:.0e}"),
        Sameness::Differs(difference) => format!("DIFFERS by {difference:.0e}"),
    }
}

fn saved(ablations: &Ablations) -> Json {
    let timing = |time: &crate::study::timing::Timing| json!({ "median": time.median, "quartiles": [time.lower, time.upper], "runs": time.runs });
    let parts = ablations.parts.iter().map(|ablation| {
        let part = ablation.part.map_or("all", Part::name);
        match &ablation.measured {
            Err(why) => json!({ "part": part, "error": why }),
            Ok(measured) => json!({
                "part": part,
                "seconds": timing(&measured.time),
                "tie": measured.time.ties(&ablations.time),
                "steps": measured.steps.count,
                "bytes": measured.steps.bytes,
                "same_bits": measured.sameness == Sameness::Same,
                "difference": match measured.sameness {
                    Sameness::Same => 0.0,
                    Sameness::Within(difference) | Sameness::Differs(difference) => difference,
                },
            }),
        }
    });
    json!({
        "left_out": { "seconds": timing(&ablations.time), "steps": ablations.steps.count, "bytes": ablations.steps.bytes },
        "done": parts.collect::<Vec<_>>(),
    })
}
