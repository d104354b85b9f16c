//! The nearest hit, object by object or by the hierarchy: the same picture, bit for bit, in another time.

use super::{memory, scenes};
use crate::algorithms::ray_casting::RayCaster;
use crate::algorithms::visible::{BruteForce, Bvh, Search};
use crate::language::Message;
use crate::methods::Setup;
use crate::record::Unrecorded;
use crate::scene::{Object, Scene, Shape};
use crate::study::fit::Law;
use crate::study::form::{
    Axes, Curve, Operations, Reference, Request, Setting, Study, Sweep, Values,
};
use crate::study::label::Label;
use glam::DVec3;
use std::rc::Rc;

pub static STUDY: Study = Study {
    name: "search",
    title: Message("study-search"),
    about: Message("study-search-about"),
    sweeps,
};

fn sweeps(request: &Request) -> Result<Vec<Sweep>, String> {
    let size = request.either([32, 24], [80, 60]);
    let scenes: Vec<Scene> = match request.scene {
        Some(scene) => vec![scene.clone()],
        None => {
            let most = request.either(10, 16);
            (0..=most).map(|power| spheres(1 << power)).collect()
        }
    };
    let mut stages = Vec::new();
    for scene in scenes {
        let camera = scenes::camera(&scene)?;
        stages.push(Rc::new(scenes::setup(scene, &camera, size)));
    }
    Ok(vec![Sweep {
        title: Label::of("part-objects"),
        axes: Axes::TimeOverSize,
        size: Message("measure-objects"),
        quantity: Message("measure-intensity"),
        law: Law::Power,
        reference: Reference::none(),
        memory: Message("memory-objects"),
        curves: vec![
            curve("curve-brute-force", &stages, BruteForce),
            curve("curve-hierarchy", &stages, Bvh),
        ],
    }])
}

fn curve<S: Search + 'static>(key: &'static str, stages: &[Rc<Setup>], search: S) -> Curve {
    let sweep_settings = stages.iter().map(|setup| {
        let prepared = &setup.prepared;
        let objects = prepared.scene.objects.len() as u64;
        let size = [prepared.view.width, prepared.view.height];
        let pixels = u64::from(size[0]) * u64::from(size[1]);
        let bytes = prepared.primitives().bytes() + memory::frame(size);
        let setup = setup.clone();
        Setting {
            setting: Label::with("setting-objects", "count", objects),
            size: objects as f64,
            bytes,
            operations: vec![Operations {
                of: "primary_rays",
                count: pixels,
            }],
            truth: None,
            drawn: None,
            run: Box::new(move || Ok(Values::Numbers(cast(&setup, search)))),
        }
    });
    Curve {
        name: Label::of(key),
        sweep_settings: sweep_settings.collect(),
    }
}

/// The picture by ray casting.
fn cast(setup: &Setup, search: impl Search) -> Vec<f64> {
    let prepared = &setup.prepared;
    let caster = RayCaster::new(prepared, setup.settings.get(), setup.needs(), search);
    let pixels =
        (0..prepared.view.height).flat_map(|y| (0..prepared.view.width).map(move |x| (x, y)));
    pixels
        .flat_map(|(x, y)| caster.pixel(x, y, &mut Unrecorded).channels())
        .collect()
}

/// So many balls in a cube that the camera looks at, a golden spiral from its middle outward.
fn spheres(count: u32) -> Scene {
    let mut scene = scenes::own(scenes::BALLS);
    let material = scene.objects[0].material;
    let radius = 1.2 / f64::from(count).cbrt();
    scene.objects = (0..count)
        .map(|i| {
            let share = (f64::from(i) + 0.5) / f64::from(count);
            let angle = f64::from(i) * std::f64::consts::PI * (3.0 - 5_f64.sqrt());
            let z = 1.0 - 2.0 * share;
            let around = (1.0 - z * z).sqrt();
            let out = 2.0 * (f64::from(i) * 0.754_877_666_246_692_7).fract().cbrt();
            let toward = DVec3::new(around * angle.cos(), around * angle.sin(), z);
            let ball = Shape::Sphere {
                center: out * toward,
                radius: 0.4 * radius,
            };
            Object::new(format!("ball {i}"), material, ball)
        })
        .collect();
    scene
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_ways_find_the_same_to_the_bit() {
        let scene = spheres(40);
        let camera = scenes::camera(&scene).unwrap();
        let setup = scenes::setup(scene, &camera, [16, 12]);
        assert_eq!(cast(&setup, BruteForce), cast(&setup, Bvh));
    }
}
