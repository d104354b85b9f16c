//! What is known of an enclosure once it is solved, the same at every step of the run.

use crate::algorithms::enclosure::{Enclosure, Light};
use crate::color::Rgb;
use std::iter::zip;

/// The share of the patches that do not come out white in the finished picture, and how bright the last of them is.
const SHARE: f64 = 0.95;
const BRIGHT: f64 = 0.9;

#[derive(Clone, Debug, PartialEq)]
pub struct Solved {
    /// What radiosity is multiplied by to be shown.
    pub exposure: f64,
    /// Σ_j F_ij, by patch i.
    pub row_sums: Vec<f64>,
    /// Iterations and relative residual at the end, by channel; empty where there is no solution.
    pub ends: Vec<(u32, f64)>,
}

impl Solved {
    /// `matrix` has the form factors, row by row; `light` is missing where the solver found none.
    pub fn new(enclosure: &Enclosure, matrix: &[f64], light: Option<&Light>) -> Self {
        let radiosity = light.map_or(&enclosure.emission, |light| &light.radiosity);
        let rows = matrix.chunks(enclosure.patches.len().max(1));
        let solutions = light.iter().flat_map(|light| &light.solutions);
        Solved {
            exposure: exposure(radiosity, &enclosure.emission),
            row_sums: rows.map(|row| row.iter().sum()).collect(),
            ends: solutions
                .map(|solution| (solution.iterations, solution.residual))
                .collect(),
        }
    }
}

/// What radiosity is multiplied by to be shown: chosen by the patches that do not emit, as lamps may well be white.
pub fn exposure(radiosity: &[Rgb], emission: &[Rgb]) -> f64 {
    let lit = zip(radiosity, emission).filter(|(_, emission)| emission.max_channel() == 0.0);
    let lit = percentile(lit.map(|(b, _)| b.max_channel()).collect());
    let all = || percentile(radiosity.iter().map(|b| b.max_channel()).collect());
    lit.or_else(all).map_or(1.0, |bright| BRIGHT / bright)
}

/// None where it is not positive.
fn percentile(mut values: Vec<f64>) -> Option<f64> {
    values.sort_by(f64::total_cmp);
    let at = (SHARE * values.len().saturating_sub(1) as f64).round() as usize;
    let value = values.get(at).copied();
    value.filter(|value| *value > 0.0 && value.is_finite())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn few_bright_patches_do_not_darken_the_rest() {
        let values = (0..100).map(|i| if i < 96 { 2.0 } else { 500.0 });
        assert_eq!(percentile(values.collect()), Some(2.0));
        assert_eq!(percentile(vec![0.0; 5]), None);
        assert_eq!(percentile(Vec::new()), None);
    }
}
