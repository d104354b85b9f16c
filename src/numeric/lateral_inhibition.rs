//! How bright a row of intensities looks: each receptor is excited by what falls on it and inhibited by what falls around it, the
//! difference of two Gaussians (Rodieck, "Quantitative analysis of cat retinal ganglion cell response to visual stimuli", Vision
//! Research 5, 1965; for the bands, Ratliff, "Mach bands", 1965).
//!
//! r = (1 + w) G_c ∗ e − w G_s ∗ e. Both Gaussians have weight 1, so that even light and even slopes look as they are, and only where
//! the slope changes does r leave e: a dark band inside a corner that turns up, a bright one inside a corner that turns down.

/// Standard deviation of the excitation, in receptors.
pub const CENTER: f64 = 1.0;
/// Standard deviation of the inhibition, in receptors.
pub const SURROUND: f64 = 4.0;
/// w.
pub const WEIGHT: f64 = 1.0;

/// The response to `intensities`, one for each. Beyond both ends they go on as straight lines do: turned about the end.
pub fn perceived(intensities: &[f64]) -> Vec<f64> {
    let center = gaussian(CENTER);
    let surround = gaussian(SURROUND);
    (0..intensities.len())
        .map(|at| {
            let excited = weighted(intensities, at, &center);
            let inhibited = weighted(intensities, at, &surround);
            (1.0 + WEIGHT) * excited - WEIGHT * inhibited
        })
        .collect()
}

/// Weights at distance 0, 1, 2, …; those on both sides sum to 1.
fn gaussian(deviation: f64) -> Vec<f64> {
    let reach = (4.0 * deviation).ceil() as usize;
    let weights = (0..=reach).map(|d| (-0.5 * (d as f64 / deviation).powi(2)).exp());
    let weights: Vec<f64> = weights.collect();
    let sum = weights[0] + 2.0 * weights[1..].iter().sum::<f64>();
    weights.into_iter().map(|weight| weight / sum).collect()
}

fn weighted(values: &[f64], at: usize, weights: &[f64]) -> f64 {
    let beside = |distance: usize| {
        beyond(values, at, -(distance as isize)) + beyond(values, at, distance as isize)
    };
    let sides = weights.iter().enumerate().skip(1);
    weights[0] * values[at]
        + sides
            .map(|(distance, weight)| weight * beside(distance))
            .sum::<f64>()
}

/// The value so far beside `at`; past an end, the point reflection of one within.
fn beyond(values: &[f64], at: usize, by: isize) -> f64 {
    let last = values.len() as isize - 1;
    let index = at as isize + by;
    let within = |index: isize| values[index.clamp(0, last) as usize];
    if index < 0 {
        2.0 * within(0) - within(-index)
    } else if index > last {
        2.0 * within(last) - within(2 * last - index)
    } else {
        within(index)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn even_light_and_even_slopes_look_as_they_are() {
        let row: Vec<f64> = (0..60).map(|x| 0.2 + 0.01 * f64::from(x)).collect();
        for (seen, recorded) in perceived(&row).iter().zip(&row) {
            assert!((seen - recorded).abs() < 1e-14);
        }
        assert!(perceived(&[]).is_empty());
        assert!((perceived(&[0.5])[0] - 0.5).abs() < 1e-15);
    }

    /// At a corner whose slope jumps by s, a Gaussian of deviation σ gives s·Σ_{k≥1} k·g(k), which by Euler and Maclaurin is
    /// s·(σ − 1/(12σ))/√(2π) and a little.
    #[test]
    fn a_corner_has_a_band_as_strong_as_its_slope_jumps() {
        for slope in [0.01, 0.02] {
            let row: Vec<f64> = (0..90)
                .map(|x| slope * (f64::from(x) - 45.0).max(0.0))
                .collect();
            let seen = perceived(&row);
            let darkest = seen.iter().copied().fold(f64::INFINITY, f64::min);
            let at = seen.iter().position(|&r| r == darkest).unwrap();
            assert!((43..=45).contains(&at), "{at}");
            let root = std::f64::consts::TAU.sqrt();
            let gathered = |deviation: f64| slope * (deviation - 1.0 / (12.0 * deviation)) / root;
            let expected = (1.0 + WEIGHT) * gathered(CENTER) - WEIGHT * gathered(SURROUND);
            assert!((seen[45] - expected).abs() < 0.01 * expected.abs());
            assert!(darkest < 0.0);
        }
    }
}
