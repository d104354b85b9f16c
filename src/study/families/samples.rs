//! Ray methods by samples a pixel: how quickly the mean over n×n rays comes to the light that the whole pixel receives.

use super::pictures::{self, MEMORY, picture, settings};
use super::scenes;
use crate::render::Method;
use crate::scene::Scene;
use crate::study::errors::Errors;
use crate::study::fit::Law;
use crate::study::form::{Axes, Curve, Ladder, Reference, Request, Study};
use std::cell::RefCell;
use std::rc::Rc;

pub static STUDY: Study = Study {
    name: "ray-samples",
    title: "Ray methods by samples a pixel",
    about: "How many rays a pixel are enough against jagged edges?",
    ladders,
};

const DEPTH: u32 = 3;
const METHODS: [Method; 2] = [Method::RayCasting, Method::RayTracing];

fn ladders(request: &Request) -> Result<Vec<Ladder>, String> {
    let scene = request
        .scene
        .map_or_else(|| scenes::own(scenes::BALLS), Scene::clone);
    let camera = scenes::camera(&scene)?;
    let size = request.either([48, 36], [160, 120]);
    let (sides, finest): (&[u32], u32) =
        request.either((&[1, 2, 3, 4, 6, 8], 24), (&[1, 2, 3, 4, 6, 8, 12, 16], 48));
    let stage = Rc::new(RefCell::new(scenes::stage(scene, &camera, size)));
    let mut own_error = 0.0_f64;
    let curves = METHODS.map(|method| {
        let truth: Rc<[f64]> = picture(&stage, method, settings(DEPTH, finest)).into();
        let half = picture(&stage, method, settings(DEPTH, finest / 2));
        let change = Errors::of(&half, &truth).map_or(0.0, |errors| errors.rms);
        own_error = own_error.max(change);
        let rungs = sides.iter().map(|&n| {
            let setting = format!("{n}×{n}");
            pictures::rung(setting, n.into(), &stage, method, settings(DEPTH, n))
        });
        Curve::against(&truth, method.name(), rungs.collect())
    });
    Ok(vec![Ladder {
        title: "Rays a pixel".into(),
        axes: Axes::ErrorOverTime,
        size: "rays along a pixel's side",
        quantity: "intensity",
        law: Law::Power,
        reference: Reference {
            what: format!("the same picture with {finest}×{finest} rays a pixel, to depth {DEPTH}"),
            error: own_error,
            known_by: "how far it is from half as many along each side, an upper bound".into(),
        },
        memory: MEMORY,
        curves: curves.into(),
    }])
}
