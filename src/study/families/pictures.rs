//! Pictures by ray methods, as the rungs of several studies draw them.

use super::memory;
use crate::algorithms::prepared_scene::PreparedScene;
use crate::algorithms::primary;
use crate::color::Rgb;
use crate::language::Message;
use crate::methods::{Method, Setup};
use crate::render::{RayCounts, render, render_counted};
use crate::scene::Scene;
use crate::study::form::{Drawn, Operations, Setting, Values};
use crate::study::label::Label;
use std::num::{NonZeroU32, NonZeroUsize};
use std::sync::Arc;

/// How far ray methods go. Both must be positive.
pub fn settings(depth: u32, samples: u32) -> primary::Settings {
    let positive = |n: u32| NonZeroU32::new(n).unwrap_or(NonZeroU32::MIN);
    primary::Settings {
        depth: positive(depth),
        samples: positive(samples),
    }
}

/// The picture, its channels in a row.
pub fn picture(
    prepared: &Arc<PreparedScene>,
    method: Method,
    settings: primary::Settings,
) -> Vec<f64> {
    let setup = Setup::new(prepared.clone(), settings);
    let frame = render(&setup, method, NonZeroUsize::MIN, &|_, _| ());
    Values::Picture(frame).numbers()
}

/// A setting that draws a whole picture on one thread. Its rays are counted at once.
pub fn sweep_setting(
    setting: Label,
    size: f64,
    prepared: &Arc<PreparedScene>,
    method: Method,
    settings: primary::Settings,
) -> Setting {
    let view = &prepared.view;
    let scene = match method.follows_rays() {
        true => prepared.primitives().bytes(),
        false => 0,
    };
    let bytes = memory::frame([view.width, view.height]) + memory::polygons(prepared) + scene;
    let setup = Arc::new(Setup::new(prepared.clone(), settings));
    Setting {
        setting,
        size,
        bytes,
        operations: operations(&setup, method),
        truth: None,
        drawn: Some(Drawn {
            setup: setup.clone(),
            method,
        }),
        run: Box::new(move || {
            let frame = render(&setup, method, NonZeroUsize::MIN, &|_, _| ());
            Ok(Values::Picture(frame))
        }),
    }
}

/// Rays by kind, or the polygons of a method that follows none.
fn operations(setup: &Setup, method: Method) -> Vec<Operations> {
    let PreparedScene {
        view, tessellation, ..
    } = &*setup.prepared;
    let mut recorded = vec![("pixels", u64::from(view.width) * u64::from(view.height))];
    if method.follows_rays() {
        let one = NonZeroUsize::MIN;
        let (_, rays) = render_counted(setup, method, setup.needs(), one, &|_, _| ());
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
        // The timed runs find what the scene needs already known.
        setup.needs();
        recorded.push(("polygons", tessellation.polygon_count() as u64));
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
pub const MEMORY: Message = Message("memory-pictures");
