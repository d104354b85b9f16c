//! Straight lines through points on logarithmic axes: orders of convergence and of growth.

/// How one quantity follows another.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Law {
    /// y = c·x^p: p is the order.
    Power,
    /// y = c·q^x: q is the factor a step.
    Geometric,
}

/// A law through points, by least squares of the logarithms.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fit {
    pub law: Law,
    /// p of a power, q of a geometric sequence.
    pub rate: f64,
    /// c
    pub factor: f64,
    /// The share of the logarithms' variance that the law accounts for.
    pub r_squared: f64,
    pub points: usize,
}

impl Fit {
    /// None through fewer than three points with positive, finite coordinates, or where x does not vary.
    pub fn through(law: Law, points: impl IntoIterator<Item = (f64, f64)>) -> Option<Fit> {
        let usable = |&(x, y): &(f64, f64)| x > 0.0 && y > 0.0 && x.is_finite() && y.is_finite();
        let logarithms: Vec<(f64, f64)> = points
            .into_iter()
            .filter(usable)
            .map(|(x, y)| match law {
                Law::Power => (x.ln(), y.ln()),
                Law::Geometric => (x, y.ln()),
            })
            .collect();
        let n = logarithms.len();
        if n < 3 {
            return None;
        }
        let mean = |of: fn(&(f64, f64)) -> f64| logarithms.iter().map(of).sum::<f64>() / n as f64;
        let (mean_x, mean_y) = (mean(|p| p.0), mean(|p| p.1));
        let (mut xx, mut xy, mut yy) = (0.0, 0.0, 0.0);
        for &(x, y) in &logarithms {
            let (dx, dy) = (x - mean_x, y - mean_y);
            xx += dx * dx;
            xy += dx * dy;
            yy += dy * dy;
        }
        if xx == 0.0 {
            return None;
        }
        let slope = xy / xx;
        let r_squared = if yy == 0.0 { 1.0 } else { slope * xy / yy };
        let rate = match law {
            Law::Power => slope,
            Law::Geometric => slope.exp(),
        };
        Some(Fit {
            law,
            rate,
            factor: (mean_y - slope * mean_x).exp(),
            r_squared,
            points: n,
        })
    }

    /// Whether y hardly changes with x.
    pub fn is_level(&self) -> bool {
        match self.law {
            Law::Power => self.rate.abs() < 0.05,
            Law::Geometric => (self.rate - 1.0).abs() < 0.01,
        }
    }

    /// Whether the points lie on a line well enough to be called one.
    pub fn is_clean(&self) -> bool {
        self.r_squared >= 0.95
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_law_is_found_exactly_in_points_that_follow_it() {
        let sizes = [1.0, 2.0, 3.0, 8.0, 50.0];
        for (law, rate) in [(Law::Power, -2.5), (Law::Power, 1.0), (Law::Geometric, 0.7)] {
            let factor = 3e-4;
            let y = |x: f64| match law {
                Law::Power => factor * x.powf(rate),
                Law::Geometric => factor * rate.powf(x),
            };
            let fit = Fit::through(law, sizes.map(|x| (x, y(x)))).unwrap();
            assert!((fit.rate - rate).abs() < 1e-12, "{fit:?}");
            assert!((fit.factor / factor - 1.0).abs() < 1e-12, "{fit:?}");
            assert!((fit.r_squared - 1.0).abs() < 1e-12 && fit.is_clean());
        }
    }

    #[test]
    fn points_without_a_logarithm_are_passed_over_and_two_make_no_law() {
        let points = [
            (1.0, 1.0),
            (2.0, 0.0),
            (4.0, 16.0),
            (3.0, f64::NAN),
            (2.0, 4.0),
        ];
        let fit = Fit::through(Law::Power, points).unwrap();
        assert_eq!(fit.points, 3);
        assert!((fit.rate - 2.0).abs() < 1e-12);
        assert_eq!(Fit::through(Law::Power, [(1.0, 1.0), (2.0, 2.0)]), None);
        assert_eq!(Fit::through(Law::Power, [(2.0, 1.0); 4]), None);
    }

    #[test]
    fn scattered_points_are_not_called_a_law() {
        let points = [(1.0, 1.0), (2.0, 9.0), (4.0, 0.5), (8.0, 7.0)];
        assert!(!Fit::through(Law::Power, points).unwrap().is_clean());
    }
}
