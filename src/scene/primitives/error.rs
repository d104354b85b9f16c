//! Bounds on what rounding does (Higham 2002, Accuracy and Stability of Numerical Algorithms, §3.1).

/// γ_n = n·u/(1 − n·u), u = 2⁻⁵³: n roundings in a row change a result by no more than this share of it.
pub const fn gamma(n: u32) -> f64 {
    const UNIT_ROUNDOFF: f64 = 0.5 * f64::EPSILON;
    let n = n as f64 * UNIT_ROUNDOFF;
    n / (1.0 - n)
}
