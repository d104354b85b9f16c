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

    /// Divided by the length of N_0, which must not be zero: the cosines are the same.
    pub fn unit(self) -> Self {
        let length = self.n_0.length();
        let [n_0, n_x, n_y] = [self.n_0, self.n_x, self.n_y].map(|part| part / length);
        LinearNormal { n_0, n_x, n_y }
    }

    /// `toward`·N = p_0 + p_x·x + p_y·y: its three coefficients.
    pub fn along(&self, toward: DVec3) -> [f64; 3] {
        [self.n_0, self.n_x, self.n_y].map(|part| toward.dot(part))
    }

    /// N·N = 1 + q_x·x + q_y·y + q_xx·x² + q_xy·xy + q_yy·y² of a normal whose N_0 is a unit vector: its five coefficients.
    pub fn squared(&self) -> [f64; 5] {
        let LinearNormal { n_0, n_x, n_y } = *self;
        [
            2.0 * n_x.dot(n_0),
            2.0 * n_y.dot(n_0),
            n_x.dot(n_x),
            2.0 * n_x.dot(n_y),
            n_y.dot(n_y),
        ]
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
    pub fn of_cosine(normal: &LinearNormal, toward: DVec3) -> Self {
        let unit = normal.unit();
        Quadratic::of_quotient(unit.along(toward), unit.squared())
    }

    /// The Taylor series of (p_0 + p_x·x + p_y·y)/√(1 + q_x·x + q_y·y + q_xx·x² + q_xy·xy + q_yy·y²): its derivatives at (0, 0) are
    /// those of the paper, where the coefficients are c, a, b and g, h, d, e, f.
    pub fn of_quotient([p_0, p_x, p_y]: [f64; 3], [q_x, q_y, q_xx, q_xy, q_yy]: [f64; 5]) -> Self {
        Quadratic([
            p_0,
            p_y - p_0 * q_y / 2.0,
            p_x - p_0 * q_x / 2.0,
            (3.0 * p_0 * q_y * q_y - 4.0 * p_0 * q_yy - 4.0 * p_y * q_y) / 8.0,
            (3.0 * p_0 * q_x * q_y - 2.0 * p_0 * q_xy - 2.0 * p_y * q_x - 2.0 * p_x * q_y) / 4.0,
            (3.0 * p_0 * q_x * q_x - 4.0 * p_0 * q_xx - 4.0 * p_x * q_x) / 8.0,
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
