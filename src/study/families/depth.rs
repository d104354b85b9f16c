//! Ray tracing by depth: what is lost where rays end at a level.
//!
//! The tracer has no adaptive cut: a ray ends at the depth, or where a surface sends none on. What `path_attenuation` does is to
//! weaken the light of far secondary rays, so that the same depth leaves a smaller error: a ladder an attenuation, each against
//! the deepest picture of its own.

use super::pictures::{self, MEMORY, picture, sends_rays_on, settings};
use super::scenes;
use crate::algorithms::prepared_scene::PreparedScene;
use crate::algorithms::primary::Settings;
use crate::language::Message;
use crate::render::Method;
use crate::scene::Scene;
use crate::study::errors::Errors;
use crate::study::fit::Law;
use crate::study::form::{Axes, Curve, Reference, Request, Study, Sweep};
use crate::study::label::Label;
use std::rc::Rc;
use std::sync::Arc;
use web_time::Instant;

pub static STUDY: Study = Study {
    name: "ray-depth",
    title: Message("study-ray-depth"),
    about: Message("study-ray-depth-about"),
    sweeps,
};

const DEPTHS: [u32; 15] = [
    1,
    2,
    3,
    4,
    5,
    6,
    8,
    10,
    12,
    16,
    20,
    28,
    36,
    48,
    Settings::DEEPEST,
];

fn sweeps(request: &Request) -> Result<Vec<Sweep>, String> {
    let attenuations = match request.scene {
        Some(scene) => vec![scene.path_attenuation],
        None => vec![[1.0, 0.0, 0.0], [1.0, 0.1, 0.0], [1.0, 0.5, 0.0]],
    };
    let size = request.either([64, 48], [240, 180]);
    let longest = request.either(0.08, 1.0);
    let sweep = |attenuation| {
        let scene = Scene {
            path_attenuation: attenuation,
            ..request
                .scene
                .map_or_else(|| scenes::own(scenes::MIRRORS), Scene::clone)
        };
        let camera = scenes::camera(&scene)?;
        if !sends_rays_on(&scene) {
            return Err(
                "nothing in the scene reflects or transmits, so that no ray is sent on".into(),
            );
        }
        let prepared = Arc::new(scenes::prepared(scene, &camera, size));
        Ok(sweep(attenuation, &prepared, longest))
    };
    attenuations.into_iter().map(sweep).collect()
}

/// Deeper and deeper pictures, and the deepest to compare them with.
fn sweep([a0, a1, a2]: [f64; 3], prepared: &Arc<PreparedScene>, longest: f64) -> Sweep {
    let depths = affordable(prepared, longest);
    let deepest = depths.last().copied().unwrap_or(1);
    let at = |depth: u32| picture(prepared, Method::RayTracing, settings(depth, 1));
    let truth: Rc<[f64]> = at(deepest).into();
    let before = depths.len().checked_sub(2).map(|index| at(depths[index]));
    let change = before.and_then(|before| Errors::of(&before, &truth));
    let sweep_settings = depths.iter().filter(|&&depth| depth < deepest);
    let sweep_settings = sweep_settings.map(|&depth| {
        let setting = Label::with("setting-depth", "depth", depth);
        let rays = settings(depth, 1);
        pictures::sweep_setting(setting, depth.into(), prepared, Method::RayTracing, rays)
    });
    Sweep {
        title: Label::Message(
            Message("part-path-attenuation"),
            [("a0", a0), ("a1", a1), ("a2", a2)]
                .map(|(name, value)| (name, value.to_string()))
                .into(),
        ),
        axes: Axes::ErrorOverTime,
        size: Message("measure-levels"),
        quantity: Message("measure-intensity"),
        law: Law::Geometric,
        reference: Reference {
            what: Label::with("reference-levels", "deepest", deepest),
            error: change.map_or(0.0, |change| change.rms),
            known_by: Label::of("reference-last-step"),
        },
        memory: MEMORY,
        curves: vec![Curve::against(
            &truth,
            Label::Method(Method::RayTracing),
            sweep_settings.collect(),
        )],
    }
}

/// Depths as far as a picture stays quicker than `longest` seconds: rays may double from level to level. No deeper than changes
/// anything.
fn affordable(prepared: &Arc<PreparedScene>, longest: f64) -> Vec<u32> {
    let mut depths: Vec<u32> = Vec::new();
    let (mut last, mut seconds) = (Vec::new(), 0.0_f64);
    for depth in DEPTHS {
        if let [.., before] = depths[..] {
            // At the worst, every level doubles the work.
            let levels = f64::from(depth - before);
            if seconds * levels.min(16.0).exp2() > 4.0 * longest && seconds > 0.1 * longest {
                break;
            }
        }
        let start = Instant::now();
        let now = picture(prepared, Method::RayTracing, settings(depth, 1));
        seconds = start.elapsed().as_secs_f64();
        depths.push(depth);
        if now == last || seconds > longest {
            break;
        }
        last = now;
    }
    depths
}
