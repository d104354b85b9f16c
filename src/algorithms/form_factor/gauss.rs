//! Gauss–Legendre quadrature on [0, 1].

use std::f64::consts::PI;
use std::sync::LazyLock;

/// The largest number of points that [`gauss`] knows.
pub const MOST_POINTS: usize = 24;

static RULES: LazyLock<Vec<Vec<[f64; 2]>>> =
    LazyLock::new(|| (0..=MOST_POINTS).map(legendre).collect());

/// The n points and weights, n ≤ [`MOST_POINTS`]. Exact for polynomials of degree 2n − 1.
pub fn gauss(n: usize) -> &'static [[f64; 2]] {
    &RULES[n.min(MOST_POINTS)]
}

/// Roots of the Legendre polynomial by Newton's method from the estimate of Tricomi (Abramowitz & Stegun 1964, 22.16.6).
fn legendre(n: usize) -> Vec<[f64; 2]> {
    let degree = n as f64;
    (0..n)
        .map(|i| {
            let mut x = -((4.0 * (i as f64) + 3.0) / (4.0 * degree + 2.0) * PI).cos();
            let mut slope = 1.0;
            for _ in 0..8 {
                let (mut before, mut value) = (1.0, x);
                for k in 2..=n {
                    let k = k as f64;
                    (before, value) = (
                        value,
                        ((2.0 * k - 1.0) * x * value - (k - 1.0) * before) / k,
                    );
                }
                slope = degree * (before - x * value) / (1.0 - x * x);
                x -= value / slope;
            }
            [0.5 * (1.0 + x), 1.0 / ((1.0 - x * x) * slope * slope)]
        })
        .collect()
}

/// How many points an integrand needs whose nearest singularity lies on the ellipse with foci at the ends of the interval and
/// semi-axes that sum to `sigma`, for an error of `share` of the integrand's size: it falls like σ^(−2n)
/// (Trefethen 2013, Approximation Theory and Approximation Practice, theorem 19.3).
pub fn points_needed(sigma: f64, share: f64) -> f64 {
    if share >= 1.0 {
        return 1.0;
    }
    (-share.ln() / (2.0 * sigma.ln())).ceil().max(1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn n_points_are_exact_to_degree_2n_minus_1() {
        for n in 1..=MOST_POINTS {
            for degree in 0..2 * n {
                let sum: f64 = gauss(n)
                    .iter()
                    .map(|&[x, weight]| weight * x.powi(degree as i32))
                    .sum();
                assert!(
                    (sum * (degree + 1) as f64 - 1.0).abs() < 1e-13,
                    "{n} {degree} {sum}"
                );
            }
        }
    }
}
