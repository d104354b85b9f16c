//! `lightwalk render`: a picture of a scene.

use super::arguments::{
    LimitArguments, RayArguments, method, method_names, parse_number, parse_size, parse_within,
};
use super::failure::Failure;
use super::form_factors::MemoryArgument;
use super::hierarchy::HierarchyArguments;
use super::progress::Progress;
use super::radiosity::{SolutionArguments, light};
use super::{files, needs, notes, output};
use crate::algorithms::enclosure;
use crate::algorithms::hierarchical::Unsolved;
use crate::export::{TakeAway, whole_picture};
use crate::methods::hierarchical::{self, NoLight};
use crate::methods::{Method, Settings, Setup};
use crate::render::{RayCounts, render, render_counted};
use std::convert::Infallible;
use std::fmt::Display;
use std::num::NonZeroUsize;
use std::path::PathBuf;
use web_time::Instant;

#[derive(clap::Args)]
pub struct Arguments {
    /// A scene file
    scene: PathBuf,
    /// How to draw it
    #[arg(long, value_parser = method_names(), value_name = "METHOD")]
    method: String,
    #[arg(long, allow_hyphen_values = true, value_parser = parse_size, value_name = "WxH", default_value = "640x480")]
    size: [u32; 2],
    /// As many as cores unless given, at most 256
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = |text: &str| parse_within(text, 1..=256_u16))]
    threads: Option<u16>,
    /// Scales a PNG by 2^EV
    #[arg(
        long,
        value_name = "EV",
        default_value_t = 0.0,
        allow_negative_numbers = true,
        value_parser = parse_number
    )]
    exposure: f64,
    /// FILE.png (8 bits, sRGB) or FILE.pfm (linear float)
    #[arg(long, value_name = "FILE")]
    out: PathBuf,
    /// Prints seconds by phase, what was drawn and what was left out, as one JSON object
    #[arg(long)]
    stats: bool,
    /// Of radiosity: interpolated between the corners of patches, instead of constant over each
    #[arg(long)]
    smooth: bool,
    #[command(flatten)]
    rays: RayArguments,
    #[command(flatten)]
    solution: SolutionArguments,
    #[command(flatten)]
    hierarchy: HierarchyArguments,
    #[command(flatten)]
    memory: MemoryArgument,
    #[command(flatten)]
    limits: LimitArguments,
}

pub fn run(arguments: Arguments) -> Result<(), Failure> {
    let Arguments {
        size: [width, height],
        exposure,
        out,
        ..
    } = &arguments;
    let method = method(&arguments.method)?;
    output::check_ending("--out", out, TakeAway::Picture.endings())?;
    let ending = out.extension().and_then(|ending| ending.to_str());
    let ending = ending.unwrap_or_default();
    if !(-64.0..=64.0).contains(exposure) {
        return Err(Failure::Wrong(format!(
            "--exposure {exposure:?}: allowed are numbers from -64 to 64"
        )));
    }
    output::check_output(out)?;

    let start = Instant::now();
    let (scene, settings) = files::scene(&arguments.scene, &arguments.limits.into())?;
    let read = start.elapsed();
    let solution = &arguments.solution;
    let settings = Settings::from(arguments.rays.or(settings.get())).with(enclosure::Settings {
        smooth: arguments.smooth,
        ..solution.or(settings.get(), arguments.limits)?
    });
    let settings = settings.with(arguments.hierarchy.or(Default::default())?);
    let prepared = files::prepared(scene, arguments.size, method, &arguments.scene.display())?;
    let setup = Setup::new(prepared, settings);
    let staged = start.elapsed();
    let mut notes = [
        arguments.rays.notes(method),
        solution.notes(method),
        arguments.hierarchy.notes(method),
    ]
    .concat();
    if arguments.smooth {
        let has_use = |method: Method| method.family().exchanges_light();
        notes.extend(notes::without_effect(["--smooth"], method, has_use));
    }
    notes.extend(setup.notes(method));
    notes::print(&arguments.scene.display(), &notes);
    let mut hierarchy = None;
    match method {
        Method::Radiosity => solve(&setup, &arguments)?,
        Method::HierarchicalRadiosity => hierarchy = Some(linked(&setup, &arguments)?),
        _ => {}
    }
    let solved = start.elapsed();
    let threads = match arguments.threads {
        Some(threads) => NonZeroUsize::new(threads.into()).unwrap_or(NonZeroUsize::MIN),
        None => std::thread::available_parallelism().unwrap_or(NonZeroUsize::MIN),
    };
    let progress = Progress::new("rendering");
    let show = |done, all| progress.show(done, all);
    let (frame, rays) = match arguments.stats {
        true => render_counted(&setup, method, setup.needs(), threads, &show),
        false => (render(&setup, method, threads, &show), RayCounts::default()),
    };
    drop(progress);
    let rendered = start.elapsed();
    let picture = whole_picture(&frame, ending, exposure.exp2());
    output::write_whole(out, |writer| picture.write_all(writer, &|_, _| ()))?;
    let written = start.elapsed();

    if arguments.stats {
        let skipped = needs::skipped(&setup, method);
        let notes = [notes, setup.replaced(method)].concat();
        let stats = serde_json::json!({
            "method": method.name(),
            "size": [width, height],
            "threads": threads,
            "seconds": {
                "read": read.as_secs_f64(),
                "tessellate": (staged - read).as_secs_f64(),
                "solve": (solved - staged).as_secs_f64(),
                "render": (rendered - solved).as_secs_f64(),
                "write": (written - rendered).as_secs_f64(),
            },
            "polygons": setup.prepared.tessellation.polygon_count(),
            "rays": {
                "primary": rays.primary,
                "shadow": rays.shadow,
                "reflected": rays.reflected,
                "transmitted": rays.transmitted,
                "total_internal_reflection": rays.total_internal_reflection,
            },
            "hierarchy": hierarchy,
            "left_out": skipped,
            "notes": notes,
        });
        use std::io::Write;
        writeln!(std::io::stdout(), "{stats}")?;
    }
    Ok(())
}

/// Finds the light of the scene's room, or says why there is none.
fn solve(setup: &Setup, arguments: &Arguments) -> Result<(), Failure> {
    let wrong = |error: &dyn Display| files::wrong(&arguments.scene.display(), error);
    let enclosure = setup.enclosure().map_err(|error| wrong(error))?;
    if let Some(refusal) = arguments.memory.refusal(enclosure) {
        return Err(wrong(&refusal));
    }
    light(&setup.prepared.scene, enclosure).map(drop)
}

/// The elements and links of the scene's room, or why there is no light.
fn linked(setup: &Setup, arguments: &Arguments) -> Result<serde_json::Value, Failure> {
    let progress = Progress::new("linking elements");
    let go_on = || {
        progress.show(0, 1);
        Ok::<(), Infallible>(())
    };
    let Ok(solved) = hierarchical::light(setup, go_on);
    drop(progress);
    match solved {
        Ok(light) => Ok(serde_json::json!({
            "patches": light.radiosity.len(),
            "elements": light.elements,
            "leaves": light.leaves,
            "links": light.links,
            "gatherings": light.sweeps,
        })),
        Err(why @ (NoLight::Patches(_) | NoLight::Unsolved(Unsolved::TooManyLinks))) => {
            Err(files::wrong(&arguments.scene.display(), &why))
        }
        Err(why @ NoLight::Unsolved(Unsolved::Unsettled { .. })) => Err(Failure::Failed(format!(
            "{}: {why}",
            arguments.scene.display()
        ))),
    }
}
