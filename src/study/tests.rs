//! A study of which everything is known.

use super::errors::Errors;
use super::fit::Law;
use super::form::{Axes, Reference, Study, Sweep};
use super::harness::{Findings, Line, Part, Point};
use super::label::Label;
use super::timing::Timing;
use crate::language::Message;

static STUDY: Study = Study {
    name: "made-up",
    title: Message("study-growth"),
    about: Message("study-growth-about"),
    sweeps: |_| Ok(Vec::<Sweep>::new()),
};

fn point(size: f64, rms: f64, median: f64) -> Point {
    Point {
        setting: Label::Plain(format!("n = {size}")),
        size,
        errors: Some(Errors {
            rms,
            largest: 2.0 * rms,
            relative: 0.5 * rms,
        }),
        seconds: Timing {
            median,
            lower: 0.9 * median,
            upper: 1.1 * median,
            runs: 5,
        },
        bytes: 1000,
        operations: Vec::new(),
        drawn: None,
        on_front: true,
    }
}

/// Two curves: one of order 2 in linear time, one of order 6 that takes ten times as long.
pub fn findings() -> Findings {
    let curve = |name: &str, order: i32, cost: f64| {
        let points = [2.0_f64, 4.0, 8.0].map(|n| point(n, n.powi(-order), cost * n));
        Line::of(
            Label::Plain(name.into()),
            points.to_vec(),
            Law::Power,
            1e-16,
        )
    };
    let part = Part {
        title: Label::of("part-steps"),
        axes: Axes::ErrorOverTime,
        size: Message("measure-samples"),
        quantity: Message("measure-samples"),
        reference: Reference {
            what: Label::Plain("what is known".into()),
            error: 1e-16,
            known_by: Label::of("reference-rounding"),
        },
        memory: Message("memory-rays"),
        lines: vec![curve("rough", 2, 1e-3), curve("fine", 7, 1e-2)],
        failed: Vec::new(),
    };
    Findings {
        study: &STUDY,
        parts: vec![part],
    }
}
