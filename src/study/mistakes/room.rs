//! Radiosity with a mistake in its equation, B = E + ρ·Σ F_ij·B_j, solved by gathering until nothing changes, or for a hundred rounds.

use super::Mistake;
use crate::algorithms::enclosure::Enclosure;
use crate::color::Rgb;
use std::f64::consts::PI;

const ROUNDS: u32 = 100;

/// B of every patch. `matrix` is F, row-major.
pub fn light(enclosure: &Enclosure, matrix: &[f64], mistake: Mistake) -> Vec<Rgb> {
    let n = enclosure.patches.len();
    let entry = |i: usize, j: usize| match mistake {
        Mistake::FormFactorTransposed => matrix[j * n + i],
        Mistake::PiTwice => matrix[i * n + j] / PI,
        _ => matrix[i * n + j],
    };
    let reflectance = |i: usize| match mistake {
        Mistake::ReflectanceForgotten => Rgb::WHITE,
        _ => enclosure.reflectance[i],
    };
    let mut light = enclosure.emission.clone();
    for _ in 0..ROUNDS {
        let gathered = |i: usize| {
            let arriving = (0..n).fold(Rgb::BLACK, |sum, j| sum + light[j] * entry(i, j));
            enclosure.emission[i] + reflectance(i) * arriving
        };
        let next: Vec<Rgb> = (0..n).map(gathered).collect();
        let settled = next == light;
        light = next;
        if settled {
            break;
        }
    }
    light
}
