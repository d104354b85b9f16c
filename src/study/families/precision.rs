//! f32 against f64: where a ray meets a far sphere, by the textbook's roots and by the stable ones.

use crate::language::Message;
use crate::numeric::sphere_roots;
use crate::study::fit::Law;
use crate::study::form::{
    Axes, Curve, Operations, Reference, Request, Setting, Study, Sweep, Values,
};
use crate::study::label::Label;
use glam::{DVec3, Vec3};
use num_traits::Float;
use std::rc::Rc;

pub static STUDY: Study = Study {
    name: "precision",
    title: Message("study-precision"),
    about: Message("study-precision-about"),
    sweeps,
};

const RAYS: u32 = 512;

/// Rays from one distance: from the sphere's centre to the origin, and the direction; unit, as far as f32 goes.
type Rays = Rc<[(Vec3, Vec3)]>;

/// A way to the nearer t of every ray; 0 where a hit is lost, which is off by the whole distance.
type Way = fn(&Rays) -> Vec<f64>;

/// Both t of a ray (from the centre to the origin, direction) and a sphere of a radius, the smaller first.
type Roots<F> = fn([F; 3], [F; 3], F) -> Option<[F; 2]>;

const WAYS: [(&str, Way); 3] = [
    ("curve-plain-roots-f32", |rays| in_f32(rays, plain_roots)),
    ("curve-stable-roots-f32", |rays| in_f32(rays, sphere_roots)),
    ("curve-plain-roots-f64", |rays| in_f64(rays, plain_roots)),
];

fn sweeps(request: &Request) -> Result<Vec<Sweep>, String> {
    if request.scene.is_some() {
        return Err("it is about a formula, whatever the scene".into());
    }
    let farthest = request.either(5, 7);
    let bundles: Vec<(i32, Rays)> = (1..=farthest).map(|power| (power, rays(power))).collect();
    let curves = WAYS.map(|(key, way)| Curve {
        name: Label::of(key),
        sweep_settings: bundles
            .iter()
            .map(|(power, rays)| sweep_setting(*power, rays, way))
            .collect(),
    });
    Ok(vec![Sweep {
        title: Label::of("part-distances"),
        axes: Axes::ErrorOverSize,
        size: Message("measure-distance-in-radii"),
        quantity: Message("measure-t-a-share-of-the-distance"),
        law: Law::Power,
        reference: Reference {
            what: Label::of("reference-stable-roots"),
            error: f64::EPSILON,
            known_by: Label::of("reference-rounding"),
        },
        memory: Message("memory-rays"),
        curves: curves.into(),
    }])
}

fn sweep_setting(power: i32, rays: &Rays, way: Way) -> Setting {
    let shared = rays.clone();
    let distance = 10_f64.powi(power);
    let shares = move |mut hits: Vec<f64>| {
        hits.iter_mut().for_each(|t| *t /= distance);
        hits
    };
    Setting {
        setting: Label::with("setting-distance", "distance", format!("1e{power}")),
        size: distance,
        bytes: (rays.len() * size_of::<(Vec3, Vec3)>()) as u64,
        operations: vec![Operations {
            of: "rays",
            count: u64::from(RAYS),
        }],
        truth: Some(shares(in_f64(rays, sphere_roots)).into()),
        drawn: None,
        run: Box::new(move || Ok(Values::Numbers(shares(way(&shared))))),
    }
}

/// Toward points within nine tenths of the sphere's disc, from places that turn around it.
fn rays(power: i32) -> Rays {
    let distance = 10_f64.powi(power);
    let ray = |i: u32| {
        let share = (f64::from(i) + 0.5) / f64::from(RAYS);
        let angle = f64::from(i) * std::f64::consts::PI * (3.0 - 5_f64.sqrt());
        let toward = DVec3::new(angle.sin(), 0.3 + share, (0.7 * angle).cos()).normalize();
        let (u, v) = toward.any_orthonormal_pair();
        let through = 0.9 * share.sqrt() * (angle.cos() * u + angle.sin() * v);
        let origin = (-distance * toward).as_vec3();
        let direction = (through - origin.as_dvec3()).normalize().as_vec3();
        (origin, direction)
    };
    (0..RAYS).map(ray).collect()
}

fn in_f32(rays: &Rays, roots: Roots<f32>) -> Vec<f64> {
    let hit = |&(origin, direction): &(Vec3, Vec3)| {
        let found = roots(origin.to_array(), direction.to_array(), 1.0);
        found.map_or(0.0, |[t, _]| f64::from(t))
    };
    rays.iter().map(hit).collect()
}

fn in_f64(rays: &Rays, roots: Roots<f64>) -> Vec<f64> {
    let hit = |&(origin, direction): &(Vec3, Vec3)| {
        let direction = direction.as_dvec3().normalize();
        let found = roots(origin.as_dvec3().to_array(), direction.to_array(), 1.0);
        found.map_or(0.0, |[t, _]| t)
    };
    rays.iter().map(hit).collect()
}

/// b ± √(b² − c), b = −f·d, c = f·f − r²: as in textbooks.
fn plain_roots<F: Float>(from_center: [F; 3], direction: [F; 3], radius: F) -> Option<[F; 2]> {
    let dot = |a: [F; 3], b: [F; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let b = -dot(from_center, direction);
    let c = dot(from_center, from_center) - radius * radius;
    let under_root = b * b - c;
    (under_root >= F::zero()).then(|| [b - under_root.sqrt(), b + under_root.sqrt()])
}
