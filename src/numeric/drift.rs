//! Incremental against direct: how far rounding carries a value that is found from the one before, step by step.

use super::{CompensatedSum, Differences, Fixed, Ramp};

/// A way to go from 0 to 1 in n equal steps: along the ramp i/n, or along the parabola (i/n)² where differences are of second order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Arithmetic {
    /// I' = I + ΔI
    F64,
    F32,
    /// The same additions with Kahan's compensation.
    F32Compensated,
    /// i/n at every step.
    F32Direct,
    /// I' = I + ΔI in 16.16 bits.
    Fixed16,
    /// I' = I + ΔI; ΔI' = ΔI + Δ²I
    SecondOrderF64,
    SecondOrderF32,
}

/// By how much the values differ from the exact ones, as magnitudes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drift {
    /// After the last step, where 1 is right.
    pub last: f64,
    /// Over all steps.
    pub largest: f64,
}

impl Arithmetic {
    pub const ALL: [Arithmetic; 7] = [
        Arithmetic::F64,
        Arithmetic::F32,
        Arithmetic::F32Compensated,
        Arithmetic::F32Direct,
        Arithmetic::Fixed16,
        Arithmetic::SecondOrderF64,
        Arithmetic::SecondOrderF32,
    ];

    pub fn name(self) -> &'static str {
        match self {
            Arithmetic::F64 => "f64",
            Arithmetic::F32 => "f32",
            Arithmetic::F32Compensated => "f32, compensated",
            Arithmetic::F32Direct => "f32, direct",
            Arithmetic::Fixed16 => "16.16 fixed point",
            Arithmetic::SecondOrderF64 => "f64, second order",
            Arithmetic::SecondOrderF32 => "f32, second order",
        }
    }

    /// Whether it goes along the parabola.
    pub fn is_second_order(self) -> bool {
        matches!(
            self,
            Arithmetic::SecondOrderF64 | Arithmetic::SecondOrderF32
        )
    }

    /// The drift over `steps` steps.
    pub fn drift(self, steps: u32) -> Drift {
        let n = f64::from(steps.max(1));
        match self {
            Arithmetic::F64 => {
                let mut ramp = Ramp {
                    value: 0.0,
                    step: 1.0 / n,
                };
                against(steps, ratio, || {
                    ramp.advance();
                    ramp.value
                })
            }
            Arithmetic::F32 => {
                let mut ramp = Ramp {
                    value: 0.0,
                    step: 1.0 / n as f32,
                };
                against(steps, ratio, || {
                    ramp.advance();
                    ramp.value.into()
                })
            }
            Arithmetic::F32Compensated => {
                let mut sum = CompensatedSum::new(0.0);
                against(steps, ratio, || {
                    sum.add(1.0 / n as f32);
                    sum.sum.into()
                })
            }
            Arithmetic::F32Direct => {
                let mut i = 0;
                against(steps, ratio, || {
                    i += 1;
                    (i as f32 / n as f32).into()
                })
            }
            Arithmetic::Fixed16 => {
                let mut ramp = Ramp {
                    value: Fixed(0),
                    step: Fixed::nearest(1.0 / n),
                };
                against(steps, ratio, || {
                    ramp.advance();
                    ramp.value.to_f64()
                })
            }
            Arithmetic::SecondOrderF64 => {
                let mut parabola = Differences {
                    value: 0.0,
                    first: 1.0 / (n * n),
                    second: 2.0 / (n * n),
                };
                against(steps, squared, || {
                    parabola.advance();
                    parabola.value
                })
            }
            Arithmetic::SecondOrderF32 => {
                let mut parabola = Differences {
                    value: 0.0,
                    first: (1.0 / (n * n)) as f32,
                    second: (2.0 / (n * n)) as f32,
                };
                against(steps, squared, || {
                    parabola.advance();
                    parabola.value.into()
                })
            }
        }
    }
}

/// What `next` gives step by step, against the exact value at each share of the way.
fn against(steps: u32, exact: fn(f64) -> f64, mut next: impl FnMut() -> f64) -> Drift {
    let mut drift = Drift {
        last: 0.0,
        largest: 0.0,
    };
    for i in 1..=steps {
        drift.last = (next() - exact(f64::from(i) / f64::from(steps))).abs();
        drift.largest = drift.largest.max(drift.last);
    }
    drift
}

fn ratio(share: f64) -> f64 {
    share
}

fn squared(share: f64) -> f64 {
    share * share
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn drift_is_as_known() {
        for (arithmetic, steps, largest) in [
            (Arithmetic::F32, 10_000, 5.4e-5),
            (Arithmetic::F32, 1_000_000, 9.5e-3),
            (Arithmetic::F32Compensated, 10_000, 5.5e-8),
            (Arithmetic::F32Compensated, 1_000_000, 3.2e-8),
            (Arithmetic::F32Direct, 10_000, 3.0e-8),
            (Arithmetic::F32Direct, 1_000_000, 3.0e-8),
            (Arithmetic::Fixed16, 10_000, 0.068),
            (Arithmetic::Fixed16, 1_000_000, 1.0),
        ] {
            let found = arithmetic.drift(steps).largest;
            let name = arithmetic.name();
            assert!(
                (found / largest - 1.0).abs() < 0.1,
                "{name} over {steps} steps: {found:e}"
            );
        }
    }

    #[test]
    fn drift_is_within_the_bounds_of_rounding() {
        for steps in [100, 1000, 10_000, 100_000, 1_000_000] {
            let n = f64::from(steps);
            let (f64_ulp, f32_ulp) = (f64::EPSILON, f64::from(f32::EPSILON));
            for (arithmetic, bound) in [
                // Half a unit in the last place of at most 1 a step, and that of the step itself
                (Arithmetic::F64, 0.5 * n * f64_ulp),
                (Arithmetic::F32, 0.5 * n * f32_ulp),
                (Arithmetic::F32Compensated, f32_ulp),
                (Arithmetic::F32Direct, 0.5 * f32_ulp),
                // The step is off by half a unit: by at most all of it
                (Arithmetic::Fixed16, (0.5 * n / 65536.0).min(1.0)),
                // The same of each value, and of each Δ ≤ 2/n, which is then added up to n times
                (Arithmetic::SecondOrderF64, 1.5 * n * f64_ulp),
                (Arithmetic::SecondOrderF32, 1.5 * n * f32_ulp),
            ] {
                let drift = arithmetic.drift(steps);
                let name = arithmetic.name();
                assert!(drift.largest <= bound, "{name}, {steps}: {drift:?}");
                assert!(drift.last <= drift.largest);
            }
        }
    }
}
