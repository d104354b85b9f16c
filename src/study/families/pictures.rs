//! Pictures by ray methods, as the rungs of several studies draw them.

use super::memory;
use crate::algorithms::primary::Settings;
use crate::color::Rgb;
use crate::render::{Method, RayCounts, render, render_counted};
use crate::scene::Scene;
use crate::study::form::{Drawn, Operations, Setting, Shared, Values};
use std::num::{NonZeroU32, NonZeroUsize};

/// How far ray methods go. Both must be positive.
pub fn settings(depth: u32, samples: u32) -> Settings {
    let positive = |n: u32| NonZeroU32::new(n).unwrap_or(NonZeroU32::MIN);
    Settings {
        depth: positive(depth),
        samples: positive(samples),
    }
}

/// The picture, its channels in a row.
pub fn picture(prepared: &Shared, method: Method, settings: Settings) -> Vec<f64> {
    let mut prepared = prepared.lock();
    prepared.settings = settings;
    let frame = render(&prepared, method, NonZeroUsize::MIN, &|_, _| ());
    Values::Picture(frame).numbers()
}

/// A setting that draws a whole picture on one thread. Its rays are counted at once.
pub fn sweep_setting(
    setting: String,
    size: f64,
    prepared: &Shared,
    method: Method,
    settings: Settings,
) -> Setting {
    let operations = operations(prepared, method, settings);
    let bytes = {
        let prepared = prepared.lock();
        let view = &prepared.view;
        let scene = match method.follows_rays() {
            true => prepared.primitives().bytes(),
            false => 0,
        };
        memory::frame([view.width, view.height]) + memory::polygons(&prepared) + scene
    };
    let shared = prepared.clone();
    Setting {
        setting,
        size,
        bytes,
        operations,
        truth: None,
        drawn: Some(Drawn {
            prepared: prepared.clone(),
            method,
            settings,
        }),
        run: Box::new(move || {
            let mut prepared = shared.lock();
            prepared.settings = settings;
            let frame = render(&prepared, method, NonZeroUsize::MIN, &|_, _| ());
            Ok(Values::Picture(frame))
        }),
    }
}

/// Rays by kind, or the polygons of a method that follows none.
fn operations(prepared: &Shared, method: Method, settings: Settings) -> Vec<Operations> {
    let mut prepared = prepared.lock();
    prepared.settings = settings;
    let pixels = u64::from(prepared.view.width) * u64::from(prepared.view.height);
    let mut recorded = vec![("pixels", pixels)];
    if method.follows_rays() {
        let one = NonZeroUsize::MIN;
        let (_, rays) = render_counted(&prepared, method, prepared.needs(), one, &|_, _| ());
        let RayCounts {
            primary,
            shadow,
            reflected,
            transmitted,
            total_internal_reflection,
        } = rays;
        recorded.extend([
            ("primary_rays", primary),
            ("shadow_rays", shadow),
            ("reflected_rays", reflected),
            ("transmitted_rays", transmitted),
            ("total_internal_reflections", total_internal_reflection),
        ]);
    } else {
        recorded.push(("polygons", prepared.tessellation.polygon_count() as u64));
    }
    let recorded = recorded.into_iter().filter(|(_, count)| *count > 0);
    recorded
        .map(|(of, count)| Operations { of, count })
        .collect()
}

/// Whether any ray of the scene has children.
pub fn sends_rays_on(scene: &Scene) -> bool {
    scene.objects.iter().any(|object| {
        let material = &scene.materials[object.material];
        material.reflection != Rgb::BLACK || material.transmission != Rgb::BLACK
    })
}

/// What counts as memory of these rungs.
pub const MEMORY: &str = "colour and depth of every pixel, the polygons with their vertices, and for rays the objects with their hierarchies, counted by their sizes";
