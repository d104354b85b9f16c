//! Refraction by Snell's law as a vector (Whitted 1980, §2; Heckbert & Hanrahan 1984, "Beam tracing polygonal objects", appendix).

use num_traits::Float;

/// cos²θ_r = 1 − η²(1 − cos²θ_i), η = η_i/η_r; negative where nothing passes. So written that η = 1 passes straight through, however
/// flat the angle.
pub fn refraction_radicand<F: Float>(eta: F, cos_i: F) -> F {
    (F::one() - eta) * (F::one() + eta) + (eta * cos_i) * (eta * cos_i)
}

/// T = ηu − (cosθ_r − η cosθ_i)N, of unit length but for rounding; `cos_i` = −u·N is not negative, nor is `radicand` = cos²θ_r.
pub fn refracted<F: Float>(u: [F; 3], n: [F; 3], eta: F, cos_i: F, radicand: F) -> [F; 3] {
    let along_n = radicand.sqrt() - eta * cos_i;
    std::array::from_fn(|axis| eta * u[axis] - along_n * n[axis])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sines_are_in_the_ratio_of_the_indices() {
        for degrees in [0.0_f64, 10.0, 45.0, 80.0] {
            let (sin, cos) = degrees.to_radians().sin_cos();
            let eta = 1.0 / 1.5;
            let radicand = refraction_radicand(eta, cos);
            let t = refracted([sin, 0.0, cos], [0.0, 0.0, -1.0], eta, cos, radicand);
            assert!((t[0] - sin / 1.5).abs() < 1e-15);
            assert!((t[0].hypot(t[2]) - 1.0).abs() < 1e-15);
        }
        // From glass, beyond 41.8°, nothing passes.
        assert!(refraction_radicand(1.5, 40.0_f64.to_radians().cos()) > 0.0);
        assert!(refraction_radicand(1.5, 42.0_f64.to_radians().cos()) < 0.0);
    }
}
