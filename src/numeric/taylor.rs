//! The cosine between a direction and a normal that is linear on the screen, as a polynomial of second order
//! (Bishop & Weimer, "Fast Phong Shading", SIGGRAPH 1986).

use super::Differences;
use glam::DVec3;

/// T_5·x² + T_4·xy + T_3·y² + T_2·x + T_1·y + T_0, x and y counted from the point of expansion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quadratic(pub [f64; 6]);

/// N(x, y) = N_0 + N_x·x + N_y·y, with N_0 at the point of expansion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LinearNormal {
    pub n_0: DVec3,
    pub n_x: DVec3,
    pub n_y: DVec3,
}

impl LinearNormal {
    pub fn at(&self, x: f64, y: f64) -> DVec3 {
        self.n_0 + self.n_x * x + self.n_y * y
    }

    /// The normal that points the other way everywhere.
    pub fn reversed(self) -> Self {
        LinearNormal {
            n_0: -self.n_0,
            n_x: -self.n_x,
            n_y: -self.n_y,
        }
    }
}

impl Quadratic {
    /// The Taylor series of `toward`·N/|N|, the cosine between N and a unit vector. N_0 must not be zero.
    ///
    /// With `toward`·N = ax + by + c and N·N = dx² + exy + fy² + gx + hy + i, the derivatives of their quotient
    /// (ax + by + c)/√(dx² + exy + fy² + gx + hy + i) at (0, 0) are those of the paper.
    pub fn of_cosine(normal: &LinearNormal, toward: DVec3) -> Self {
        // A normal of unit length at (0, 0) has the same cosine, and makes i = 1.
        let length = normal.n_0.length();
        let [n_0, n_x, n_y] = [normal.n_0, normal.n_x, normal.n_y].map(|part| part / length);
        let (a, b, c) = (toward.dot(n_x), toward.dot(n_y), toward.dot(n_0));
        let (d, e, f) = (n_x.dot(n_x), 2.0 * n_x.dot(n_y), n_y.dot(n_y));
        let (g, h) = (2.0 * n_x.dot(n_0), 2.0 * n_y.dot(n_0));
        Quadratic([
            c,
            b - c * h / 2.0,
            a - c * g / 2.0,
            (3.0 * c * h * h - 4.0 * c * f - 4.0 * b * h) / 8.0,
            (3.0 * c * g * h - 2.0 * c * e - 2.0 * b * g - 2.0 * a * h) / 4.0,
            (3.0 * c * g * g - 4.0 * c * d - 4.0 * a * g) / 8.0,
        ])
    }

    /// The same everywhere.
    pub fn constant(value: f64) -> Self {
        Quadratic([value, 0.0, 0.0, 0.0, 0.0, 0.0])
    }

    /// The product of two series, again up to second order.
    pub fn product(self, other: Self) -> Self {
        let (Quadratic(s), Quadratic(t)) = (self, other);
        Quadratic([
            s[0] * t[0],
            s[0] * t[1] + s[1] * t[0],
            s[0] * t[2] + s[2] * t[0],
            s[0] * t[3] + s[1] * t[1] + s[3] * t[0],
            s[0] * t[4] + s[1] * t[2] + s[2] * t[1] + s[4] * t[0],
            s[0] * t[5] + s[2] * t[2] + s[5] * t[0],
        ])
    }

    /// `scale` times the polynomial, plus `constant`.
    pub fn scaled(self, scale: f64, constant: f64) -> Self {
        let mut terms = self.0.map(|term| scale * term);
        terms[0] += constant;
        Quadratic(terms)
    }

    /// The direct form.
    pub fn at(&self, x: f64, y: f64) -> f64 {
        let [t_0, t_1, t_2, t_3, t_4, t_5] = self.0;
        (t_5 * x + t_4 * y + t_2) * x + (t_3 * y + t_1) * y + t_0
    }

    /// The incremental form, from (x, y) in steps of one along x: s to the right of it the value is c_0 + c_1·s + c_2·s².
    pub fn differences(&self, x: f64, y: f64) -> Differences<f64> {
        let [_, _, t_2, _, t_4, t_5] = self.0;
        let (c_0, c_1, c_2) = (self.at(x, y), 2.0 * t_5 * x + t_4 * y + t_2, t_5);
        Differences {
            value: c_0,
            first: c_1 + c_2,
            second: 2.0 * c_2,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn normal() -> LinearNormal {
        LinearNormal {
            n_0: DVec3::new(0.3, -0.5, 0.9),
            n_x: DVec3::new(0.02, 0.05, -0.03),
            n_y: DVec3::new(-0.04, 0.01, 0.02),
        }
    }

    #[test]
    fn the_series_leaves_an_error_of_third_order() {
        let toward = DVec3::new(-0.48, 0.6, 0.64);
        let normal = normal();
        let series = Quadratic::of_cosine(&normal, toward);
        let cosine = |x: f64, y: f64| normal.at(x, y).normalize().dot(toward);
        for (x, y) in [(1.0, 0.0), (0.0, 1.0), (0.6, -0.8), (-0.8, -0.6)] {
            let error = |scale: f64| {
                let (x, y) = (scale * x, scale * y);
                (series.at(x, y) - cosine(x, y)).abs()
            };
            // Half the distance, an eighth of the error
            let ratio = error(0.02) / error(0.01);
            assert!((ratio - 8.0).abs() < 0.05, "({x}, {y}): {ratio}");
        }
    }

    #[test]
    fn the_product_of_two_series_is_the_series_of_the_product() {
        let normal = normal();
        let (l, v) = (DVec3::new(0.48, 0.6, 0.64), DVec3::new(0.0, -0.28, 0.96));
        // R·V of the mirrored direction R = 2(N·L)N − L
        let series = Quadratic::of_cosine(&normal, l)
            .product(Quadratic::of_cosine(&normal, v))
            .scaled(2.0, -l.dot(v));
        let error = |scale: f64| {
            let n = normal.at(0.6 * scale, -0.8 * scale).normalize();
            let exact = (2.0 * n.dot(l) * n - l).dot(v);
            (series.at(0.6 * scale, -0.8 * scale) - exact).abs()
        };
        let ratio = error(0.02) / error(0.01);
        assert!((ratio - 8.0).abs() < 0.05, "{ratio}");
    }

    #[test]
    fn differences_meet_the_polynomial() {
        let polynomial = Quadratic([0.7, -0.02, 0.03, 1e-3, -2e-3, 5e-4]);
        let mut running = polynomial.differences(-7.5, 3.25);
        for step in 0..16 {
            let direct = polynomial.at(f64::from(step) - 7.5, 3.25);
            assert!((running.value - direct).abs() < 1e-15, "step {step}");
            running.advance();
        }
    }
}
