//! Incremental against direct interpolation: a ramp from 0 to 1 in more and more steps, in f32 and in f64.

use crate::language::Message;
use crate::numeric::{Linear, Ramp, interpolate};
use crate::study::fit::Law;
use crate::study::form::{
    Axes, Curve, Operations, Reference, Request, Setting, Study, Sweep, Values,
};
use crate::study::label::Label;

pub static STUDY: Study = Study {
    name: "interpolation",
    title: Message("study-interpolation"),
    about: Message("study-interpolation-about"),
    sweeps,
};

/// A number of 32 bits that is interpolated.
#[derive(Clone, Copy)]
struct Single(f32);

impl Linear for Single {
    fn plus(self, other: Self) -> Self {
        Single(self.0 + other.0)
    }

    fn minus(self, other: Self) -> Self {
        Single(self.0 - other.0)
    }

    /// Weights are rounded to 32 bits too.
    fn times(self, factor: f64) -> Self {
        Single(self.0 * factor as f32)
    }
}

/// The values of the ramp at steps 1, 2, … of so many.
type Way = fn(u32) -> Vec<f64>;

const WAYS: [(&str, Way); 4] = [
    ("curve-incremental-f32", |steps| {
        incremental(Single(0.0), Single(1.0), steps, |a| a.0.into())
    }),
    ("curve-direct-f32", |steps| {
        direct(Single(0.0), Single(1.0), steps, |a| a.0.into())
    }),
    ("curve-incremental-f64", |steps| {
        incremental(0.0, 1.0, steps, |a| a)
    }),
    ("curve-direct-f64", |steps| direct(0.0, 1.0, steps, |a| a)),
];

fn incremental<A: Linear>(zero: A, one: A, steps: u32, number: fn(A) -> f64) -> Vec<f64> {
    let mut ramp = Ramp::start(zero, 0.0, one, f64::from(steps), 0.0);
    let step = |_| {
        ramp.advance();
        number(ramp.value)
    };
    (0..steps).map(step).collect()
}

fn direct<A: Linear>(zero: A, one: A, steps: u32, number: fn(A) -> f64) -> Vec<f64> {
    let at = |i: u32| interpolate(zero, 0.0, one, f64::from(steps), f64::from(i));
    (1..=steps).map(|i| number(at(i))).collect()
}

fn sweeps(request: &Request) -> Result<Vec<Sweep>, String> {
    if request.scene.is_some() {
        return Err("it is about a formula, whatever the scene".into());
    }
    let powers = request.either(1..=5, 1..=6);
    let sizes: Vec<u32> = powers.map(|power| 10_u32.pow(power)).collect();
    let curves = WAYS.map(|(key, way)| Curve {
        name: Label::of(key),
        sweep_settings: sizes
            .iter()
            .map(|&steps| sweep_setting(steps, way))
            .collect(),
    });
    Ok(vec![Sweep {
        title: Label::of("part-steps"),
        axes: Axes::ErrorOverSize,
        size: Message("measure-steps"),
        quantity: Message("measure-the-values-from-0-to-1"),
        law: Law::Power,
        reference: Reference {
            what: Label::of("reference-rounded-once"),
            error: 0.5 * f64::EPSILON,
            known_by: Label::of("reference-half-a-unit"),
        },
        memory: Message("memory-ramp"),
        curves: curves.into(),
    }])
}

fn sweep_setting(steps: u32, way: Way) -> Setting {
    let right = (1..=steps).map(|i| f64::from(i) / f64::from(steps));
    Setting {
        setting: Label::with("setting-steps", "count", steps),
        size: steps.into(),
        bytes: u64::from(steps) * size_of::<f64>() as u64,
        operations: vec![Operations {
            of: "steps",
            count: steps.into(),
        }],
        truth: Some(right.collect()),
        drawn: None,
        run: Box::new(move || Ok(Values::Numbers(way(steps)))),
    }
}
