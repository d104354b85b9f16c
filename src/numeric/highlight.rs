//! The cosine of a highlight raised to the shininess: of the cosine itself, and of the chord between the two unit vectors.

use num_traits::Float;

/// max(0, cos θ)^n, as it is usually written (Phong 1975). A cosine near 1 has lost θ²/2 to rounding, and the power makes n times as
/// much of that error.
pub fn power_of_cosine<F: Float>(cosine: F, n: F) -> F {
    cosine.max(F::zero()).powf(n)
}

/// cos^n θ for θ up to a right angle, of the chord c = 2 sin(θ/2) = |N − H|: exp(n·log1p(−c²/2)), since cos θ = 1 − 2 sin²(θ/2). The
/// small angle is never taken from 1, so that nothing is lost.
pub fn power_of_chord<F: Float>(chord: F, n: F) -> F {
    let two = F::one() + F::one();
    (n * (-chord * chord / two).ln_1p()).exp()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_forms_are_the_same_power() {
        for (degrees, n) in [
            (0.0_f64, 40.0),
            (1.0, 1e4),
            (30.0, 20.0),
            (60.0, 1.0),
            (80.0, 0.5),
        ] {
            let angle = degrees.to_radians();
            let exact = angle.cos().powf(n);
            let found = power_of_chord(2.0 * (0.5 * angle).sin(), n);
            assert!(
                (found - exact).abs() <= n.max(1.0) * 1e-15 * exact,
                "{degrees}°^{n}"
            );
            assert_eq!(power_of_cosine(angle.cos(), n), exact);
        }
        assert_eq!(power_of_cosine(-0.5, 3.0), 0.0);
    }
}
