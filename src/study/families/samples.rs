//! Ray methods by samples a pixel: how quickly the mean over n×n rays comes to the light that the whole pixel receives.

use super::pictures::{self, MEMORY, picture, settings};
use super::scenes;
use crate::language::Message;
use crate::render::Method;
use crate::scene::Scene;
use crate::study::errors::Errors;
use crate::study::fit::Law;
use crate::study::form::{Axes, Curve, Reference, Request, Study, Sweep};
use crate::study::label::Label;
use std::rc::Rc;
use std::sync::Arc;

pub static STUDY: Study = Study {
    name: "ray-samples",
    title: Message("study-ray-samples"),
    about: Message("study-ray-samples-about"),
    sweeps,
};

const DEPTH: u32 = 3;
const METHODS: [Method; 2] = [Method::RayCasting, Method::RayTracing];

fn sweeps(request: &Request) -> Result<Vec<Sweep>, String> {
    let scene = request
        .scene
        .map_or_else(|| scenes::own(scenes::BALLS), Scene::clone);
    let camera = scenes::camera(&scene)?;
    let size = request.either([32, 24], [120, 90]);
    let (sides, finest): (&[u32], u32) =
        request.either((&[1, 2, 3, 4, 6, 8], 32), (&[1, 2, 3, 4, 6, 8, 12, 16], 64));
    let prepared = Arc::new(scenes::prepared(scene, &camera, size));
    let sweep = |method: Method| {
        let truth: Rc<[f64]> = picture(&prepared, method, settings(DEPTH, finest)).into();
        let half = picture(&prepared, method, settings(DEPTH, finest / 2));
        let change = Errors::of(&half, &truth);
        let sweep_settings = sides.iter().map(|&n| {
            let setting = Label::Plain(format!("{n}×{n}"));
            pictures::sweep_setting(setting, n.into(), &prepared, method, settings(DEPTH, n))
        });
        Sweep {
            title: Label::Method(method),
            axes: Axes::ErrorOverTime,
            size: Message("measure-rays-along-a-pixel-s-side"),
            quantity: Message("measure-intensity"),
            law: Law::Power,
            reference: Reference {
                what: Label::with("reference-samples", "finest", finest),
                error: change.map_or(0.0, |change| change.rms),
                known_by: Label::of("reference-half-as-many"),
            },
            memory: MEMORY,
            curves: vec![Curve::against(
                &truth,
                Label::Method(method),
                sweep_settings.collect(),
            )],
        }
    };
    Ok(METHODS.map(sweep).into())
}
