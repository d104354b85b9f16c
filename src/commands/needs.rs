//! `lightwalk needs`: what a scene needs, what is left out, why, and what that saves.

use super::progress::named;
use super::render::{method, method_names};
use super::{Failure, LimitArguments, RayArguments, files};
use crate::algorithms::stage::Stage;
use crate::render::{Method, RayCounts, render_counted};
use crate::scene::{Needs, Part};
use serde_json::{Value as Json, json};
use std::io::Write;
use std::num::NonZeroUsize;
use std::path::PathBuf;
use std::time::Duration;
use web_time::Instant;

/// The picture on which the saving is measured, and how often each way.
const SIZE: [u32; 2] = [160, 120];
const RUNS: usize = 5;

#[derive(clap::Args)]
pub struct Arguments {
    /// A scene file
    scene: PathBuf,
    /// For which way to draw it: ray-tracing unless given
    #[arg(long, value_parser = method_names(), value_name = "METHOD")]
    method: Option<String>,
    #[command(flatten)]
    rays: RayArguments,
    #[command(flatten)]
    limits: LimitArguments,
}

pub fn run(arguments: Arguments) -> Result<(), Failure> {
    let method = match &arguments.method {
        Some(name) => method(name)?,
        None => Method::RayTracing,
    };
    let (scene, settings, _) = files::scene(&arguments.scene, &arguments.limits.into())?;
    let settings = arguments.rays.or(settings);
    let mut out = std::io::stdout().lock();
    writeln!(out, "{} of {}", method.name(), arguments.scene.display())?;
    if !method.follows_rays() {
        for object in &scene.objects {
            if matches!(object.shape, crate::scene::Shape::Plane { .. }) {
                writeln!(out, "  left out  object \"{}\": {INFINITE}", object.name)?;
            }
        }
        return Ok(());
    }
    let needs = Needs::of(&scene);
    for part in Part::ALL.into_iter().filter(|&part| method.does(part)) {
        let left_out: Vec<_> = needs
            .left_out
            .iter()
            .filter(|left_out| left_out.part == part)
            .collect();
        if left_out.is_empty() {
            writeln!(out, "  needed    {}", part.name())?;
        }
        for left_out in left_out {
            let share = left_out.share.map_or(String::new(), |[some, all]| {
                format!(", for {some} of {all} objects")
            });
            let (place, why) = (&left_out.place, part.why());
            writeln!(out, "  left out  {}{share}: {place}: {why}", part.name())?;
        }
    }
    if scene.camera.is_some() {
        let stage =
            files::stage(scene, SIZE, method, &arguments.scene.display())?.with_settings(settings);
        let saving = named("measuring", || Saving::measure(&stage, method));
        saving.tell(&mut out)?;
    }
    Ok(())
}

const INFINITE: &str = "an infinite plane has no polygons";

/// What was left out of a picture, for `render --stats`.
pub fn left_out(stage: &Stage, method: Method) -> Vec<Json> {
    if method.follows_rays() {
        let parts = stage
            .needs()
            .left_out
            .iter()
            .filter(|left_out| method.does(left_out.part));
        let told = |left_out: &crate::scene::LeftOut| {
            let mut told = json!({ "what": left_out.part.name(), "place": left_out.place, "why": left_out.part.why() });
            if let Some([some, all]) = left_out.share {
                told["objects"] = json!([some, all]);
            }
            told
        };
        return parts.map(told).collect();
    }
    let planes = stage.tessellation.left_out.iter();
    planes
        .map(|&object| json!({ "what": "object", "object": stage.scene.objects[object].name, "place": format!("objects[{object}]"), "why": INFINITE }))
        .collect()
}

/// The same picture with and without what the scene does not need.
struct Saving {
    /// Medians of runs in turn.
    with: Duration,
    without: Duration,
    rays_with: RayCounts,
    rays_without: RayCounts,
}

impl Saving {
    fn measure(stage: &Stage, method: Method) -> Self {
        let everything = Needs::everything(&stage.scene);
        let timed = |needs| {
            let start = Instant::now();
            let (_, rays) = render_counted(stage, method, needs, NonZeroUsize::MIN, &|_, _| {});
            (start.elapsed(), rays)
        };
        // The first run of each warms up, and counts the rays.
        let (_, rays_with) = timed(&everything);
        let (_, rays_without) = timed(stage.needs());
        let (mut with, mut without) = (Vec::new(), Vec::new());
        for _ in 0..RUNS {
            with.push(timed(&everything).0);
            without.push(timed(stage.needs()).0);
        }
        with.sort();
        without.sort();
        Saving {
            with: with[RUNS / 2],
            without: without[RUNS / 2],
            rays_with,
            rays_without,
        }
    }

    fn tell(&self, out: &mut impl Write) -> Result<(), Failure> {
        let [width, height] = SIZE;
        let milliseconds = |time: Duration| 1e3 * time.as_secs_f64();
        writeln!(
            out,
            "  measured on {width}x{height}, one thread, median of {RUNS}: {:.2} ms with everything, {:.2} ms without: {:.2} of the time",
            milliseconds(self.with),
            milliseconds(self.without),
            self.without.as_secs_f64() / self.with.as_secs_f64().max(f64::MIN_POSITIVE),
        )?;
        writeln!(
            out,
            "  shadow rays: {} with everything, {} without",
            self.rays_with.shadow, self.rays_without.shadow
        )?;
        Ok(())
    }
}
