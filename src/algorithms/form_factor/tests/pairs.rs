//! Random pairs of convex polygons in every position that is hard, against an adaptive sum of exact elements.

use super::*;
use crate::numeric;
use glam::DMat3;
use std::f64::consts::TAU;

struct Random(numeric::Random);

impl Random {
    fn new(seed: u64) -> Self {
        Random(numeric::Random(seed))
    }

    fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * 0.5 * (self.0.number() + 1.0)
    }

    fn of_any_size(&mut self, low: f64, high: f64) -> f64 {
        self.within(low.ln(), high.ln()).exp()
    }

    fn point(&mut self) -> DVec3 {
        DVec3::from_array([(); 3].map(|()| self.within(-1.0, 1.0)))
    }

    /// Three to six corners on an ellipse whose axes are 1 : `thinnest` at least.
    fn polygon(&mut self, thinnest: f64) -> Vec<DVec3> {
        let count = self.within(3.0, 7.0) as usize;
        let squeeze = self.of_any_size(thinnest, 1.0);
        let (a, b) = self.point().normalize().any_orthonormal_pair();
        (0..count)
            .map(|k| {
                let angle = (k as f64 + self.within(0.1, 0.9)) * TAU / count as f64;
                angle.cos() * a + squeeze * angle.sin() * b
            })
            .collect()
    }

    /// A triangle or quadrilateral in the half plane of X and `up`, with an edge on X from `start` to `end`.
    fn on_edge(&mut self, up: DVec3, start: f64, end: f64) -> Vec<DVec3> {
        let height = self.of_any_size(1e-3, 3.0);
        let middle = 0.5 * (start + end);
        let mut corners = vec![start * DVec3::X, end * DVec3::X];
        corners.push(self.within(middle, end + 1.0) * DVec3::X + height * up);
        if self.within(0.0, 1.0) < 0.5 {
            corners.push(self.within(start - 1.0, middle) * DVec3::X + height * up);
        }
        corners
    }
}

/// A name, and a pair of polygons in that position.
type Position = (&'static str, fn(&mut Random) -> [Vec<DVec3>; 2]);

const POSITIONS: [Position; 9] = [
    ("a common edge", |r| hinged(r, [0.0, 1.0])),
    ("edges on one line that overlap", |r| {
        let start = r.within(-1.0, 0.9);
        let end = r.within(1.0, 2.0);
        hinged(r, [start, end])
    }),
    ("edges on one line, end to end", |r| hinged(r, [1.0, 2.0])),
    ("nearly parallel", |r| {
        let i = r.polygon(0.2);
        let normal = polygon(&i).normal;
        let (axis, across) = normal.any_orthonormal_pair();
        let tilt = DMat3::from_axis_angle(axis, r.of_any_size(1e-9, 1e-6));
        let shift = r.of_any_size(1e-3, 10.0) * normal + r.within(-1.0, 1.0) * across;
        let j = i.iter().rev().map(|&p| tilt * p + shift).collect();
        [i, j]
    }),
    ("a common corner", |r| {
        let i = r.polygon(1e-3);
        let shift = i[0];
        moved_to(r, i, shift, 1.0)
    }),
    ("a corner on an edge", |r| {
        let i = r.polygon(1e-3);
        let shift = 0.3 * i[0] + 0.7 * i[1];
        moved_to(r, i, shift, 1.0)
    }),
    ("anywhere, also through each other", |r| {
        let i = r.polygon(1e-6);
        let shift = r.point();
        moved_to(r, i, shift, 1.0)
    }),
    ("very unequal, touching", |r| {
        let i = r.polygon(0.1);
        let size = r.of_any_size(1e-4, 1.0);
        let shift = i[0];
        moved_to(r, i, shift, size)
    }),
    ("far", |r| {
        let i = r.polygon(0.1);
        let shift = r.of_any_size(1.0, 1e6) * r.point();
        moved_to(r, i, shift, 1.0)
    }),
];

/// Two polygons on both sides of the x axis, folded by 1° to 179°.
fn hinged(r: &mut Random, [start, end]: [f64; 2]) -> [Vec<DVec3>; 2] {
    let degrees = match r.within(0.0, 3.0) as u32 {
        0 => r.within(1.0, 179.0),
        1 => r.of_any_size(1.0, 10.0),
        _ => 180.0 - r.of_any_size(1.0, 10.0),
    };
    let (sin, cos) = degrees.to_radians().sin_cos();
    let i = r.on_edge(DVec3::Y, 0.0, 1.0);
    let mut j = r.on_edge(cos * DVec3::Y + sin * DVec3::Z, start, end);
    j.reverse();
    [i, j]
}

/// `i` and another polygon of a size whose first corner is at `place`.
fn moved_to(r: &mut Random, i: Vec<DVec3>, place: DVec3, size: f64) -> [Vec<DVec3>; 2] {
    let j = r.polygon(0.1);
    let first = j[0];
    let j = j.iter().map(|&p| place + size * (p - first)).collect();
    [i, j]
}

#[test]
fn pairs_in_every_position_are_exact_to_the_tolerance() {
    let trials = std::env::var("TRIALS").map_or(6, |trials| trials.parse().unwrap());
    let random = &mut Random::new(77);
    for (name, position) in POSITIONS {
        let mut worst = [0.0_f64; 2];
        let mut seen = 0;
        for trial in 0..trials {
            let turn = DMat3::from_rotation_x(random.within(0.0, TAU))
                * DMat3::from_rotation_z(random.within(0.0, TAU));
            let [i, j] = position(random).map(|corners| {
                let turned = corners.iter().map(|&corner| turn * corner);
                turned.collect::<Vec<DVec3>>()
            });
            let Some([i, j]) = facing(polygon(&i), polygon(&j)) else {
                continue;
            };
            // One of the two sees the other evenly enough to be trusted: what the two orders agree on.
            let none = &mut Unrecorded;
            let reference = element_to_polygon::adaptive_exchange(&i, &j, 1e-7, &mut 0, none);
            let other = element_to_polygon::adaptive_exchange(&j, &i, 1e-7, &mut 0, none);
            if (reference / other - 1.0).abs() > 1e-6 {
                continue;
            }
            seen += 1;
            for (worst, tolerance) in worst.iter_mut().zip([1e-3, 1e-6]) {
                let found = auto::exchange(&i, &j, tolerance, &mut 0, none);
                let error = (found / other - 1.0).abs();
                *worst = worst.max(error);
                // The reference itself is no better than some 1e-6.
                assert!(
                    error < tolerance + 1e-6,
                    "{name}, trial {trial}, {tolerance:e}: {found:e} for {other:e}, off by {error:e}"
                );
            }
        }
        println!("{name}: {seen} of {trials}, off by {worst:?} at 1e-3 and 1e-6");
        assert!(10 * seen >= trials, "{name}: {seen} of {trials}");
    }
}

#[test]
fn what_is_recorded_is_what_ran() {
    use crate::record::{Recording, RecordingLimit};
    let random = &mut Random::new(5);
    for (_, position) in POSITIONS {
        let [i, j] = position(random);
        let Some([i, j]) = facing(polygon(&i), polygon(&j)) else {
            continue;
        };
        let mut recording = Recording::new(RecordingLimit::default());
        let recorded = auto::exchange(&i, &j, 1e-6, &mut 0, &mut recording);
        assert_eq!(
            recorded,
            auto::exchange(&i, &j, 1e-6, &mut 0, &mut Unrecorded)
        );
        assert!(!recording.is_empty());
    }
}
