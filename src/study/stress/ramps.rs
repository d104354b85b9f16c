//! Ramps: values that are interpolated by one addition a step, and what the additions make of them.

use super::case::{Case, Measured, Ran, degrades, holds};
use crate::numeric::{Linear, Ramp, interpolate};

pub const CASES: &[Case] = &[
    Case {
        name: "ramps/1e4-additions",
        asks: "the largest error of a ramp from 0 to 1 in 10⁴ additions",
        expects: "n/10⁴ at step n; more than an ulp, less than 10⁴ of half an ulp",
        because: "each addition is rounded by half an ulp at most, and so is the step (Higham 2002, §4.2)",
        run: || ramp(10_000),
        recorded: degrades(2.3e-16, 1e4 * 1.2e-16).f32_degrades(1.2e-7, 1e4 * 6e-8),
    },
    Case {
        name: "ramps/1e6-additions",
        asks: "the largest error of a ramp from 0 to 1 in 10⁶ additions",
        expects: "n/10⁶ at step n; more than an ulp, less than 10⁶ of half an ulp",
        because: "as for 10⁴; in f32 the rounding of the step alone makes it one hundredth of the whole",
        run: || ramp(1_000_000),
        recorded: degrades(2.3e-16, 1e6 * 1.2e-16).f32_degrades(1.2e-7, 1e6 * 6e-8),
    },
    Case {
        name: "ramps/1e6-direct",
        asks: "the largest error of 10⁶ values from 0 to 1, each interpolated directly",
        expects: "n/10⁶ to an ulp of 1",
        because: "one weight, one product and one sum a value",
        run: || {
            let error = |value: &dyn Fn(f64) -> f64| {
                let n = 1e6;
                (0..=1_000_000).fold(0.0_f64, |most, i| {
                    let s = f64::from(i);
                    most.max((value(s) - s / n).abs())
                })
            };
            let double = error(&|s| interpolate(0.0, 0.0, 1.0, 1e6, s));
            let single = error(&|s| interpolate(Single(0.0), 0.0, Single(1.0), 1e6, s).0.into());
            Ok(Ran::from(Measured::absolute(double, 0.0)).and_f32(Measured::absolute(single, 0.0)))
        },
        recorded: holds(2.3e-16).f32_holds(1.2e-7),
    },
    Case {
        name: "ramps/constant",
        asks: "a ramp from 1/3 to 1/3 over 10⁶ additions",
        expects: "1/3, exactly, to the end",
        because: "the step is 0",
        run: || {
            let third = 1.0 / 3.0;
            let double = run(third, third, 1_000_000, |_, _| {});
            let third = Single(third as f32);
            let single = run(third, third, 1_000_000, |_, _| {});
            Ok(Ran::from(Measured::ulps(double, 1.0 / 3.0))
                .and_f32(Measured::ulps(single.0, third.0.into())))
        },
        recorded: holds(0.0).f32_holds(0.0),
    },
    Case {
        name: "ramps/ends",
        asks: "the ends of 2000 lines through values and places of all sizes, each interpolated directly",
        expects: "the values at the ends, exactly",
        because: "there the weights are 1 and 0",
        run: || {
            let wrong = (0..2000).filter(|&i| {
                let size = 10.0_f64.powi(i % 150 - 75);
                let (s_1, s_2) = (0.1 * f64::from(i), 0.7 * f64::from(i) + 0.3);
                let (a_1, a_2) = (size / 3.0, -1.0 / 7.0);
                let at = |s| interpolate(a_1, s_1, a_2, s_2, s);
                at(s_1) != a_1 || at(s_2) != a_2
            });
            Ok(Measured::share(wrong.count(), 2000).into())
        },
        recorded: holds(0.0),
    },
    Case {
        name: "ramps/cancelling",
        asks: "the middle of the line from 1 to −(1 − 2⁻²⁰)",
        expects: "2⁻²¹, exactly",
        because: "both halves are exact, and numbers so close are subtracted without rounding (Sterbenz 1974)",
        run: || {
            let end = -(1.0 - 2.0_f64.powi(-20));
            let middle = 2.0_f64.powi(-21);
            let double = interpolate(1.0, 0.0, end, 2.0, 1.0);
            let single = interpolate(Single(1.0), 0.0, Single(end as f32), 2.0, 1.0);
            Ok(Ran::from(Measured::ulps(double, middle))
                .and_f32(Measured::ulps(single.0, middle))
                .conditioned(2.0_f64.powi(21)))
        },
        recorded: holds(0.0).f32_holds(0.0),
    },
    Case {
        name: "ramps/1e75",
        asks: "a quarter of the way from −10⁷⁵ to 10⁷⁵",
        expects: "−5·10⁷⁴",
        because: "the weights are 1/4 and 3/4; no square is taken",
        run: || {
            let found = interpolate(-1e75, 0.0, 1e75, 4.0, 1.0);
            Ok(Measured::ulps(found, -5e74).into())
        },
        recorded: holds(1.0),
    },
];

/// A number of f32 that the generic kernels interpolate: the product with a weight is rounded once.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Single(pub f32);

impl Linear for Single {
    fn plus(self, other: Self) -> Self {
        Single(self.0 + other.0)
    }

    fn minus(self, other: Self) -> Self {
        Single(self.0 - other.0)
    }

    fn times(self, factor: f64) -> Self {
        Single((f64::from(self.0) * factor) as f32)
    }
}

/// The largest error on the way from 0 to 1 in both precisions.
fn ramp(n: u32) -> Result<Ran, String> {
    let mut worst = [0.0_f64; 2];
    let exact = |i: u32| f64::from(i) / f64::from(n);
    run(0.0, 1.0, n, |i, value: f64| {
        worst[0] = worst[0].max((value - exact(i)).abs());
    });
    run(Single(0.0), Single(1.0), n, |i, value| {
        worst[1] = worst[1].max((f64::from(value.0) - exact(i)).abs());
    });
    let [double, single] = worst.map(|error| Measured::absolute(error, 0.0));
    Ok(Ran::from(double).and_f32(single))
}

/// The last value of a ramp of `n` steps; each is shown.
fn run<A: Linear>(a_1: A, a_2: A, n: u32, mut each: impl FnMut(u32, A)) -> A {
    let mut ramp = Ramp::start(a_1, 0.0, a_2, f64::from(n), 0.0);
    for i in 0..=n {
        each(i, ramp.value);
        if i < n {
            ramp.advance();
        }
    }
    ramp.value
}
